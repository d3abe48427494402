"""Loads of cracks that run across a border of boundary elements and a lattice, over those of elements alone on the same path."""

from __future__ import annotations

import dataclasses
import math

import bempd

Point = tuple[float, float]

# Lengths are in spacings. The border lies BORDER along the plate where the crack, WAY above its lower side, comes; beyond SLANTED
# above and below that it goes straight on to the sides of the plate, so that no region has a sharp corner.
WIDTH, HEIGHT, BORDER, WAY, SLANTED = 80.0, 64.0, 40.0, 32.5, 14.0

# Ends of the cracks along the plate at first: elements begin ten spacings before the border, lines six horizons.
FIRST_OF_ELEMENTS, HORIZONS_OF_LINE = 30.0, 6
FARTHEST = 20.0  # behind the border, along the plate


@dataclasses.dataclass(frozen=True)
class Scene:
    """A plate that is clamped and pulled at its long sides, with an edge crack along it."""

    degrees: float  # from the rows of the lattice to the crack
    slant: float  # from the border to the rows across the crack, in degrees
    horizon_ratio: int

    def turned(self, x: float, y: float) -> Point:
        a = math.radians(self.degrees)
        return x * math.cos(a) - y * math.sin(a), x * math.sin(a) + y * math.cos(a)

    def behind(self, place: Point) -> float:
        """Distance of a place behind the border, along the plate."""
        a = math.radians(self.degrees)
        return place[0] * math.cos(a) + place[1] * math.sin(a) - BORDER

    def border(self) -> list[Point]:
        side = SLANTED * math.tan(math.radians(self.degrees + self.slant))
        if side == 0:
            return [(BORDER, 0), (BORDER, HEIGHT)]
        return [(BORDER - side, 0), (BORDER - side, WAY - SLANTED), (BORDER + side, WAY + SLANTED), (BORDER + side, HEIGHT)]

    def parts(self, kinds: str) -> list[list[Point]]:
        """Outlines of the regions: one for one kind of region, or two on either side of the border."""
        whole = [(0.0, 0.0), (WIDTH, 0.0), (WIDTH, HEIGHT), (0.0, HEIGHT)]
        if len(kinds) == 1:
            return [whole]
        border = self.border()
        return [[whole[0], *border, whole[3]], [*reversed(border), whole[1], whole[2]]]

    def sides(self, outline: list[Point]) -> list[tuple[int, float]]:
        """Numbers of the edges at the long sides, and where they move."""
        ends = list(zip(outline, outline[1:] + outline[:1]))
        return [(k + 1, 1.0 if a[1] else -1.0) for k, (a, b) in enumerate(ends) if a[1] == b[1] and a[1] in (0, HEIGHT)]


def plate(scene: Scene, kinds: str, crack: list[Point]) -> bempd.Model:
    """The plate with its crack. `kinds`: "e" for elements, "l" for a lattice; "el" for both, from the mouth of the crack."""
    model = bempd.Model(options={"stepping.control": "path"})
    solid = model.add_material(young_modulus=1, poisson_ratio=1 / 3, fracture_energy=1)
    up = scene.turned(0, 1)
    for kind, corners in zip(kinds, scene.parts(kinds)):
        outline = [scene.turned(*corner) for corner in corners]
        region = model.add_bem_region(solid, outline, 4) if kind == "e" else model.add_pd_region(solid, outline, 1, scene.horizon_ratio)
        for edge, sense in scene.sides(corners):
            model.prescribe_edge(region, edge, "x", sense * up[0])
            model.prescribe_edge(region, edge, "y", sense * up[1])
    model.add_crack(crack)
    return model


@dataclasses.dataclass
class Load:
    """A step of the crack: from where it went, in which kind of region, and its load over that of elements alone, less one, in per cent."""

    behind: float
    kind: str
    off: float


def loads(scene: Scene, kinds: str, tip: float, nearest: float, farthest: float) -> list[Load]:
    """Of all steps between two distances behind the border, of a crack whose tip lies at a place along the plate at first."""
    path = [scene.turned(0, WAY), scene.turned(tip, WAY)]
    model = plate(scene, kinds, path)
    found: list[Load] = []
    seen = 0
    while scene.behind(path[-1]) < farthest:
        report = model.step_to_next_event(1e9)
        for extension in model.extensions()[seen:]:
            seen += 1
            behind = scene.behind(path[-1])
            if nearest < behind < farthest:
                alone = plate(scene, "e", path)
                alone.step(1.0)
                known = max(one.critical_load_factor for one in alone.tips())
                found.append(Load(behind, kinds[-1] if behind > 0 else kinds[0], 100 * (extension.load_factor / known - 1)))
            path.append((extension.x, extension.y))
        if report.stop_reason != bempd.StopReason.EVENT:
            break
    return found


def across(scene: Scene) -> tuple[list[Load], list[Load], list[Load], list[Load]]:
    """Loads into the lattice, and of a lattice alone from where that one begins; and out of the lattice, with a lattice alone again."""
    horizon = scene.horizon_ratio
    into = loads(scene, "el", FIRST_OF_ELEMENTS, -10, FARTHEST)
    line = next(load.behind for load in into if load.behind > 0)
    first = BORDER - HORIZONS_OF_LINE * horizon
    return (into, loads(scene, "l", BORDER + line, -10, FARTHEST),
            loads(scene, "le", first, -6 * horizon, FARTHEST), loads(scene, "l", first, -6 * horizon, 0))


def words(found: list[Load]) -> str:
    """Least and largest of some loads."""
    if not found:
        return ""
    low, high = min(load.off for load in found), max(load.off for load in found)
    return f"{low:+.1f} %" if f"{low:+.1f}" == f"{high:+.1f}" else f"{low:+.1f} to {high:+.1f} %"


HEADINGS = ("crack to the rows", "border to the rows", "m", "elements before the border", "first load of the line", "next four",
            "farther on", "lattice alone: first", "next four", "farther on", "line before the border", "lattice alone",
            "first load of elements", "farther on")


def row(scene: Scene) -> str:
    into, alone, out, alone_before = across(scene)
    line = [load for load in into if load.kind == "l"]
    elements = [load for load in out if load.kind == "e"]
    # The last step of a line goes across the border, at the load of the one before it.
    before = [load for load in out if load.kind == "l"][:-1]
    compared = [load for load in alone_before if load.behind <= before[-1].behind + 0.5]
    cells = [f"{scene.degrees:g}", f"{scene.slant:g}", str(scene.horizon_ratio), words([load for load in into if load.kind == "e"]),
             words(line[:1]), words(line[1:5]), words(line[5:]), words(alone[:1]), words(alone[1:5]), words(alone[5:]),
             words(before), words(compared), words(elements[:1]), words(elements[1:])]
    return "| " + " | ".join(cells) + " |"


SCENES = [Scene(degrees, slant, m) for degrees, slant in ((0, 0), (0, 12), (20, 0), (20, 12), (45, 0), (45, 20), (63, 0))
          for m in (3, 4)]


def table() -> list[str]:
    lines = ["| " + " | ".join(HEADINGS) + " |", "|---" * len(HEADINGS) + "|"]
    for scene in SCENES:
        lines.append(row(scene))
        print(lines[-1], flush=True)
    return lines
