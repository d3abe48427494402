"""Stress intensity factors by finite elements of dolfinx (Debian: python3-dolfinx, python3-gmsh): quadratic triangles with
quarter points around the tips, as long as their distance from the tip allows, MUMPS' Cholesky factorization. Pure mode I by
the J-integral over a ring around one tip, both modes by interaction integrals over it.

    /usr/bin/python3 dolfinx_crack.py centre|edge|hole|inclined whole|symmetric CRACK REPEATS SIZE TIP SLOPE [SIZE TIP SLOPE ...]

`centre`, `edge`: a plate 1 wide to one side of the crack's middle or mouth and 3 high to each side of the crack, of length
CRACK. `hole`: two cracks from a hole of radius 1 in the middle of a square of half width 20, their ends CRACK from its centre.
`inclined`: a crack of half length 1, CRACK degrees from the x axis, in the same square. All are pulled by 1 in y.
`symmetric`: a quarter of the plate with a crack in its middle or a hole, half of that with an edge crack.

Triangles are TIP long at tips and longer by SLOPE times the distance from them, at most SIZE. Prints one line of JSON for each
triple: K_I and K_II over the root of pi times the length, unknowns, seconds to mesh and seconds to solve (spaces, assembly,
factorization, solution, integrals): the least of REPEATS each; imports and compilation of forms are not counted; processor time.
"""
import json
import math
import sys
import time

import gmsh
import numpy as np
import ufl
from dolfinx import fem
from dolfinx.fem import petsc
from dolfinx.io import gmshio
from mpi4py import MPI
from petsc4py import PETSc

POISSON = 0.3
DEGREE = {"quadrature_degree": 4}


class Case:
    """A plate between (left, -height) and (width, height) with its cracks."""

    def __init__(self, kind, part, crack):
        self.kind, self.whole, self.crack = kind, part == "whole", crack
        strip = kind in ("centre", "edge")
        self.width, self.height = (1.0, 3.0) if strip else (20.0, 20.0)
        self.left = 0.0 if kind == "edge" or not self.whole else -self.width
        angle = math.radians(crack) if kind == "inclined" else 0.0
        self.length = 1.0 if kind == "inclined" else crack
        self.along = (math.cos(angle), math.sin(angle))
        self.tip = (self.length * self.along[0], self.length * self.along[1])
        # Radius of the outer edge of the ring.
        self.ring = 0.8 * {"hole": crack - 1}.get(kind, min(self.length, self.width - self.length))


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


def part_outline(case, point, join):
    """Of the part that symmetry leaves."""
    w, h = case.width, case.height
    tip = point(*case.tip)
    shapes = gmsh.model.geo
    if case.kind == "hole":
        centre, mouth, right, top_right, top, above = (point(*p) for p in ((0, 0), (1, 0), (w, 0), (w, h), (0, h), (0, 1)))
        lines = [shapes.addLine(p, q) for p, q in zip((mouth, tip, right, top_right, top), (tip, right, top_right, top, above))]
        loop = [*lines, shapes.addCircleArc(above, centre, mouth)]
    else:
        loop = join([point(0, 0), tip, point(w, 0), point(w, h), point(0, h)])
    shapes.addPlaneSurface([shapes.addCurveLoop(loop)])
    return tip


def whole_with_hole(case, point, edges):
    shapes = gmsh.model.geo
    centre, around = point(0, 0), [point(*p) for p in ((1, 0), (0, 1), (-1, 0), (0, -1))]
    arcs = [shapes.addCircleArc(p, centre, q) for p, q in zip(around, around[1:] + around[:1])]
    surface = shapes.addPlaneSurface([shapes.addCurveLoop(edges), shapes.addCurveLoop(arcs)])
    tips, mouths = [point(*case.tip), point(-case.tip[0], 0)], around[::2]
    lines = [shapes.addLine(mouth, tip) for mouth, tip in zip(mouths, tips)]
    shapes.synchronize()
    gmsh.model.mesh.embed(1, lines, 2, surface)
    return tips, mouths, lines


