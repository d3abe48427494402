"""Smooth curves as chains of circular arcs, to a tolerance: pairs of arcs that keep the curve's tangents at their ends."""

from __future__ import annotations

import math
from typing import Callable, Optional, Sequence

import numpy as np
import numpy.typing as npt

from ._sketch import Place

FloatArray = npt.NDArray[np.float64]
#: Places and derivatives of a curve at parameters, both of shape (n, 2).
Curve = Callable[[FloatArray], tuple[FloatArray, FloatArray]]

SAMPLES = 24  # of a part of a curve that is compared with its two arcs
FINEST = 14  # times that a part is halved at most


def arcs_of(curve: Curve, breaks: Sequence[float], tolerance: float) -> tuple[list[Place], list[float], float]:
    """Places, bulges and the largest distance from a curve that is smooth between each two breaks."""
    places: list[Place] = []
    bulges: list[float] = []
    worst = 0.0
    for start, end in zip(breaks, breaks[1:]):
        # Halves first: a part that closes on itself has no pair of arcs.
        for a, b in ((start, 0.5 * (start + end)), (0.5 * (start + end), end)):
            deviation = add_arcs(curve, a, b, tolerance, FINEST, places, bulges)
            worst = max(worst, deviation)
    last = curve(np.array([breaks[-1]]))[0][0]
    places.append((float(last[0]), float(last[1])))
    return places, bulges, worst


def add_arcs(curve: Curve, start: float, end: float, tolerance: float, halvings: int, places: list[Place],
             bulges: list[float]) -> float:
    """Add the arcs of a part, without its last place; returns the distance from the curve."""
    points, slopes = curve(np.linspace(start, end, SAMPLES + 1))
    straight = distances_from_line(points)
    if straight <= 1e-9 * float(np.hypot(*(points[-1] - points[0]))):
        places.append((float(points[0][0]), float(points[0][1])))
        bulges.append(0.0)
        return straight
    for side, inner in ((0, start + 1e-4 * (end - start)), (-1, end - 1e-4 * (end - start))):
        # A control point that is given twice leaves no derivative at an end of a curve.
        if not np.hypot(*slopes[side]) > 1e-9 * float(np.hypot(*slopes.T).max()):
            slopes[side] = curve(np.array([inner]))[1][0]
    pair = biarc(points[0], slopes[0], points[-1], slopes[-1])
    deviation = math.inf if pair is None else distances_from_arcs(points, pair)
    if deviation <= tolerance or halvings == 0:
        joint, first, second = pair if pair is not None else (0.5 * (points[0] + points[-1]), 0.0, 0.0)
        places += [(float(points[0][0]), float(points[0][1])), (float(joint[0]), float(joint[1]))]
        bulges += [first, second]
        return deviation if pair is not None else straight
    middle = 0.5 * (start + end)
    return max(add_arcs(curve, start, middle, tolerance, halvings - 1, places, bulges),
               add_arcs(curve, middle, end, tolerance, halvings - 1, places, bulges))


def biarc(p: FloatArray, u: FloatArray, q: FloatArray, v: FloatArray) -> Optional[tuple[FloatArray, float, float]]:
    """Joint and bulges of two arcs from p in the direction u to q in the direction v, tangents of equal length.

    Source: Bolton, Biarc curves, Computer-Aided Design 7 (1975) 89-92.
    """
    if not (np.hypot(*u) > 0 and np.hypot(*v) > 0):
        return None
    u, v, w = u / np.hypot(*u), v / np.hypot(*v), q - p
    a, b, c = 2 * (1 - float(np.dot(u, v))), 2 * float(np.dot(w, u + v)), -float(np.dot(w, w))
    if abs(a) < 1e-12:
        if b <= 0:
            return None
        length = -c / b
    else:
        length = (-b + math.sqrt(b * b - 4 * a * c)) / (2 * a)
    joint = 0.5 * (p + length * u + q - length * v)
    return joint, bulge_of(p, u, joint), -bulge_of(q, -v, joint)


def bulge_of(start: FloatArray, direction: FloatArray, end: FloatArray) -> float:
    """Bulge of the arc that leaves a place in a direction and ends at another one."""
    chord = end - start
    # The angle between tangent and chord is half of what the arc turns.
    half = math.atan2(direction[0] * chord[1] - direction[1] * chord[0], float(np.dot(direction, chord)))
    return math.tan(half / 2)


