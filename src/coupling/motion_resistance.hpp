#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "coupling/repeatable_factor.hpp"
#include "coupling/system_parts.hpp"

namespace bempd::coupling {

// Motion with little resistance: displacements (2 * node + component, the largest 1). `resistance` is the energy of the
// motion over its energy with the diagonal of the matrix alone.
struct SoftMotion {
  Eigen::VectorXd motion;
  double resistance;
};

// Resistance of a system to motions of its parts. Broken terms and open cracks may have taken this resistance away.
class MotionResistance {
 public:
  MotionResistance(SystemParts& parts, const SystemMatrix& matrix, RepeatableFactor& factor)
      : parts_(parts), matrix_(matrix), factor_(factor) {}

  // Whether every motion meets resistance after the energy terms `broken` have broken; if not, softest() finds a motion
  // that does not. The loss may not show in elongations under the present load.
  bool resists_all(std::span<const int> broken);

  // Motions that only the holding springs `springs` resist, with all constraints open. A motion may be resisted by
  // several springs.
  std::vector<Eigen::VectorXd> motions_held_by(std::span<const HoldingSpring> springs);

  // Motion with the least resistance. After solve() has failed or displacements have grown without bound, it is a free
  // motion.
  SoftMotion softest();

 private:
  SystemParts& parts_;
  const SystemMatrix& matrix_;
  RepeatableFactor& factor_;
};

}  // namespace bempd::coupling
