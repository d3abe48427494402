"""What criteria for the break of a bond make of bodies that are pulled and pressed, and what the library's own cost: the
tables in docs/research/tables. Run it with benchmarks/run.sh compression."""

import os
import subprocess
import time
from pathlib import Path

import bempd
from stored_tables import store


def by_criteria() -> str:
    program = Path(os.environ["BEMPD_BENCHMARKS"]) / "bempd_compression"
    return subprocess.run([program], check=True, capture_output=True, text=True).stdout.strip()


def slot(criterion: str, solver: str, sign: int) -> tuple[float, int]:
    """Processor seconds of 250 events after the first in a plate with a slot at 45 degrees, and bonds broken by then."""
    model = bempd.Model(options={"crack.rule": "bond", "pd.criterion": criterion, "test.solver": solver})
    solid = model.add_material(young_modulus=1, poisson_ratio=1 / 3, critical_stretch=1e-3)
    body = model.add_pd_region(solid, bempd.rectangle(0, 0, 90, 110), 1, 3)
    model.add_crack([(30.25, 40.75), (59.75, 70.25)])
    model.fix_edge(body, 1, "y")
    model.prescribe_edge(body, 3, "y", sign)
    model.fix_point((0, 0), "x")
    model.step_to_next_event(1e3)
    began = time.process_time()
    for _ in range(250):
        model.step_to_next_event(1e3)
    return time.process_time() - began, model.statistics().broken_bonds


def costs() -> str:
    lines = ["| plate with a slot | criterion | whole body [s] | windows [s] | bonds broken |", "|---|---|---|---|---|"]
    for name, sign in (("pulled", 1), ("pressed", -1)):
        for criterion in ("stretch", "opening"):
            whole, broken = slot(criterion, "plain", sign)
            windows, same = slot(criterion, "window", sign)
            if broken != same:
                raise SystemExit(f"not so: windows break as the whole body does, {broken} and {same} bonds")
            lines.append(f"| {name} | {criterion} | {whole:.2f} | {windows:.2f} | {broken} |")
    return "\n".join(lines)


def main() -> None:
    for mark, table in (("compression", by_criteria()), ("compression_cost", costs())):
        print(table)
        store(f"materials_{mark}", table)


main()
