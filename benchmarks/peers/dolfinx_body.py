"""Plates with round holes and cracks by finite elements of dolfinx (Debian: python3-dolfinx, python3-gmsh): quadratic triangles
with quarter points around the tips, MUMPS' Cholesky factorization, K_I and K_II by interaction integrals around each tip. A crack
grows by a new mesh for each step, in the direction of the largest hoop stress (Erdogan and Sih, 1963).

    /usr/bin/python3 dolfinx_body.py < SCENE

SCENE is JSON: "size" [width, height]; "holes" [[x, y, radius], ...]; "cracks", polylines, of which an end on the left edge is a
mouth; "tips" [[crack, 0 or -1], ...]; "step" and "steps" of the first tip's growth; "ring", radius of the integrals. Young's
modulus 1, Poisson's ratio 0.3, plane stress; upper and lower edge carry the traction 1. "meshes" [[size, at_tip, slope, at_hole], ...]:
triangles are at_tip long at tips, at_hole at holes, and longer by slope times the distance, at most size.

Prints a line of JSON for each mesh: displacement (y, of the upper right corner), K of the tips, path and loads 1 / K_eq of each step of growth,
unknowns of the last mesh, processor seconds to mesh and to solve. The first line has the seconds of imports and of the
compilation of forms, which those of the meshes leave out.
"""
import time

BEGIN = time.process_time()
import json  # noqa: E402
import math  # noqa: E402
import os  # noqa: E402
import sys  # noqa: E402

import gmsh  # noqa: E402
import numpy as np  # noqa: E402
import ufl  # noqa: E402
from dolfinx import fem  # noqa: E402
from dolfinx.fem import petsc  # noqa: E402
from dolfinx.io import gmshio  # noqa: E402
from mpi4py import MPI  # noqa: E402
from petsc4py import PETSc  # noqa: E402

IMPORTS = time.process_time() - BEGIN


def with_compilers():
    """Processor seconds of this process and of those it has waited for."""
    used = os.times()
    return used.user + used.system + used.children_user + used.children_system


POISSON = 0.3
MU, LAMBDA = 1 / (2 * (1 + POISSON)), POISSON / (1 - POISSON**2)  # plane stress
KAPPA = (3 - POISSON) / (1 + POISSON)
DEGREE = {"quadrature_degree": 4}


def add_loops(scene, mouths):
    """Curve loops of the rectangle, whose left edge is parted at mouths, and of the holes; and the points of mouths."""
    shapes, (width, height) = gmsh.model.geo, scene["size"]
    ways = sorted(mouths, key=lambda place: -place[1])
    points = [shapes.addPoint(x, y, 0) for x, y in [(0, 0), (width, 0), (width, height), (0, height), *ways]]
    edges = [shapes.addLine(p, q) for p, q in zip(points, points[1:] + points[:1])]
    loops, arcs = [shapes.addCurveLoop(edges)], []
    for x, y, radius in scene["holes"]:
        centre = shapes.addPoint(x, y, 0)
        around = [shapes.addPoint(x + radius * a, y + radius * b, 0) for a, b in ((1, 0), (0, 1), (-1, 0), (0, -1))]
        arcs += [shapes.addCircleArc(p, centre, q) for p, q in zip(around, around[1:] + around[:1])]
        loops.append(shapes.addCurveLoop(arcs[-4:]))
    return loops, arcs, dict(zip(ways, points[4:]))


def set_sizes(sizes, tips, arcs):
    size, at_tip, slope, at_hole = sizes
    field = gmsh.model.mesh.field
    for number, (kind, places, least) in enumerate((("PointsList", tips, at_tip), ("CurvesList", arcs, at_hole))):
        field.add("Distance", 2 * number + 1)
        field.setNumbers(2 * number + 1, kind, places)
        field.setNumber(2 * number + 1, "NumPointsPerCurve", 40)
        field.add("Threshold", 2 * number + 2)
        for name, value in (("InField", 2 * number + 1), ("SizeMin", least), ("SizeMax", size), ("DistMin", 0),
                            ("DistMax", max(size - least, 1e-9) / slope)):
            field.setNumber(2 * number + 2, name, value)
    field.add("Min", 5)
    field.setNumbers(5, "FieldsList", [number for number, places in ((2, tips), (4, arcs)) if places])
    field.setAsBackgroundMesh(5)
    for name, value in (("MeshSizeMax", size), ("MeshSizeExtendFromBoundary", 0), ("MeshSizeFromPoints", 0)):
        gmsh.option.setNumber("Mesh." + name, value)


