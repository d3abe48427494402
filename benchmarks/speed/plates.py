"""Own rows of the lattice plate, and of the elastic plates to an accuracy of 1e-4."""

from __future__ import annotations

import argparse
from typing import Any, Callable

import numpy as np

from rows import OUT, Table, measure

ACCURACY = 1e-4


def same_sequence(name: str) -> str:
    """Whether window and plain broke the same bonds in the same events at the same loads."""
    window, plain = (np.load(OUT / f"history_{name}_{way}.npz") for way in ("window", "plain"))
    a, b = window["events"], plain["events"]
    if a.shape != b.shape:
        return f"NO: {len(a)} events against {len(b)}"
    same = np.array_equal(a[:, 0], b[:, 0]) and window["states"] == plain["states"]
    load = float(np.abs(a[:, 1] / b[:, 1] - 1).max())
    return f"{'yes' if same else 'NO'}, load factors to {load:.1g}"


def plate(arguments: argparse.Namespace, columns: list[str],
          row_of: Callable[[str, str, dict[str, Any]], list[Any]]) -> dict[int, dict[str, Any]]:
    """Returns the rows to 0.1 % of the force with a band of 0.1 %, by N."""
    table = Table("plate", "Lattice plate with a central crack", columns)
    own, compared = {}, []
    for n in (50, 100, 200) + ((400, 700) if arguments.full else ()):
        repeats = arguments.repeats if n <= 200 else 1
        scene = f"{n} x {n}"
        for band, until in ((1e-3, "force"), (1e-3, "separation"), (0.05, "force")):
            if n > 200 and band > 1e-3 or n > 400 and until == "force":
                continue  # minutes
            history = str(OUT / f"history_{n}_window.npz") if until == "separation" else None
            result = measure("plate", {"n": n}, {"crack.tie_share": band}, until, repeats, history=history)
            end = "0.1 % of the force" if until == "force" else "separation"
            table.add(row_of(scene, f"window, band {band:g}, to {end}", result))
            if until == "force" and band == 1e-3 and "failed" not in result:
                own[n] = result
        result = measure("plate", {"n": n}, {"crack.rule": "line"}, "force", repeats)
        table.add(row_of(scene, "line, to 0.1 % of the force", result))
        if n <= 100:
            result = measure("plate", {"n": n}, {"test.solver": "plain"}, "separation", 1,
                             history=str(OUT / f"history_{n}_plain.npz"))
            table.add(row_of(scene, "plain, band 0.001, to separation", result))
            compared.append(f"N = {n}: {same_sequence(str(n))}")
    print("\nSequences of window and plain are the same: " + "; ".join(compared))
    return own


def paper_sequences(arguments: argparse.Namespace, columns: list[str],
                    row_of: Callable[[str, str, dict[str, Any]], list[Any]]) -> None:
    """The paper's three cracks, followed to separation by both solvers."""
    table = Table("sequences", "The paper's three cracks by both solvers", columns)
    compared = []
    for scene in ("paper_crack", "paper_slanted_crack", "paper_edge_cracks"):
        for way in ("window", "plain"):
            result = measure(scene, {}, {"test.solver": way}, "separation", 1,
                             history=str(OUT / f"history_{scene}_{way}.npz"))
            result.pop("peak_force", None)  # that of a plate pulled by its ends
            table.add(row_of(scene, way, result))
        compared.append(f"{scene}: {same_sequence(scene)}")
    print("\nSequences of window and plain are the same: " + "; ".join(compared))


def elastic(arguments: argparse.Namespace) -> None:
    table = Table("elastic", f"Elastic plates to a relative error of {ACCURACY:g}",
                  ["scene", "element length", "nodes", "error", "seconds", "memory [MB]"])
    for name in ("plate", "hole", "shear"):
        for element_length in (0.2, 0.1, 0.05, 0.025, 0.0125):
            result = measure("clamped", {"name": name, "element_length": element_length}, {}, "elastic",
                             arguments.repeats)
            if "failed" in result:
                table.add([name, element_length, result["failed"], "", "", ""])
                break
            if result["error"] <= ACCURACY:
                table.add([name, element_length, result["statistics"]["boundary_nodes"], result["error"],
                           result["seconds"], result["megabytes"]])
                break
