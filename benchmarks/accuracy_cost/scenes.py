"""Scenes whose answer is known, and what can be bought in each: every scene has knobs with defaults, builds itself in a
model, and measures its relative error against a closed form or an independent solution."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Callable

import numpy as np

import bempd
from bempd import rectangle

Model = bempd.Model
Knobs = dict[str, Any]


@dataclass(frozen=True)
class Scene:
    name: str
    reference: str  # where the right answer comes from
    knobs: Knobs  # defaults
    build: Callable[[Model, Knobs], None]
    solve: Callable[[Model], None]
    error: Callable[[Model, Knobs], float]
    outcome: Callable[[Model], dict[str, Any]] | None = None  # more to be told than an error


def one_step(model: Model) -> None:
    model.step(1.0)


def displacement_error(model: Model, regions: list[int], exact: Callable[..., Any]) -> float:
    """Largest error of the nodes' displacements over the largest displacement."""
    error = size = 0.0
    for region in regions:
        x, u = model.field(region, "position"), model.field(region, "displacement")
        reference = np.stack(exact(x[:, 0], x[:, 1]), axis=1)
        error = max(error, float(np.abs(u - reference).max()))
        size = max(size, float(np.abs(reference).max()))
    return error / size


# --------------------------------------------------------------------------------------------------------------------
# The clamped plate 1.0 x 0.2 m: extrapolated from finite elements and boundary elements, which agree to 2e-6.
LENGTH, HEIGHT, YOUNG, POISSON = 1.0, 0.2, 100e9, 1 / 3
CLAMPED = {"plate": (5.23431e-5, 0), "shear": (-5.13570e-4, 1), "hole": (6.07911e-5, 0)}


def build_clamped(kind: str) -> Callable[[Model, Knobs], None]:
    def build(model: Model, knobs: Knobs) -> None:
        material = model.add_material(young_modulus=YOUNG, poisson_ratio=POISSON)
        region = model.add_bem_region(material, rectangle(0, 0, LENGTH, HEIGHT), knobs["element_length"])
        if knobs["edge_grading"]:  # by hand instead of the option bem.grading
            for edge, length in ((1, knobs["element_length"]), (3, knobs["element_length"]), (4, HEIGHT / 4)):
                model.set_edge_mesh(region, edge, length, knobs["edge_grading"])
        if kind == "hole":
            model.add_circular_hole(region, (LENGTH / 2, HEIGHT / 2), 0.05)
        model.fix_edge(region, 4)
        if kind == "shear":
            model.add_traction(region, 2, "y", -0.5e6)
        else:
            model.add_traction(region, 2, "x", 5.25e6)

    return build


def clamped_error(kind: str) -> Callable[[Model, Knobs], float]:
    def error(model: Model, knobs: Knobs) -> float:
        reference, component = CLAMPED[kind]
        x, u = model.field(1, "position"), model.field(1, "displacement")
        node = int(np.argmin(np.hypot(x[:, 0] - LENGTH, x[:, 1] - HEIGHT / 2)))
        return abs(float(u[node, component]) / reference - 1)

    return error


def clamped(kind: str, element_length: float) -> Scene:
    return Scene(kind, "finite and boundary elements, extrapolated", {"element_length": element_length, "edge_grading": 0},
                 build_clamped(kind), one_step, clamped_error(kind))


# --------------------------------------------------------------------------------------------------------------------
# Cantilever 4 x 1 under a parabolic end shear: Timoshenko and Goodier, Theory of Elasticity, 3rd ed., art. 21.
def cantilever_field(young: float, poisson: float) -> tuple[Callable[..., Any], Callable[..., Any]]:
    length, half = 4.0, 0.5
    inertia, force = 2 * half**3 / 3, 1.0
    shear = young / (2 * (1 + poisson))

    def displacement(x: Any, y: Any) -> Any:  # the end x = 0 is loaded, x = length held
        y = y - half
        u = (-force * x**2 * y / (2 * young * inertia) - poisson * force * y**3 / (6 * young * inertia)
             + force * y**3 / (6 * inertia * shear)
             + (force * length**2 / (2 * young * inertia) - force * half**2 / (2 * inertia * shear)) * y)
        v = (poisson * force * x * y**2 / (2 * young * inertia) + force * x**3 / (6 * young * inertia)
             - force * length**2 * x / (2 * young * inertia) + force * length**3 / (3 * young * inertia))
        return u, v

    def shear_stress(y: Any) -> Any:
        return -force / (2 * inertia) * (half**2 - (y - half) ** 2)

    return displacement, shear_stress


