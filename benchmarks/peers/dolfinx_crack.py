"""Stress intensity factors by finite elements of dolfinx (Debian: python3-dolfinx, python3-gmsh): quadratic triangles with
quarter points around the tips, the J-integral over a ring around one, MUMPS' Cholesky factorization.

    /usr/bin/python3 dolfinx_crack.py centre|edge whole|symmetric CRACK REPEATS SIZE REFINEMENT [SIZE REFINEMENT ...]

`symmetric`: a quarter of the plate with a crack in its middle, half of that with an edge crack.

The plate is 1 wide to one side of the crack's middle or mouth and 3 high to each side of the crack, of length CRACK, pulled
by 1. SIZE is the length of a triangle, SIZE / REFINEMENT at the tip. Prints one line of JSON for each pair: K over the root
of pi CRACK, unknowns, seconds to mesh and seconds to solve (spaces, assembly, factorization, solution, J: the least of
REPEATS; imports and compilation of forms are not counted; processor time).
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

WIDTH, HEIGHT, POISSON = 1.0, 3.0, 0.3


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


def outline(kind, whole, crack):
    """Surface with the crack's line; points of its tips and mouth, and the line if it has two faces."""
    shapes = gmsh.model.geo
    point = lambda x, y: shapes.addPoint(x, y, 0)
    join = lambda points: [shapes.addLine(p, q) for p, q in zip(points, points[1:] + points[:1])]
    if not whole:
        points = [point(x, y) for x, y in ((0, 0), (crack, 0), (WIDTH, 0), (WIDTH, HEIGHT), (0, HEIGHT))]
        shapes.addPlaneSurface([shapes.addCurveLoop(join(points))])
        return [points[1]], None, None
    left = -WIDTH if kind == "centre" else 0.0
    corners = [point(x, y) for x, y in ((left, -HEIGHT), (WIDTH, -HEIGHT), (WIDTH, HEIGHT), (left, HEIGHT))]
    start, tip = point(-crack if kind == "centre" else 0.0, 0), point(crack, 0)
    edges = join(corners if kind == "centre" else [*corners, start])
    surface = shapes.addPlaneSurface([shapes.addCurveLoop(edges)])
    line = shapes.addLine(start, tip)
    shapes.synchronize()
    gmsh.model.mesh.embed(1, [line], 2, surface)
    return ([start, tip], None, line) if kind == "centre" else ([tip], start, line)


def part_faces(line, mouth):
    """Doubles the nodes of the crack."""
    faces = gmsh.model.addPhysicalGroup(1, [line])
    gmsh.plugin.setNumber("Crack", "Dimension", 1)
    gmsh.plugin.setNumber("Crack", "PhysicalGroup", faces)
    if mouth:
        gmsh.plugin.setNumber("Crack", "OpenBoundaryPhysicalGroup", gmsh.model.addPhysicalGroup(0, [mouth]))
    gmsh.plugin.run("Crack")
    gmsh.model.mesh.renumberNodes()


def make_mesh(kind, whole, crack, size, refinement):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    tips, mouth, line = outline(kind, whole, crack)
    gmsh.model.geo.synchronize()
    gmsh.option.setNumber("Mesh.MeshSizeMax", size)
    gmsh.option.setNumber("Mesh.MeshSizeExtendFromBoundary", 0)
    field = gmsh.model.mesh.field
    field.add("Distance", 1)
    field.setNumbers(1, "PointsList", tips)
    field.add("Threshold", 2)
    field.setNumber(2, "InField", 1)
    field.setNumber(2, "SizeMin", size / refinement)
    field.setNumber(2, "SizeMax", size)
    field.setNumber(2, "DistMin", 0)
    field.setNumber(2, "DistMax", 0.5)
    field.setAsBackgroundMesh(2)
    gmsh.model.addPhysicalGroup(2, [1], 1)
    gmsh.model.mesh.generate(2)
    gmsh.model.mesh.setOrder(2)
    quarter_points({gmsh.model.mesh.getNodes(0, tip)[0][0] for tip in tips})
    if line:
        part_faces(line, mouth)
    mesh, _, _ = gmshio.model_to_mesh(gmsh.model, MPI.COMM_SELF, 0, gdim=2)
    gmsh.finalize()
    return mesh


