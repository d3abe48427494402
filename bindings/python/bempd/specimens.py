"""Standard specimens of fracture mechanics, each as one call, with the formula of its standard or handbook.

All are loaded by forces that balance each other, so supports only hold the body in its place. Lengths are in [m], forces
in [N], stresses in [Pa]; the load factor multiplies the load.

>>> import bempd
>>> specimen = bempd.specimens.compact_tension(width=0.05, crack=0.025, force=1000, thickness=0.0125)
>>> print(f"{specimen.difference():+.4f}, the formula holds within {specimen.formula.accuracy}")
-0.0039, the formula holds within 0.005
"""

from __future__ import annotations

import dataclasses
import math
from typing import Any, Callable, Optional, Sequence

from .errors import ArgumentError
from .model import Model
from .reports import CrackTip

Material = dict[str, float]
STEEL: Material = {"young_modulus": 210e9, "poisson_ratio": 0.3}


@dataclasses.dataclass(frozen=True)
class Formula:
    """What a standard or a handbook says of a specimen, at the load factor 1."""

    stress_intensity_1: float  #: K_I [Pa m^(1/2)]
    stress_intensity_2: float  #: K_II [Pa m^(1/2)]
    accuracy: float  #: as its source states it, a share of K; NaN where it states none
    source: str
    holds: bool = True  #: whether the source covers this shape


@dataclasses.dataclass
class Specimen:
    """A specimen as a model, with its formula."""

    model: Model
    material: int
    region: int
    cracks: list[int]
    load_case: int  #: of all loads
    formula: Formula

    def tips(self) -> list[CrackTip]:
        """Tips of the cracks under the load factor 1."""
        return self.model.combine({self.load_case: 1.0}).tips

    def difference(self) -> float:
        """Largest difference of a tip's factors from the formula's, as a share of its size."""
        known = math.hypot(self.formula.stress_intensity_1, self.formula.stress_intensity_2)
        largest = 0.0
        for tip in self.tips():
            parts = (tip.stress_intensity_1 - self.formula.stress_intensity_1,
                     abs(tip.stress_intensity_2) - abs(self.formula.stress_intensity_2))
            largest = max(parts + (largest,), key=abs)
        return largest / known


def _require(caller: str, **lengths: float) -> None:
    for name, value in lengths.items():
        if not (math.isfinite(value) and value > 0):
            raise ArgumentError(f"{caller}: {name} is {value:g}; it must be > 0")


def _below(caller: str, name: str, value: float, most: float, what: str) -> None:
    if not value < most:
        raise ArgumentError(f"{caller}: {name} is {value:g}; it must be below {what}, {most:g}")


class _Builder:
    """A plate whose material and thickness are known."""

    def __init__(self, outline: Sequence[tuple[float, float]], element_length: float, thickness: float,
                 material: Optional[Material], options: Optional[dict[str, Any]]) -> None:
        self.model = Model(options=options, log=None)
        self.material = self._material(thickness, {**STEEL, **(material or {})})
        self.region = self.model.add_bem_region(self.material, list(outline), element_length)
        self.cracks: list[int] = []
        self.loads: list[int] = []

    def _material(self, thickness: float, given: Material) -> int:
        numbers: dict[str, Any] = dict(given)
        return self.model.add_material(thickness=thickness, **numbers)

    def crack(self, *points: tuple[float, float]) -> None:
        self.cracks.append(self.model.add_crack(list(points)))

    def hold(self, first: tuple[float, float], second: tuple[float, float]) -> None:
        """Hold the body in its place at two corners that lie beside each other."""
        self.model.fix_point(first)
        self.model.fix_point(second, "y" if first[1] == second[1] else "x")

    def pull(self, top: int, bottom: int, stress: float) -> None:
        self.traction(top, stress)
        self.traction(bottom, -stress)

    def traction(self, edge: int, stress: float) -> None:
        self.loads.append(self.model.add_traction(self.region, edge, "y", stress))

    def pin(self, centre: tuple[float, float], radius: float, force: tuple[float, float], thickness: float, power: int = 1) -> int:
        """A hole with a force on the half towards which it points, as a pressure with a power of the cosine of the angle to it."""
        first_edge = self.model.add_circular_hole(self.region, centre, radius)
        size = math.hypot(*force)
        along = (force[0] / size, force[1] / size)
        share = math.sqrt(math.pi) * math.gamma(power / 2 + 1) / math.gamma(power / 2 + 1.5)
        peak = size / (share * radius * thickness)

        def traction(x: float, y: float) -> tuple[tuple[float, float], tuple[float, float]]:
            normal = ((x - centre[0]) / radius, (y - centre[1]) / radius)
            pressure = peak * max(0.0, normal[0] * along[0] + normal[1] * along[1])**power
            return (0.0, 0.0), (pressure * normal[0], pressure * normal[1])

        for edge in range(first_edge, first_edge + 4):
            self.loads.append(self.model.add_traction_function(self.region, edge, traction))
        return first_edge

    def done(self, formula: Formula) -> Specimen:
        case = self.model.add_load_case(self.loads)
        return Specimen(self.model, self.material, self.region, self.cracks, case, formula)