def build_cantilever(coupled: bool) -> Callable[[Model, Knobs], None]:
    def build(model: Model, knobs: Knobs) -> None:
        displacement, shear_stress = cantilever_field(1.0, POISSON)
        material = model.add_material(young_modulus=1.0, poisson_ratio=POISSON)
        length = knobs["element_length"]
        if coupled:
            model.add_bem_region(material, rectangle(0, 0, 2, 1), length)
            model.add_pd_region(material, rectangle(2, 0, 4, 1), knobs["spacing"], knobs["horizon_ratio"])
        else:
            model.add_bem_region(material, rectangle(0, 0, 4, 1), length)
        # The outward normal of the loaded end is -x.
        model.add_traction_function(1, 4, lambda x, y: (0.0, -float(shear_stress(y))))
        model.prescribe_edge_function(2 if coupled else 1, 2, lambda x, y: tuple(map(float, displacement(x, y))))

    return build


def cantilever_error(model: Model, knobs: Knobs) -> float:
    regions = list(range(1, model.region_count + 1))
    return displacement_error(model, regions, cantilever_field(1.0, POISSON)[0])


# --------------------------------------------------------------------------------------------------------------------
# L-shaped body whose corner is singular: Szabo and Babuska, Finite Element Analysis (1991), sec. 4.2, mode I.
EXPONENT, FACTOR = 0.544483736782464, 0.543075578836737


def corner_field(poisson: float, shear: float) -> tuple[Callable[..., Any], Callable[..., Any]]:
    kappa = (3 - poisson) / (1 + poisson)
    e, q = EXPONENT, FACTOR * (EXPONENT + 1)

    def displacement(x: Any, y: Any) -> Any:
        r, t = np.hypot(x, y), np.arctan2(y, x)
        scale = r**e / (2 * shear)
        return (scale * ((kappa - q) * np.cos(e * t) - e * np.cos((e - 2) * t)),
                scale * ((kappa + q) * np.sin(e * t) + e * np.sin((e - 2) * t)))

    def stress(x: float, y: float) -> tuple[float, float, float]:
        r, t = math.hypot(x, y), math.atan2(y, x)
        scale = e * r ** (e - 1)
        return (scale * ((2 - q) * math.cos((e - 1) * t) - (e - 1) * math.cos((e - 3) * t)),
                scale * ((2 + q) * math.cos((e - 1) * t) + (e - 1) * math.cos((e - 3) * t)),
                scale * ((e - 1) * math.sin((e - 3) * t) + q * math.sin((e - 1) * t)))

    return displacement, stress


def l_shape_vertices() -> Any:
    """The corner at the origin, its faces at 135 degrees to the x axis, which halves the body."""
    h = math.sqrt(0.5)
    square = np.array([[0, 0], [0, -1], [1, -1], [1, 1], [-1, 1], [-1, 0]], float)
    turn = np.array([[h, -h], [h, h]])  # the free corner at (-1, -1) goes to the negative x axis
    return square @ turn


def build_l_shape(model: Model, knobs: Knobs) -> None:
    displacement, stress = corner_field(POISSON, 1 / (2 * (1 + POISSON)))
    vertices = l_shape_vertices()
    material = model.add_material(young_modulus=1.0, poisson_ratio=POISSON)
    region = model.add_bem_region(material, vertices, knobs["element_length"])
    for edge in (2, 3, 4, 5):
        a, b = vertices[edge - 1], vertices[edge % 6]
        normal = np.array([b[1] - a[1], a[0] - b[0]]) / np.hypot(*(b - a))

        def traction(x: float, y: float, normal: Any = normal) -> tuple[float, float]:
            xx, yy, xy = stress(x, y)
            return float(xx * normal[0] + xy * normal[1]), float(xy * normal[0] + yy * normal[1])

        if edge == 3:
            model.prescribe_edge_function(region, edge, lambda x, y: tuple(map(float, displacement(x, y))))
        else:
            model.add_traction_function(region, edge, traction)


def l_shape_error(model: Model, knobs: Knobs) -> float:
    return displacement_error(model, [1], corner_field(POISSON, 1 / (2 * (1 + POISSON)))[0])


# --------------------------------------------------------------------------------------------------------------------
# Lame's ring, quarter of it: Timoshenko and Goodier, art. 28. Kirsch's plate, quarter of it: art. 35.
INNER, OUTER = 1.0, 2.0


