#include "model/fatigue.hpp"

#include <algorithm>

#include "elasticity/kinked_tip.hpp"
#include "model/crack_lengthening.hpp"
#include "model/fatigue_run.hpp"
#include "model/line_lengthening.hpp"

namespace bempd::model {

void Fatigue::set_rate(int material, crack::RateParameters parameters) {
  model_.scene().material(material);  // throws without it
  rates_[material] = std::move(parameters);
}

const crack::RateParameters* Fatigue::rate_of(int material) const {
  const auto found = rates_.find(material);
  return found == rates_.end() ? nullptr : &found->second;
}

FatigueReport Fatigue::grow(const FatigueOptions& options) {
  const std::unique_ptr<CrackLengthening> kind = lengthening_for(model_);
  CrackLengthening& lengthening = *kind;
  try {
    FatigueRun run(model_, lengthening, options);
    const FatigueReport report = run.run();
    lengthening.keep_result();
    records_ = run.take_records();
    overloads_ = run.remembered_overloads();
    return report;
  } catch (...) {
    lengthening.take_back();
    throw;
  }
}

namespace {

const regions::TipValues& tip_with(const std::vector<regions::TipValues>& tips, const crack::TipId& id) {
  const regions::TipValues* found = crack::tip_in(tips, id);
  require(found != nullptr, "the ", id.end == 0 ? "start" : "end", " of crack ", id.crack,
          " is no tip with boundary elements that may grow: it has ended or stopped, is frozen, or lies in a "
          "peridynamic region; bempd_tip() lists tips");
  return *found;
}

}  // namespace

GrowthResult Fatigue::extend(const std::vector<std::pair<crack::TipId, double>>& lengths) {
  CrackLengthening lengthening(model_);
  try {
    const std::vector<regions::TipValues> tips = lengthening.tips();
    std::vector<Lengthened> grow;
    for (const auto& [id, length] : lengths) {
      const regions::TipValues& tip = tip_with(tips, id);
      const Kink kink = law_of(tip, model_.options()).kink(factors_of(tip), model_.load_factor());
      grow.push_back({tip, length, kink.equivalent_factor > 0 ? kink.angle : 0});
    }
    LongerCracks longer = lengthening.lengthened(grow);
    if (model_.options().text_value("crack.direction") == "chord") {
      for (Lengthened& one : grow)
        if (const regions::TipValues* after = crack::tip_in(longer.grown.tips, one.tip.id());
            after && !after->directions)
          one.angle += 0.5 * law_of(*after, model_.options()).kink(factors_of(*after), model_.load_factor()).angle;
      longer = lengthening.lengthened(grow);
    }
    GrowthResult result = result_of(longer.grown.growth);
    result.released_energy = longer.grown.scene->evolution->progress().released_energy -
                             lengthening.scene().evolution->progress().released_energy;
    lengthening.go_on_in(std::move(longer));
    lengthening.report_progress();
    lengthening.keep_result();
    return result;
  } catch (...) {
    lengthening.take_back();
    throw;
  }
}

}  // namespace bempd::model
