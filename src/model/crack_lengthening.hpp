#pragma once

#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "model/driven_growth.hpp"
#include "model/element_carrier.hpp"
#include "model/element_growth.hpp"
#include "model/model.hpp"

namespace bempd::model {

// Tip, with the length and the turn of the extension that it gets at the present load factor.
struct Lengthened {
  regions::TipValues tip;
  double length, angle;
  // Whether the extension is a crack line (crack that grows in a lattice by steps of a spacing) that turns at each
  // spacing by the loads that act at present; else it is straight.
  bool turns_by_itself = false;
};

// Prepared scene with longer cracks, and the cracks of the scene.
struct LongerCracks {
  Grown grown;
  std::vector<scene::Crack> cracks;
};

// Call of the host that extends cracks with boundary elements by given lengths, whether or not their tips are critical.
// The call can be undone until keep_result(). LineLengthening extends crack lines in lattices as well.
class CrackLengthening {
 public:
  // Prepares the model and finds its equilibrium under the values that the host has set. Throws Error (argument) if no
  // crack has boundary elements.
  explicit CrackLengthening(Model& model) : CrackLengthening(model, true) {}
  CrackLengthening(const CrackLengthening&) = delete;
  CrackLengthening& operator=(const CrackLengthening&) = delete;
  virtual ~CrackLengthening() = default;

  // Tips that may grow: neither frozen by the host nor stopped. Their stress intensity factors are functions of the
  // load factor.
  virtual std::vector<regions::TipValues> tips() { return model_.growth().growing_tips(); }
  // Tips with their values under the loads that act at present.
  virtual std::vector<regions::TipValues> loaded_tips(regions::TipDetail detail) {
    return model_.cracks().tips_of(model_.prepared(), detail);
  }
  // Cracks with their growth so far.
  virtual std::vector<scene::Crack> cracks() const { return model_.scene().cracks(); }
  // Id of the region in which a tip grows.
  virtual int region_of(const regions::TipValues& tip, const PreparedScene& scene) const {
    return scene.discretization.cracks[static_cast<std::size_t>(tip.crack) - 1].region_at(tip.end);
  }
  PreparedScene& scene() { return model_.prepared(); }
  // Prepared scene of the trial `longer`, which is not accepted yet.
  virtual PreparedScene& scene_of(LongerCracks& longer) { return *longer.grown.scene; }
  // Calls `read` while the scene of the trial `longer` is the model's scene; if `longer` is null, in the model's own
  // scene.
  virtual void in_scene_of(LongerCracks* longer, const std::function<void()>& read);
  // Whether crack lines in lattices can grow in a scene.
  virtual bool grows_lines(const PreparedScene&) const { return false; }
  // Length of which the growth of a tip must be a multiple: a step in a lattice [m]; 0 in boundary elements, where any
  // length is possible.
  virtual double growth_increment(const regions::TipValues&) const { return 0; }
  // Distance from a tip within which its lattice smooths the singular stress field: two horizons [m]; 0 in elements.
  virtual double spread(const regions::TipValues&, const PreparedScene&) const { return 0; }
  // Distance by which the effective tip, at which the singular stress field is centred, lies ahead of the tip's place
  // [m].
  virtual double effective_tip_ahead(const regions::TipValues&, const PreparedScene&) const { return 0; }

  // Moves the load factor without growth of cracks.
  virtual void go_to(double load_factor);
  // Makes a trial with longer cracks at the present load factor, and enters the growth in the history of the trial.
  // go_on_in() accepts the trial, leave_trial() drops it. Throws crack::CannotGrow.
  virtual LongerCracks lengthened(const std::vector<Lengthened>& tips);
  // Extends the tips of `growing`, which become critical by the loads, by the lengths given in `growing`, and accepts
  // the longer cracks.
  GrowthResult grown_first(const Growing& growing);
  // Accepts a trial: its scene and cracks become those of the model.
  virtual void go_on_in(LongerCracks longer);
  // Drops a trial: the model returns to its last accepted state.
  virtual void leave_trial() {}
  // Calls the host's progress function; throws Error (cancelled) if the function asks to stop.
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
  ElementCarrier carrier_;  // carrier of the cracks with elements

 private:
  static Model& prepared(Model& model);

  std::optional<LoadValues::Before> loads_;  // loads before the call, if it changed them
  fracture::EvolutionState state_;           // state at the start of the call
  fracture::Continuation continuation_;      // continuation at the start of the call
  std::vector<scene::Crack> present_;        // accepted cracks of the scene, without growth in lattices
  std::size_t recorded_;                     // number of tip records at the start of the call
};

// Moves the load factor of a scene. Neither cracks with boundary elements nor the tips `frozen` grow meanwhile.
void move_load(PreparedScene& scene, double load_factor, const std::set<crack::TipId>& frozen);

}  // namespace bempd::model
