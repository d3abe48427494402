#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/point.hpp"

namespace bempd::coupling {

// Support of a node along one direction.
struct HeldDirection {
  int node;
  double cosine, sine;
};

// Rigid motions of a set of nodes (two translations, one rotation) that the held directions leave free.
class RigidMotion {
 public:
  RigidMotion(const std::vector<Point>& positions, const std::vector<int>& nodes,
              const std::vector<HeldDirection>& held);

  int free_count() const { return static_cast<int>(free_.cols()); }

  // Displacement at a position in free motion number `motion`, scaled so that displacements are of order 1.
  Point displacement(int motion, const Point& position) const;

  // Work of nodal forces (2 * node + component) in free motion number `motion`.
  double work(int motion, const std::vector<Point>& positions, const std::vector<int>& nodes,
              const Eigen::Ref<const Eigen::VectorXd>& forces) const;

  // Chooses supports from `candidates`: for each free motion that some candidate can hold, the candidate at which the
  // motion is largest.
  std::vector<HeldDirection> missing_supports(const std::vector<Point>& positions,
                                              const std::vector<HeldDirection>& candidates) const;

  // Name of the free motions for a sentence, such as "translate in x, and rotate".
  std::string describe() const;

 private:
  Eigen::RowVector3d row(const Point& position, double cosine, double sine) const;

  Point centre_ = Point::Zero();
  double radius_ = 1;
  Eigen::Matrix<double, 3, Eigen::Dynamic> free_;  // columns: (x, y, rotation * radius)
};

// Small rigid motion that fits the displacements of some nodes best, in the mean square.
struct RigidFit {
  Point centre = Point::Zero(), translation = Point::Zero();  // mean position, and its displacement
  double rotation = 0;                                        // counter-clockwise
  double deviation = 0;                                       // largest of a node from this motion
};
RigidFit nearest_rigid_motion(const std::vector<Point>& positions, const std::vector<int>& nodes,
                              const Eigen::VectorXd& displacement);

}  // namespace bempd::coupling
