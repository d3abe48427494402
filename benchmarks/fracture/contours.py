"""Contour integrals around the tip of a crack in a lattice, through the lattice and through boundary elements around it: J by
the energy density, K by interaction with Williams' terms, and how little they depend on the contour."""

from __future__ import annotations

import math
from typing import Callable

import bempd
import lattice
import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
POISSON = 1 / 3  # plane stress, Young's modulus 1
KAPPA = (3 - POISSON) / (1 + POISSON)
SHEAR = 0.5 / (1 + POISSON)


class Field:
    """Stress [n, 2, 2] at places and the slope [n, 2] of displacement in a direction."""

    def __init__(self, stress: Array, slope: Array) -> None:
        self.stress, self.slope = stress, slope


def of_model(model: bempd.Model, places: Array, along: Array, step: float) -> Field:
    """The slope by the difference over `step` to either side, which crosses no crack that runs along."""
    found = model.evaluate(places).stress
    stress = np.stack([found[:, 0], found[:, 2], found[:, 2], found[:, 1]], axis=1).reshape(-1, 2, 2)
    ahead, behind = (model.evaluate(places + sign * step * along).displacement for sign in (1, -1))
    return Field(stress, (ahead - behind) / (2 * step))


def of_williams(mode: int, angle: float, tip: Array, places: Array, along: Array) -> Field:
    """K = 1 at a tip whose crack points in the direction `angle`."""
    displacement, step = williams(mode, angle, tip), 1e-6 * float(np.abs(places - tip).max())
    gradient = np.stack([(displacement(places + step * d) - displacement(places - step * d)) / (2 * step) for d in np.eye(2)],
                        axis=2)
    strain = 0.5 * (gradient + gradient.transpose(0, 2, 1))
    trace = np.trace(strain, axis1=1, axis2=2)
    stress = (strain + POISSON / (1 - POISSON) * trace[:, None, None] * np.eye(2)) / (1 + POISSON)
    return Field(stress, np.einsum("nij,nj->ni", gradient, along))


def williams(mode: int, angle: float, tip: Array) -> Callable[[Array], Array]:
    """Displacement of K = 1 at a tip whose crack points in the direction `angle`."""
    turn = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])

    def displacement(places: Array) -> Array:
        x, y = turn @ (places - tip).T
        r, half = np.hypot(x, y), 0.5 * np.arctan2(y, x)
        s, c = np.sin(half), np.cos(half)
        local = ((c * (KAPPA - 1 + 2 * s**2), s * (KAPPA + 1 - 2 * c**2)) if mode == 1 else
                 (s * (KAPPA + 1 + 2 * c**2), -c * (KAPPA - 1 - 2 * s**2)))
        return (np.sqrt(r / (2 * math.pi)) / (2 * SHEAR) * np.array(local)).T @ turn

    return displacement


def square(centre: Array, half: float, piece: float, angle: float = 0) -> tuple[Array, Array, float]:
    """Middles of pieces of its outline, their outward normals and their length; it starts and ends on the negative x axis."""
    count = 2 * max(1, round(half / piece))
    way = (np.arange(count) + 0.5) / count * 2 - 1
    ones = np.ones(count)
    sides = ((np.stack([ones, way], 1), (1, 0)), (np.stack([way, ones], 1), (0, 1)), (np.stack([-ones, way], 1), (-1, 0)),
             (np.stack([way, -ones], 1), (0, -1)))
    places = np.concatenate([side for side, _ in sides]) * half
    normals = np.concatenate([np.tile(np.array(n, float), (count, 1)) for _, n in sides])
    turn = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
    return places @ turn + centre, normals @ turn, 2 * half / count


def flow(one: Field, two: Field, normals: Array, along: Array) -> Array:
    """Of the material force in the directions `along` [n, 2], of two fields together: with both alike twice that of one."""
    trace = np.trace(two.stress, axis1=1, axis2=2)
    strain = (1 + POISSON) * two.stress - POISSON * trace[:, None, None] * np.eye(2)
    energy = np.einsum("nij,nij->n", one.stress, strain)
    work = (np.einsum("nij,nj,ni->n", one.stress, normals, two.slope)
            + np.einsum("nij,nj,ni->n", two.stress, normals, one.slope))
    return energy * np.einsum("nj,nj->n", normals, along) - work


