#pragma once

#include <memory>
#include <vector>

#include "model/crack_lengthening.hpp"

namespace bempd::model {

// Call in which crack lines in lattices are extended by whole steps of a spacing. Between steps the model is at its
// last accepted state, or at that of a trial.
class LineLengthening final : public CrackLengthening {
 public:
  // Throws Error (argument) if cracks do not grow as lines, or if a crack has boundary elements as well.
  explicit LineLengthening(Model& model);

  std::vector<regions::TipValues> tips() override;
  std::vector<regions::TipValues> loaded_tips(regions::TipDetail) override { return tips(); }
  std::vector<scene::Crack> cracks() const override;
  int region_of(const regions::TipValues& tip, const PreparedScene& scene) const override;
  PreparedScene& scene_of(LongerCracks&) override { return scene(); }
  void in_scene_of(LongerCracks*, const std::function<void()>& read) override { read(); }
  bool grows_lines() const override { return true; }
  double quantum(const regions::TipValues& tip) const override;
  void go_to(double load_factor) override;
  LongerCracks lengthened(const std::vector<Lengthened>& tips) override;
  void go_on_in(LongerCracks longer) override;

 private:
  void remember();
  void return_to_accepted();
  crack::Extension extend(const Lengthened& one);

  fracture::EvolutionState accepted_;
  fracture::Continuation way_on_;
  bool in_trial_ = false;
};

// The lengthening for the cracks of a model: in boundary elements, or as lines in lattices.
std::unique_ptr<CrackLengthening> lengthening_for(Model& model);

}  // namespace bempd::model
