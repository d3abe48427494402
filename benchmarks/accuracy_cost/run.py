"""The price of every knob: error, time and memory of the scenes in scenes.py over the settings in sweeps.py, the plates
against finite element programs, and the machine's limits. Run it with benchmarks/run.sh accuracy_cost."""

from __future__ import annotations

import json
import os
from pathlib import Path

from cracks import crack_columns, crack_trials, relate
from limits import limits
from measure import Row, bempd_command, measure
from peers import TARGET, duel, installed
from report import SWEEP_COLUMNS, draw, duel_table, limits_table, shown, sweep_tables, write_csv
from sweeps import Trial, all_trials

ROUNDS, BUDGET = 2, 0.15  # seconds of repeats per round


def run_trials(trials: list[Trial]) -> list[Row]:
    quick = [trial for trial in trials if not trial.slow]
    slow = [trial for trial in trials if trial.slow]
    results: dict[int, Row] = {}
    for group, rounds, budget in ((quick, ROUNDS, BUDGET), (slow, 1, 0.0)):
        commands = [bempd_command(trial.scene, trial.settings, budget) for trial in group]
        results.update(zip(map(id, group), measure(commands, rounds, threads=os.cpu_count() or 1)))
    rows = []
    for trial in trials:
        rows.append({"scene": trial.scene, "program": "bempd", "knob": trial.knob, "settings": trial.settings,
                     "setting": json.dumps(trial.settings), "shown": shown(trial.settings, trial.key), **results[id(trial)]})
    return rows


def main() -> None:
    folder = Path(os.environ["BEMPD_OUTPUT"])
    folder.mkdir(parents=True, exist_ok=True)
    tried, best = duel()
    machine = limits()
    trials = run_trials(all_trials())
    cracks = run_trials(crack_trials())
    relate(cracks)
    write_csv(folder / "rows.csv", trials + cracks + [
        {**row, "scene": row["problem"], "seconds": row["seconds_solve"], "knob": "against peers"} for row in tried])
    text = "\n".join([
        f"## The fastest way to a displacement within {TARGET:g}, one core\n", duel_table(best),
        f"Peers installed: {', '.join(installed()) or 'none'}.\n",
        "## Machine limits\n", limits_table(machine), "## Every knob\n", sweep_tables(trials, SWEEP_COLUMNS),
        "## Plates torn apart\n", sweep_tables(cracks, crack_columns())])
    (folder / "table.md").write_text(text)
    draw(folder / "accuracy_cost.png", trials + cracks, best)
    print((folder / "rows.csv").read_text())
    print(text)


main()
