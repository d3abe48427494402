"""The price of every knob: error, time and memory of the scenes in scenes.py over the settings in sweeps.py, the plates
against finite element programs, and the machine's limits. Run it with benchmarks/run.sh accuracy_cost."""

from __future__ import annotations

import json
import os
from pathlib import Path

from limits import limits
from measure import Row, bempd_command, measure
from peers import TARGET, duel, installed
from report import draw, duel_table, limits_table, shown, sweep_tables, write_csv
from sweeps import Trial, all_trials

ROUNDS, BUDGET = 2, 0.15  # seconds of repeats per round
CRACK = "centre_crack"


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
    relate_crack_runs(rows)
    return rows


def relate_crack_runs(rows: list[Row]) -> None:
    """A torn plate has no closed form: its released energy is compared with that of bonds breaking one by one."""
    alone = next(r["error"] for r in rows if r["scene"] == CRACK and r["settings"].get("stepping.tie_band") == 0)
    for row in rows:
        if row["scene"] == CRACK and "refused" not in row:
            row["error"] = abs(row["error"] / alone - 1)


def main() -> None:
    folder = Path(os.environ["BEMPD_OUTPUT"])
    folder.mkdir(parents=True, exist_ok=True)
    tried, best = duel()
    machine = limits()
    trials = run_trials(all_trials())
    write_csv(folder / "rows.csv", trials + [{**row, "scene": row["problem"], "seconds": row["seconds_solve"],
                                              "knob": "against peers"} for row in tried])
    text = "\n".join([
        f"## The fastest way to a displacement within {TARGET:g}, one core\n", duel_table(best),
        f"Peers installed: {', '.join(installed()) or 'none'}.\n",
        "## Machine limits\n", limits_table(machine), "## Every knob\n", sweep_tables(trials)])
    (folder / "table.md").write_text(text)
    draw(folder / "accuracy_cost.png", trials, [row for row in tried if row["error"] > 0])
    print((folder / "rows.csv").read_text())
    print(text)


main()
