"""The part of a Model that describes the body: materials, regions, cracks, supports, loads."""

from __future__ import annotations

import dataclasses
from typing import Any, Callable, Optional, Sequence, Union

import numpy.typing as npt

from . import _arguments as arguments
from ._handle import Handle
from ._library import ffi, lib, new_struct
from ._loops import Loop, Outline
from ._names import Component, Components, Edge, FaceComponent, Plane, Turn
from ._sketch import Arc, Mark, Region, Sketch, arc_through
from .callbacks import BoundaryFunction, boundary_callback
from .errors import ArgumentError, OrderError

COMPONENTS = {"x": lib.BEMPD_X, "y": lib.BEMPD_Y, "both": lib.BEMPD_BOTH}
ONE_COMPONENT = {"x": lib.BEMPD_X, "y": lib.BEMPD_Y}
TURNS = {"counter-clockwise": lib.BEMPD_COUNTER_CLOCKWISE, "clockwise": lib.BEMPD_CLOCKWISE}
TREATMENTS = {"automatic": lib.BEMPD_TREATMENT_AUTOMATIC, "elements": lib.BEMPD_TREATMENT_ELEMENTS,
              "lattice": lib.BEMPD_TREATMENT_LATTICE, "frozen": lib.BEMPD_TREATMENT_FROZEN}
FACE_COMPONENTS = {"pressure": lib.BEMPD_PRESSURE, "shear": lib.BEMPD_SHEAR}
PLANES = {"stress": lib.BEMPD_PLANE_STRESS, "strain": lib.BEMPD_PLANE_STRAIN}
WHOLE_EDGE = (0.0, 1.0)
Where = Union[float, Sequence[float]]  # a coordinate, or two between which it lies


