"""The block that cools, as every program for it takes it; and such a program in numpy: biquadratic finite elements for
heat and elasticity.

A program for the block has
    points                                    places of its nodes on the face that is bonded, from the bottom to the top, (n, 2)
    cooled(temperature, cold, hours)          temperatures after some hours more, with this one at the wall [K]
    displacement(temperature, forces)         of these nodes [m], under forces on them [N]
    mean(temperature), start                  over the block, and the temperatures at the beginning
It keeps no state: whoever couples keeps the temperatures, and repeats a step with those of its beginning."""

from __future__ import annotations

import dataclasses

import numpy as np


@dataclasses.dataclass(frozen=True)
class Block:
    """A rectangle whose left face is bonded and whose right face is fixed to a cold wall; plane stress."""

    left: float = 0.060  # [m]
    width: float = 0.060  # [m]
    height: float = 0.020  # [m]
    thickness: float = 0.005  # [m]
    young_modulus: float = 10e9  # [Pa]
    poisson_ratio: float = 0.3
    thermal_expansion: float = 40e-6  # [1/K]
    diffusivity: float = 7.2e-4  # [m^2/h]
    cells: tuple[int, int] = (15, 6)


def line(cells: int, length: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Integrals of f_i f_j, f_i' f_j' and f_i' f_j over a line of quadratic elements."""
    h = length / cells
    local = (h / 30 * np.array([[4, 2, -1], [2, 16, 2], [-1, 2, 4]]), np.array([[7, -8, 1], [-8, 16, -8], [1, -8, 7]]) / (3 * h),
             np.array([[-3, -4, 1], [4, 0, -4], [-1, 4, 3]]) / 6)
    whole = tuple(np.zeros((2 * cells + 1, 2 * cells + 1)) for _ in local)
    for cell in range(cells):
        at = slice(2 * cell, 2 * cell + 3)
        for matrix, part in zip(whole, local):
            matrix[at, at] += part
    return whole


class Peer:
    """Biquadratic elements on a grid: all integrals are products of integrals over lines. Nodes go by columns."""

    name = "numpy"

    def __init__(self, block: Block) -> None:
        self.block = block
        nx, ny = block.cells
        (mx, kx, gx), (my, ky, gy) = line(nx, block.width), line(ny, block.height)
        y = np.linspace(0, block.height, 2 * ny + 1)
        self.points = np.column_stack([np.full(len(y), block.left), y])
        count, face = (2 * nx + 1) * (2 * ny + 1), 2 * ny + 1
        self._mass, self._conduction = np.kron(mx, my), np.kron(kx, my) + np.kron(mx, ky)
        self._free = np.arange(count - face)  # what is not at the wall
        self.start = np.zeros(count)
        self._heat: dict[float, np.ndarray] = {}
        young, nu = block.young_modulus * block.thickness, block.poisson_ratio
        c11, c12, c33 = young / (1 - nu**2), young * nu / (1 - nu**2), young / (2 * (1 + nu))
        mixed = c12 * np.kron(gx, gy.T) + c33 * np.kron(gx.T, gy)
        stiffness = np.block([[c11 * np.kron(kx, my) + c33 * np.kron(mx, ky), mixed],
                              [mixed.T, c11 * np.kron(mx, ky) + c33 * np.kron(kx, my)]])
        free = np.concatenate([self._free, count + self._free])
        flexibility = np.linalg.inv(stiffness[np.ix_(free, free)])
        swelling = (c11 + c12) * block.thermal_expansion * np.vstack([np.kron(gx, my), np.kron(mx, gy)])
        self._flexibility, self._pull, self._free_dofs = flexibility, swelling[free], free
        face_dofs = np.concatenate([np.arange(face), len(self._free) + np.arange(face)])
        self._by_forces = flexibility[np.ix_(face_dofs, face_dofs)]
        self._by_heat = flexibility[face_dofs] @ swelling[free]
        self._face_dofs = face_dofs

    def mean(self, temperature: np.ndarray) -> float:
        return float((self._mass @ temperature).sum() / (self.block.width * self.block.height))

    def cooled(self, temperature: np.ndarray, cold: float, hours: float) -> np.ndarray:
        free = self._free
        matrix = self._mass + hours * self.block.diffusivity * self._conduction
        after = np.full_like(temperature, cold)
        if hours not in self._heat:
            self._heat = {hours: np.linalg.inv(matrix[np.ix_(free, free)])}
        right = self._mass @ temperature - matrix[:, len(free):].sum(axis=1) * cold
        after[free] = self._heat[hours] @ right[free]
        return after

    def displacement_field(self, temperature: np.ndarray, forces: np.ndarray) -> np.ndarray:
        """Of all nodes, in x and then in y, for pictures."""
        load = self._pull @ temperature
        load[self._face_dofs] += forces.T.ravel()
        moved = np.zeros(2 * len(temperature))
        moved[self._free_dofs] = self._flexibility @ load
        return moved

    def displacement(self, temperature: np.ndarray, forces: np.ndarray) -> np.ndarray:
        return (self._by_forces @ forces.T.ravel() + self._by_heat @ temperature).reshape(2, -1).T
