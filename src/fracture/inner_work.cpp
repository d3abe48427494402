#include "fracture/inner_work.hpp"

#include <cmath>

namespace bempd::fracture {

double InnerWork::at(double load_factor) const {
  const Eigen::Vector2d loads(1, load_factor);
  const double open = 0.5 * loads.dot(form_ * loads);
  if (system_.constraints().closed_exact_count() == 0) return open;
  const Eigen::VectorXd u = coupling::evaluate(state_.displacement, load_factor);
  return open + system_.operators().work_due_to_multipliers(u, load_factor);
}

double InnerWork::least_scale(double load_factor) const {
  constexpr double accuracy = 1e-9;
  const Eigen::Vector2d loads(1, std::abs(load_factor));
  return accuracy * 0.5 * loads.dot(form_.cwiseAbs() * loads);
}

}  // namespace bempd::fracture
