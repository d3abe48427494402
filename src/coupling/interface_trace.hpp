#pragma once

#include <Eigen/SparseCore>
#include <optional>
#include <vector>

namespace bempd::coupling {

// Trace matrix N of a straight interface on which lattice points and boundary nodes do not coincide: u_P = N u_B gives
// the displacements of the lattice points from those of the boundary nodes. Lengths are in lattice spacings along the
// interface. The lattice points lie at 0, 1, .., length, and the ends of quadratic elements at `stations`, 0 = first <
// ... < last = length. The nodes are numbered 0 .. 2 * elements along the interface, mid nodes included. Where the
// interface ends at the mouth of a crack, the first station is -1/2, or the last station is length + 1/2: half way to
// the next lattice point, which lies on the crack's other side.
//
// N starts from the quadratic interpolation and is changed as little as possible, so that
//   - its rows reproduce constants and the coordinate: a linear displacement is continuous;
//   - N^T turns the forces of a constant traction on the lattice points' shares (1; 1/2 at ends that are points; 9/8
//   and
//     7/8 beside a mouth) into those of the boundary elements, the integrals of the shape functions: a constant stress
//     passes from one side to the other.
// Interpolation alone has the first property only; its forces are those of a trapezoid rule. Points at the ends of the
// interface have the displacement of the boundary nodes there. The result is empty if no such N exists, as on an
// interface of one spacing.
std::optional<Eigen::SparseMatrix<double, Eigen::RowMajor>> interface_trace(const std::vector<double>& stations);

}  // namespace bempd::coupling