def middle_tension(*, width: float, crack: float, stress: float, height: Optional[float] = None, thickness: float = 1.0,
                   material: Optional[Material] = None, options: Optional[dict[str, Any]] = None) -> Specimen:
    """M(T): a strip of a `width` with a crack of this length in its middle, pulled by a `stress`.

    Tada, Paris and Irwin, The Stress Analysis of Cracks Handbook, section 2.1: 0.1 % for any length.
    """
    _require("middle_tension", width=width, crack=crack, stress=abs(stress))
    _below("middle_tension", "crack", crack, width, "the width")
    half, a, tall = width / 2, crack / 2, height or 3 * width
    builder = _Builder([(-half, -tall / 2), (half, -tall / 2), (half, tall / 2), (-half, tall / 2)], width / 8, thickness, material, options)
    builder.crack((-a, 0), (a, 0))
    builder.hold((-half, -tall / 2), (half, -tall / 2))
    builder.pull(3, 1, stress)
    ratio = a / half
    factor = (1 - 0.025 * ratio**2 + 0.06 * ratio**4) / math.sqrt(math.cos(math.pi * ratio / 2))
    return builder.done(Formula(stress * math.sqrt(math.pi * a) * factor, 0, 0.001, "Tada, Paris and Irwin, 2.1", tall >= 2 * width))


def edge_tension(*, width: float, crack: float, stress: float, height: Optional[float] = None, thickness: float = 1.0,
                 material: Optional[Material] = None, options: Optional[dict[str, Any]] = None) -> Specimen:
    """SENT: a strip with a crack from its left edge, pulled by a uniform `stress`; its ends turn freely.

    Tada, Paris and Irwin, section 2.10: 0.5 % for any length.
    """
    _require("edge_tension", width=width, crack=crack, stress=abs(stress))
    _below("edge_tension", "crack", crack, width, "the width")
    tall = height or 4 * width
    builder = _Builder([(0, -tall / 2), (width, -tall / 2), (width, tall / 2), (0, tall / 2)], width / 6, thickness, material, options)
    builder.crack((0, 0), (crack, 0))
    builder.hold((0, -tall / 2), (width, -tall / 2))
    builder.pull(3, 1, stress)
    x = math.pi * crack / (2 * width)
    factor = math.sqrt(math.tan(x) / x) * (0.752 + 2.02 * crack / width + 0.37 * (1 - math.sin(x))**3) / math.cos(x)
    return builder.done(Formula(stress * math.sqrt(math.pi * crack) * factor, 0, 0.005, "Tada, Paris and Irwin, 2.10", tall >= 3 * width))


def double_edge_tension(*, width: float, crack: float, stress: float, height: Optional[float] = None, thickness: float = 1.0,
                        material: Optional[Material] = None, options: Optional[dict[str, Any]] = None) -> Specimen:
    """DENT: a strip of a `width` with a crack of this length from each edge, pulled by a `stress`.

    Tada, Paris and Irwin, section 2.6: 0.5 % for any length.
    """
    _require("double_edge_tension", width=width, crack=crack, stress=abs(stress))
    _below("double_edge_tension", "crack", crack, width / 2, "half the width")
    half, tall = width / 2, height or 3 * width
    builder = _Builder([(-half, -tall / 2), (half, -tall / 2), (half, tall / 2), (-half, tall / 2)], width / 8, thickness, material, options)
    builder.crack((-half, 0), (crack - half, 0))
    builder.crack((half - crack, 0), (half, 0))
    builder.hold((-half, -tall / 2), (half, -tall / 2))
    builder.pull(3, 1, stress)
    x = math.pi * crack / (2 * half)
    factor = math.sqrt(math.tan(x) / x) * (1 + 0.122 * math.cos(x)**4)
    return builder.done(Formula(stress * math.sqrt(math.pi * crack) * factor, 0, 0.005, "Tada, Paris and Irwin, 2.6", tall >= 2 * width))


