#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "model/driven_growth.hpp"
#include "model/element_growth.hpp"
#include "model/model.hpp"

namespace bempd::model {

// A tip that is to grow by a length at the present load factor, turned by an angle.
struct Lengthened {
  regions::TipValues tip;
  double length, angle;
};

// A scene with longer cracks, and these.
struct LongerCracks {
  Grown grown;
  std::vector<scene::Crack> cracks;
};

// A call in which cracks with boundary elements grow by given lengths, whatever their load. Until keep() is called the
// model can be brought back to where it was.
class CrackLengthening {
 public:
  // Prepares the model and finds its equilibrium under the values that the host has set. Throws Error (argument)
  // without a crack that has elements.
  explicit CrackLengthening(Model& model);

  // Tips that may grow: those that are not frozen and have not stopped. Factors are functions of the load factor.
  std::vector<regions::TipValues> tips() { return model_.growing_tips(); }
  PreparedScene& scene() { return *model_.prepared_; }

  // Moves the load factor; no crack with elements grows.
  void go_to(double load_factor);
  // Scene with longer cracks, at the same load factor, whose growth is in its books; the model stays as it is. Throws
  // crack::CannotGrow.
  LongerCracks lengthened(const std::vector<Lengthened>& tips);
  // Makes it the model's scene.
  void go_on_in(LongerCracks longer);
  // The host's progress callback hears of it; throws Error (cancelled).
  void report_progress();
  void tell(const std::string& warning) const {
    Model::say([&] { model_.log(1, warning); });
  }
  bool stop_requested() const { return model_.stop_requested_; }

  // Ends the call: for good, or back at its start.
  void keep() noexcept;
  void take_back() noexcept;

 private:
  Model& model_;
  std::vector<scene::Crack> cracks_;         // at the start
  std::optional<Model::LoadsBefore> loads_;  // likewise
  fracture::EvolutionState state_;           // likewise
  fracture::Continuation continuation_;      // likewise
  std::unique_ptr<PreparedScene> start_;     // null: no crack has grown yet
  std::vector<scene::Crack> present_;        // cracks
  std::ptrdiff_t recorded_;                  // tips
};

// Moves the load factor of a scene; no crack with elements grows.
void move_load(PreparedScene& scene, double load_factor, const std::set<crack::TipId>& frozen);

}  // namespace bempd::model
