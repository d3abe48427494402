#include "error.hpp"
#include "model/model.hpp"

namespace bempd::model {

// Replaces load factors of growth that change as soon as the load factor moves, because crack faces then open or close,
// as in a body at rest. The new values are those of a state a little ahead. If there is no equilibrium ahead, the load
// factors of growth are unknown.
void CrackResults::take_growth_past_face_changes(std::vector<regions::TipValues>& tips) {
  for (const bool upwards : {true, false}) {
    std::vector<regions::TipValues> ahead(tips.size());
    try {
      if (!model_.prepared().evolution->look_past_switch(upwards, [&] { ahead = present_tips(); })) continue;
    } catch (const Error& error) {
      if (error.failure() != Failure::unsolvable && error.failure() != Failure::convergence) throw;
    }
    ahead.resize(tips.size());
    for (std::size_t k = 0; k < tips.size(); ++k) {
      if (!upwards) {
        tips[k].critical_load_factor_down = ahead[k].critical_load_factor_down;
        continue;
      }
      tips[k].critical_load_factor = ahead[k].critical_load_factor;
      tips[k].critical_kink_angle = ahead[k].critical_kink_angle;
      tips[k].load_rule = ahead[k].load_rule, tips[k].load_error = ahead[k].load_error;
    }
  }
}

}  // namespace bempd::model
