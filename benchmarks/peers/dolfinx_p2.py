"""Finite elements of dolfinx (Debian: python3-dolfinx, python3-gmsh) on the elastic plates: quadratic triangles,
MUMPS' Cholesky factorization; meshes of gmsh, uniform or refined towards the clamped corners.

    /usr/bin/python3 dolfinx_p2.py PROBLEM SIZE REFINEMENT REPEATS

PROBLEM is plate, shear or hole; SIZE the length of a triangle [m], in the corners SIZE / REFINEMENT. Prints one line of
JSON: displacement, unknowns, seconds to mesh and seconds to solve (spaces, assembly, factorization, solution: the least
of REPEATS; imports and compilation of forms are not counted).
"""
import json
import sys
import time

import gmsh
import numpy as np
import ufl
from dolfinx import fem, geometry
from dolfinx.fem import petsc
from dolfinx.io import gmshio
from mpi4py import MPI
from petsc4py import PETSc

from plate_mesh import HEIGHT, LENGTH, POISSON, YOUNG, load_of, mesh_plate


def make_mesh(problem, size, refinement):
    mesh_plate(problem, size, refinement)
    mesh, _, _ = gmshio.model_to_mesh(gmsh.model, MPI.COMM_SELF, 0, gdim=2)
    gmsh.finalize()
    return mesh


def solve(mesh, traction):
    space = fem.VectorFunctionSpace(mesh, ("Lagrange", 2))
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    strain = lambda w: ufl.sym(ufl.grad(w))
    mu = YOUNG / (2 * (1 + POISSON))
    lam = YOUNG * POISSON / (1 - POISSON**2)  # plane stress
    stress = 2 * mu * strain(u) + lam * ufl.tr(strain(u)) * ufl.Identity(2)
    facets = fem.locate_dofs_geometrical(space, lambda x: np.isclose(x[0], 0))
    clamped = fem.dirichletbc(np.zeros(2), facets, space)
    # The end is the only part of the boundary with x = LENGTH.
    x = ufl.SpatialCoordinate(mesh)
    at_end = ufl.conditional(ufl.gt(x[0], LENGTH - 1e-9), 1.0, 0.0)
    stiffness = fem.form(ufl.inner(stress, strain(v)) * ufl.dx)
    load = fem.form(at_end * ufl.dot(fem.Constant(mesh, np.array(traction)), v) * ufl.ds)
    matrix = petsc.assemble_matrix(stiffness, bcs=[clamped])
    matrix.assemble()
    rhs = petsc.assemble_vector(load)
    petsc.set_bc(rhs, [clamped])
    solver = PETSc.KSP().create(MPI.COMM_SELF)
    solver.setOperators(matrix)
    solver.setType("preonly")
    solver.getPC().setType("cholesky")
    solver.getPC().setFactorSolverType("mumps")
    result = fem.Function(space)
    solver.solve(rhs, result.vector)
    return result


def value_at(result, point, component):
    mesh = result.function_space.mesh
    tree = geometry.BoundingBoxTree(mesh, 2)
    point = np.array([*point, 0.0])
    cells = geometry.compute_colliding_cells(mesh, geometry.compute_collisions(tree, point), point)
    return float(result.eval(point, cells[:1])[component])


def main():
    problem, size, refinement, repeats = sys.argv[1], float(sys.argv[2]), float(sys.argv[3]), int(sys.argv[4])
    traction, component = load_of(problem)
    solve(make_mesh(problem, HEIGHT, 1), traction)  # compiles the forms
    start = time.perf_counter()
    mesh = make_mesh(problem, size, refinement)
    seconds_mesh = time.perf_counter() - start
    seconds = []
    for _ in range(repeats):
        start = time.perf_counter()
        result = solve(mesh, traction)
        seconds.append(time.perf_counter() - start)
    print(json.dumps({
        "displacement": value_at(result, (LENGTH, HEIGHT / 2), component),
        "unknowns": result.function_space.dofmap.index_map.size_global * 2,
        "seconds_mesh": seconds_mesh,
        "seconds_solve": min(seconds),
    }))


main()
