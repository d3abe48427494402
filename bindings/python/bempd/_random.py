"""Random bodies from seeds: fields with a correlation length, Weibull strengths, cracks. A seed gives the same everywhere."""

from __future__ import annotations

import math
from typing import List, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _arguments as arguments
from .errors import ArgumentError

FloatArray = npt.NDArray[np.float64]
Segment = List[Tuple[float, float]]

STEPS_IN_A_LENGTH = 4  # of the grid of a field, in a correlation length
LARGEST_FIELD = 4_000_000  # places
TRIES = 2000  # for the place of one crack


def random_field(seed: int, box: Sequence[float], correlation_length: float, *,
                 spacing: Optional[float] = None) -> tuple[FloatArray, FloatArray]:
    """A random field: places (n, 2) on a grid over a box, and a value for each, normal with mean 0 and deviation 1.

    box                 (left, bottom, right, top) [m]
    correlation_length  values at a distance r have the correlation exp(-(r / correlation_length)^2) [m]
    spacing             of the grid; a quarter of the correlation length if not given

    Values at places between are those of set_toughness_at(): linear. Equal seeds give equal values with any version of numpy.

    >>> import bempd
    >>> places, values = bempd.random_field(7, (0, 0, 0.1, 0.05), correlation_length=0.02)
    >>> places.shape, values.shape
    ((231, 2), (231,))
    """
    length = positive("random_field: correlation_length", correlation_length)
    grid = Grid("random_field", box, length / STEPS_IN_A_LENGTH if spacing is None else positive("random_field: spacing", spacing))
    across, up = kernel(length, grid.steps[0]), kernel(length, grid.steps[1])
    noise = generator("random_field", seed).standard_normal((grid.rows + len(up), grid.columns + len(across)))
    smooth = np.apply_along_axis(np.convolve, 1, noise, across, "valid")
    smooth = np.apply_along_axis(np.convolve, 0, smooth, up, "valid")
    return grid.places(), np.asarray(smooth.ravel(), dtype=np.float64)


def weibull_field(seed: int, box: Sequence[float], correlation_length: float, *, modulus: float, strength: float = 1.0,
                  volume: Optional[float] = None, thickness: float = 1.0) -> tuple[FloatArray, FloatArray]:
    """Strengths of a material with Weibull statistics, at places on a grid over a box whose steps are the correlation length.

    A body of volume V fails below the stress s with the probability 1 - exp(-(V / volume) (s / strength)^modulus). Each
    place has an independent strength by this law, V being its part of the box: so the weakest place of the box follows it
    too, for any box and any grid. Between places strengths are linear, which no place of its own is below.

    correlation_length  step of the grid, rounded so that steps fit into the box [m]
    modulus    Weibull modulus m
    strength   characteristic strength of a body of `volume`, which 63 of 100 do not reach
    volume     [m^3]; that of one step by one step of the grid if not given
    thickness  of the plate [m]

    The fracture energy that belongs to a strength goes with its square:

    >>> import bempd
    >>> model = bempd.Model(log=None)
    >>> glass = model.add_material(young_modulus=70e9, poisson_ratio=1 / 3, fracture_energy=8)
    >>> plate = model.add_pd_region(glass, bempd.rectangle(0, 0, 0.02, 0.02), spacing=0.001)
    >>> places, strengths = bempd.weibull_field(3, (0, 0, 0.02, 0.02), 0.002, modulus=8)
    >>> model.set_toughness_at(plate, places, 8 * strengths**2)
    """
    m, scale = positive("weibull_field: modulus", modulus), positive("weibull_field: strength", strength)
    grid = Grid("weibull_field", box, positive("weibull_field: correlation_length", correlation_length))
    across, up = grid.shares()
    cell = grid.steps[0] * grid.steps[1] * positive("weibull_field: thickness", thickness)
    reference = cell if volume is None else positive("weibull_field: volume", volume)
    beyond = -np.log1p(-generator("weibull_field", seed).random_sample((len(up), len(across))))
    return grid.places(), scale * (beyond.ravel() * reference / (cell * np.outer(up, across).ravel())) ** (1 / m)