def outline(case):
    """Surface with the cracks' lines; points of their tips and mouths, and the lines if they have two faces."""
    shapes = gmsh.model.geo
    point = lambda x, y: shapes.addPoint(x, y, 0)
    join = lambda points: [shapes.addLine(p, q) for p, q in zip(points, points[1:] + points[:1])]
    if not case.whole:
        return [part_outline(case, point, join)], [], []
    corners = [point(x, y) for x, y in ((case.left, -case.height), (case.width, -case.height), (case.width, case.height),
                                        (case.left, case.height))]
    if case.kind == "hole":
        return whole_with_hole(case, point, join(corners))
    inner = case.kind != "edge"
    start, tip = point(-case.tip[0], -case.tip[1]) if inner else point(0, 0), point(*case.tip)
    edges = join(corners if inner else [*corners, start])
    surface = shapes.addPlaneSurface([shapes.addCurveLoop(edges)])
    line = shapes.addLine(start, tip)
    shapes.synchronize()
    gmsh.model.mesh.embed(1, [line], 2, surface)
    return ([start, tip], [], [line]) if inner else ([tip], [start], [line])


def part_faces(lines, mouths):
    """Doubles the nodes of the cracks."""
    faces = gmsh.model.addPhysicalGroup(1, lines)
    gmsh.plugin.setNumber("Crack", "Dimension", 1)
    gmsh.plugin.setNumber("Crack", "PhysicalGroup", faces)
    if mouths:
        gmsh.plugin.setNumber("Crack", "OpenBoundaryPhysicalGroup", gmsh.model.addPhysicalGroup(0, mouths))
    gmsh.plugin.run("Crack")
    gmsh.model.mesh.renumberNodes()


def make_mesh(case, size, at_tip, slope):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    tips, mouths, lines = outline(case)
    gmsh.model.geo.synchronize()
    gmsh.option.setNumber("Mesh.MeshSizeMax", size)
    gmsh.option.setNumber("Mesh.MeshSizeExtendFromBoundary", 0)
    field = gmsh.model.mesh.field
    field.add("Distance", 1)
    field.setNumbers(1, "PointsList", tips)
    field.add("Threshold", 2)
    for name, number in (("InField", 1), ("SizeMin", at_tip), ("SizeMax", size), ("DistMin", 0),
                         ("DistMax", (size - at_tip) / slope)):
        field.setNumber(2, name, number)
    field.setAsBackgroundMesh(2)
    gmsh.model.addPhysicalGroup(2, [1], 1)
    gmsh.model.mesh.generate(2)
    gmsh.model.mesh.setOrder(2)
    quarter_points({gmsh.model.mesh.getNodes(0, tip)[0][0] for tip in tips})
    if lines:
        part_faces(lines, mouths)
    mesh, _, _ = gmshio.model_to_mesh(gmsh.model, MPI.COMM_SELF, 0, gdim=2)
    gmsh.finalize()
    return mesh


def supports_of(case, space):
    def held(component, where):
        part, _ = space.sub(component).collapse()
        dofs = fem.locate_dofs_geometrical((space.sub(component), part), where)
        return fem.dirichletbc(fem.Function(part), dofs, space.sub(component))

    at_left, low = (lambda x: np.isclose(x[0], case.left)), (lambda x: np.isclose(x[1], -case.height))
    right = lambda x: np.isclose(x[0], case.width)
    if case.whole:
        return [held(0, lambda x: right(x) & low(x)), held(1, lambda x: right(x) & low(x)),
                held(1, lambda x: at_left(x) & low(x))]
    # Supports: the line ahead of the tip, and the middle of the plate or one point.
    on_axis = lambda x: np.isclose(x[1], 0)
    return [held(1, lambda x: on_axis(x) & (x[0] > case.length - 1e-9)),
            held(0, (lambda x: right(x) & on_axis(x)) if case.kind == "edge" else at_left)]


