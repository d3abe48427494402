#include "fracture/body_response.hpp"

#include <algorithm>
#include <cmath>

#include "fracture/balance.hpp"
#include "stopwatch.hpp"

namespace bempd::fracture {

namespace {

// Residual (largest unbalanced force over the largest internal force) above which some motion of the body may have lost
// its resistance.
constexpr double suspicious_residual = 1e-8;
// Rounding error of the forces of a solution whose constant and proportional forces nearly cancel, as a share of these.
constexpr double rounding_of_parts = 1e-12;
// Least size of the load factor f at which energies divided by f^2 keep their digits; the largest size is the
// reciprocal.
constexpr double least_load_factor = 1e-50;

}  // namespace

using coupling::Affine;
using coupling::evaluate;

double BodyResponse::energy_at_rest() const {
  return system_.response().has_offsets()
             ? system_.response().energy(Eigen::VectorXd::Zero(2 * system_.node_count()), 0)
             : 0;
}

bool BodyResponse::is_balanced() const {
  const double f = state_.load_factor;
  const Eigen::VectorXd force = system_.response().internal_force(evaluate(state_.displacement, f), f);
  const double largest =
      std::max({state_.largest_force, force.lpNorm<Eigen::Infinity>(), least_force_scale(system_, f)});
  const double residual = fracture::residual(system_, force, f, largest);
  if (residual <= suspicious_residual) return true;
  // The constant and the proportional part of loads may nearly cancel, as in a load program of which a short part is
  // run late in its time. Such loads leave rounding errors of both parts.
  const double parts =
      system_.response().internal_force(state_.displacement.col(0)).lpNorm<Eigen::Infinity>() +
      std::abs(f) * system_.response().internal_force(state_.displacement.col(1)).lpNorm<Eigen::Infinity>();
  return residual * largest <= rounding_of_parts * parts;
}

void BodyResponse::solve() { state_.displacement = system_.solve(); }

void BodyResponse::update_ratios() {
  const Stopwatch watch(seconds_search_);
  enter_stages();
  ratios_.update(state_.displacement);
}

double BodyResponse::absorb(double load_factor) {
  const Eigen::VectorXd displacement = evaluate(state_.displacement, load_factor);
  const Eigen::VectorXd force = system_.response().internal_force(displacement, load_factor);
  if (!displacement.allFinite() || !force.allFinite()) fail_out_of_range();
  // The trapezoidal rule gives the exact work, because the path between two states is straight; in equilibrium the
  // internal forces equal the loads.
  double work = 0.5 * (state_.total_force + force).dot(displacement - state_.total_displacement);
  if (system_.response().has_offsets() && load_factor != state_.load_factor) {
    const double before = system_.response().energy_slope(state_.total_displacement, state_.load_factor);
    const double after = system_.response().energy_slope(displacement, load_factor);
    work += 0.5 * (before + after) * (load_factor - state_.load_factor);
  }
  state_.total_displacement = displacement;
  state_.total_force = force;
  state_.largest_force =
      std::max({state_.largest_force, force.lpNorm<Eigen::Infinity>(), least_force_scale(system_, load_factor)});
  state_.load_factor = load_factor;
  return work;
}

double BodyResponse::move_to(double load_factor) { return load_factor != state_.load_factor ? absorb(load_factor) : 0; }

void BodyResponse::set_solution(Affine displacement) {
  state_.displacement = std::move(displacement);
  update_ratios();
  state_.total_displacement = evaluate(state_.displacement, state_.load_factor);
  state_.total_force = system_.response().internal_force(state_.total_displacement, state_.load_factor);
}

std::optional<double> BodyResponse::next_critical(const LoadWay& way) {
  const Stopwatch watch(seconds_search_);
  return fracture::next_critical(bonds(), way);
}

double BodyResponse::stored_energy() const {
  return system_.response().energy(state_.total_displacement, state_.load_factor, state_.total_force);
}

double BodyResponse::potential_of_loads() const {
  return evaluate(system_.load().force(), state_.load_factor).dot(state_.total_displacement);
}

double BodyResponse::stored_energy_at(double load_factor) const {
  if (load_factor == state_.load_factor) return stored_energy();
  if (system_.response().is_proportional(state_.displacement)) return load_factor * load_factor * unit_energy();
  return system_.response().energy(evaluate(state_.displacement, load_factor), load_factor);
}

double BodyResponse::unit_energy() const {
  const double f = state_.load_factor, size = std::abs(f);
  const bool is_shown = size > least_load_factor && size < 1 / least_load_factor &&
                        system_.response().is_proportional(state_.displacement) &&
                        state_.total_displacement == evaluate(state_.displacement, f);
  return is_shown ? stored_energy() / (f * f) : system_.response().unit_energy(state_.displacement.col(1));
}

double BodyResponse::residual() const {
  return fracture::residual(system_, state_.total_force, state_.load_factor, state_.largest_force);
}

}  // namespace bempd::fracture