def random_cracks(seed: int, box: Sequence[float], *, length: Union[float, Sequence[float]], count: Optional[int] = None,
                  density: Optional[float] = None, exponent: float = 0.0, apart: Optional[float] = None) -> list[Segment]:
    """Straight cracks at random places and in random directions, inside a box, none near another.

    length    of all [m], or the least and the largest of lengths whose density falls as length^-exponent
    count     number of cracks, or
    density   number for each area [1/m^2]: the number is then random as well (Poisson)
    apart     least distance of a crack from others and from the sides of the box [m]; a quarter of the least length if
              not given

    >>> import bempd
    >>> for crack in bempd.random_cracks(1, (0, 0, 1, 1), count=2, length=(0.1, 0.4), exponent=4):
    ...     print([(round(x, 3), round(y, 3)) for x, y in crack])
    [(0.057, 0.12), (0.128, 0.253)]
    [(0.382, 0.481), (0.412, 0.597)]
    """
    left, bottom, right, top = sides_of("random_cracks", box)
    least, largest = arguments.interval("random_cracks: length", length)
    if not 0 < least <= largest < math.hypot(right - left, top - bottom):
        raise ArgumentError(f"random_cracks: length is {length!r}; lengths must be above 0 and fit into the box")
    gap = 0.25 * least if apart is None else positive("random_cracks: apart", apart)
    random = generator("random_cracks", seed)
    if (count is None) == (density is None):
        raise ArgumentError("random_cracks: give either count or density")
    number = int(random.poisson(positive("random_cracks: density", density) * (right - left) * (top - bottom))) if count is None else \
        arguments.whole("random_cracks: count", count)
    # The longest find room first.
    lengths = sorted((power_law(random.random_sample(), least, largest, exponent) for _ in range(number)), reverse=True)
    placed: list[Segment] = []
    for one in lengths:
        for _ in range(TRIES):
            x, y = left + (right - left) * random.random_sample(), bottom + (top - bottom) * random.random_sample()
            angle = math.pi * random.random_sample()
            dx, dy = 0.5 * one * math.cos(angle), 0.5 * one * math.sin(angle)
            crack = [(x - dx, y - dy), (x + dx, y + dy)]
            inside = all(left + gap <= px <= right - gap and bottom + gap <= py <= top - gap for px, py in crack)
            if inside and all(distance(crack, other) >= gap for other in placed):
                placed.append(crack)
                break
        else:
            raise ArgumentError(f"random_cracks: no room is left after {len(placed)} of {number} cracks; give fewer, shorter ones, or a "
                                "smaller distance `apart`")
    return placed


class Grid:
    """Places at equal steps over a box, row by row from below, the sides included."""

    def __init__(self, caller: str, box: Sequence[float], step: float) -> None:
        self._sides = left, bottom, right, top = sides_of(caller, box)
        self.columns, self.rows = (max(1, math.ceil(extent / step - 1e-9)) for extent in (right - left, top - bottom))
        if (self.columns + 1) * (self.rows + 1) > LARGEST_FIELD:
            raise ArgumentError(f"{caller}: the grid has {self.columns + 1} x {self.rows + 1} places; give a larger spacing or correlation length")
        self.steps = (right - left) / self.columns, (top - bottom) / self.rows

    def places(self) -> FloatArray:
        left, bottom, right, top = self._sides
        x, y = np.meshgrid(np.linspace(left, right, self.columns + 1), np.linspace(bottom, top, self.rows + 1))
        return np.column_stack((x.ravel(), y.ravel()))

    def shares(self) -> tuple[FloatArray, FloatArray]:
        """Parts of a step that belong to the places of a row and of a column: a half at the sides."""
        return tuple(np.r_[0.5, np.ones(count - 1), 0.5] for count in (self.columns, self.rows))  # type: ignore[return-value]


def power_law(share: float, least: float, largest: float, exponent: float) -> float:
    """The length below which a share of all lies, for a density length^-exponent."""
    if least == largest:
        return least
    power = 1 - exponent
    if abs(power) < 1e-12:
        return float(least * (largest / least) ** share)
    return float((least**power + share * (largest**power - least**power)) ** (1 / power))


def distance(one: Segment, other: Segment) -> float:
    """Least distance of two segments; 0 if they cross."""
    (a, b), (c, d) = one, other
    if turn(a, b, c) * turn(a, b, d) < 0 and turn(c, d, a) * turn(c, d, b) < 0:
        return 0.0
    return min(to_segment(a, other), to_segment(b, other), to_segment(c, one), to_segment(d, one))


def turn(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def to_segment(p: tuple[float, float], segment: Segment) -> float:
    (ax, ay), (bx, by) = segment
    along = (bx - ax, by - ay)
    part = ((p[0] - ax) * along[0] + (p[1] - ay) * along[1]) / (along[0] ** 2 + along[1] ** 2)
    part = min(max(part, 0.0), 1.0)
    return math.hypot(p[0] - ax - part * along[0], p[1] - ay - part * along[1])


def kernel(length: float, step: float) -> FloatArray:
    """Weights of white noise that make the correlation exp(-(r / length)^2) and the deviation 1."""
    reach = math.ceil(2.2 * length / step)
    weights = np.exp(-2 * (np.arange(-reach, reach + 1) * step / length) ** 2)
    return np.asarray(weights / np.sqrt(np.sum(weights**2)), dtype=np.float64)


def generator(caller: str, seed: int) -> np.random.RandomState:
    """Numbers that are the same with every version of numpy."""
    if isinstance(seed, (bool, float)) or not isinstance(seed, (int, np.integer)) or not 0 <= seed < 2**32:
        raise ArgumentError(f"{caller}: seed is {seed!r}; give a whole number from 0 to 4294967295")
    return np.random.RandomState(int(seed))


def sides_of(caller: str, box: Sequence[float]) -> tuple[float, float, float, float]:
    """Left, bottom, right and top."""
    sides = arguments.real_array(f"{caller}: box", box)
    if sides.shape != (4,) or not np.all(np.isfinite(sides)) or not (sides[0] < sides[2] and sides[1] < sides[3]):
        raise ArgumentError(f"{caller}: box is {box!r}; give (left, bottom, right, top) with left < right and bottom < top")
    left, bottom, right, top = (float(side) for side in sides)
    return left, bottom, right, top


def positive(name: str, value: Optional[float]) -> float:
    """A number above 0."""
    number = arguments.real(name, value)
    if not (math.isfinite(number) and number > 0):
        raise ArgumentError(f"{name} is {value!r}; it must be a number above 0")
    return number
