#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "crack/factors.hpp"
#include "crack/order.hpp"
#include "fracture/evolution_state.hpp"
#include "fracture/line/line_load.hpp"
#include "fracture/line/line_way.hpp"
#include "fracture/line/tip_stress.hpp"
#include "fracture/loaded_body.hpp"
#include "fracture/stepping_options.hpp"

namespace bempd::fracture {

// Which way the load factor goes, from where, and what is held on it.
struct LoadWay {
  double present;
  bool upwards = true;
  Control control = Control::load;

  double sense() const { return upwards ? 1 : -1; }
  double ahead(double load_factor) const { return sense() * load_factor; }  // grows on the way
  // Where what is critical at a load factor happens: here, if that lies behind and the load factor is held.
  double place_of(double critical) const {
    return control == Control::load && ahead(critical) < ahead(present) ? present : critical;
  }
  // Whether one load factor comes before another one on the way, by more than rounding.
  bool is_before(double one, double other) const {
    if (std::isinf(other)) return ahead(one) < ahead(other);
    return ahead(one) < ahead(other) - crack::tie_share * std::abs(other);
  }
};

// What a tip does next.
struct LineStep {
  std::size_t tip = 0;
  Point direction{1, 0};
  LineWay::Step way{};
  double load_factor = 0;            // critical
  double constant = 0, growing = 0;  // hoop intensity there, over the toughness, corrected
  int law = 0;                       // by which it grows
  double angle = 0;                  // by which it turns, counter-clockwise
  crack::AffineFactors factors{};    // of the tip

  double ratio_at(double at) const { return constant + at * growing; }
};

// Steps of lines by displacements, which have to be known around tips only: the tip that reaches its toughness first
// goes on by a spacing towards the largest hoop stress. The load factor is corrected by what the last steps released,
// so that a length of crack takes the fracture energy.
class LineSteps {
 public:
  LineSteps(LoadedBody& body, pd::TipLaws laws);

  const pd::TipLaws& laws() const { return laws_; }
  const pd::TipLaw& law_of(const GrowingTip& tip) const { return laws_.laws[static_cast<std::size_t>(tip.law)]; }

  // One for each tip whose way meets bonds and that something drives.
  std::vector<LineStep> all(const std::vector<GrowingTip>& tips, const coupling::Affine& displacement,
                            const LoadWay& way) const;
  // The one that is taken first (crack/order.hpp); null if there is none.
  struct First {
    const LineStep* step = nullptr;
    int ties = 0;
  };
  static First first_of(const std::vector<LineStep>& steps, const std::vector<GrowingTip>& tips, const LoadWay& way);
  // Whether what drives the tip is more than rounding, where something happens at this load factor.
  static bool is_driven(const LineStep& step, const LoadWay& way, double load_factor);

  // By how much a tip that grows at a load factor turns, counter-clockwise [rad].
  double kink_at(const GrowingTip& tip, const coupling::Affine& displacement, double load_factor) const;

  // The tip moves. Then, of an event with this ratio that released this energy and has led to these displacements:
  // the tip remembers it, or ends.
  void move(const LineStep& step, std::vector<GrowingTip>& tips) const;
  CrackExtension remember(const LineStep& step, double ratio, double released_energy,
                          const coupling::Affine& displacement, double load_factor,
                          std::vector<GrowingTip>& tips) const;

  // The first thing known of what a tip has done.
  static CrackExtension extension_from(const Point& from, const GrowingTip& tip, double length);

  // Nodes whose displacements are asked for where these tips are, each once.
  std::vector<int> nodes_asked(const std::vector<GrowingTip>& tips) const;
  static bool has_ended(const GrowingTip& tip) { return crack::has_ended(tip.state); }

  // Whether a term is too near to a tip that grows to break by itself.
  bool is_spared(int term, const GrowingTip& tip) const;

  std::vector<int> across(const Point& from, const Point& to, double horizon) const {
    return way_.across(from, to, horizon);
  }
  // Marks as gone the terms near a tip that grows: they do not break by themselves.
  void spare(const GrowingTip& tip, std::vector<char>& intact) const;

  const TipStress& stress() const { return stress_; }

 private:
  std::optional<LineStep> next(const std::vector<GrowingTip>& tips, std::size_t tip,
                               const coupling::Affine& displacement, const LoadWay& way) const;
  AffineIntensity turning_of(const GrowingTip& tip, const AffineIntensity& by_fit, const coupling::Affine& displacement,
                             double present) const;
  int law_ahead_of(const GrowingTip& tip) const;
  // Largest hoop intensity of a tip over the toughness of a law.
  double ratio_after(const GrowingTip& tip, const pd::TipLaw& law, const coupling::Affine& displacement,
                     double load_factor) const;
  bool has_begun(const GrowingTip& tip) const;

  LoadedBody& body_;
  const coupling::EquilibriumSystem& system_;
  pd::TipLaws laws_;
  TipStress stress_;
  LineWay way_;
};

}  // namespace bempd::fracture