def through_lattice(model: bempd.Model, tip: bempd.CrackTip, half: float, spacing: float) -> tuple[float, float, float]:
    """J, K_I and K_II of a square around the place where a tip is felt, through the lattice."""
    direction = np.array([tip.direction_x, tip.direction_y])
    angle, place = math.atan2(direction[1], direction[0]), np.array([tip.x, tip.y])
    places, normals, piece = square(place, half, spacing, angle)
    along = np.tile(direction, (len(places), 1))
    own = of_model(model, places, along, spacing)
    rate = 0.5 * piece * flow(own, own, normals, along).sum()
    others = (of_williams(mode, angle, place + tip.felt_ahead * direction, places, along) for mode in (1, 2))
    one, two = (0.5 * piece * flow(own, other, normals, along).sum() for other in others)
    return rate, one, two


def around_crack(model: bempd.Model, half: float, length: float) -> float:
    """G of the tips of a crack of half length `length` around the origin, by Knowles' and Sternberg's integral over a square
    in the boundary elements around the lattice."""
    places, normals, piece = square(np.zeros(2), half, half / 400)
    own = of_model(model, places, places, 1e-5)
    return float(0.5 * piece * flow(own, own, normals, places).sum() / (2 * length))


Found = tuple[float, float, float]


def row(name: str, contour: str, found: Found) -> str:
    return f"| {name} | {contour} | {found[0]:+.2e} | {found[1]:+.2e} | {found[2]:+.2e} |"


def against(found: Found, of: bempd.CrackTip) -> Found:
    """J relative to G, the factors relative to both together."""
    size = math.hypot(of.stress_intensity_1, of.stress_intensity_2)
    return (found[0] / of.energy_release_rate - 1, (found[1] - of.stress_intensity_1) / size,
            (found[2] - of.stress_intensity_2) / size)


def section() -> str:
    lines = ["| crack | contour | J | K_I | K_II |", "|---|---|---|---|---|"]
    for name, case, horizon in (("centre crack, through the lattice", lattice.centre(40), 4),
                                ("inclined, 45 degrees, through the lattice", lattice.inclined(45, 40), 4)):
        plate, spacing = case
        model = plate.model(spacing, horizon)
        model.step(1)
        tips = model.tips()
        felt = lattice.reference(plate, (tips[0].felt_ahead, tips[1].felt_ahead))
        values = []
        for cells in (8, 12, 16, 24, 32):
            values.append(against(through_lattice(model, tips[1], cells * spacing, spacing), felt))
            lines.append(row(name, f"square, {cells} spacings", values[-1]))
        spread = np.ptp(np.array(values), axis=0)
        lines.append(f"| {name} | largest less smallest | {spread[0]:.1e} | {spread[1]:.1e} | {spread[2]:.1e} |")
        tip = tips[1]
        lines.append(row(name, f"the library's rings, up to {tip.contour_radius / spacing:.0f} spacings", against(
            (tip.energy_release_rate, tip.stress_intensity_1, tip.stress_intensity_2), felt)))
    plate, spacing = lattice.patch(40, 8)
    model = plate.model(spacing, 4)
    model.step(1)
    tips = model.tips()
    felt = lattice.reference(plate, (tips[0].felt_ahead, tips[1].felt_ahead))
    name, rates = "patch of 8 spacings around, through boundary elements around it", []
    for half in (1.5, 2.0, 2.5, 3.0, 3.5):
        rates.append(around_crack(model, half, 1 + tips[1].felt_ahead) / felt.energy_release_rate - 1)
        lines.append(f"| {name} | square, {half / spacing:.0f} spacings | {rates[-1]:+.5f} | | |")
    lines.append(f"| {name} | largest less smallest | {max(rates) - min(rates):.1e} | | |")
    print("\n".join(lines), flush=True)
    return "\n".join(lines)


if __name__ == "__main__":
    section()