def factor(mesh, kind, whole, crack):
    space = fem.VectorFunctionSpace(mesh, ("Lagrange", 2))
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    strain = lambda w: ufl.sym(ufl.grad(w))
    mu, lam = 1 / (2 * (1 + POISSON)), POISSON / (1 - POISSON**2)  # Young's modulus 1, plane stress
    stress = lambda w: 2 * mu * strain(w) + lam * ufl.tr(strain(w)) * ufl.Identity(2)

    def held(component, where):
        part, _ = space.sub(component).collapse()
        dofs = fem.locate_dofs_geometrical((space.sub(component), part), where)
        return fem.dirichletbc(fem.Function(part), dofs, space.sub(component))

    corner = lambda x: np.isclose(x[0], WIDTH) & np.isclose(x[1], -HEIGHT)
    if whole:
        left = -WIDTH if kind == "centre" else 0.0
        supports = [held(0, corner), held(1, corner), held(1, lambda x: np.isclose(x[0], left) & np.isclose(x[1], -HEIGHT))]
    else:  # ahead of the tip, and the middle of the plate or one point
        supports = [held(1, lambda x: np.isclose(x[1], 0) & (x[0] > crack - 1e-9)),
                    held(0, (lambda x: np.isclose(x[0], 0)) if kind == "centre" else
                         lambda x: np.isclose(x[0], WIDTH) & np.isclose(x[1], 0))]
    at = ufl.SpatialCoordinate(mesh)
    ends = ufl.conditional(ufl.gt(at[1], HEIGHT - 1e-9), 1.0, ufl.conditional(ufl.lt(at[1], 1e-9 - HEIGHT), -1.0, 0.0))
    stiffness = fem.form(ufl.inner(stress(u), strain(v)) * ufl.dx)
    matrix = petsc.assemble_matrix(stiffness, bcs=supports)
    matrix.assemble()
    rhs = petsc.assemble_vector(fem.form(ends * v[1] * ufl.ds))
    petsc.set_bc(rhs, supports)
    solver = PETSc.KSP().create(MPI.COMM_SELF)
    solver.setOperators(matrix)
    solver.setType("preonly")
    solver.getPC().setType("cholesky")
    solver.getPC().setFactorSolverType("mumps")
    found = fem.Function(space)
    solver.solve(rhs, found.vector)
    # The weight falls from 1 to 0 across a ring.
    radius = fem.Constant(mesh, 0.8 * min(crack, WIDTH - crack))
    r = ufl.sqrt((at[0] - fem.Constant(mesh, crack))**2 + at[1]**2 + 1e-30)
    s = ufl.max_value(0.0, ufl.min_value(1.0, (r / radius - 0.25) / 0.75))
    slope = ufl.grad(1 - 3 * s**2 + 2 * s**3)
    sigma, grad = stress(found), ufl.grad(found)
    energy = 0.5 * ufl.inner(sigma, strain(found))
    along = ufl.as_vector((grad[0, 0], grad[1, 0]))
    rate = fem.assemble_scalar(fem.form((ufl.dot(ufl.dot(sigma, along), slope) - energy * slope[0]) * ufl.dx))
    return math.sqrt((1 if whole else 2) * rate / (math.pi * crack)), space.dofmap.index_map.size_global * 2


def main():
    kind, whole, crack, repeats = sys.argv[1], sys.argv[2] == "whole", float(sys.argv[3]), int(sys.argv[4])
    numbers = [float(word) for word in sys.argv[5:]]
    factor(make_mesh(kind, whole, crack, 0.5, 1), kind, whole, crack)  # compiles the forms
    for size, refinement in zip(numbers[::2], numbers[1::2]):
        start = time.process_time()
        mesh = make_mesh(kind, whole, crack, size, refinement)
        seconds_mesh = time.process_time() - start
        seconds = []
        for _ in range(repeats):
            start = time.process_time()
            value, unknowns = factor(mesh, kind, whole, crack)
            seconds.append(time.process_time() - start)
        print(json.dumps({"value": value, "unknowns": unknowns, "size": size, "refinement": refinement,
                          "seconds_mesh": seconds_mesh, "seconds_solve": min(seconds)}), flush=True)


main()
