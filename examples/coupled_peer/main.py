"""A block of another program cools and pulls a cracked specimen: displacements to the specimen, forces back, each step
repeated until both agree.

usage: main.py [--peer numpy|dolfinx|both] [--short] [FOLDER]
    --peer    the program that has the block; both runs both and compares them
    --short   a coarse lattice, trials until 1e-6 and no picture, as a test
    FOLDER    for the picture; out/coupled_peer without it
"""

from __future__ import annotations

import argparse
import importlib
import pathlib

import bempd
import numpy as np
from block import Block

COLDEST, COOLING = -90.0, 18.0  # [K], [K/h]: the wall becomes colder by so much an hour down to this
STEP, MOST_BONDS = 0.5, 40  # [h]; a step that breaks more bonds is repeated with half of the time


class Specimen:
    """A strip of acrylic glass with an edge crack: boundary elements | lattice | boundary elements."""

    def __init__(self, spacing: float, tough: bool = False) -> None:
        self.model = model = bempd.Model(options={"crack.rule": "bond"})
        acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, thickness=0.005,
                                     fracture_energy=0 if tough else 300)
        left = model.add_bem_region(acrylic, bempd.rectangle(0, 0, 0.020, 0.020), element_length=0.004)
        self.strip = model.add_pd_region(acrylic, bempd.rectangle(0.020, 0, 0.040, 0.020), spacing=spacing)
        self.right = model.add_bem_region(acrylic, bempd.rectangle(0.040, 0, 0.060, 0.020), element_length=0.004)
        model.add_crack([(0.030 + spacing / 2, 0), (0.030 + spacing / 2, 0.0105)])
        model.fix_edge(left, 4)
        self.held = model.fix_edge(self.right, 2)  # driven by values at places from here on

    def couple(self, points: np.ndarray) -> None:
        """Where the nodes of the other program lie on the edge, and how those here lie between them."""
        along = self.model.fractions_on_edge(self.right, 2, points)
        if along.distances.max() > 1e-9:
            raise SystemExit(f"nodes of the other program are {along.distances.max():g} m away from the edge")
        self.fractions = along.fractions
        here = self.model.edge_nodes(self.right, 2).fractions
        unit = np.eye(len(points))
        self.between = np.array([np.interp(here, self.fractions, column) for column in unit]).T

    def forces(self, displacement: np.ndarray, hours: float) -> tuple[np.ndarray, bempd.StepReport]:
        """On the nodes of the other program, by which its displacements do the work that is done here."""
        self.model.set_support_values_at(self.held, self.fractions, constant=displacement)
        report = self.model.step_to_values(hours)
        return -self.between.T @ self.model.edge_forces(self.right, 2), report


class QuasiNewton:
    """Interface quasi-Newton with least squares (Degroote, Bathe and Vierendeels, Computers and Structures 87, 2009): the
    next displacement from the differences that the trials so far have made."""

    def __init__(self) -> None:
        self.given: list[np.ndarray] = []
        self.changes: list[np.ndarray] = []

    def next(self, displacement: np.ndarray, change: np.ndarray) -> np.ndarray:
        self.given.append((displacement + change).ravel())
        self.changes.append(change.ravel())
        if len(self.changes) == 1:
            return displacement + 0.5 * change
        steps = np.diff(self.changes, axis=0)[::-1].T
        answers = np.diff(self.given, axis=0)[::-1].T
        weights = np.linalg.lstsq(steps, -self.changes[-1], rcond=1e-10)[0]
        return displacement + change + (answers @ weights).reshape(change.shape)


def agree(specimen: Specimen, peer, temperature: np.ndarray, guess: np.ndarray, hours: float, torn: bool = False,
          precision: float = 1e-9):
    """The fixed point of one step; None if the step breaks too much. `torn`: the specimen breaks however short the step
    is, so that trials go on from each other: what has broken while the block gave way stays broken."""
    start = specimen.model.save()
    displacement, newton = guess, QuasiNewton()
    for trial in range(1, 41):
        if not torn:
            specimen.model.restore(start)
        forces, report = specimen.forces(displacement, hours + (0.002 * trial if torn else 0))
        if report.broken_bonds > MOST_BONDS and not report.separated and not torn:
            break
        change = peer.displacement(temperature, forces) - displacement
        if np.abs(change).max() <= precision * np.abs(displacement).max() + 1e-15:
            return displacement, forces, report, trial
        if torn and report.broken_bonds:
            newton = QuasiNewton()  # it is another body now
        displacement = newton.next(displacement, change)
    if torn:
        raise SystemExit("not so: the block comes to rest after the break")
    specimen.model.restore(start)
    return None


