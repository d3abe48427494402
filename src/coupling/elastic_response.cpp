#include "coupling/elastic_response.hpp"

namespace bempd::coupling {

bool ElasticResponse::has_offsets() const {
  return parts_.terms.have_offsets() || parts_.operators.have_rest(0) || parts_.operators.have_rest(1) ||
         parts_.constraints.closed_exact_count() > 0;
}

bool ElasticResponse::is_proportional(const Affine& displacement) const {
  return !parts_.terms.have_offsets() && !parts_.operators.have_rest(0) &&
         parts_.operators.gap_offsets().col(0).isZero(0) && displacement.col(0).isZero(0);
}

Eigen::VectorXd ElasticResponse::internal_force(const Eigen::VectorXd& displacement, double load_factor) const {
  const Terms& terms = parts_.terms;
  const std::vector<double>& stiffness = parts_.stages.stiffness();
  Eigen::VectorXd force = Eigen::VectorXd::Zero(displacement.size());
  if (terms.have_offsets()) {
    for (std::size_t t = 0; t < terms.size(); ++t) {
      if (!parts_.stages.intact()[t]) continue;
      const double tension = terms.tension(t, stiffness[t], displacement.data(), load_factor);
      terms.for_each_entry(t, [&](int node, double x, double y) {
        force[2 * node] += tension * x;
        force[2 * node + 1] += tension * y;
      });
    }
  } else {
    terms.add_forces(stiffness, displacement.data(), force.data());
  }
  parts_.constraints.add_penalty_forces(displacement.data(), force.data());
  for (const OperatorSchurComplement& op : parts_.operators.list())
    op.add_internal_force(displacement, load_factor, force);
  parts_.ties.collect(force);
  return force;
}

Eigen::VectorXd ElasticResponse::force_of_terms(std::span<const int> terms, const Eigen::VectorXd& displacement,
                                                double load_factor) const {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(displacement.size());
  for (const int term : terms) {
    const auto t = static_cast<std::size_t>(term);
    if (!parts_.stages.intact()[t]) continue;
    const double tension = parts_.terms.tension(t, parts_.stages.stiffness()[t], displacement.data(), load_factor);
    parts_.terms.for_each_entry(t, [&](int node, double x, double y) {
      force[2 * node] += tension * x;
      force[2 * node + 1] += tension * y;
    });
  }
  return force;
}

double ElasticResponse::energy(const Eigen::VectorXd& displacement, double load_factor) const {
  const Terms& terms = parts_.terms;
  const std::vector<char>& intact = parts_.stages.intact();
  const std::vector<double>& stiffness = parts_.stages.stiffness();
  double sum = 0;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (intact[t]) sum += terms.energy(t, stiffness[t], displacement.data(), load_factor);
  }
  sum += parts_.constraints.penalty_energy(displacement.data());
  for (const OperatorSchurComplement& op : parts_.operators.list()) sum += op.energy(displacement, load_factor);
  return sum;
}

double ElasticResponse::energy(const Eigen::VectorXd& displacement, double load_factor,
                               const Eigen::VectorXd& force) const {
  if (parts_.terms.have_offsets() || parts_.operators.have_rest(0) || parts_.operators.have_rest(1))
    return energy(displacement, load_factor);
  double sum = 0.5 * displacement.dot(force);  // Clapeyron's theorem
  for (const OperatorSchurComplement& op : parts_.operators.list())
    sum += op.energy_of_multipliers(displacement, load_factor);
  return sum;
}

double ElasticResponse::energy_slope(const Eigen::VectorXd& displacement, double load_factor) const {
  const Terms& terms = parts_.terms;
  double sum = 0;
  const double* u = displacement.data();
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (!parts_.stages.intact()[t]) continue;
    sum -= parts_.stages.stiffness()[t] * terms.elastic_elongation(t, u, load_factor) * terms.rest(t, 1);
  }
  for (const OperatorSchurComplement& op : parts_.operators.list()) sum += op.energy_slope(displacement, load_factor);
  return sum;
}

double ElasticResponse::unit_energy(const Eigen::VectorXd& proportional) const {
  if (!has_offsets()) return 0.5 * proportional.dot(internal_force(proportional));
  const Terms& terms = parts_.terms;
  double sum = 0;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (!parts_.stages.intact()[t]) continue;
    const double elastic = terms.elastic_elongation_part(t, proportional.data(), 1);
    sum += 0.5 * parts_.stages.stiffness()[t] * elastic * elastic;
  }
  sum += parts_.constraints.penalty_energy(proportional.data());
  for (const OperatorSchurComplement& op : parts_.operators.list()) sum += op.unit_energy(proportional);
  return sum;
}

}  // namespace bempd::coupling