class Scene:
    """What can be added to a model. Ids of materials, regions, edges, cracks, supports and loads begin at 1.

    Points are anything that converts to an array of shape (n, 2); values along an edge are a number, or n numbers at
    equally spaced places, linear between. Whatever is given is copied. Components are "x", "y" and, where that makes
    sense, "both". Displacements, tractions and forces are `constant + load_factor * proportional`.
    """

    _handle: Optional[Handle]
    _sketch: Sketch

    def _open(self) -> Handle:
        if self._handle is None:
            raise OrderError("the model is closed; create another one")
        return self._handle

    def _added(self, name: str, *values: Any) -> int:
        added = ffi.new("int32_t *")
        self._open().call(name, *values, added)
        return int(added[0])

    def add_material(self, *, young_modulus: float, poisson_ratio: float, thickness: float = 1.0,
                     critical_stretch: Optional[float] = None, fracture_energy: Optional[float] = None,
                     plane: Plane = "stress", thermal_expansion: float = 0.0, toughness: Optional[float] = None) -> int:
        """Add an isotropic elastic material; returns its id.

        Give the fracture energy [J/m^2], the toughness K_IC [Pa m^0.5], from which it follows, or the critical bond stretch;
        or none of them for a material that does not break.
        `plane` is "stress" or "strain". Peridynamic regions take Poisson's ratios from -0.2 to 0.49.

        >>> import bempd
        >>> bempd.Model().add_material(young_modulus=3e9, poisson_ratio=1 / 3, fracture_energy=300)
        1
        """
        if toughness is not None:
            if fracture_energy is not None:
                raise ArgumentError("add_material: toughness and fracture_energy are both given; give one, the other follows from it")
            intensity = arguments.real("add_material: toughness", toughness)
            if not intensity > 0:
                raise ArgumentError(f"add_material: toughness is {toughness!r}; K_IC must be positive")
            modulus, ratio = (arguments.real(f"add_material: {name}", value)
                              for name, value in (("young_modulus", young_modulus), ("poisson_ratio", poisson_ratio)))
            if modulus > 0:  # else the library says what is wrong with it
                fracture_energy = intensity**2 * (1 - ratio**2 if plane == "strain" else 1) / modulus
        material = new_struct("bempd_material", "bempd_material_init")
        material.plane = arguments.choice("add_material: plane", plane, PLANES)
        given = {"young_modulus": young_modulus, "poisson_ratio": poisson_ratio, "thickness": thickness,
                 "critical_stretch": critical_stretch, "fracture_energy": fracture_energy,
                 "thermal_expansion": thermal_expansion}
        for name, value in given.items():
            if value is not None:
                setattr(material, name, arguments.real(f"add_material: {name}", value))
        number = self._added("bempd_add_material", material)
        self._sketch.materials[number] = plane, float(poisson_ratio)
        return number

    def add_bem_region(self, material: int, vertices: Union[npt.ArrayLike, Outline], element_length: float, *,
                       bulges: Optional[npt.ArrayLike] = None) -> int:
        """Add a polygon treated by boundary elements; returns its id.

        `vertices` run counter-clockwise; edge k (1, 2, ...) goes from vertex k to the next. Edges that coincide with
        edges of other regions are bonded. `bulges`, one for each edge, make arcs: the tangent of a quarter of the angle
        that the edge turns, 0 for a straight one, 1 for half a circle that bulges out of the body (as in DXF files).
        In place of vertices an Outline can be given, such as bempd.outline.from_dxf() reads: its holes and names come with it.
        """
        if isinstance(vertices, Outline):
            return self._outlined("add_bem_region", vertices, bulges, lambda loop: self.add_bem_region(
                material, loop.vertices, element_length, bulges=loop.bulges))
        points = arguments.point_array("add_bem_region: vertices", vertices)
        bends = arguments.bulge_array("add_bem_region: bulges", bulges, len(points))
        region = self._added("bempd_add_bem_region_with_arcs", material, len(points), arguments.doubles(points),
                             arguments.doubles(bends), element_length)
        self._sketch.regions[region] = Region("BEM", arguments.pairs(points), material)
        self._sketch.regions[region].bend(1, bends)
        return region

    def add_body(self, material: int, vertices: Union[npt.ArrayLike, Outline], *, bulges: Optional[npt.ArrayLike] = None) -> int:
        """Add a polygon whose boundary elements the library chooses by the option "error.wanted"; returns its id.

        A body is a region: cracks, supports, loads and results take it like one. Vertices, bulges and outlines are as in
        add_bem_region(); plan() and error_estimate() tell what is chosen and how accurate it is.

        >>> import bempd
        >>> model = bempd.Model(options={"error.wanted": 0.001})
        >>> steel = model.add_material(young_modulus=210e9, poisson_ratio=0.3)
        >>> arm = model.add_body(steel, bempd.rectangle(0, 0, 4, 1))
        >>> clamp = model.fix_edge(arm, 4)
        >>> load = model.add_traction(arm, 2, "y", proportional=-1e6)
        >>> model.prepare()
        >>> model.error_estimate().displacement < 0.001
        True
        """
        if isinstance(vertices, Outline):
            return self._outlined("add_body", vertices, bulges, lambda loop: self.add_body(
                material, loop.vertices, bulges=loop.bulges))
        points = arguments.point_array("add_body: vertices", vertices)
        bends = arguments.bulge_array("add_body: bulges", bulges, len(points))
        body = self._added("bempd_add_body_with_arcs", material, len(points), arguments.doubles(points),
                           arguments.doubles(bends))
        self._sketch.regions[body] = Region("BEM", arguments.pairs(points), material)
        self._sketch.regions[body].bend(1, bends)
        return body

    def set_body_lattice(self, body: int, spacing: float = 0, horizon_ratio: int = 0) -> None:
        """Choose the lattice of the patches that set_crack_treatment() lays in a body; 0 leaves a value to the library."""
        self._open().call("bempd_set_body_lattice", body, spacing, horizon_ratio, changes=True)

    def set_crack_treatment(self, crack: int, treatment: str) -> None:
        """Choose how a crack is modelled: "automatic", "elements", "lattice" (a patch of its body around it), or "frozen".

        Before the model is prepared, or later to freeze a crack and let it grow again.
        """
        chosen = arguments.choice("set_crack_treatment: treatment", treatment, TREATMENTS)
        self._open().call("bempd_set_crack_treatment", crack, chosen)

    def add_bem_disc(self, material: int, centre: Sequence[float], radius: float, element_length: float) -> int:
        """Add a round region treated by boundary elements, of four quarter circles; returns its id."""
        place = arguments.place("add_bem_disc: centre", centre)
        region = self._added("bempd_add_bem_disc", material, *place, radius, element_length)
        self._sketch.add_circle(region, place, radius, material=material)
        return region

    def add_pd_region(self, material: int, vertices: Union[npt.ArrayLike, Outline], spacing: float, horizon_ratio: int = 0, *,
                      bulges: Optional[npt.ArrayLike] = None, lattice_angle: float = 0) -> int:
        """Add a polygon treated by peridynamics; returns its id.

        With edges parallel to the axes material points lie on the corners of square cells of size `spacing`, also on the
        boundary; with others they lie on the edges, about `spacing` apart, and on a lattice inside. `horizon_ratio` is
        the horizon over the spacing, 2 to 8; 0 stands for 4. `bulges` make arcs of edges as in add_bem_region(), and an
        Outline can be given in place of vertices. `lattice_angle` is that from the x axis to the rows of the lattice [rad];
        other than 0 there are material points on all edges.
        """
        if isinstance(vertices, Outline):
            return self._outlined("add_pd_region", vertices, bulges, lambda loop: self.add_pd_region(
                material, loop.vertices, spacing, horizon_ratio, bulges=loop.bulges, lattice_angle=lattice_angle))
        points = arguments.point_array("add_pd_region: vertices", vertices)
        bends = arguments.bulge_array("add_pd_region: bulges", bulges, len(points))
        region = self._added("bempd_add_turned_pd_region", material, len(points), arguments.doubles(points),
                             arguments.doubles(bends), spacing, horizon_ratio, lattice_angle)
        self._sketch.regions[region] = Region("PD", arguments.pairs(points), material)
        self._sketch.regions[region].bend(1, bends)
        return region

    def _outlined(self, caller: str, outline: Outline, bulges: Optional[npt.ArrayLike], add: Callable[[Loop], int]) -> int:
        """Add a region with the holes and the names of an outline; it is taken back if a hole is refused."""
        if bulges is not None:
            raise ArgumentError(f"{caller}: bulges are given beside an Outline, which has its own; leave them out")
        region = add(outline.outer)
        try:
            for hole in outline.holes:
                self.add_hole(region, hole.vertices, bulges=hole.bulges)
        except Exception:
            self.remove_region(region)
            raise
        for edge, name in enumerate(outline.names, 1):
            if name:
                self.name_edge(region, edge, name)
        return region

    def name_edge(self, region: int, edge: Edge, name: str) -> None:
        """Name an edge; every method that takes an edge then takes the name. Several edges may have one name.

        >>> import bempd
        >>> model = bempd.Model()
        >>> glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3)
        >>> plate = model.add_bem_region(glass, bempd.rectangle(0, 0, 2, 1), element_length=0.25)
        >>> model.name_edge(plate, model.edge_at(plate, (0, 0.5)), "clamp")
        >>> model.fix_edge(plate, "clamp")
        1
        """
        number = arguments.whole("name_edge: edge", self._sketch.edge("name_edge", region, edge))
        self._open().call("bempd_name_edge", region, number, arguments.word("name_edge: name", name))
        self._sketch.regions[region].names[number] = name

    def name_region(self, region: int, name: str) -> None:
        """Name a region; messages, the log, tables, the picture of a notebook, histories and snapshots show the name.

        >>> import bempd
        >>> model = bempd.Model()
        >>> glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3)
        >>> plate = model.add_bem_region(glass, bempd.rectangle(0, 0, 2, 1), element_length=0.25)
        >>> model.name_region(plate, "pane")
        >>> model.prepare()  # doctest: +ELLIPSIS
        Traceback (most recent call last):
        bempd.errors.UnsolvableError: prepare: region 1 ("pane") can translate ...
        """
        self._name("region", "bempd_name_region", region, name)

    def name_support(self, support: int, name: str) -> None:
        """Name a support, as name_region() does a region."""
        self._name("support", "bempd_name_support", support, name)

    def name_load(self, load: int, name: str) -> None:
        """Name a load, as name_region() does a region."""
        self._name("load", "bempd_name_load", load, name)

    def _name(self, what: str, function: str, number: int, name: str) -> None:
        whole = arguments.whole(f"name_{what}: {what}", number)
        self._open().call(function, whole, arguments.word(f"name_{what}: name", name))
        self._sketch.names[what, whole] = name

    def edge_named(self, region: int, name: str) -> int:
        """The number of the edge with a name; an error if there is none, or several."""
        if not isinstance(name, str):
            raise ArgumentError(f"edge_named: name is {name!r}; it must be a word")
        self._edge_exists("edge_named", region, 1)
        return self._sketch.edge("edge_named", region, name)

    def edges_named(self, region: int, name: str) -> list[int]:
        """The numbers of all edges with a name; an error if there is none."""
        self._edge_exists("edges_named", region, 1)
        found = self._sketch.regions[region].named(name)
        return found or [self.edge_named(region, name)]

    def edge_names(self, region: int) -> dict[int, str]:
        """Names of the edges that have one, by number."""
        self._edge_exists("edge_names", region, 1)
        return dict(sorted(self._sketch.regions[region].names.items()))

    def edge_at(self, region: int, point: Sequence[float], *, tolerance: Optional[float] = None) -> int:
        """The number of the edge on which a place lies, to a tolerance [m]: 1e-6 of the region's size if not given.

        >>> import bempd
        >>> model = bempd.Model()
        >>> glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3)
        >>> plate = model.add_bem_region(glass, bempd.rectangle(0, 0, 2, 1), element_length=0.25)
        >>> model.edge_at(plate, (2, 0.5))
        2
        """
        x, y = arguments.place("edge_at: point", point)
        self._edge_exists("edge_at", region, 1)
        sketched = self._sketch.regions[region]
        close = 1e-6 * sketched.size() if tolerance is None else arguments.real("edge_at: tolerance", tolerance)
        distance, place = ffi.new("double *"), ffi.new("double[]", [x, y])
        found = []
        for edge in range(1, sketched.edge_count + 1):
            self._open().call("bempd_fractions_on_edge", region, edge, 1, place, ffi.NULL, distance)
            found.append((float(distance[0]), edge))
        here = [edge for away, edge in found if away <= close]
        if not here:
            away, edge = min(found)
            nearest = self._sketch.place_of(Mark(region, edge))
            raise ArgumentError(f"edge_at: no edge of region {region} passes through ({x:g}, {y:g}); the nearest, {nearest}, is "
                                f"{away:.3g} away; give a place on the edge, or a larger tolerance")
        if len(here) > 1:
            raise ArgumentError(f"edge_at: edges {' and '.join(map(str, here))} of region {region} meet at ({x:g}, {y:g}); give a place "
                                "inside one of them")
        return here[0]

    def edges_where(self, region: int, *, x: Optional[Where] = None, y: Optional[Where] = None,
                    tolerance: Optional[float] = None) -> list[int]:
        """The numbers of the edges that lie wholly at a coordinate, or between two: `x=0`, `y=(0.1, 0.2)`, or both.

        The tolerance [m] is 1e-6 of the region's size if not given. An error tells if there is no such edge. Edges of
        set_edges_smooth() count with their ends only.

        >>> import bempd
        >>> model = bempd.Model()
        >>> glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3)
        >>> bracket = model.add_bem_region(glass, [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)], element_length=0.25)
        >>> model.edges_where(bracket, x=0), model.edges_where(bracket, y=(1, 2))
        ([6], [3, 4, 5])
        """
        self._edge_exists("edges_where", region, 1)
        if x is None and y is None:
            raise ArgumentError("edges_where: neither x nor y is given; give a number, or a pair (low, high)")
        sketched = self._sketch.regions[region]
        close = 1e-6 * sketched.size() if tolerance is None else arguments.real("edges_where: tolerance", tolerance)
        asked = [(axis, *arguments.interval(f"edges_where: {'xy'[axis]}", where))
                 for axis, where in enumerate((x, y)) if where is not None]
        found = [edge for edge in range(1, sketched.edge_count + 1)
                 if all(low - close <= place[axis] <= high + close for axis, low, high in asked for place in sketched.way(edge))]
        if not found:
            (left, bottom), (right, top) = sketched.box()
            wanted = " and ".join(f"{'xy'[axis]} = {low:g}" if low == high else f"{'xy'[axis]} from {low:g} to {high:g}"
                                  for axis, low, high in asked)
            raise ArgumentError(f"edges_where: no edge of region {region} lies at {wanted}; the region goes from x = {left:g} to {right:g} "
                                f"and y = {bottom:g} to {top:g}")
        return found

    def _edge_exists(self, caller: str, region: int, edge: int) -> None:
        """An error if a region or its edge is not there."""
        known = self._sketch.regions.get(arguments.whole(f"{caller}: region", region))
        if known is None:
            raise ArgumentError(f"{caller}: region {region} does not exist")
        if not 1 <= edge <= known.edge_count:
            raise ArgumentError(f"{caller}: edge {edge} does not exist; region {region} has edges 1 .. {known.edge_count}")

    def add_hole(self, region: int, vertices: npt.ArrayLike, *, bulges: Optional[npt.ArrayLike] = None) -> int:
        """Cut a hole into a region, its vertices clockwise; returns the number of the hole's first edge.

        `bulges` make arcs of its edges as in add_bem_region(): -1 is half a circle that bulges into the body.
        """
        points = arguments.point_array("add_hole: vertices", vertices)
        bends = arguments.bulge_array("add_hole: bulges", bulges, len(points))
        edge = self._added("bempd_add_hole_with_arcs", region, len(points), arguments.doubles(points),
                           arguments.doubles(bends))
        self._sketch.regions[region].loops.append(arguments.pairs(points))
        self._sketch.regions[region].bend(edge, bends)
        return edge

    def add_circular_hole(self, region: int, centre: Sequence[float], radius: float) -> int:
        """Cut a circular hole into a region; returns the number of its first edge, a quarter circle."""
        place = arguments.place("add_circular_hole: centre", centre)
        edge = self._added("bempd_add_circular_hole", region, *place, radius)
        self._sketch.add_circle(region, place, radius)
        return edge

    def set_edge_arc(self, region: int, edge: Edge, point: Sequence[float]) -> None:
        """Make an edge the circular arc through a point between its ends."""
        edge = self._sketch.edge("set_edge_arc", region, edge)
        place = arguments.place("set_edge_arc: point", point)
        self._open().call("bempd_set_edge_arc", region, edge, *place)
        ends = self._sketch.regions[region].ends(edge)
        arc = arc_through(ends[0], place, ends[1]) if ends else None
        if arc:
            self._sketch.regions[region].arcs[edge] = arc

    def set_edge_arc_about(self, region: int, edge: Edge, centre: Sequence[float], radius: float, turn: Turn) -> None:
        """Make an edge the arc about a centre: "clockwise" or "counter-clockwise" from its first vertex.

        >>> import bempd
        >>> model = bempd.Model()
        >>> glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3)
        >>> plate = model.add_bem_region(glass, bempd.rectangle(0, 0, 1, 1), element_length=0.25)
        >>> model.set_edge_arc_about(plate, 3, (0.5, 1), 0.5, "counter-clockwise")
        >>> support = model.fix_edge(plate, 1)
        >>> round(float(model.field(plate, "position")[:, 1].max()), 12)
        1.5
        """
        edge = self._sketch.edge("set_edge_arc_about", region, edge)
        self._open().call("bempd_set_edge_arc_about", region, edge,
                          *arguments.place("set_edge_arc_about: centre", centre), radius,
                          arguments.choice("set_edge_arc_about: turn", turn, TURNS))
        self._sketch.regions[region].arcs[edge] = Arc(arguments.place("set_edge_arc_about: centre", centre),
                                                      turn == "counter-clockwise")

    def set_edges_smooth(self, region: int, first_edge: Edge, last_edge: Edge) -> None:
        """Make a row of edges a smooth curve through their vertices."""
        first, last = (self._sketch.edge("set_edges_smooth", region, edge) for edge in (first_edge, last_edge))
        self._open().call("bempd_set_edges_smooth", region, first, last)

    def set_edge_mesh(self, region: int, edge: Edge, element_length: float, grading: float = 1.0) -> None:
        """Choose the elements of an edge of a BEM region; `grading` is the ratio of neighbours' lengths, 1 to 4."""
        edge = self._sketch.edge("set_edge_mesh", region, edge)
        self._open().call("bempd_set_edge_mesh", region, edge, element_length, grading)

    def set_toughness_at(self, region: int, places: npt.ArrayLike, values: npt.ArrayLike) -> None:
        """Give a region fracture energies G0 [J/m^2] at places, in place of the one of its material.

        Between the places G0 is linear on their triangles, elsewhere that of the nearest place on the border. It acts on
        bonds, and on cracks as lines and with elements. random_field() makes values of a random material.

        >>> import bempd
        >>> model = bempd.Model()
        >>> glass = model.add_material(young_modulus=70e9, poisson_ratio=0.2, fracture_energy=8)
        >>> plate = model.add_bem_region(glass, bempd.rectangle(-1, -3, 1, 3), element_length=0.5)
        >>> model.set_toughness_at(plate, [(-1, 0), (1, 0)], [8, 32])  # rises from left to right
        >>> crack = model.add_crack([(-0.5, 0), (0.5, 0)])
        >>> loads = model.add_traction(plate, 3, "y", 1e6), model.add_traction(plate, 1, "y", -1e6)
        >>> held = model.fix_point((-1, -3)), model.fix_point((1, -3), "y")
        >>> report = model.step(0)
        >>> left, right = (tip.critical_load_factor for tip in model.tips())
        >>> round(right / left, 3), round((26 / 14) ** 0.5, 3)
        (1.363, 1.363)
        """
        points = arguments.point_array("set_toughness_at: places", places)
        energies = arguments.real_array("set_toughness_at: values", values)
        if energies.shape != (len(points),):
            raise ArgumentError(f"set_toughness_at: values has the shape {energies.shape}; give {len(points)} numbers, one for each place")
        self._open().call("bempd_set_toughness_at", region, len(points), arguments.doubles(points), arguments.doubles(energies))

    def set_resistance_curve(self, material: int, extensions: npt.ArrayLike, energies: npt.ArrayLike) -> None:
        """Give a material fracture energies G_c [J/m^2] by the growth of a tip [m] (R-curve), in place of its one.

        The table is linear between its rows and constant beyond them. It acts on cracks with elements and as lines.

        >>> import bempd
        >>> model = bempd.Model(options={"stepping.control": "path"})
        >>> ceramic = model.add_material(young_modulus=300e9, poisson_ratio=0.2, fracture_energy=20)
        >>> model.set_resistance_curve(ceramic, [0, 0.001, 0.002], [20, 50, 60])
        """
        self._set_energies("bempd_set_resistance_curve", material, "extensions", extensions, energies)

    def set_resistance_directions(self, material: int, angles: npt.ArrayLike, energies: npt.ArrayLike) -> None:
        """Give a material fracture energies G_c [J/m^2] by the direction of a crack [rad], as of layers or weak planes.

        A tip goes where G over G_c is largest, by the option crack.criterion. Angles are ascending within half a turn.

        >>> import bempd
        >>> model = bempd.Model(options={"crack.criterion": "energy"})
        >>> slate = model.add_material(young_modulus=50e9, poisson_ratio=0.2, fracture_energy=40)
        >>> model.set_resistance_directions(slate, [0.7, 0.75, 0.8], [40, 10, 40])  # a weak plane at 0.75
        """
        self._set_energies("bempd_set_resistance_directions", material, "angles", angles, energies)

    def _set_energies(self, call: str, material: int, name: str, values: npt.ArrayLike, energies: npt.ArrayLike) -> None:
        function = call[len("bempd_"):]
        at = arguments.real_array(f"{function}: {name}", values)
        given = arguments.real_array(f"{function}: energies", energies)
        if at.ndim != 1 or given.shape != at.shape:
            raise ArgumentError(f"{function}: {name} has the shape {at.shape} and energies {given.shape}; give a number of each in a row")
        self._open().call(call, material, len(at), arguments.doubles(at), arguments.doubles(given))

    def add_crack(self, points: npt.ArrayLike) -> int:
        """Add an initial crack along a polyline; returns its id."""
        polyline = arguments.point_array("add_crack: points", points)
        crack = self._added("bempd_add_crack", len(polyline), arguments.doubles(polyline))
        self._sketch.cracks[crack] = arguments.pairs(polyline)
        return crack

    def remove_region(self, region: int) -> None:
        """Remove a region that bears no support or load, before the model is prepared; other ids stay."""
        self._open().call("bempd_remove_region", region)
        self._sketch.regions.pop(region, None)

    def remove_crack(self, crack: int) -> None:
        """Remove an initial crack before the model is prepared; other ids stay."""
        self._open().call("bempd_remove_crack", crack)
        self._sketch.cracks.pop(crack, None)

    def remove_support(self, support: int) -> None:
        """Remove a support before the model is prepared; other ids stay."""
        self._open().call("bempd_remove_support", support)
        self._sketch.supports.pop(support, None)

    def remove_load(self, load: int) -> None:
        """Remove a load before the model is prepared; other ids stay."""
        self._open().call("bempd_remove_load", load)
        self._sketch.loads.pop(load, None)

    @property
    def region_count(self) -> int:
        """Largest id of a region: their number, with those that were removed."""
        return self._added("bempd_region_count")

    @property
    def region_ids(self) -> list[int]:
        """Ids of the regions there are."""
        return [region for region in range(1, self.region_count + 1) if self._has_region(region)]

    def _has_region(self, region: int) -> bool:
        try:
            return self.edge_count(region) > 0
        except ArgumentError:
            return False

    def edge_count(self, region: int) -> int:
        """Number of edges of a region with its holes."""
        return self._added("bempd_edge_count", region)

    def fix_edge(self, region: int, edge: Edge, component: Components = "both") -> int:
        """Fix a whole edge; returns the id of the support."""
        edge = self._sketch.edge("fix_edge", region, edge)
        chosen = arguments.choice("fix_edge: component", component, COMPONENTS)
        return self._support(self._added("bempd_fix_edge", region, edge, chosen), Mark(region, edge, does=held(component)))

    def fix_point(self, point: Sequence[float], component: Components = "both") -> int:
        """Fix the node or material point at a place; returns the id of the support."""
        place = arguments.place("fix_point: point", point)
        chosen = arguments.choice("fix_point: component", component, COMPONENTS)
        return self._support(self._added("bempd_fix_point", *place, chosen), Mark(point=place, does=held(component)))

    def prescribe_edge(self, region: int, edge: Edge, component: Component, proportional: Optional[npt.ArrayLike] = None, *,
                       constant: Optional[npt.ArrayLike] = None, part: Sequence[float] = WHOLE_EDGE) -> int:
        """Prescribe the displacement [m] of an edge, or of the `part` between two fractions of it; returns the id of
        the support."""
        edge = self._sketch.edge("prescribe_edge", region, edge)
        count, *values = arguments.samples("prescribe_edge", constant, proportional)
        support = self._added("bempd_prescribe_edge", region, edge, *arguments.fraction_pair("prescribe_edge: part", part),
                              arguments.choice("prescribe_edge: component", component, ONE_COMPONENT), count, *values)
        return self._support(support, Mark(region, edge, component=component, proportional=arguments.one_number(proportional),
                                           does=f"{component} prescribed"))

    def prescribe_edge_function(self, region: int, edge: Edge, function: BoundaryFunction, component: Components = "both", *,
                                part: Sequence[float] = WHOLE_EDGE) -> int:
        """Prescribe the displacement of a part of an edge by a function f(x, y), asked once for each node.

        It returns (ux, uy) [m], multiplied by the load factor, or the two pairs constant and proportional.
        """
        edge = self._sketch.edge("prescribe_edge_function", region, edge)
        ends = arguments.fraction_pair("prescribe_edge_function: part", part)
        chosen = arguments.choice("prescribe_edge_function: component", component, COMPONENTS)
        support = self._added("bempd_prescribe_edge_function", region, edge, *ends, chosen, self._kept(function), ffi.NULL)
        return self._support(support, Mark(region, edge, component=component if component != "both" else None,
                                           does=("x and y" if component == "both" else component) + " prescribed by a function"))

    def prescribe_point(self, point: Sequence[float], component: Component, proportional: float = 0.0, *,
                        constant: float = 0.0) -> int:
        """Prescribe the displacement [m] of the node or material point at a place; returns the id of the support."""
        place = arguments.place("prescribe_point: point", point)
        support = self._added("bempd_prescribe_point", *place,
                              arguments.choice("prescribe_point: component", component, ONE_COMPONENT), constant,
                              proportional)
        return self._support(support, Mark(point=place, component=component, proportional=arguments.one_number(proportional),
                                           does=f"{component} prescribed"))

    def add_traction(self, region: int, edge: Edge, component: Component, proportional: Optional[npt.ArrayLike] = None, *,
                     constant: Optional[npt.ArrayLike] = None, part: Sequence[float] = WHOLE_EDGE) -> int:
        """Add a traction [Pa] on an edge that is not an interface, or on a part of it; returns the id of the load."""
        edge = self._sketch.edge("add_traction", region, edge)
        count, *values = arguments.samples("add_traction", constant, proportional)
        load = self._added("bempd_add_traction", region, edge, *arguments.fraction_pair("add_traction: part", part),
                           arguments.choice("add_traction: component", component, ONE_COMPONENT), count, *values)
        return self._load(load, Mark(region, edge, does=f"traction along {component}"))

    def add_pressure(self, region: int, edge: Edge, proportional: Optional[npt.ArrayLike] = None, *,
                     constant: Optional[npt.ArrayLike] = None, part: Sequence[float] = WHOLE_EDGE) -> int:
        """Press [Pa] on an edge that is not an interface, or on a part of it; returns the id of the load."""
        edge = self._sketch.edge("add_pressure", region, edge)
        count, *values = arguments.samples("add_pressure", constant, proportional)
        ends = arguments.fraction_pair("add_pressure: part", part)
        return self._load(self._added("bempd_add_pressure", region, edge, *ends, count, *values),
                          Mark(region, edge, does="pressure"))

    def add_traction_function(self, region: int, edge: Edge, function: BoundaryFunction, *,
                              part: Sequence[float] = WHOLE_EDGE) -> int:
        """Add a traction given by a function f(x, y), as prescribe_edge_function() has it; returns the id of the load.

        >>> import bempd
        >>> model = bempd.Model()
        >>> glass = model.add_material(young_modulus=3e9, poisson_ratio=0.3)
        >>> plate = model.add_bem_region(glass, bempd.rectangle(0, 0, 2, 1), element_length=0.25)
        >>> support = model.fix_edge(plate, 4)
        >>> model.add_traction_function(plate, 2, lambda x, y: (0, 6e6 * y * (1 - y)))
        1
        """
        edge = self._sketch.edge("add_traction_function", region, edge)
        ends = arguments.fraction_pair("add_traction_function: part", part)
        load = self._added("bempd_add_traction_function", region, edge, *ends, self._kept(function), ffi.NULL)
        return self._load(load, Mark(region, edge, does="traction by a function"))

    def add_crack_traction(self, crack: int, component: FaceComponent, proportional: Optional[npt.ArrayLike] = None, *,
                           constant: Optional[npt.ArrayLike] = None) -> int:
        """Add "pressure" or "shear" [Pa] on both faces of a crack in a BEM region; returns the id of the load."""
        count, *values = arguments.samples("add_crack_traction", constant, proportional)
        chosen = arguments.choice("add_crack_traction: component", component, FACE_COMPONENTS)
        return self._load(self._added("bempd_add_crack_traction", crack, chosen, count, *values),
                          Mark(crack=crack, does=f"{component} on both faces"))

    def add_point_force(self, point: Sequence[float], component: Component, proportional: float = 0.0, *,
                        constant: float = 0.0) -> int:
        """Add a force [N] on the node or material point at a place; returns the id of the load."""
        place = arguments.place("add_point_force: point", point)
        load = self._added("bempd_add_point_force", *place,
                           arguments.choice("add_point_force: component", component, ONE_COMPONENT), constant,
                           proportional)
        return self._load(load, Mark(point=place, does=f"force along {component}"))

    def add_body_force(self, region: int, component: Component, proportional: float = 0.0, *, constant: float = 0.0) -> int:
        """Add a force per volume [N/m^3] on a whole region, such as its weight; returns the id of the load."""
        load = self._added("bempd_add_body_force", region,
                           arguments.choice("add_body_force: component", component, ONE_COMPONENT), constant,
                           proportional)
        return self._load(load, Mark(region, does=f"body force along {component}"))

    def add_rotation(self, region: int, axis: Sequence[float], proportional: float = 0.0, *, constant: float = 0.0) -> int:
        """Let a region turn about an axis: density times angular velocity squared [N/m^4]; returns the id of the load."""
        load = self._added("bempd_add_rotation", region, axis[0], axis[1], constant, proportional)
        return self._load(load, Mark(region, does="rotation"))

    def add_crack_pressure(self, crack: int, proportional: float = 0.0, *, constant: float = 0.0) -> int:
        """Add a uniform pressure [Pa] in a crack that follows wherever it grows, in either kind of region; returns the id
        of the load."""
        load = self._added("bempd_add_crack_pressure", crack, constant, proportional)
        return self._load(load, Mark(crack=crack, does="pressure that follows the crack"))

    def add_temperature(self, region: int, proportional: float = 0.0, *, constant: float = 0.0) -> int:
        """Change the temperature [K] of a whole region; returns the id of the load."""
        load = self._added("bempd_add_temperature", region, constant, proportional)
        self._sketch.regions[region].heated = True
        return self._load(load, Mark(region, does="temperature"))

    def add_temperature_function(self, region: int, function: BoundaryFunction) -> int:
        """Change the temperature [K] of a region by a function f(x, y), asked once for each place; returns the id of the
        load.

        It returns the part that is multiplied by the load factor and, unused, 0, or two pairs, constant and
        proportional, of which the first numbers count. In a BEM region it has to be linear.
        """
        load = self._added("bempd_add_temperature_function", region, self._kept(function), ffi.NULL)
        self._sketch.regions[region].heated = True
        return self._load(load, Mark(region, does="temperature"))

    def set_load_values(self, load: int, proportional: Optional[npt.ArrayLike] = None, *,
                        constant: Optional[npt.ArrayLike] = None) -> None:
        """Give a traction or point force new values, as many as it was made with; they act from the next step on."""
        self._set_values("load", load, constant, proportional)

    def set_support_values(self, support: int, proportional: Optional[npt.ArrayLike] = None, *,
                           constant: Optional[npt.ArrayLike] = None) -> None:
        """Give a support new prescribed displacements, as many as it was made with."""
        self._set_values("support", support, constant, proportional)

    def _set_values(self, what: str, number: int, constant: Any, proportional: Any) -> None:
        count, *values = arguments.samples(f"set_{what}_values", constant, proportional)
        name = "bempd_set_load_values" if what == "load" else "bempd_set_support_values"
        self._open().call(name, number, count, *values, changes=True)
        mark = self._sketch.supports.get(number) if what == "support" else None
        if mark is not None and mark.component is not None:
            self._sketch.supports[number] = dataclasses.replace(mark, proportional=arguments.one_number(proportional))

    def _support(self, number: int, mark: Mark) -> int:
        self._sketch.supports[number] = mark
        return number

    def _load(self, number: int, mark: Mark) -> int:
        self._sketch.loads[number] = mark
        return number

    def _kept(self, function: BoundaryFunction) -> Any:
        handle = self._open()
        callback = boundary_callback(handle.raised, function)
        handle.callbacks.append(callback)
        return callback


def held(component: Components) -> str:
    """What a support does that fixes components."""
    return ("x and y" if component == "both" else component) + " held"


def rectangle(left: float, bottom: float, right: float, top: float) -> list[tuple[float, float]]:
    """Vertices of a rectangle; its edges are 1 bottom, 2 right, 3 top, 4 left.

    >>> import bempd
    >>> bempd.rectangle(0, 0, 2, 1)
    [(0, 0), (2, 0), (2, 1), (0, 1)]
    """
    return [(left, bottom), (right, bottom), (right, top), (left, top)]