def compact_tension(*, width: float, crack: float, force: float, thickness: float, material: Optional[Material] = None,
                    options: Optional[dict[str, Any]] = None) -> Specimen:
    """C(T) of ASTM E399: `width` and `crack` count from the line through the pins, whose holes have a quarter of the width.

    The pins of E399 are smaller than their holes: they press on about 10 degrees to each side, as the 32nd power of the cosine.
    ASTM E399, by Srawley: 0.5 % for cracks from 0.2 of the width on.
    """
    _require("compact_tension", width=width, crack=crack, force=abs(force), thickness=thickness)
    _below("compact_tension", "crack", crack, width, "the width")
    w = width
    builder = _Builder([(-0.25 * w, -0.6 * w), (w, -0.6 * w), (w, 0.6 * w), (-0.25 * w, 0.6 * w)], w / 10, thickness, material, options)
    for side in (1, -1):
        builder.pin((0.0, side * 0.275 * w), 0.125 * w, (0.0, side * force), thickness, power=32)
    builder.crack((-0.25 * w, 0), (crack, 0))
    builder.hold((w, -0.6 * w), (w, 0.6 * w))
    a = crack / w
    factor = (2 + a) * (0.886 + 4.64 * a - 13.32 * a**2 + 14.72 * a**3 - 5.6 * a**4) / (1 - a)**1.5
    return builder.done(Formula(force / (thickness * math.sqrt(w)) * factor, 0, 0.005, "ASTM E399 (Srawley 1976)", a >= 0.2 - 1e-12))


def _beam(outline: Sequence[tuple[float, float]], width: float, crack: float, thickness: float, material: Optional[Material],
          options: Optional[dict[str, Any]]) -> _Builder:
    builder = _Builder(outline, width / 6, thickness, material, options)
    builder.crack((0, 0), (0, crack))
    return builder


def three_point_bend(*, width: float, crack: float, force: float, thickness: float, material: Optional[Material] = None,
                     options: Optional[dict[str, Any]] = None) -> Specimen:
    """SE(B): a beam of the height `width` on a span of four times that, with a crack from below, loaded in its middle.

    ASTM E399, by Srawley: 0.5 % for any length. Below 0.25 of the width it leaves out that the middle force is concentrated.
    Forces act on 0.005 of the width.
    """
    _require("three_point_bend", width=width, crack=crack, force=abs(force), thickness=thickness)
    _below("three_point_bend", "crack", crack, width, "the width")
    w, part, end = width, 0.0025 * width, 2.2 * width
    builder = _beam([(-end, 0), (-2 * w - part, 0), (-2 * w + part, 0), (2 * w - part, 0), (2 * w + part, 0), (end, 0), (end, w), (part, w),
                     (-part, w), (-end, w)], w, crack, thickness, material, options)
    pressure = force / (2 * part * thickness)
    builder.traction(8, -pressure)
    for edge in (2, 4):
        builder.traction(edge, pressure / 2)
    builder.hold((-end, 0), (end, 0))
    a = crack / w
    factor = 3 * math.sqrt(a) * (1.99 - a * (1 - a) * (2.15 - 3.93 * a + 2.7 * a**2)) / (2 * (1 + 2 * a) * (1 - a)**1.5)
    return builder.done(Formula(4 * force / (thickness * math.sqrt(w)) * factor, 0, 0.005, "ASTM E399 (Srawley 1976)"))


