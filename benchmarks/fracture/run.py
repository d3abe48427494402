"""Stress intensity factors of cracks in boundary elements against closed forms and published values, with the error that
the library tells and the time: tables in docs/research/tables. Run it with benchmarks/run.sh fracture."""

from __future__ import annotations

import dataclasses
import math
import os
import random
import re
import time
from pathlib import Path
from typing import Callable

import bempd
import contours
import growth
import lattice
import peers
import scenes
import tip_places
from stored_tables import store

REPEATS = 5
LATTICES = """Whole plates of lattice, and patches of lattice around the crack in boundary elements, against cracks in
boundary elements, which are right to 1e-4: as long as stated, and as long as the lattice's is felt (`felt_ahead`).
Differences of K_I and K_II are relative to the whole, that of T to the stress; *ring* is the largest radius and *felt
ahead* the distance, in spacings; *spread* is the error that `bempd_tip()` tells, among three rings. a is half the length
of inner cracks. Plane stress, accuracy standard."""
PEERS = """dolfinx with quadratic triangles that grow with the distance from the tip, quarter points, J or (inclined crack)
interaction integrals over a ring (`benchmarks/peers/dolfinx_crack.py`), on the whole plate as bempd has it and, where it says
symmetric, on the quarter or half of it that symmetry leaves. bempd with `bem.quadrature_tolerance` = 1e-6, one thread, few elements where
nothing happens. The inclined crack of half length a and the hole of radius R lie in squares of 40 a and 40 R. *Difference* is
that of both factors together from bempd with many elements."""
CHORDS = """The crack along a quarter of a circle by chords that touch it, against the closed form (Cotterell and Rice 1980);
differences relative to both factors together. There are no curved elements on cracks: chords reach 1e-3 in a few
milliseconds, if they touch the curve, so that the last one points where the tip does."""
CONTOURS = """Differences from cracks in boundary elements that are as long as the lattice's is felt, of J relative to G, of
factors relative to both. Squares around the tip through the lattice: J from stresses and displacements that
`bempd_evaluate()` gives there, factors by interaction with Williams' terms. Squares in the boundary elements around the
lattice: the integral of Knowles and Sternberg, whose value is 2 a G. Rings: `bempd_tip()`. What all contours of a crack have
in common is no error of theirs: faces in lattices are softer, which J and what is seen from afar feel more than the factors."""
PI = math.pi

ISIDA = "Isida, in Tada, Paris and Irwin 2.1"
KAYA = "Kaya and Erdogan 1987"
NEWMAN = "Newman 1971"
AMESTOY = "Amestoy and Leblond 1992"
OWN = "here, finer mesh"


@dataclasses.dataclass
class Case:
    name: str
    scene: Callable[[], bempd.Model]
    value: Callable[[list[bempd.CrackTip]], float]
    reference: float
    source: str
    limit: float | None = None  # of the relative difference


@dataclasses.dataclass
class Result:
    tips: list[bempd.CrackTip]
    elements: int
    seconds: float


def run(scene: Callable[[], bempd.Model]) -> Result:
    """The fastest of some runs: from the finished scene to its tips."""
    best = math.inf
    for _ in range(REPEATS):
        model = scene()
        start = time.process_time()
        model.step(1)
        tips = model.tips()
        best = min(best, time.process_time() - start)
        elements = model.statistics().boundary_elements
    return Result(tips, elements, best)


def first(a: float) -> Callable[[list[bempd.CrackTip]], float]:
    """K_I of the first tip over that of a crack of half length a in an infinite plate."""
    return lambda tips: tips[0].stress_intensity_1 / math.sqrt(PI * a)


def factor(scene: Callable[[], bempd.Model], a: float) -> float:
    model = scene()
    model.step(1)
    return first(a)(model.tips())


def complete_elliptic(m: float) -> tuple[float, float]:
    """K and E of the parameter m, by the arithmetic-geometric mean."""
    a, b, c, total, power = 1.0, math.sqrt(1 - m), math.sqrt(m), m / 2, 0.5
    while abs(c) > 1e-17 and power < 1e9:
        a, b, c, power = (a + b) / 2, math.sqrt(a * b), (a - b) / 2, 2 * power
        total += power * c * c
    first_kind = PI / (2 * a)
    return first_kind, first_kind * (1 - total)