def distances_from_line(points: FloatArray) -> float:
    """Largest distance of places from the line between the first and the last one."""
    along = points[-1] - points[0]
    length = float(np.hypot(*along))
    off = points - points[0]
    if length == 0:
        return float(np.hypot(*off.T).max())
    return float(np.abs(along[0] * off[:, 1] - along[1] * off[:, 0]).max()) / length


def distances_from_arcs(points: FloatArray, pair: tuple[FloatArray, float, float]) -> float:
    """Largest distance of places from the nearer of two arcs."""
    joint, first, second = pair
    return float(np.minimum(distances_from_arc(points, points[0], joint, first),
                            distances_from_arc(points, joint, points[-1], second)).max())


def distances_from_arc(points: FloatArray, start: FloatArray, end: FloatArray, bulge: float) -> FloatArray:
    """Distances of places from an arc or, where they lie beside its sector, from its nearer end."""
    ends: FloatArray = np.minimum(np.hypot(*(points - start).T), np.hypot(*(points - end).T))
    chord = end - start
    length = float(np.hypot(*chord))
    if length == 0:
        return ends
    along = (points - start) @ chord / length
    across = (chord[0] * (points - start)[:, 1] - chord[1] * (points - start)[:, 0]) / length
    if abs(bulge) < 1e-9:
        beside: FloatArray = np.where((along >= 0) & (along <= length), np.abs(across), ends)
        return beside
    # The centre is computed in the chord's frame: a positive bulge lies on the chord's right.
    height = length * (1 - bulge * bulge) / (4 * bulge)
    radius = length * (1 + bulge * bulge) / (4 * abs(bulge))
    offset_x, offset_y = along - length / 2, across - height
    swept = 4 * math.atan(abs(bulge))
    angle = np.abs(np.arctan2(offset_x, -math.copysign(1, bulge) * offset_y))
    distances: FloatArray = np.where(angle <= swept / 2 + 1e-12, np.abs(np.hypot(offset_x, offset_y) - radius), ends)
    return distances


def elliptic_arc(centre: Place, major: Place, minor: Place, start: float, end: float) -> Curve:
    """The curve centre + major cos t + minor sin t."""
    c, a, b = np.array(centre), np.array(major), np.array(minor)

    def at(t: FloatArray) -> tuple[FloatArray, FloatArray]:
        angle = (start + (end - start) * t)[:, None]
        return c + a * np.cos(angle) + b * np.sin(angle), (end - start) * (b * np.cos(angle) - a * np.sin(angle))

    return at


def circular_arc(centre: Place, radius: float, start: float, end: float) -> tuple[list[Place], list[float]]:
    """Places and bulges of an arc about a centre between two angles, counter-clockwise if the end is larger: in parts of at
    most a half circle."""
    parts = max(1, math.ceil(abs(end - start) / math.pi - 1e-9))
    angles = [start + (end - start) * k / parts for k in range(parts + 1)]
    return ([(centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)) for angle in angles],
            [math.tan((end - start) / parts / 4)] * parts)


def full_circle(centre: Place, radius: float) -> tuple[list[Place], list[float]]:
    """Places and bulges of a circle in four quarters, counter-clockwise."""
    sides = ((1, 0), (0, 1), (-1, 0), (0, -1), (1, 0))
    return [(centre[0] + radius * x, centre[1] + radius * y) for x, y in sides], [math.tan(math.pi / 8)] * 4


def bezier(points: Sequence[complex]) -> Curve:
    """The Bezier curve of three or four control points."""
    control = np.array([(one.real, one.imag) for one in points])
    degree = len(control) - 1

    def at(t: FloatArray) -> tuple[FloatArray, FloatArray]:
        return (bernstein(degree, t) @ control, degree * bernstein(degree - 1, t) @ np.diff(control, axis=0))

    return at


def bernstein(degree: int, t: FloatArray) -> FloatArray:
    """Polynomials of a Bezier curve at parameters, shape (n, degree + 1)."""
    return np.stack([math.comb(degree, k) * t**k * (1 - t)**(degree - k) for k in range(degree + 1)], axis=1)
