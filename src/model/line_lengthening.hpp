#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "model/crack_lengthening.hpp"
#include "pd/tip_law.hpp"

namespace bempd::model {

// Call of the host that extends crack lines (cracks in lattices) by whole spacings, and cracks with boundary elements
// beside them. A trial that extends elements has a scene of its own, in which crack lines are extended as well. A trial
// that extends crack lines only changes the model's scene, which leave_trial() returns to its last accepted state. A
// crack line that has reached boundary elements continues in them in one step.
class LineLengthening final : public CrackLengthening {
 public:
  // Throws Error (argument) if cracks in lattices do not grow as lines.
  explicit LineLengthening(Model& model);

  std::vector<regions::TipValues> tips() override;
  std::vector<regions::TipValues> loaded_tips(regions::TipDetail detail) override;
  std::vector<scene::Crack> cracks() const override;
  int region_of(const regions::TipValues& tip, const PreparedScene& scene) const override;
  PreparedScene& scene_of(LongerCracks& longer) override { return longer.grown.scene ? *longer.grown.scene : scene(); }
  void in_scene_of(LongerCracks* longer, const std::function<void()>& read) override;
  bool grows_lines(const PreparedScene& scene) const override;
  double growth_increment(const regions::TipValues& tip) const override;
  double spread(const regions::TipValues& tip, const PreparedScene& scene) const override;
  double effective_tip_ahead(const regions::TipValues& tip, const PreparedScene& scene) const override;
  void go_to(double load_factor) override;
  LongerCracks lengthened(const std::vector<Lengthened>& tips) override;
  void go_on_in(LongerCracks longer) override;
  void leave_trial() override { return_to_accepted(); }

 private:
  std::optional<pd::TipLaw> law_at(const regions::TipValues& tip, const PreparedScene& scene) const;
  double spacing_at(const regions::TipValues& tip, const PreparedScene& scene) const;
  void save_accepted_state();
  void return_to_accepted();
  crack::Extension extend(const Lengthened& one);
  bool continue_in_elements(const Lengthened& one, LongerCracks& longer);
  std::vector<regions::TipValues> tips_of_lines();
  std::optional<Point> behind_border(const regions::TipValues& tip) const;

  fracture::EvolutionState accepted_;
  fracture::Continuation accepted_continuation_;
  bool in_trial_ = false;
};

// Makes the lengthening for the cracks of a model: LineLengthening if cracks cut bonds or crack lines have begun, else
// CrackLengthening.
std::unique_ptr<CrackLengthening> lengthening_for(Model& model);

}  // namespace bempd::model