def plates() -> list[Case]:
    isida = (1.0060, 1.0246, 1.0577, 1.1094, 1.1867, 1.3033, 1.4882, 1.8160)
    kaya = (1.1892, 1.3673, 1.6599, 2.1114, 2.8246, 4.0332)
    newman = ((1.1, 0.8400), (1.2, 0.9851), (1.5, 1.0582), (2.0, 1.0409))
    cases = [Case(f"centre crack, a/W = {a:.1f}", lambda a=a: scenes.centre(a), first(a), value, ISIDA, 1e-4)
             for a, value in zip((0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8), isida)]
    cases += [Case(f"single edge crack, a/W = {a:.1f}", lambda a=a: scenes.single_edge(a), first(a), value, KAYA, 1e-4)
              for a, value in zip((0.1, 0.2, 0.3, 0.4, 0.5, 0.6), kaya)]
    for a in (0.1, 0.3, 0.5, 0.7):
        cases.append(Case(f"double edge crack, a/W = {a:.1f}", lambda a=a: scenes.double_edge(a), first(a),
                          factor(lambda a=a: scenes.double_edge(a, 0.1), a), OWN, 1e-3))
    cases += [Case(f"two cracks from a hole, a/R = {a:.1f}", lambda a=a: scenes.from_hole(a), first(a), value, NEWMAN, 1e-3)
              for a, value in newman]
    return cases


def infinite_plates() -> list[Case]:
    root = math.sqrt(PI)
    straight = factor(lambda: scenes.kinked(0), 1) * root
    half, half_arc = PI / 4, PI / 8
    arc = math.sqrt(PI * math.sin(half)) / (1 + math.sin(half_arc) ** 2)
    angle = math.radians(20)
    fine = scenes.inclined(20, 1)
    fine.step(1)
    tip = fine.tips()[1]
    cases = [
        Case("inclined crack, 20 degrees, K_I", lambda: scenes.inclined(20), lambda t: t[1].stress_intensity_1 / root,
             tip.stress_intensity_1 / root, OWN, 5e-4),
        Case("inclined crack, 20 degrees, K_II", lambda: scenes.inclined(20), lambda t: t[1].stress_intensity_2 / root,
             tip.stress_intensity_2 / root, OWN, 5e-4),
        Case("the same, infinite plate, K_I", lambda: scenes.inclined(20), lambda t: t[1].stress_intensity_1 / root,
             math.cos(angle) ** 2, "closed form; the rest is the finite plate"),
        Case("the same, infinite plate, K_II", lambda: scenes.inclined(20), lambda t: t[1].stress_intensity_2 / root,
             math.sin(angle) * math.cos(angle), "closed form; the rest is the finite plate"),
        Case("kink of 45 degrees, b/a = 1e-4, F_11", lambda: scenes.kinked(1e-4),
             lambda t: t[1].stress_intensity_1 / straight, 0.79090, AMESTOY, 5e-4),
        Case("kink of 45 degrees, b/a = 1e-4, F_21", lambda: scenes.kinked(1e-4),
             lambda t: t[1].stress_intensity_2 / straight, 0.32328, AMESTOY, 5e-4),
        Case("arc of 90 degrees, K_I", scenes.arc, lambda t: t[0].stress_intensity_1, arc * math.cos(half_arc),
             "Cotterell and Rice 1980", 1e-3),
        Case("arc of 90 degrees, K_II", scenes.arc, lambda t: abs(t[0].stress_intensity_2), arc * math.sin(half_arc),
             "Cotterell and Rice 1980", 1e-3),
        Case("pressure on the faces, K_I", scenes.pressure, first(1), 1, "Sneddon 1946", 1e-3),
        Case("pressure on the faces, T", scenes.pressure, lambda t: t[0].t_stress, -1, "closed form", 1e-3),
        Case("shear on the faces, K_II", scenes.shear, lambda t: t[1].stress_intensity_2 / root, 1, "closed form", 1e-3),
    ]
    for c in (0.1, 0.01, 0.001):
        b = c + 2
        k, e = complete_elliptic(1 - (c / b) ** 2)
        inner = math.sqrt(PI / c) * (b * b * e / k - c * c) / math.sqrt(b * b - c * c)
        cases.append(Case(f"two cracks in a row, gap {c:.1%} of one", lambda c=c: scenes.collinear(c),
                          lambda t: t[1].stress_intensity_1, inner, "Tada, Paris and Irwin 7.1", 1e-3))
    return cases


