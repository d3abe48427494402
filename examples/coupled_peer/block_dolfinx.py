"""The block in dolfinx (Debian: python3-dolfinx): the same biquadratic elements, the equations as forms."""

from __future__ import annotations

import logging

import numpy as np
import ufl
from block import Block
from dolfinx import fem, mesh
from dolfinx.fem import petsc
from mpi4py import MPI
from petsc4py import PETSc

logging.disable(logging.INFO)  # what the compiler of forms says


def factorized(matrix: PETSc.Mat) -> PETSc.KSP:
    solver = PETSc.KSP().create(MPI.COMM_SELF)
    solver.setOperators(matrix)
    solver.setType("preonly")
    solver.getPC().setType("lu")
    return solver


class Peer:
    name = "dolfinx"

    def __init__(self, block: Block) -> None:
        self.block = block
        right = block.left + block.width
        grid = mesh.create_rectangle(MPI.COMM_SELF, [(block.left, 0.0), (right, block.height)], block.cells,
                                     mesh.CellType.quadrilateral)
        self._heat_space, space = fem.FunctionSpace(grid, ("Lagrange", 2)), fem.VectorFunctionSpace(grid, ("Lagrange", 2))
        self._temperature = fem.Function(self._heat_space)
        self.start = np.zeros(len(self._temperature.x.array))
        self._heat: dict[float, tuple] = {}

        u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
        strain = lambda w: ufl.sym(ufl.grad(w))
        mu = block.young_modulus / (2 * (1 + block.poisson_ratio))
        lam = block.young_modulus * block.poisson_ratio / (1 - block.poisson_ratio**2)  # plane stress
        stress = 2 * mu * strain(u) + lam * ufl.tr(strain(u)) * ufl.Identity(2)
        pull = 2 * (mu + lam) * block.thermal_expansion * self._temperature
        at_wall = fem.locate_dofs_geometrical(space, lambda x: np.isclose(x[0], right))
        self._wall = fem.dirichletbc(np.zeros(2), at_wall, space)
        matrix = petsc.assemble_matrix(fem.form(block.thickness * ufl.inner(stress, strain(v)) * ufl.dx), bcs=[self._wall])
        matrix.assemble()
        self._solver, self._space = factorized(matrix), space
        self._swelling = fem.form(block.thickness * pull * ufl.div(v) * ufl.dx)

        nodes = fem.locate_dofs_geometrical(space, lambda x: np.isclose(x[0], block.left))
        places = space.tabulate_dof_coordinates()[nodes]
        order = np.argsort(places[:, 1])
        self._nodes, self.points = nodes[order], places[order, :2]

    def mean(self, temperature: np.ndarray) -> float:
        self._temperature.x.array[:] = temperature
        area = self.block.width * self.block.height
        return float(fem.assemble_scalar(fem.form(self._temperature * ufl.dx))) / area

    def cooled(self, temperature: np.ndarray, cold: float, hours: float) -> np.ndarray:
        space, right = self._heat_space, self.block.left + self.block.width
        if hours not in self._heat:
            at_wall = fem.locate_dofs_geometrical(space, lambda x: np.isclose(x[0], right))
            value = fem.Constant(space.mesh, 0.0)
            wall = fem.dirichletbc(value, at_wall, space)
            t, w = ufl.TrialFunction(space), ufl.TestFunction(space)
            spread = fem.Constant(space.mesh, hours * self.block.diffusivity)  # a number in the form is compiled anew
            form = fem.form(t * w * ufl.dx + spread * ufl.dot(ufl.grad(t), ufl.grad(w)) * ufl.dx)
            matrix = petsc.assemble_matrix(form, bcs=[wall])
            matrix.assemble()
            self._heat = {hours: (value, wall, form, factorized(matrix), fem.form(self._temperature * w * ufl.dx))}
        value, wall, form, solver, load = self._heat[hours]
        self._temperature.x.array[:] = temperature
        value.value = cold
        right_side = petsc.assemble_vector(load)
        petsc.apply_lifting(right_side, [form], [[wall]])
        petsc.set_bc(right_side, [wall])
        after = fem.Function(space)
        solver.solve(right_side, after.vector)
        return after.x.array.copy()

    def displacement(self, temperature: np.ndarray, forces: np.ndarray) -> np.ndarray:
        self._temperature.x.array[:] = temperature
        right_side = petsc.assemble_vector(self._swelling)
        right_side.array.reshape(-1, 2)[self._nodes] += forces
        petsc.set_bc(right_side, [self._wall])
        moved = fem.Function(self._space)
        self._solver.solve(right_side, moved.vector)
        return moved.x.array.reshape(-1, 2)[self._nodes].copy()
