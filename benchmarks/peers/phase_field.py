"""The plate of the speed table torn by a phase field in dolfinx (Debian: python3-dolfinx): Bourdin, Francfort and Marigo
(2000), with quadratic dissipation, solved in turns for displacement and damage (Miehe, Hofacker, Welschinger 2010, without
a split of the energy: the plate is only pulled), bilinear elements of one spacing, a length scale of two.

    /usr/bin/python3 phase_field.py N OPENING INCREMENTS

OPENING is that of each end at the first break in the other programs, reached in INCREMENTS increments; they go on, of the
same size, until the pull of an end has fallen to 2 % of its peak. The toughness is that of the bonds: critical stretch
1e-3, horizon 4, plane stress (Ha and Bobaru 2010). Prints one line of JSON; seconds are processor time without imports and
compilation of forms."""
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

POISSON, LENGTH_SCALE, STRETCH, HORIZON = 1 / 3, 2.0, 1e-3, 4.0
TOUGHNESS = 9 * HORIZON * STRETCH**2 / (4 * math.pi)
RESIDUAL_STIFFNESS, SETTLED, MOST_TURNS = 1e-7, 1e-3, 5000


class Problem:
    """A linear problem whose matrix keeps its pattern."""

    def __init__(self, a, load, conditions, result):
        self.a, self.load, self.conditions, self.result = fem.form(a), fem.form(load), conditions, result
        self.matrix = petsc.create_matrix(self.a)
        self.solver = PETSc.KSP().create(MPI.COMM_SELF)
        self.solver.setType("preonly")
        self.solver.getPC().setType("cholesky")
        self.solver.getPC().setFactorSolverType("mumps")

    def solve(self):
        self.matrix.zeroEntries()
        petsc.assemble_matrix(self.matrix, self.a, bcs=self.conditions)
        self.matrix.assemble()
        rhs = petsc.assemble_vector(self.load)
        petsc.apply_lifting(rhs, [self.a], [self.conditions])
        petsc.set_bc(rhs, self.conditions)
        self.solver.setOperators(self.matrix)
        self.solver.solve(rhs, self.result.vector)


class Plate:
    def __init__(self, n):
        side = n - 1
        body = mesh.create_rectangle(MPI.COMM_SELF, [[0, 0], [side, side]], [side, side], mesh.CellType.quadrilateral)
        vectors, scalars = fem.VectorFunctionSpace(body, ("Lagrange", 1)), fem.FunctionSpace(body, ("Lagrange", 1))
        cells = fem.FunctionSpace(body, ("DG", 0))
        self.u, self.damage, self.drive = fem.Function(vectors), fem.Function(scalars), fem.Function(cells)
        dx = ufl.Measure("dx", body, metadata={"quadrature_degree": 2})
        # The crack: cells whose energy was once large.
        rows, middle = math.floor(0.2 * n), 0.5 * (n - 1)
        low, crack = math.ceil(middle - 0.5 * rows) - 0.5, math.floor(middle) + 0.5
        x = ufl.SpatialCoordinate(body)
        in_crack = ufl.And(abs(x[0] - crack) < 0.5, abs(x[1] - low - 0.5 * rows) < 0.5 * rows)
        start = fem.Expression(ufl.conditional(in_crack, 1e3 * TOUGHNESS / LENGTH_SCALE, 0.0),
                               cells.element.interpolation_points())
        self.drive.interpolate(start)
        mu = 1 / (2 * (1 + POISSON))
        lam = POISSON / (1 - POISSON**2)  # plane stress
        strain = lambda w: ufl.sym(ufl.grad(w))
        stress = lambda w: 2 * mu * strain(w) + lam * ufl.tr(strain(w)) * ufl.Identity(2)
        whole = (1 - self.damage) ** 2 + RESIDUAL_STIFFNESS
        self.energy = fem.Expression(0.5 * ufl.inner(stress(self.u), strain(self.u)), cells.element.interpolation_points())
        self.stored = fem.form(0.5 * whole * ufl.inner(stress(self.u), strain(self.u)) * dx)
        self.ends = []
        for place in (0.0, float(side)):
            dofs = fem.locate_dofs_geometrical(vectors, lambda y, place=place: np.isclose(y[0], place))
            pull = fem.Constant(body, np.zeros(2))
            self.ends.append((pull, fem.dirichletbc(pull, dofs, vectors)))
        u, v = ufl.TrialFunction(vectors), ufl.TestFunction(vectors)
        d, q = ufl.TrialFunction(scalars), ufl.TestFunction(scalars)
        self.elastic = Problem(whole * ufl.inner(stress(u), strain(v)) * dx,
                               ufl.dot(fem.Constant(body, np.zeros(2)), v) * dx, [end for _, end in self.ends], self.u)
        self.phase = Problem(TOUGHNESS * LENGTH_SCALE * ufl.dot(ufl.grad(d), ufl.grad(q)) * dx
                             + (TOUGHNESS / LENGTH_SCALE + 2 * self.drive) * d * q * dx, 2 * self.drive * q * dx, [],
                             self.damage)
        self.cells = cells
        self.turns = 0

    def pull(self, opening):
        """Equilibrium at this displacement of each end; the force on an end: their work is twice the energy."""
        for sign, (value, _) in zip((-1, 1), self.ends):
            value.value[0] = sign * opening
        now = fem.Function(self.cells)
        for _ in range(MOST_TURNS):
            self.elastic.solve()
            now.interpolate(self.energy)
            self.drive.x.array[:] = np.maximum(self.drive.x.array, now.x.array)
            before = self.damage.x.array.copy()
            self.phase.solve()
            self.turns += 1
            if np.abs(self.damage.x.array - before).max() < SETTLED:
                break
        return fem.assemble_scalar(self.stored) / opening


def main():
    n, opening, increments = int(sys.argv[1]), float(sys.argv[2]), int(sys.argv[3])
    Plate(6).pull(0.01 * opening)  # compiles the forms
    start = time.process_time()
    plate = Plate(n)
    plate.phase.solve()
    forces = []
    while not forces or forces[-1] > 0.02 * max(forces) and len(forces) < 10 * increments:
        forces.append(plate.pull(opening * (len(forces) + 1) / increments))
    print(json.dumps({"seconds": time.process_time() - start, "steps": plate.turns, "peak_force": max(forces),
                      "finished": forces[-1] <= 0.02 * max(forces)}))


main()
