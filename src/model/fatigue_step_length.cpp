#include "model/fatigue_step_length.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bempd::model {

bool FatigueStepLength::choose(const crack::TipOnStep& tip, double before, double after, double cycles, double so_far,
                               bool must_stand) {
  constexpr double much = 4, most_change = 2, least_change = 0.3, few = 0.1;
  if (!(before > 0 && after > 0) || tip.after.empty()) return true;
  const double way = std::log1p(tip.growth / tip.own_length());
  const double power = std::log(after / before) / way;
  const auto known = powers_.find(tip.tip);
  if (known == powers_.end()) {
    powers_[tip.tip] = power;
    first_steps_[tip.tip] = way * cycles;
    return true;
  }
  const double change_of_power = std::abs(power - known->second) / 12, error = change_of_power * way;
  const double allowed = options_.tolerance * std::max(1.0, few * so_far / std::max(cycles, 1e-300));
  if (error > much * allowed && share_ > 1e-3 && !must_stand) return false;
  const double change = error > 0 ? 0.9 * std::sqrt(allowed / error) : most_change;
  share_ = std::min(options_.largest_step, share_ * std::clamp(change, least_change, most_change));
  known->second = power;
  has_estimate_ = true;
  error_ += error * cycles;
  if (const auto first = first_steps_.extract(tip.tip)) error_ += change_of_power * first.mapped();
  return true;
}

double FatigueStepLength::error(double passed, bool steps_were_made) const {
  if (steps_were_made && !has_estimate_) return std::numeric_limits<double>::quiet_NaN();
  return passed > 0 ? error_ / passed : 0;
}

}  // namespace bempd::model
