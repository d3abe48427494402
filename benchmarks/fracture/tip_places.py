"""Where tips of initial cracks in lattices are felt, over their places within a spacing and the direction of the crack."""

from __future__ import annotations

import math
import random

import bempd

CRACK, HALF = 15.0, 36
PLACES = 10


def felt(horizon_ratio: int, degrees: float, tip: tuple[float, float], rule: str, shear: bool, outlined: bool,
         poisson: float) -> float:
    """How far ahead the tip is felt, in spacings, in a square of lattice under tension across the crack or shear along it."""
    model = bempd.Model(options={"threads": 1, "crack.rule": rule})
    material = model.add_material(young_modulus=1, poisson_ratio=poisson)
    plate = model.add_pd_region(material, bempd.rectangle(-HALF, -HALF, HALF, HALF), 1, horizon_ratio,
                                lattice_angle=-math.radians(degrees) if outlined else 0.0)
    angle = 0.0 if outlined else math.radians(degrees)
    along, across = (math.cos(angle), math.sin(angle)), (-math.sin(angle), math.cos(angle))
    end = tuple(round(CRACK * t) + p for t, p in zip(along, tip))
    model.add_crack([tuple(e - 2 * CRACK * t for e, t in zip(end, along)), end])
    model.fix_point((-HALF, -HALF))
    model.fix_point((HALF, -HALF), "y")
    for edge, normal in ((1, (0, -1)), (2, (1, 0)), (3, (0, 1)), (4, (-1, 0))):
        on_across, on_along = (sum(n * d for n, d in zip(normal, of)) for of in (across, along))
        for component in (0, 1):
            value = on_across * across[component]
            if shear:
                value = on_across * along[component] + on_along * across[component]
            if abs(value) > 1e-12:
                model.add_traction(plate, edge, "xy"[component], value)
    model.step(1)
    return min(model.tips(), key=lambda found: math.dist((found.x, found.y), end)).felt_ahead


def places(degrees: float) -> list[tuple[float, float]]:
    """Within a spacing, none on the way of a point; along rows and diagonals half-way between them."""
    steps = [(k + 0.03) / PLACES for k in range(PLACES)]
    if degrees == 0:
        return [(s, 0.5) for s in steps]
    if degrees == 45:
        return [(s, s + 0.5) for s in steps]
    chance = random.Random(1)
    return [(chance.random(), chance.random()) for _ in steps]


def spread(horizon_ratio: int, degrees: float, rule: str, shear: bool = False, outlined: bool = False,
           poisson: float = 1 / 3) -> str:
    found = [felt(horizon_ratio, degrees, place, rule, shear, outlined, poisson) for place in places(degrees)]
    return f"{min(found):+.2f} to {max(found):+.2f}"


def section() -> str:
    lines = [f"Tips of cracks of {2 * CRACK:g} spacings, {PLACES} places within a spacing for each row of the table: least and "
             "largest\ndistance ahead of the described place at which they are felt, in spacings: *ahead* by `crack.rule` = `bond`, *stated* by "
             "`line`. What is counted is stiffness across the crack, so that under shear, which other bonds bear, tips are felt further ahead.",
             "",
             "| direction from the rows | horizon | ahead | stated | stated, sheared |", "|---|---|---|---|---|"]
    for degrees in (0.0, 15.0, 30.0, 45.0):
        for m in (3, 4, 5, 6):
            lines.append(f"| {degrees:g} degrees | {m} | {spread(m, degrees, 'bond')} | {spread(m, degrees, 'line')} | "
                         f"{spread(m, degrees, 'line', shear=True)} |")
    for name, outlined, poisson in (("rows turned by -20 degrees", True, 1 / 3), ("30 degrees, ratio 0", False, 0.0),
                                    ("30 degrees, ratio 0.45", False, 0.45)):
        degrees = 20.0 if outlined else 30.0
        lines.append(f"| {name} | 4 | " + " | ".join(
            spread(4, degrees, rule, shear, outlined, poisson)
            for rule, shear in (("bond", False), ("line", False), ("line", True))) + " |")
    return "\n".join(lines)


if __name__ == "__main__":
    print(section())
