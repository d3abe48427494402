#include "fracture/window/forecast_balance.hpp"

#include "fracture/balance.hpp"
#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

using coupling::Affine;
using coupling::evaluate;

double ForecastBalance::largest_force_before(double load_factor, const BodyState& start) const {
  const Eigen::VectorXd force = body_.system().response().internal_force(evaluate(whole_, load_factor));
  return std::max(
      {start.largest_force, force.lpNorm<Eigen::Infinity>(), least_force_scale(body_.system(), load_factor)});
}

bool ForecastBalance::holds_after(ComputedEvents& events, Affine whole) {
  Affine before = std::exchange(whole_, std::move(whole));  // displacements before the first event
  ForecastEvent& last = events.last();
  const double f = last.event.load_factor;
  const Eigen::VectorXd force = internal_force_after(events.list());
  last.largest_force =
      std::max({last.largest_force, force.lpNorm<Eigen::Infinity>(), least_force_scale(body_.system(), f)});
  residual_ = std::max(unbalanced_, fracture::residual(body_.system(), force, f, last.largest_force));
  if (residual_ <= WindowSettings::acceptable_residual) return true;
  whole_ = std::move(before);
  return false;
}

Eigen::VectorXd ForecastBalance::internal_force_after(const std::vector<ForecastEvent>& events) const {
  coupling::EquilibriumSystem& system = body_.system();
  const double load_factor = events.back().event.load_factor;
  const auto last = std::find_if(events.rbegin(), events.rend(), [](const ForecastEvent& e) { return e.faces; });
  if (last == events.rend()) return system.response().internal_force(evaluate(whole_, load_factor));
  coupling::Constraints present = system.constraints();
  system.contact().set_without_factor(body_.faces().constraints_of(*last->faces));
  Eigen::VectorXd force = system.response().internal_force(evaluate(whole_, load_factor));
  system.contact().set_without_factor(std::move(present));
  return force;
}

}  // namespace bempd::fracture