def extremes() -> list[Case]:
    cases = [Case(f"crack {a:g} of the body", lambda a=a: scenes.tiny(a), first(a), 1, "infinite plate",
                  1e-3) for a in (1e-2, 1e-4, 1e-6, 1e-8)]
    for degrees in (90, 150, 177):
        fine = scenes.kinked(0.5, degrees, 32)
        fine.step(1)
        reference = math.sqrt(fine.tips()[1].energy_release_rate)
        cases.append(Case(f"kink of {degrees} degrees, half as long, K of both modes", lambda d=degrees: scenes.kinked(0.5, d),
                          lambda t: math.sqrt(t[1].energy_release_rate), reference, OWN, 1e-3))
    cases.append(Case("centre crack, a/W = 0.5, plane strain, Poisson's ratio 1/2", scenes.incompressible, first(0.5), 1.1867,
                      ISIDA, 1e-3))
    for gap in (0.1, 0.01, 0.001):
        fine = scenes.next_to_an_edge(gap, 0.06)
        fine.step(1)
        reference = fine.tips()[1].stress_intensity_1
        cases.append(Case(f"tip {gap:g} of its crack from an edge", lambda g=gap: scenes.next_to_an_edge(g),
                          lambda t: t[1].stress_intensity_1, reference, OWN, 1e-3))
    return cases


def table(cases: list[Case]) -> tuple[str, int]:
    lines = ["| case | value | reference | source | difference | told | elements | ms |", "|---|---|---|---|---|---|---|---|"]
    failures = 0
    for case in cases:
        result = run(case.scene)
        value = case.value(result.tips)
        difference = value / case.reference - 1
        worst = max(tip.error / math.hypot(tip.stress_intensity_1, tip.stress_intensity_2) for tip in result.tips)
        beyond = case.limit is not None and abs(difference) > case.limit
        failures += beyond
        lines.append(f"| {case.name} | {value:.6g} | {case.reference:.6g} | {case.source} | {difference:+.1e}"
                     f"{' beyond ' + format(case.limit, 'g') if beyond else ''} | {worst:.0e} | {result.elements} | "
                     f"{1e3 * result.seconds:.1f} |")
        print(lines[-1], flush=True)
    return "\n".join(lines), failures


def convergence() -> str:
    """K of the centre crack of half the width over the length of the boundary's elements, against the finest."""
    finest = factor(lambda: scenes.centre(0.5, 0.04), 0.5)
    lines = ["| boundary elements of | elements | difference | order | told | ms |", "|---|---|---|---|---|---|"]
    before = None
    for element in (1.0, 0.5, 0.25, 0.125):
        result = run(lambda: scenes.centre(0.5, element))
        difference = first(0.5)(result.tips) / finest - 1
        order = "" if before is None else f"{math.log2(abs(before / difference)):.1f}"
        lines.append(f"| {element:g} W | {result.elements} | {difference:+.1e} | {order} | "
                     f"{result.tips[0].error / result.tips[0].stress_intensity_1:.0e} | {1e3 * result.seconds:.1f} |")
        before = difference
    return "\n".join(lines)


