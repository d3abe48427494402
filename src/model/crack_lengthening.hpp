#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "model/driven_growth.hpp"
#include "model/element_carrier.hpp"
#include "model/element_growth.hpp"
#include "model/model.hpp"

namespace bempd::model {

// Tip with the length and the angle of the extension that it is to get at the present load factor.
struct Lengthened {
  regions::TipValues tip;
  double length, angle;
  bool turns_by_itself = false;  // a line: at each spacing, by the loads that act at present; else it goes straight on
};

// Scene with longer cracks, and these cracks.
struct LongerCracks {
  Grown grown;
  std::vector<scene::Crack> cracks;
};

// Call in which cracks with boundary elements are extended by given lengths, whatever their load. It can be taken back
// until keep_result() is called. LineLengthening extends lines beside them.
class CrackLengthening {
 public:
  // Prepares the model and finds its equilibrium under the values that the host has set. Throws Error (argument) if no
  // crack has boundary elements.
  explicit CrackLengthening(Model& model) : CrackLengthening(model, true) {}
  CrackLengthening(const CrackLengthening&) = delete;
  CrackLengthening& operator=(const CrackLengthening&) = delete;
  virtual ~CrackLengthening() = default;

  // Tips that may grow: neither frozen by the host nor stopped. Their stress intensity factors are given as functions
  // of the load factor.
  virtual std::vector<regions::TipValues> tips() { return model_.growth().growing_tips(); }
  // Tips that may grow, under the loads that act at present.
  virtual std::vector<regions::TipValues> loaded_tips(regions::TipDetail detail) {
    return model_.cracks().tips_of(model_.prepared(), detail);
  }
  // Cracks as they are now.
  virtual std::vector<scene::Crack> cracks() const { return model_.scene().cracks(); }
  // Region in which the tip of a crack grows.
  virtual int region_of(const regions::TipValues& tip, const PreparedScene& scene) const {
    return scene.discretization.cracks[static_cast<std::size_t>(tip.crack) - 1].region_at(tip.end);
  }
  PreparedScene& scene() { return model_.prepared(); }
  // Prepared scene of longer cracks that are not accepted yet.
  virtual PreparedScene& scene_of(LongerCracks& longer) { return *longer.grown.scene; }
  // Calls `read` while the scene of longer cracks (null: the present one) is the model's.
  virtual void in_scene_of(LongerCracks* longer, const std::function<void()>& read);
  virtual bool grows_lines(const PreparedScene&) const { return false; }
  // Least length by which a tip can grow, of which its growth is a multiple [m]; 0 for any length.
  virtual double growth_increment(const regions::TipValues&) const { return 0; }
  // Distance from a tip over which a lattice spreads the stress of the tip's field, two horizons [m]; 0 in elements.
  virtual double spread(const regions::TipValues&, const PreparedScene&) const { return 0; }
  // Distance by which the effective tip, where the field of the tip begins, lies ahead of the tip's place [m].
  virtual double effective_tip_ahead(const regions::TipValues&, const PreparedScene&) const { return 0; }

  // Moves the load factor; cracks do not grow meanwhile.
  virtual void go_to(double load_factor);
  // Scene with longer cracks at the same load factor, in whose history the growth is entered; the model itself stays
  // unchanged. Throws crack::CannotGrow.
  virtual LongerCracks lengthened(const std::vector<Lengthened>& tips);
  // Extends the tips in `growing`, which the load drives, by the lengths given there, and continues with longer cracks.
  GrowthResult grown_first(const Growing& growing);
  // Continues in the scene with longer cracks, which becomes the model's.
  virtual void go_on_in(LongerCracks longer);
  // Leaves a trial that is not accepted: the model is again at its last accepted state.
  virtual void leave_trial() {}
  // Calls the host's progress function; throws Error (cancelled) if that asks to stop.
  void report_progress();
  void tell(const std::string& warning) const {
    say([&] { model_.reports().log(1, warning); });
  }
  bool stop_requested() const { return model_.host().stop_requested(); }

  // Ends the call: keep_result() keeps its result, take_back() returns the model to the start of the call.
  void keep_result() noexcept;
  virtual void take_back() noexcept;

 protected:
  CrackLengthening(Model& model, bool in_elements);

  Model& model_;
  ElementCarrier carrier_;  // of cracks with elements

 private:
  static Model& prepared(Model& model);

  std::optional<LoadValues::Before> loads_;  // at the start
  fracture::EvolutionState state_;           // likewise
  fracture::Continuation continuation_;      // likewise
  std::vector<scene::Crack> present_;        // cracks, but for those of lines
  std::size_t recorded_;                     // tips
};

// Moves the load factor of a scene; cracks with elements do not grow meanwhile.
void move_load(PreparedScene& scene, double load_factor, const std::set<crack::TipId>& frozen);

}  // namespace bempd::model
