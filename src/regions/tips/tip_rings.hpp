#pragma once

#include <complex>
#include <map>
#include <utility>
#include <vector>

#include "coupling/constraints.hpp"
#include "elasticity/crack_tip_field.hpp"
#include "regions/discretization.hpp"
#include "regions/tips/bent_crack.hpp"

namespace bempd::regions {

// Lattices of a scene in their present state: energy terms (bonds and cell squares), cracks, contact, and fluid
// pressures.
struct BondedBody {
  const scene::Scene& scene;
  const Discretization& discretization;
  const coupling::Terms& bonds;
  const std::vector<double>& stiffness;  // present stiffness of each term [N/m]
  const std::vector<char>& intact;
  const std::vector<int>& cut;                  // bonds that initial cracks cut, ascending
  const std::vector<scene::Crack>& cracks;      // as they are in lattices
  const coupling::Constraints& constraints;     // contact constraints of crack faces
  std::map<int, Eigen::RowVector2d> pressures;  // pressure by id of the crack: constant and proportional part [Pa]
};

// Position and direction of a crack tip, the path of the crack, and the lattice around the tip.
struct TipAxes {
  Point place, direction;   // unit vector in which a straight crack would go on
  std::vector<Point> path;  // path of the crack, ending at the tip
  double spacing;           // spacing of the lattice
  PlaneElasticity elasticity;
  bool is_rough = false;  // whether the path leads from middle to middle of broken cells

  Point into(const Point& vector) const {
    return {direction.dot(vector), direction.x() * vector.y() - direction.y() * vector.x()};
  }
  Point out_of(const Point& local) const {
    return local.x() * direction + local.y() * Point(-direction.y(), direction.x());
  }
};

// Coefficients of Williams' expansion at a crack tip, from the body's displacements on rings around the tip.
//
// The reciprocal theorem relates the displacement u to a dual field u* (the Williams term of the opposite power). Let a
// weight q fall from 1 to 0 across the ring. With the stiffness k and the elongation e of each energy term (bond or
// cell square),
//   H = sum k [e(u*) e(q u) - e(u) e(q u*)]
// is the work that the two fields do on each other across the ring, the same for every ring. No stress is recovered and
// no displacement differentiated. The second part of the sum vanishes if u is in equilibrium without nodal forces. What
// is left is
//   H = sum k e(u*) e(q u) - sum q F*.u,
// where F* are the forces of the dual field's tractions on the outline of the lattice. They occur because the path
// around the tip continues along the outline where the ring meets the outline. The faces of a crack that bends behind
// the tip are treated like the outline.
class TipRings {
 public:
  TipRings(const BondedBody& body, TipAxes axes, double radius);

  struct Expansion {
    std::complex<double> opening;  // factor of the term of power 1/2
    std::complex<double> shift;    // factor of the term of power -1/2: not 0 if the effective tip is elsewhere
    double uniform = 0;            // T-stress [Pa]
  };

  // Dual fields and distances about one centre, shared by all rings around it.
  struct View {
    struct Dual {
      double power;  // power of the term that the dual picks out
      std::complex<double> factor;
      std::vector<double> tensions;  // tensions of the terms [N]
      Eigen::VectorXd face_forces;   // [N] at the nodes
    };
    Point centre;
    std::vector<double> distances;  // distances of the nodes from the centre
    std::vector<Dual> duals;
  };
  // Dual fields about the centre at the distance `ahead` from the tip, along the tip's direction [m].
  View about(double ahead) const;
  // Displacements of the nodes around the tip without their rigid motion; `displacement` is that of all nodes of the
  // scene.
  Eigen::VectorXd around(const Eigen::VectorXd& displacement) const;
  // Coefficients of Williams' terms at the tip from the ring between the radii `inner` and `outer`. `around` holds the
  // displacements that the function around() gives.
  Expansion expansion(const View& view, double inner, double outer, const Eigen::VectorXd& around) const;

 private:
  // Energy term with the local numbers of its nodes and the coefficients of their displacements.
  struct LocalTerm {
    double stiffness;
    std::vector<std::pair<int, Point>> pulls;
  };
  struct FacePart {
    const Region* region;
    EdgeSpan span;
  };

  bool is_of_material(const Region& region) const {
    return region.lattice_grid().has_value() && region.elasticity() == axes_.elasticity;
  }
  std::vector<char> terms_of_material() const;
  void collect_faces();
  TipPolar polar(const Point& place, const Point& centre) const;
  View::Dual dual_at(const Point& centre, double power, std::complex<double> factor) const;
  Eigen::VectorXd face_forces(const CrackTipField& dual, const Point& centre) const;

  const BondedBody& body_;
  TipAxes axes_;
  double radius_;
  std::vector<int> nodes_;  // numbers of the nodes around the tip in the scene
  std::vector<LocalTerm> terms_;
  std::vector<FacePart> faces_;
  BentCrack crack_;
};

}  // namespace bempd::regions