def quarter_points(tips):
    """Moves the mid nodes next to the tips, so that displacements there go with the root of the distance."""
    _, corners = gmsh.model.mesh.getElementsByType(9)
    for nodes in np.reshape(corners, (-1, 6)):
        for k in range(3):
            start, end, middle = nodes[k], nodes[(k + 1) % 3], nodes[3 + k]
            for near, far in ((start, end), (end, start)):
                if near in tips:
                    here, there = (np.array(gmsh.model.mesh.getNode(n)[0]) for n in (near, far))
                    gmsh.model.mesh.setNode(middle, 0.75 * here + 0.25 * there, [])


def part_faces(cracks, mouths):
    """Doubles the nodes of the cracks."""
    for lines, mouth in zip(cracks, mouths):
        faces = gmsh.model.addPhysicalGroup(1, lines)
        gmsh.plugin.setNumber("Crack", "Dimension", 1)
        gmsh.plugin.setNumber("Crack", "PhysicalGroup", faces)
        gmsh.plugin.setNumber("Crack", "OpenBoundaryPhysicalGroup", gmsh.model.addPhysicalGroup(0, mouth) if mouth else 0)
        gmsh.plugin.run("Crack")


def make_mesh(scene, cracks, sizes):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    shapes = gmsh.model.geo
    loops, arcs, mouths = add_loops(scene, [path[end] for path in cracks for end in (0, -1) if path[end][0] == 0])
    surface = shapes.addPlaneSurface(loops)
    lines, tips, open_ends = [], [], []
    for path in cracks:
        points = [mouths[place] if place in mouths else shapes.addPoint(*place, 0) for place in path]
        lines.append([shapes.addLine(p, q) for p, q in zip(points, points[1:])])
        tips += [points[end] for end in (0, -1) if path[end] not in mouths]
        open_ends.append([points[end] for end in (0, -1) if path[end] in mouths])
    shapes.synchronize()
    if lines:
        gmsh.model.mesh.embed(1, [line for crack in lines for line in crack], 2, surface)
    set_sizes(sizes, tips, arcs)
    gmsh.model.addPhysicalGroup(2, [surface], 1)
    gmsh.model.mesh.generate(2)
    gmsh.model.mesh.setOrder(2)
    if tips:
        quarter_points({gmsh.model.mesh.getNodes(0, tip)[0][0] for tip in tips})
    part_faces(lines, open_ends)
    gmsh.model.mesh.renumberNodes()
    mesh, _, _ = gmshio.model_to_mesh(gmsh.model, MPI.COMM_SELF, 0, gdim=2)
    gmsh.finalize()
    return mesh


def strain(grad):
    return 0.5 * (grad + grad.T)


def stress(e):
    return 2 * MU * e + LAMBDA * ufl.tr(e) * ufl.Identity(2)


def at_corner(space, component, x, y):
    part, _ = space.sub(component).collapse()
    return fem.locate_dofs_geometrical((space.sub(component), part), lambda p: np.isclose(p[0], x) & np.isclose(p[1], y)), part


def solve(mesh, scene):
    """Displacement field, that of the upper right corner in y, and the unknowns."""
    width, height = scene["size"]
    space = fem.VectorFunctionSpace(mesh, ("Lagrange", 2))
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    supports = []
    for component, x in ((0, 0), (1, 0), (1, width)):
        dofs, part = at_corner(space, component, x, 0)
        supports.append(fem.dirichletbc(fem.Function(part), dofs, space.sub(component)))
    at, high = ufl.SpatialCoordinate(mesh), fem.Constant(mesh, float(height))
    ends = ufl.conditional(ufl.gt(at[1], high - 1e-9), 1.0, ufl.conditional(ufl.lt(at[1], 1e-9), -1.0, 0.0))
    matrix = petsc.assemble_matrix(fem.form(ufl.inner(stress(strain(ufl.grad(u))), ufl.grad(v)) * ufl.dx(metadata=DEGREE)),
                                   bcs=supports)
    matrix.assemble()
    rhs = petsc.assemble_vector(fem.form(ends * v[1] * ufl.ds(metadata=DEGREE)))
    petsc.set_bc(rhs, supports)
    solver = PETSc.KSP().create(MPI.COMM_SELF)
    solver.setOperators(matrix)
    solver.setType("preonly")
    solver.getPC().setType("cholesky")
    solver.getPC().setFactorSolverType("mumps")
    found = fem.Function(space)
    solver.solve(rhs, found.vector)
    corner = found.x.array[at_corner(space, 1, width, height)[0][0]]
    return found, float(corner[0]), space.dofmap.index_map.size_global * 2