def ring_field(young: float, poisson: float) -> Callable[..., Any]:
    a2, b2 = INNER**2, OUTER**2

    def displacement(x: Any, y: Any) -> Any:
        r2 = x**2 + y**2
        over_r = a2 / (young * (b2 - a2)) * ((1 - poisson) + (1 + poisson) * b2 / r2)
        return over_r * x, over_r * y

    return displacement


def build_ring(model: Model, knobs: Knobs) -> None:
    material = model.add_material(young_modulus=1.0, poisson_ratio=POISSON)
    region = model.add_bem_region(material, [(INNER, 0), (OUTER, 0), (0, OUTER), (0, INNER)], knobs["element_length"])
    h = math.sqrt(0.5)
    model.set_edge_arc(region, 2, (OUTER * h, OUTER * h))
    model.set_edge_arc(region, 4, (INNER * h, INNER * h))
    model.fix_edge(region, 1, "y")
    model.fix_edge(region, 3, "x")
    # Unit pressure inside: the traction on the body points outward.
    model.add_traction_function(region, 4, lambda x, y: (x / math.hypot(x, y), y / math.hypot(x, y)))


def ring_error(model: Model, knobs: Knobs) -> float:
    return displacement_error(model, [1], ring_field(1.0, POISSON))


def kirsch_stress(x: float, y: float) -> tuple[float, float, float]:
    r2, t = x * x + y * y, math.atan2(y, x)
    c2, c4, s2, s4 = math.cos(2 * t), math.cos(4 * t), math.sin(2 * t), math.sin(4 * t)
    a2 = 1 / r2
    return (1 - a2 * (1.5 * c2 + c4) + 1.5 * a2**2 * c4, -a2 * (0.5 * c2 - c4) - 1.5 * a2**2 * c4,
            -a2 * (0.5 * s2 + s4) + 1.5 * a2**2 * s4)


def kirsch_displacement(x: Any, y: Any) -> Any:
    """Hole of radius 1, E = 1, plane stress."""
    shear, kappa = 1 / (2 * (1 + POISSON)), (3 - POISSON) / (1 + POISSON)
    r, t = np.hypot(x, y), np.arctan2(y, x)
    scale = 1 / (8 * shear)
    u = scale * (r * (kappa + 1) * np.cos(t) + 2 / r * ((1 + kappa) * np.cos(t) + np.cos(3 * t)) - 2 / r**3 * np.cos(3 * t))
    v = scale * (r * (kappa - 3) * np.sin(t) + 2 / r * ((1 - kappa) * np.sin(t) + np.sin(3 * t)) - 2 / r**3 * np.sin(3 * t))
    return u, v


def build_kirsch(model: Model, knobs: Knobs) -> None:
    material = model.add_material(young_modulus=1.0, poisson_ratio=POISSON)
    vertices = [(1, 0), (4, 0), (4, 4), (0, 4), (0, 1)]
    region = model.add_bem_region(material, vertices, knobs["element_length"])
    model.set_edge_arc(region, 5, (math.sqrt(0.5), math.sqrt(0.5)))
    model.fix_edge(region, 1, "y")
    model.fix_edge(region, 4, "x")

    def traction(normal: int) -> Callable[[float, float], tuple[float, float]]:
        def value(x: float, y: float) -> tuple[float, float]:
            xx, yy, xy = kirsch_stress(x, y)
            return (xx, xy) if normal == 0 else (xy, yy)

        return value

    model.add_traction_function(region, 2, traction(0))
    model.add_traction_function(region, 3, traction(1))


def kirsch_error(model: Model, knobs: Knobs) -> float:
    return displacement_error(model, [1], kirsch_displacement)


SCENES = {
    scene.name: scene
    for scene in (
        Scene("lame", "Lame's ring in closed form", {"element_length": 0.4}, build_ring, one_step, ring_error),
        Scene("kirsch", "Kirsch's hole in closed form", {"element_length": 0.4}, build_kirsch, one_step, kirsch_error),
        Scene("cantilever", "Timoshenko and Goodier in closed form", {"element_length": 0.25}, build_cantilever(False),
              one_step, cantilever_error),
        clamped("plate", 0.05),
        clamped("shear", 0.05),
        clamped("hole", 0.05),
        Scene("l_shape", "Williams' corner in closed form", {"element_length": 0.25}, build_l_shape, one_step,
              l_shape_error),
        Scene("coupled_cantilever", "Timoshenko and Goodier in closed form",
              {"element_length": 0.25, "spacing": 0.05, "horizon_ratio": 4}, build_cantilever(True), one_step,
              cantilever_error),
    )
}
