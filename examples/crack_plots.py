"""The pictures of an example with cracks: damage and load curve of every run, displacements at the first break."""

import argparse

import field_plots
import plotting


def draw(example, **figure_options):
    """Command line of examples/EXAMPLE/plot.py: [FOLDER] [RUN...]; options are those of plotting.fracture_figure()."""
    parser = argparse.ArgumentParser(
        description="Draws the damage around the growing cracks, the load curve and the displacements of the runs.")
    parser.add_argument("folder", nargs="?", default=f"out/{example}", help="where the run wrote its files")
    parser.add_argument("runs", nargs="*", help="names of runs, such as events_symmetric (default: all)")
    options = parser.parse_args()
    runs = options.runs or plotting.written_runs(options.folder)
    for run in runs:
        print(f"wrote {plotting.fracture_figure(options.folder, run, **figure_options)}")
    panels = [(f"{run.replace('_', ', ')}, first break", plotting.first_break_snapshot(options.folder, run)) for run in runs]
    picture = field_plots.cracked_figure(options.folder, "fields", panels, length_unit=1e-3, length_name="mm")
    if picture:
        print(f"wrote {picture}")