def crack_tip_fields(r, angle, along, across):
    """Gradients of the displacements of K_I = 1 and of K_II = 1 (Williams, 1957)."""
    sine, cosine = ufl.sin(angle / 2), ufl.cos(angle / 2)
    size = ufl.sqrt(r / (2 * math.pi)) / (2 * MU)
    for one, two in ((cosine * (KAPPA - 1 + 2 * sine**2), sine * (KAPPA + 1 - 2 * cosine**2)),
                     (sine * (KAPPA + 1 + 2 * cosine**2), -cosine * (KAPPA - 1 - 2 * sine**2))):
        yield ufl.grad(size * ufl.as_vector([one * along[i] + two * across[i] for i in range(2)]))


class TipIntegrals:
    """Interaction integrals over a ring whose weight falls from 1 to 0; compiled once, the tip's numbers are constants."""

    def __init__(self, mesh, found):
        constant = [fem.Constant(mesh, 0.0) for _ in range(5)]
        self.numbers = constant
        along, across = (constant[2], constant[3]), (-constant[3], constant[2])
        at = ufl.SpatialCoordinate(mesh)
        place = (at[0] - constant[0], at[1] - constant[1])
        r = ufl.sqrt(place[0]**2 + place[1]**2 + 1e-30)
        s = ufl.max_value(0.0, ufl.min_value(1.0, (r / constant[4] - 0.25) / 0.75))
        slope = ufl.grad(1 - 3 * s**2 + 2 * s**3)
        angle = ufl.atan_2(place[0] * across[0] + place[1] * across[1], place[0] * along[0] + place[1] * along[1])
        grad = ufl.grad(found)
        derivative = lambda g: ufl.as_vector([g[i, 0] * along[0] + g[i, 1] * along[1] for i in range(2)])
        slope_along = slope[0] * along[0] + slope[1] * along[1]
        self.forms = []
        for other in crack_tip_fields(r, angle, along, across):
            mixed = (ufl.dot(ufl.dot(stress(strain(grad)), derivative(other))
                             + ufl.dot(stress(strain(other)), derivative(grad)), slope)
                     - ufl.inner(stress(strain(grad)), strain(other)) * slope_along)
            self.forms.append(fem.form(mixed * ufl.dx(metadata=DEGREE)))

    def factors(self, tip, behind, ring):
        length = math.dist(tip, behind)
        numbers = (*tip, (tip[0] - behind[0]) / length, (tip[1] - behind[1]) / length, ring)
        for constant, number in zip(self.numbers, numbers):
            constant.value = number
        return [0.5 * fem.assemble_scalar(form) for form in self.forms]


def hoop(one, two):
    """Angle of the largest hoop stress, and the equivalent factor."""
    angle = 2 * math.atan2(-2 * two, one + math.hypot(one, math.sqrt(8) * two))
    cosine = math.cos(angle / 2)
    return angle, cosine * (one * cosine**2 - 1.5 * two * math.sin(angle))


def run(scene, sizes):
    """All steps of growth, or one solution."""
    cracks = [[tuple(place) for place in path] for path in scene["cracks"]]
    meshing = solving = 0.0
    loads, answer = [], {}
    for _ in range(scene.get("steps", 1)):
        start = time.process_time()
        mesh = make_mesh(scene, cracks, sizes)
        middle = time.process_time()
        found, corner, unknowns = solve(mesh, scene)
        factors = []
        if cracks:
            integrals = TipIntegrals(mesh, found)
            ends = [(cracks[crack][end], cracks[crack][end - 1 if end else 1]) for crack, end in scene["tips"]]
            factors = [integrals.factors(tip, behind, scene["ring"]) for tip, behind in ends]
        if "steps" in scene:
            turn, equivalent = hoop(*factors[0])
            loads.append(1 / equivalent)
            (x, y), behind = ends[0]
            turn += math.atan2(y - behind[1], x - behind[0])
            cracks[scene["tips"][0][0]].append((x + scene["step"] * math.cos(turn), y + scene["step"] * math.sin(turn)))
        meshing += middle - start
        solving += time.process_time() - middle
        answer = {"displacement": corner, "factors": factors, "unknowns": unknowns}
    return {**answer, "path": cracks[0] if cracks else [], "loads": loads, "seconds_mesh": meshing, "seconds_solve": solving}


def main():
    scene = json.load(sys.stdin)
    coarse = [(scene["size"][0] / 4, scene["size"][0] / 20, 0.5, scene["size"][0] / 10)] * 2
    total = []
    for sizes in coarse:
        start = with_compilers()
        run({**scene, **({"steps": 1} if "steps" in scene else {})}, sizes)
        total.append(with_compilers() - start)
    print(json.dumps({"imports": IMPORTS, "compilation": total[0] - total[1]}), flush=True)
    for sizes in scene["meshes"]:
        print(json.dumps(run(scene, sizes)), flush=True)


main()
