"""Other ways to tear the same plate, in the same run: classical peridynamics of this repository, LAMMPS, and a phase field
in dolfinx. Own rows that part plate has measured are compared with whatever finishes."""

from __future__ import annotations

import argparse
import sys
from typing import Any

from rows import ROOT, Table, call, measure

WANTED = 10  # times as fast as every peer that finishes


def classical(arguments: argparse.Namespace, n: int, *words: str) -> dict[str, Any]:
    rows = [call([str(arguments.peers / "bempd_explicit_pd"), str(n), *words])
            for _ in range(arguments.repeats if n <= 50 else 1)]
    return min(rows, key=lambda row: row.get("seconds", 1e9))


def rows_of(arguments: argparse.Namespace, n: int) -> dict[str, dict[str, Any]]:
    rows = {"classical, adaptive dynamic relaxation": classical(arguments, n, "relaxation")}
    for transits in (20, 40, 80, 160):
        rows[f"classical, explicit, {transits} transits"] = classical(arguments, n, "explicit", str(transits))
    opening = rows["classical, explicit, 20 transits"].get("opening", 0.01)
    if n <= 50 or arguments.full:
        peers = ROOT / "benchmarks/peers"
        rows["LAMMPS PERI, 20 transits"] = call([sys.executable, str(peers / "lammps_plate.py"), str(n), str(opening), "20"])
        rows["phase field, 20 increments"] = call([sys.executable, str(peers / "phase_field.py"), str(n), str(opening), "20"])
    return rows


def compare(arguments: argparse.Namespace, own: dict[int, dict[str, Any]]) -> None:
    table = Table("peers", "The plate torn by other programs", ["N", "program", "seconds", "steps", "bonds", "peak force",
                                                                "finished", "over bempd"])
    for n in (50, 100) + ((200,) if arguments.full else ()):
        ours = own.get(n) or measure("plate", {"n": n}, {}, "force", arguments.repeats)
        table.add([n, "bempd, window", ours["seconds"], ours["events"], ours["bonds"], ours["peak_force"], True, 1.0])
        ratios = []
        for name, row in rows_of(arguments, n).items():
            if "failed" in row:
                table.add([n, name, row["failed"], "", "", "", False, ""])
                continue
            ratio = row["seconds"] / ours["seconds"]
            table.add([n, name, row["seconds"], row["steps"], row.get("bonds", ""), row["peak_force"], row["finished"],
                       ratio if row["finished"] else f"> {ratio:.3g}"])
            if row["finished"]:
                ratios.append((ratio, name))
        if ratios:
            least, name = min(ratios)
            print(f"\nN = {n}: the fastest peer that finishes ({name}) takes {least:.2f} x the time of bempd; "
                  f"{WANTED} x is {'reached' if least >= WANTED else 'NOT reached'}.\n")
