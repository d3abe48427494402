#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "bem/boundary_elements.hpp"
#include "bem/boundary_slopes.hpp"
#include "bem/crack_field.hpp"
#include "elasticity/plane_elasticity.hpp"

namespace bempd::bem {

// Displacement and stress inside a body from its boundary values, by Somigliana's identity. The linear field with the
// displacement, tangential strain and traction of the nearest boundary point is subtracted first, and added back in
// closed form. The integrand then vanishes where the kernels are singular, so that points may lie arbitrarily close to
// the boundary. On the boundary the stress follows from the traction and the tangential strain, with the more exact
// slopes of boundary_slopes.hpp. Inside the body these slopes are not used: the displacements of a Galerkin solution
// are accurate on average, and the correction would spoil this average.
class InteriorEvaluator {
 public:
  struct Value {
    Point displacement;
    Eigen::Vector3d stress;  // xx, yy, xy [Pa]
  };

  // Prepares the evaluation. `displacements` [m] are numbered 2 * node + component, `tractions` [Pa] 2 * traction_node
  // + component.
  InteriorEvaluator(const BoundaryMesh& mesh, const PlaneElasticity& elasticity, const Eigen::VectorXd& displacements,
                    const Eigen::VectorXd& tractions);

  // Sets the body's cracks with their openings, whose field is added to that of the boundary.
  void set_cracks(CrackField cracks) { cracks_ = std::move(cracks); }

  // Chooses the crack face whose values are returned for points on a crack: the right one, or the left one (the
  // default).
  void choose_right_face(bool right) {
    if (cracks_) cracks_->choose_right_face(right);
  }

  // Displacement and stress at x. Throws Error (argument) at the tip of a crack, where the stress is infinite.
  Value at(const Point& x) const;
  // Stress at x due to the boundary and all crack elements except number `crack_element`.
  Eigen::Vector3d stress_without(const Point& x, int crack_element) const;
  // Stress at the parameter xi (-1 to 1) of a boundary element, from the traction and the tangential strain there.
  Eigen::Vector3d stress_on(int element, double xi) const;
  Point displacement_at(const Point& x) const;

  std::int64_t kernel_evaluations() const { return kernel_evaluations_; }

 private:
  struct Nearest;
  struct LinearField;
  struct Sums;

  // Correction of the derivative of an element's displacement by xi: the derivative of xi (xi^2 - 1) (odd + even xi)
  // with the members `odd` and `even`. This product vanishes at all nodes, so nodal displacements stay, while the
  // slopes at the ends become those of boundary_slopes.hpp.
  struct SlopeCorrection {
    Point odd = Point::Zero(), even = Point::Zero();

    Point at(double xi) const { return (3 * xi * xi - 1) * (odd + xi * even) + xi * (xi * xi - 1) * even; }
  };

  Nearest nearest(const Point& x) const;
  SlopeCorrection slope_correction(std::size_t element, const ElementSlopes& better) const;
  LinearField matching_field(const Nearest& nearest, const Point& displacement_derivative) const;
  Point remainder(int element, double xi, const Nearest& nearest, const LinearField& field) const;
  Value evaluate(const Point& x, bool with_stress) const;
  // Displacement and stress due to the boundary alone, in scaled units.
  Value from_boundary(const Point& x, const Nearest& nearest, bool with_stress) const;
  void integrate(int element, const Interval& interval, const Point& x, const Nearest& nearest,
                 const LinearField& field, bool with_stress, int depth, Sums& sums) const;

  ScaledBoundary boundary_;
  double nu_, shear_modulus_;
  std::vector<ElementGeometry> displacement_, traction_;  // per element: scaled values in place of positions
  std::vector<SlopeCorrection> correction_;
  std::vector<std::array<int, 2>> end_nodes_;
  std::optional<CrackField> cracks_;
  mutable std::int64_t kernel_evaluations_ = 0;
};

}  // namespace bempd::bem
