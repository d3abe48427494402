"""The plate of the speed table torn by phase-field fracture (AT2) in dolfinx (Debian: python3-dolfinx).

    /usr/bin/python3 phase_field.py N OPENING

Bourdin, Francfort and Marigo (J. Mech. Phys. Solids 48, 2000): alternate minimization of displacement and damage, with
the history field of Miehe et al. (Comput. Methods Appl. Mech. Eng. 199, 2010) against healing. Bilinear squares of half
a spacing, length scale of one horizon quarter (a spacing), toughness of the lattice's critical stretch, the crack as a
history on its line. The load rises by 1 % of OPENING from 90 % of it on, and is solved until the damage changes by less
than 1e-3. Ends at 2 % of the peak force. Prints one line of JSON; seconds are processor time."""
import json
import math
import sys
import time

import numpy as np
import ufl
from dolfinx import fem, mesh
from dolfinx.fem import petsc
from mpi4py import MPI
from petsc4py import PETSc

POISSON, HORIZON, STRETCH, LENGTH_SCALE, RESIDUAL = 1 / 3, 4.0, 1e-3, 1.0, 1e-7
SECONDS_ALLOWED = 300


class System:
    """A linear problem with a matrix that is assembled and factored anew each time."""

    def __init__(self, form, load, result, conditions):
        self.form, self.load, self.result, self.conditions = fem.form(form), fem.form(load), result, conditions
        self.solver = PETSc.KSP().create(MPI.COMM_SELF)
        self.solver.setType("preonly")
        self.solver.getPC().setType("cholesky")
        self.solver.getPC().setFactorSolverType("mumps")

    def solve(self):
        matrix = petsc.assemble_matrix(self.form, bcs=self.conditions)
        matrix.assemble()
        right = petsc.assemble_vector(self.load)
        petsc.apply_lifting(right, [self.form], [self.conditions])
        petsc.set_bc(right, self.conditions)
        self.solver.setOperators(matrix)
        self.solver.solve(right, self.result.vector)


def main():
    n, opening = int(sys.argv[1]), float(sys.argv[2])
    side, start = n - 1.0, time.process_time()
    # The critical stretch of a micromodulus that falls linearly to the horizon: G0 = 105 E delta s^2 / (64 pi).
    toughness = 105 * HORIZON * STRETCH**2 / (64 * math.pi)
    domain = mesh.create_rectangle(MPI.COMM_SELF, [[0, 0], [side, side]], [2 * (n - 1)] * 2, mesh.CellType.quadrilateral)
    vectors = fem.VectorFunctionSpace(domain, ("Lagrange", 1))
    scalars = fem.FunctionSpace(domain, ("Lagrange", 1))
    cells = fem.FunctionSpace(domain, ("DG", 0))
    u, d, history = fem.Function(vectors), fem.Function(scalars), fem.Function(cells)

    rows, middle = math.floor(0.2 * n), 0.5 * (n - 1)
    low, line = math.ceil(middle - 0.5 * rows) - 0.5, math.floor(middle) + 0.5
    history.interpolate(lambda x: 1e3 * toughness / (2 * LENGTH_SCALE) * ((abs(x[0] - line) < 0.5) & (x[1] > low)
                                                                          & (x[1] < low + rows)))
    mu, lam = 1 / (2 * (1 + POISSON)), POISSON / (1 - POISSON**2)
    strain = lambda w: ufl.sym(ufl.grad(w))
    stress = lambda w: 2 * mu * strain(w) + lam * ufl.tr(strain(w)) * ufl.Identity(2)
    energy = 0.5 * ufl.inner(stress(u), strain(u))
    stiffness_left = (1 - d) ** 2 + RESIDUAL

    left = fem.locate_dofs_geometrical(vectors, lambda x: np.isclose(x[0], 0))
    right = fem.locate_dofs_geometrical(vectors, lambda x: np.isclose(x[0], side))
    pull = [fem.Constant(domain, np.zeros(2)), fem.Constant(domain, np.zeros(2))]
    held = [fem.dirichletbc(pull[0], left, vectors), fem.dirichletbc(pull[1], right, vectors)]
    w, v, e, q = (ufl.TrialFunction(vectors), ufl.TestFunction(vectors), ufl.TrialFunction(scalars),
                  ufl.TestFunction(scalars))
    none = fem.Constant(domain, np.zeros(2))
    elastic = System(stiffness_left * ufl.inner(stress(w), strain(v)) * ufl.dx, ufl.dot(none, v) * ufl.dx, u, held)
    damage = System((2 * history + toughness / LENGTH_SCALE) * e * q * ufl.dx
                    + toughness * LENGTH_SCALE * ufl.dot(ufl.grad(e), ufl.grad(q)) * ufl.dx,
                    2 * history * q * ufl.dx, d, [])
    density = fem.Expression(energy, cells.element.interpolation_points())
    new = fem.Function(cells)
    stored = fem.form(2 * stiffness_left * energy * ufl.dx)

    damage.solve()
    load, peak, solves, force = 0.9 * opening, 0.0, 0, 0.0
    while time.process_time() - start < SECONDS_ALLOWED:
        pull[0].value[0], pull[1].value[0] = -load, load
        change = 1.0
        while change > 1e-3 and time.process_time() - start < SECONDS_ALLOWED:
            elastic.solve()
            new.interpolate(density)
            history.x.array[:] = np.maximum(history.x.array, new.x.array)
            before = d.x.array.copy()
            damage.solve()
            change = float(np.abs(d.x.array - before).max())
            solves += 1
        force = fem.assemble_scalar(stored) / (2 * load)
        peak = max(peak, force)
        if force < 0.02 * peak:
            break
        load += 0.01 * opening
    print(json.dumps({"seconds": time.process_time() - start, "steps": solves, "peak_force": peak, "opening": load,
                      "finished": force < 0.02 * peak}))


main()