def four_point_bend(*, width: float, crack: float, force: float, thickness: float, inner: Optional[float] = None,
                    outer: Optional[float] = None, material: Optional[Material] = None,
                    options: Optional[dict[str, Any]] = None) -> Specimen:
    """A beam of the height `width` with a crack from below, between two forces of half the `force` above, `inner` apart, and two
    below, `outer` apart; by default 4 and 8 times the width.

    Tada, Paris and Irwin, section 2.13, for pure bending: 0.2 % up to 0.6 of the width, where the inner forces lie far apart.
    """
    _require("four_point_bend", width=width, crack=crack, force=abs(force), thickness=thickness)
    _below("four_point_bend", "crack", crack, width, "the width")
    near, far = (inner or 4 * width) / 2, (outer or 8 * width) / 2
    _below("four_point_bend", "inner", 2 * near, 2 * far, "outer")
    w, part, end = width, 0.0025 * width, far + 0.2 * width
    builder = _beam([(-end, 0), (-far - part, 0), (-far + part, 0), (far - part, 0), (far + part, 0), (end, 0), (end, w), (near + part, w),
                     (near - part, w), (-near + part, w), (-near - part, w), (-end, w)], w, crack, thickness, material, options)
    pressure = force / 2 / (2 * part * thickness)
    for edge in (8, 10):
        builder.traction(edge, -pressure)
    for edge in (2, 4):
        builder.traction(edge, pressure)
    builder.hold((-end, 0), (end, 0))
    stress = 6 * (force / 2 * (far - near)) / (thickness * w**2)
    r = crack / w
    factor = 1.122 - 1.40 * r + 7.33 * r**2 - 13.08 * r**3 + 14.0 * r**4
    return builder.done(Formula(stress * math.sqrt(math.pi * crack) * factor, 0, 0.002, "Tada, Paris and Irwin, 2.13", near >= 2 * w and crack <= 0.6 * w))


def double_cantilever(*, height: float, crack: float, force: float, thickness: float, length: Optional[float] = None,
                      material: Optional[Material] = None, options: Optional[dict[str, Any]] = None) -> Specimen:
    """DCB: two arms of this `height`, split by a `crack` from the left end on, where a `force` pulls them apart.

    Foote and Buchwald, Int. J. Fract. 29, 1985: 1.1 % for any length of the crack, with a long rest ahead of it.
    """
    _require("double_cantilever", height=height, crack=crack, force=abs(force), thickness=thickness)
    h, a = height, crack
    end = length or a + 6 * h
    _below("double_cantilever", "crack", a, end, "the length")
    builder = _Builder([(0, -h), (end, -h), (end, h), (0, h)], h / 3, thickness, material, options)
    builder.crack((0, 0), (a, 0))
    builder.hold((end, -h), (end, h))
    # The force acts as the shear of a beam theory, spread over the end of each arm as a parabola.
    peak = 1.5 * force / (h * thickness)

    def traction(x: float, y: float) -> tuple[tuple[float, float], tuple[float, float]]:
        s = abs(y) / h
        return (0.0, 0.0), (0.0, math.copysign(4 * peak * s * (1 - s), y))

    builder.loads.append(builder.model.add_traction_function(builder.region, 4, traction))
    ratio = a / h
    factor = math.sqrt(12) * (ratio + 0.673) + math.sqrt(2 / (math.pi * ratio)) - 1 / (0.815 * ratio**0.619 + 0.429)
    return builder.done(Formula(force / (thickness * math.sqrt(h)) * factor, 0, 0.011, "Foote and Buchwald 1985", end - a >= 4 * h))


def compact_tension_shear(*, width: float, crack: float, force: float, angle: float, thickness: float,
                          material: Optional[Material] = None, options: Optional[dict[str, Any]] = None) -> Specimen:
    """CTS of Richard: pulled at an `angle` [rad] to the normal of the crack, 0 mode I and pi/2 mode II, by three pins on each side.

    Richard, 1985, for cracks of 0.5 to 0.7 of the width; the source states no accuracy.
    """
    _require("compact_tension_shear", width=width, crack=crack, force=abs(force), thickness=thickness)
    _below("compact_tension_shear", "crack", crack, width, "the width")
    if not 0 <= angle <= math.pi / 2:
        raise ArgumentError(f"compact_tension_shear: angle is {angle:g}; it must lie between 0 and pi/2")
    w, tall, b, c = width, width * 148 / 90, width * 54 / 90, width * 54 / 90
    builder = _Builder([(0, -tall / 2), (w, -tall / 2), (w, tall / 2), (0, tall / 2)], w / 9, thickness, material, options)
    pull, shear = force * math.cos(angle), force * math.sin(angle)
    radius = w * 8.5 / 90
    for side in (1, -1):
        # The moment of the sheared middle pins about the crack is taken by the outer ones.
        for place, fx, fy in ((w / 2 - b / 2, 0.0, pull / 2 - shear * c / b * side), (w / 2, shear, 0.0),
                              (w / 2 + b / 2, 0.0, pull / 2 + shear * c / b * side)):
            if fx == 0 and fy == 0:
                continue
            builder.pin((place, side * c), radius, (side * fx, side * fy), thickness)
    builder.crack((0, 0), (crack, 0))
    builder.hold((w, -tall / 2), (w, tall / 2))
    r = crack / (w - crack)
    nominal = math.sqrt(math.pi * crack) / (w * thickness) / (1 - crack / w)
    one = pull * nominal * math.sqrt((0.26 + 2.65 * r) / (1 + 0.55 * r - 0.08 * r**2))
    two = shear * nominal * math.sqrt((-0.23 + 1.40 * r) / (1 - 0.67 * r + 2.08 * r**2))
    return builder.done(Formula(one, two, math.nan, "Richard 1985", 0.5 <= crack / w <= 0.7))