def arcs() -> str:
    """The crack along an arc by more and more chords; the last column has chords that end on the arc."""
    half, half_arc = PI / 4, PI / 8
    scale = math.sqrt(PI * math.sin(half)) / (1 + math.sin(half_arc) ** 2)
    known = (scale * math.cos(half_arc), scale * math.sin(half_arc))
    lines = ["| chords | elements | K_I | K_II | ms | chords that end on the arc: K_I | K_II |", "|---|---|---|---|---|---|---|"]
    for pieces in (2, 4, 8, 16, 32, 64, 128):
        off = []
        for touching in (True, False):
            result = run(lambda: scenes.arc(pieces, touching))
            tip = result.tips[0]
            off += [f"{(value - reference) / scale:+.1e}" for value, reference in
                    zip((tip.stress_intensity_1, abs(tip.stress_intensity_2)), known)]
            if touching:
                size, seconds = result.elements, result.seconds
        lines.append(f"| {pieces} | {size} | {off[0]} | {off[1]} | {1e3 * seconds:.1f} | {off[2]} | {off[3]} |")
        print(lines[-1], flush=True)
    return "\n".join(lines)


def many_cracks(count: int = 100) -> str:
    numbers = random.Random(7)
    cracks = []
    for i in range(count):
        x, y = 0.18 * (i % 10) - 0.81 + numbers.uniform(-0.03, 0.03), 0.18 * (i // 10) - 0.81 + numbers.uniform(-0.03, 0.03)
        angle = numbers.uniform(0, PI)
        dx, dy = 0.05 * math.cos(angle), 0.05 * math.sin(angle)
        cracks.append([(x - dx, y - dy), (x + dx, y + dy)])
    model = scenes.plate(1, 1, 0.25, cracks)
    start = time.process_time()
    model.step(1)
    solved = time.process_time() - start
    start = time.process_time()
    tips = model.tips()
    seconds = time.process_time() - start
    sound = scenes.plate(1, 1, 0.25, [])
    sound.step(1)
    return (f"{count} cracks with {len(tips)} tips, {model.statistics().boundary_elements} elements: {solved:.1f} s to "
            f"equilibrium, {seconds:.1f} s for all factors with their errors; reciprocal condition "
            f"{model.statistics().reciprocal_condition:.0e}, without cracks {sound.statistics().reciprocal_condition:.0e}.")


def units() -> str:
    def value(size: float, modulus: float) -> float:
        model = scenes.plate(size, size, size / 2, [[(-0.5 * size, 0), (0.3 * size, 0.2 * size)]], stress=(0, modulus),
                             modulus=modulus)
        model.step(1)
        return model.tips()[0].stress_intensity_1 / modulus / math.sqrt(size)
    reference = value(1, 1)
    worst = max(abs(value(size, modulus) / reference - 1)
                for size, modulus in ((1e-9, 1), (1e9, 1), (1, 1e-12), (1, 1e15)))
    return f"Sizes of 1e-9 and 1e9 and moduli of 1e-12 and 1e15 change the factor by {worst:.0e} of its value."


def main() -> None:
    folder = Path(os.environ["BEMPD_OUTPUT"])
    folder.mkdir(parents=True, exist_ok=True)
    sections, failures = [], 0
    for title, cases in (("Plates", plates()), ("Cracks in large plates", infinite_plates()), ("Extremes", extremes())):
        text, beyond = table(cases)
        sections.append(f"## {title}\n\n{text}\n")
        failures += beyond
    sections.append(growth.section())
    sections.append(f"{units()}\n\n{many_cracks()}\n")
    sections.append(f"## Beside finite elements\n\n{PEERS}\n\n{peers.side_by_side()}\n")
    sections.append(f"## Order\n\nCentre crack, a/W = 0.5, eight elements on the crack.\n\n{convergence()}\n")
    sections.append(f"## Curved cracks\n\n{CHORDS}\n\n{arcs()}\n")
    sections.append(f"## Cracks in lattices\n\n{LATTICES}\n\n{lattice.section()}\n\n{tip_places.section()}\n")
    sections.append(f"## Contours around tips in lattices\n\n{CONTOURS}\n\n{contours.section()}\n")
    text = "\n".join(sections)
    (folder / "tables.md").write_text(text)
    for title, section in re.findall(r"^## (.*?)\n(.*?)(?=^## |\Z)", text, re.DOTALL | re.MULTILINE):
        store("verification_" + re.sub(r"\W+", "_", title.lower()), section)
    print(f"\n{failures} differences beyond their limits; the tables are in docs/research/tables")
    if failures:
        raise SystemExit(1)


main()
