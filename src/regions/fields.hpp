#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/terms.hpp"
#include "elasticity/linear_body_force.hpp"
#include "geometry/point.hpp"

namespace bempd::regions {

enum class Field { position = 1, displacement, stress, damage, traction, bond_stretch, element_stress, stress_order };
enum class BondState { intact = 0, broken = 1, cut = 2 };

// Values of a field: `components` numbers for each of its entries, one entry after the other.
struct FieldValues {
  std::vector<double> values;
  int components = 1;
  std::int64_t count() const { return static_cast<std::int64_t>(values.size()) / components; }
};

struct FieldSize {
  std::int64_t count;
  int components;
};

inline int components_of(Field field) {
  if (field == Field::stress || field == Field::element_stress) return 3;
  return field == Field::damage || field == Field::bond_stretch || field == Field::stress_order ? 1 : 2;
}

// Largest overlap (interpenetration) of the two faces of a crack, and where it is.
struct Overlap {
  int crack;
  Point place;
  double depth;  // [m]
};

// Load on the faces of a crack with elements: pressure and shear [Pa] at a fraction of the crack's length. The first of
// the two values is the constant part, the second is multiplied by the load factor.
struct CrackLoad {
  int crack;  // id of the crack
  std::function<std::array<Point, 2>(double fraction)> values;
};

// State of all nodes and bonds at one load factor, from which results are computed.
struct Solution {
  const Eigen::VectorXd& displacement;  // [m], 2 * node + component
  const coupling::Terms& bonds;
  const std::vector<char>& intact;     // flag of each term: 1 if it is intact
  std::vector<BodyForce> body_forces;  // body force of each region id, from 1 on
  // Constant and proportional part of the displacement; needed for cracks with elements, null if there are none.
  const coupling::Affine* parts = nullptr;
  // Loads on the faces of cracks with elements; null if there are no such cracks.
  const std::vector<CrackLoad>* crack_loads = nullptr;
  double load_factor = 0;
  const std::vector<std::uint8_t>* stages = nullptr;  // damage stages of bonds; null: bonds are whole or broken

  // Flags of the contact constraints of crack faces, by region: nonzero if the constraint is closed. Empty if no face
  // is closed.
  std::vector<std::vector<char>> closed_faces = {};
  const coupling::Affine* body_force_parts = nullptr;  // DofConditions::body_force; null: none

  const std::vector<char>& closed_faces_of(int region) const {
    static const std::vector<char> none;
    const auto place = static_cast<std::size_t>(region) - 1;
    return place < closed_faces.size() ? closed_faces[place] : none;
  }
  const BodyForce& body_force(int region) const { return body_forces[static_cast<std::size_t>(region) - 1]; }
};

struct PointValue {
  int region = 0;
  Point displacement = Point::Zero();
  Eigen::Vector3d stress = Eigen::Vector3d::Zero();
};

// Function that returns a field of one region for one solution. A field is computed when it is first asked for.
using FieldsOfRegion = std::function<const FieldValues&(Field)>;

// Evaluates displacement and stress at any place in one region, for one solution.
class Evaluator {
 public:
  virtual ~Evaluator() = default;
  virtual PointValue at(const Point& place) = 0;
  // Chooses the face of a crack with elements whose values are returned for places on the crack: the right face (as
  // seen from the crack's first point) if `right`, else the left face.
  virtual void choose_right_face(bool /*right*/) {}
  virtual std::int64_t kernel_evaluations() const { return 0; }
};

}  // namespace bempd::regions