def run(peer, specimen: Specimen, precision: float) -> list[dict]:
    specimen.couple(peer.points)
    specimen.model.prepare()
    temperature, displacement, hours, step = peer.start, np.zeros_like(peer.points), 0.0, STEP
    rows: list[dict] = []
    while not rows or rows[-1]["force"] > 0.05 * max(row["force"] for row in rows):
        if len(rows) == 100:
            raise SystemExit("not so: the specimen tears within 100 steps")
        trial = peer.cooled(temperature, max(COLDEST, -COOLING * (hours + step)), step)
        torn = step < STEP / 500
        found = agree(specimen, peer, trial, displacement, hours + step, torn, precision)
        if found is None:
            step /= 2
            continue
        displacement, forces, report, trials = found
        hours, temperature = report.load_factor, trial
        rows.append({"hours": hours, "mean": peer.mean(temperature), "elongation": displacement[:, 0].mean(),
                     "force": -forces[:, 0].sum(), "bonds": report.total_broken_bonds, "trials": trials, "torn": torn,
                     "temperature": temperature, "forces": forces, "state": specimen.model.save(values=True)})
        step = min(STEP, 2 * step)
    return rows


def table(rows: list[dict]) -> str:
    lines = ["   time [h]   block [K]  elongation [um]   force [N]  bonds  trials"]
    lines += [f"{row['hours']:11.5f} {row['mean']:11.4f} {1e6 * row['elongation']:16.4f} {row['force']:11.4f} "
              f"{row['bonds']:6d} {row['trials']:7d}{'  torn' if row['torn'] else ''}" for row in rows]
    return "\n".join(lines)


def elastic_check(peer) -> str:
    """A tough specimen and an evenly cold block: as one model, whose block is a region with a temperature."""
    coupled = Specimen(spacing=0.001, tough=True)
    coupled.couple(peer.points)
    coupled.model.prepare()
    block, cold = peer.block, np.full_like(peer.start, -60.0)
    displacement, forces, _, trials = agree(coupled, peer, cold, np.zeros_like(peer.points), 1.0)
    whole = Specimen(spacing=0.001, tough=True)
    whole.model.remove_support(whole.held)
    filled = whole.model.add_material(young_modulus=block.young_modulus, poisson_ratio=block.poisson_ratio,
                                      thickness=block.thickness, thermal_expansion=block.thermal_expansion)
    corners = bempd.rectangle(block.left, 0, block.left + block.width, block.height)
    region = whole.model.add_bem_region(filled, corners, element_length=0.002)
    wall = whole.model.fix_edge(region, 2)
    whole.model.add_temperature(region, constant=-60.0)
    force = whole.model.reaction(wall)[0]
    apart = abs(-forces[:, 0].sum() / force - 1)
    if apart > 2e-3:
        raise SystemExit(f"not so: the coupled force is that of one model; they differ by {apart:.1e}")
    return (f"elastic, block evenly at -60 K: {-forces[:, 0].sum():.3f} N after {trials} trials, one model {force:.3f} N, "
            f"{apart:.1e} apart; the programs pass {displacement[:, 0].mean() * 1e6:.3f} um")


def compare(one: list[dict], other: list[dict]) -> str:
    if len(one) != len(other) or any(a["bonds"] != b["bonds"] for a, b in zip(one, other)):
        raise SystemExit("not so: both programs break the same bonds in the same steps")
    apart = max(abs(a["force"] - b["force"]) for a, b in zip(one, other)) / max(a["force"] for a in one)
    if apart > 1e-8:
        raise SystemExit(f"not so: both programs find the same forces; they differ by {apart:.1e}")
    return f"the same bonds in the same {len(one)} steps; forces {apart:.1e} of the largest apart"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--peer", choices=("numpy", "dolfinx", "both"), default="numpy")
    parser.add_argument("--short", action="store_true")
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=pathlib.Path("out/coupled_peer"))
    arguments = parser.parse_args()
    modules = {"numpy": ["block"], "dolfinx": ["block_dolfinx"], "both": ["block", "block_dolfinx"]}[arguments.peer]
    spacing, precision = (0.001, 1e-6) if arguments.short else (0.0005, 1e-9)
    results = []
    for module in modules:
        peer, specimen = importlib.import_module(module).Peer(Block()), Specimen(spacing)
        rows = run(peer, specimen, precision)
        print(f"block in {peer.name}\n{table(rows)}")
        if rows[-1]["bonds"] == 0 or rows[-1]["force"] > 0.05 * max(row["force"] for row in rows):
            raise SystemExit("not so: the specimen tears")
        print(elastic_check(peer), flush=True)
        results.append((rows, specimen, peer))
    if len(results) == 2:
        print(compare(results[0][0], results[1][0]))
    if not arguments.short and modules[0] == "block":
        import picture

        rows, specimen, peer = results[0]
        shown = max((row for row in rows[:-1]), key=lambda row: row["bonds"])
        specimen.model.restore(shown["state"])
        arguments.folder.mkdir(parents=True, exist_ok=True)
        print(f"wrote {picture.draw(arguments.folder, rows, shown, specimen, peer)}")


if __name__ == "__main__":
    main()