def cracked_hole(*, radius: float, crack: float, stress: float, cracks: int = 2, width: Optional[float] = None,
                 thickness: float = 1.0, material: Optional[Material] = None,
                 options: Optional[dict[str, Any]] = None) -> Specimen:
    """A hole in a wide plate with one or two cracks of this length across the pull.

    The numbers of Bowie, J. Math. Phys. 35, 1956, as fitted by Grandt; the fit states no accuracy.
    """
    _require("cracked_hole", radius=radius, crack=crack, stress=abs(stress))
    if cracks not in (1, 2):
        raise ArgumentError(f"cracked_hole: cracks is {cracks}; it must be 1 or 2")
    half = (width or 60 * (radius + crack)) / 2
    _below("cracked_hole", "radius + crack", radius + crack, half, "half the width")
    builder = _Builder([(-half, -half), (half, -half), (half, half), (-half, half)], half / 4, thickness, material, options)
    builder.model.add_circular_hole(builder.region, (0, 0), radius)
    builder.crack((radius, 0), (radius + crack, 0))
    if cracks == 2:
        builder.crack((-radius - crack, 0), (-radius, 0))
    builder.hold((-half, -half), (half, -half))
    builder.pull(3, 1, stress)
    ratio = crack / radius
    factor = 0.6762 + 0.8734 / (0.3246 + ratio) if cracks == 1 else 0.9439 + 0.6865 / (0.2772 + ratio)
    return builder.done(Formula(stress * math.sqrt(math.pi * crack) * factor, 0, math.nan, "Bowie 1956, fitted by Grandt",
                                half >= 20 * (radius + crack)))


def lug(*, width: float, hole: float, crack: float, force: float, thickness: float, material: Optional[Material] = None,
        options: Optional[dict[str, Any]] = None) -> Specimen:
    """A lug with a round head and a hole of this diameter, pulled by a pin that fits, with a crack from the hole across the pull.

    No source of a formula with an accuracy was at hand. What stands for it is the limit of a short crack, an edge crack under the
    stress that the lug without it has there: within 2 % up to a 300th of the hole.
    """
    _require("lug", width=width, hole=hole, crack=crack, force=abs(force), thickness=thickness)
    _below("lug", "hole / 2 + crack", hole / 2 + crack, width / 2, "half the width")

    def body(cracked: bool) -> _Builder:
        half = width / 2
        builder = _Builder([(-half, -2 * width), (half, -2 * width), (half, 0), (-half, 0)], width / 8, thickness, material, options)
        builder.model.set_edge_arc(builder.region, 3, (0, half))
        first_edge = builder.pin((0.0, 0.0), hole / 2, (0.0, force), thickness)
        builder.traction(1, -force / (width * thickness))
        if cracked:
            builder.crack((hole / 2, 0), (hole / 2 + crack, 0))
        for edge in range(first_edge, first_edge + (0 if cracked else 4)):
            builder.model.set_edge_mesh(builder.region, edge, hole / 100)
        builder.hold((-half, -2 * width), (half, -2 * width))
        return builder

    whole = body(False)
    whole.model.step(1.0)
    stresses = whole.model.evaluate([(hole / 2, 0.0)]).stress
    assert stresses is not None
    stress = float(stresses[0][1])
    return body(True).done(Formula(1.1215 * stress * math.sqrt(math.pi * crack), 0, math.nan, "limit of a short crack",
                                   crack <= 1.001 * hole / 300))


#: All kinds by their short names.
KINDS: dict[str, Callable[..., Specimen]] = {
    "M(T)": middle_tension, "SENT": edge_tension, "DENT": double_edge_tension, "C(T)": compact_tension, "SE(B)": three_point_bend,
    "four-point bend": four_point_bend, "DCB": double_cantilever, "CTS": compact_tension_shear, "cracked hole": cracked_hole, "lug": lug,
}
