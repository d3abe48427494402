"""Lets cracks of well-known bodies grow, says how far from known ways they go, and draws them.

usage: main.py [--short] [FOLDER]      --short: long steps and no picture, as a test
"""

from __future__ import annotations

import argparse
import math
import pathlib
import time

import cases
import numpy as np
import references

Path = list[tuple[float, float]]


def expect(holds: bool, what: str) -> None:
    if not holds:
        raise SystemExit(f"not so: {what}")


def distance(places: Path, way: Path) -> float:
    """The largest distance of places from a polyline, over those that lie beside it."""
    worst = 0.0
    points = np.array(way)
    starts, along = points[:-1], np.diff(points, axis=0)
    for place in np.array(places):
        parts = ((place - starts) * along).sum(axis=1) / (along**2).sum(axis=1)
        feet = starts + np.clip(parts, 0, 1)[:, None] * along
        nearest = np.hypot(*(place - feet).T).argmin()
        # The path gives no direction beyond its last end.
        if nearest == len(along) - 1 and parts[nearest] > 1:
            continue
        worst = max(worst, float(np.hypot(*(place - feet[nearest]))))
    return worst


def two_holes(short: bool) -> tuple[list[str], dict]:
    lines, drawn = [], {}
    for held, published in references.TWO_HOLES.items():
        ways = {}
        for step in (1.0,) if short else (1.0, 0.5, 0.25):
            model = cases.run(cases.two_holes(held), step, int(12 / step), tie_share=1e6)
            ways[step] = {crack: cases.path(model, crack, published[crack][:2]) for crack in (1, 2)}
        finest = ways[min(ways)]
        apart = max(distance(published[crack], finest[crack]) for crack in (1, 2))
        own = max(math.dist((20 - x, 10 - y), other) for (x, y), other in zip(published[1], published[2]))
        name = "two holes, sides held" if held else "two holes, sides free"
        mirrored = [(20 - x, 10 - y) for x, y in finest[2]]
        lines.append(f"{name}: {apart:.2f} mm from X-FEM with 1 mm steps, whose two ways differ by {own:.2f} mm; "
                     f"ours by {distance(mirrored, finest[1]):.0e} mm")
        for step, found in ways.items():
            if step > min(ways):
                lines.append(f"    steps of {step:g} instead of {min(ways):g} mm: {distance(found[1], finest[1]):.3f} mm")
        expect(distance(mirrored, finest[1]) < 1e-9, "the two ways are the same, turned by half a turn")
        expect(any(e.ended for e in model.extensions()) != held, "with free sides the cracks end in the holes, with held ones not")
        drawn[name] = (finest, published)
    return lines, drawn


def hole_entered(way: Path) -> str:
    x, y = way[-1]
    for name, (a, b) in zip(("bottom", "middle", "top"), cases.HOLES):
        if abs(math.hypot(x - a, y - b) - cases.HOLE_RADIUS) < 1e-3:
            return f"ends in the {name} hole at {math.degrees(math.atan2(y - b, x - a)):.0f} degrees"
    return f"ends at ({x:.2f}, {y:.2f})"


def three_holes(short: bool) -> tuple[list[str], dict]:
    known = references.THREE_HOLES
    model = cases.run(cases.three_holes(known["notch"], known["offset"]), known["step"], known["steps"])
    lines = []
    extension = model.extensions()[-1]
    if not extension.ended:
        model.step(1)
        tip = model.tips()[0]
        lines.append(f"three holes, notch {known['notch']}, offset {known['offset']:g}, after {known['steps']} steps of "
                     f"{known['step']}: K_I {tip.stress_intensity_1:.4f}, code_aster {known['K_I']:.4f}")
    drawn = {}
    for notch, offset in ((1.5, 5.0), (1.0, 6.0), *(() if short else ((1.5, 4.95), (1.5, 5.05)))):
        model = cases.run(cases.three_holes(notch, offset), 0.2 if short else 0.05, 40 if short else 160)
        way = cases.path(model, 1, [(10 - offset, 0), (10 - offset, notch)])
        gaps = ", ".join(f"{gap_to_hole(way, hole):.2f}" for hole in cases.HOLES)
        lines.append(f"three holes, notch {notch:g}, offset {offset:g}: {hole_entered(way)}; as close to the holes as {gaps}")
        drawn[(notch, offset)] = way
    expect(hole_entered(drawn[(1.0, 6.0)]).startswith("ends in the middle hole"), "the crack 6 inches off ends in a hole")
    if not short:
        for offset, hole in ((4.95, "bottom"), (5.05, "middle")):
            expect(hole_entered(drawn[(1.5, offset)]).startswith(f"ends in the {hole} hole"), f"{offset} inches off: {hole} hole")
    return lines, drawn


def gap_to_hole(way: Path, hole: tuple[float, float]) -> float:
    return max(0.0, min(math.dist(hole, place) for place in way) - cases.HOLE_RADIUS)


def edge_cracks(short: bool) -> tuple[list[str], dict]:
    model = cases.run(cases.edge_cracks(), 1.0 if short else 0.5, 30 if short else 80, tie_share=1e6)
    ways = [cases.path(model, 1, [(0, 0.5), (8, 0.5)]), cases.path(model, 2, [(40, -0.5), (32, -0.5)])]
    mirrored = [(40 - x, -y) for x, y in ways[1]]
    left = distance(ways[0][-1:], ways[1])
    lines = [f"edge cracks, 1 mm apart: away from each other to {max(y for _, y in ways[0]):.2f} mm above the middle, round each "
             f"other, and back until {left:.2f} mm from the other; the two ways differ by {distance(mirrored, ways[0]):.0e} mm"]
    expect(distance(mirrored, ways[0]) < 1e-9 and left < 1.5, "the cracks hook into each other alike")
    return lines, {"ways": ways}


def four_points(short: bool) -> tuple[list[str], dict]:
    model = cases.run(cases.four_points(), 15 if short else 5, 20 if short else 60)
    way = cases.path(model, 1, [(0, 0), (0, 82)])
    first = model.extensions()[0]
    expect(61 < way[-1][0] < 150 and way[-1][1] > 250, "the crack comes up beside the load")
    return [f"four points: turns by {math.degrees(first.angle):.0f} degrees at the notch, its last step ends at "
            f"({way[-1][0]:.0f}, {way[-1][1]:.0f}) mm; the load acts at (61, 306)"], {"way": way}


def compressed_plate(short: bool) -> tuple[list[str], dict]:
    measured = references.COMPRESSED_PLATE
    model = cases.run(cases.compressed_plate(measured[0]), 3 if short else 1, 17 if short else 52)
    way = cases.path(model, 1, measured[:1])
    expect(distance(measured, way) < 1.0, "the crack goes where that of the experiment went")
    return [f"compressed plate: {distance(measured, way):.1f} mm from the experiment along {len(measured)} places over "
            f"{measured[0][0] - measured[-1][0]:.0f} mm"], {"way": way, "measured": measured}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--short", action="store_true")
    parser.add_argument("folder", nargs="?", default="out/crack_paths")
    options = parser.parse_args()
    drawn = {}
    for case in (two_holes, three_holes, edge_cracks, four_points, compressed_plate):
        start = time.process_time()
        lines, drawn[case.__name__] = case(options.short)
        print("\n".join(lines), f"    {time.process_time() - start:.1f} s", sep="\n", flush=True)
    if not options.short:
        import picture

        folder = pathlib.Path(options.folder)
        folder.mkdir(parents=True, exist_ok=True)
        print(f"wrote {picture.draw(drawn, folder)} and {picture.draw_experiment(drawn, folder)}")


if __name__ == "__main__":
    main()