def factors(mesh, case):
    """K_I and K_II over the root of pi times the length, and the unknowns."""
    space = fem.VectorFunctionSpace(mesh, ("Lagrange", 2))
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    strain = lambda grad: 0.5 * (grad + grad.T)
    mu, lam = 1 / (2 * (1 + POISSON)), POISSON / (1 - POISSON**2)  # Young's modulus 1, plane stress
    stress = lambda e: 2 * mu * e + lam * ufl.tr(e) * ufl.Identity(2)
    supports = supports_of(case, space)
    at = ufl.SpatialCoordinate(mesh)
    height = case.height
    ends = ufl.conditional(ufl.gt(at[1], height - 1e-9), 1.0, ufl.conditional(ufl.lt(at[1], 1e-9 - height), -1.0, 0.0))
    inside, outside = ufl.dx(metadata=DEGREE), ufl.ds(metadata=DEGREE)
    matrix = petsc.assemble_matrix(fem.form(ufl.inner(stress(strain(ufl.grad(u))), ufl.grad(v)) * inside), bcs=supports)
    matrix.assemble()
    rhs = petsc.assemble_vector(fem.form(ends * v[1] * outside))
    petsc.set_bc(rhs, supports)
    solver = PETSc.KSP().create(MPI.COMM_SELF)
    solver.setOperators(matrix)
    solver.setType("preonly")
    solver.getPC().setType("cholesky")
    solver.getPC().setFactorSolverType("mumps")
    found = fem.Function(space)
    solver.solve(rhs, found.vector)
    unknowns = space.dofmap.index_map.size_global * 2
    constant = lambda number: fem.Constant(mesh, float(number))
    along, across = (constant(case.along[0]), constant(case.along[1])), (constant(-case.along[1]), constant(case.along[0]))
    # The weight falls from 1 to 0 across a ring.
    place = (at[0] - constant(case.tip[0]), at[1] - constant(case.tip[1]))
    r = ufl.sqrt(place[0]**2 + place[1]**2 + 1e-30)
    s = ufl.max_value(0.0, ufl.min_value(1.0, (r / constant(case.ring) - 0.25) / 0.75))
    slope = ufl.grad(1 - 3 * s**2 + 2 * s**3)
    grad = ufl.grad(found)
    sigma = stress(strain(grad))
    derivative = lambda g: ufl.as_vector([g[i, 0] * along[0] + g[i, 1] * along[1] for i in range(2)])
    slope_along = slope[0] * along[0] + slope[1] * along[1]
    scale = math.sqrt(math.pi * case.length)
    if case.kind != "inclined":
        rate = fem.assemble_scalar(fem.form((ufl.dot(ufl.dot(sigma, derivative(grad)), slope)
                                             - 0.5 * ufl.inner(sigma, strain(grad)) * slope_along) * inside))
        return math.sqrt((1 if case.whole else 2) * rate) / scale, 0.0, unknowns
    angle = ufl.atan_2(place[0] * across[0] + place[1] * across[1], place[0] * along[0] + place[1] * along[1])
    kappa = (3 - POISSON) / (1 + POISSON)
    size = ufl.sqrt(r / (2 * math.pi)) / (2 * mu)
    sine, cosine = ufl.sin(angle / 2), ufl.cos(angle / 2)
    values = []
    for one, two in ((cosine * (kappa - 1 + 2 * sine**2), sine * (kappa + 1 - 2 * cosine**2)),
                     (sine * (kappa + 1 + 2 * cosine**2), -cosine * (kappa - 1 - 2 * sine**2))):
        other = ufl.grad(size * ufl.as_vector([one * along[i] + two * across[i] for i in range(2)]))
        other_sigma = stress(strain(other))
        mixed = (ufl.dot(ufl.dot(sigma, derivative(other)) + ufl.dot(other_sigma, derivative(grad)), slope)
                 - ufl.inner(sigma, strain(other)) * slope_along)
        values.append(0.5 * fem.assemble_scalar(fem.form(mixed * inside)) / scale)
    return values[0], values[1], unknowns


def main():
    case, repeats = Case(sys.argv[1], sys.argv[2], float(sys.argv[3])), int(sys.argv[4])
    numbers = [float(word) for word in sys.argv[5:]]
    factors(make_mesh(case, 2.0 if case.width > 1 else 0.5, 0.2, 0.5), case)  # compiles the forms
    for size, at_tip, slope in zip(numbers[::3], numbers[1::3], numbers[2::3]):
        meshing, solving = [], []
        for _ in range(repeats):
            start = time.process_time()
            mesh = make_mesh(case, size, at_tip, slope)
            middle = time.process_time()
            one, two, unknowns = factors(mesh, case)
            meshing.append(middle - start)
            solving.append(time.process_time() - middle)
        print(json.dumps({"value": one, "value_2": two, "unknowns": unknowns, "size": size, "at_tip": at_tip, "slope": slope,
                          "seconds_mesh": min(meshing), "seconds_solve": min(solving)}), flush=True)


main()
