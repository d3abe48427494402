#pragma once

#include <optional>
#include <vector>

#include "fracture/line/line_way.hpp"
#include "fracture/line/tip_stress.hpp"
#include "fracture/loaded_body.hpp"
#include "fracture/stepping_options.hpp"

namespace bempd::fracture {

// What a tip does next.
struct LineStep {
  std::size_t tip;
  Point direction;
  LineWay::Step way;
  double load_factor;        // critical
  double constant, growing;  // hoop intensity there, over the toughness, corrected

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

  // One for each tip whose way meets bonds and that something drives; and the first of them, of those alike but for
  // rounding that of the first tip. Null if there is none.
  std::vector<LineStep> all(const std::vector<GrowingTip>& tips, const coupling::Affine& displacement,
                            double load_factor, Control control) const;
  static const LineStep* first_of(const std::vector<LineStep>& steps);
  // Whether what drives the tip is more than rounding, where something happens at this load factor.
  static bool is_driven(const LineStep& step, double load_factor);

  // The tip moves. Then, of an event with this ratio that released this energy and has led to these displacements:
  // the tip remembers it, or ends.
  static void move(const LineStep& step, std::vector<GrowingTip>& tips);
  void remember(const LineStep& step, double ratio, double released_energy, const coupling::Affine& displacement,
                double load_factor, std::vector<GrowingTip>& tips) const;

  // Nodes whose displacements are asked for where these tips are, each once.
  std::vector<int> nodes_asked(const std::vector<GrowingTip>& tips) const;
  static bool has_ended(const GrowingTip& tip) { return tip.law < 0; }

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
                               const coupling::Affine& displacement, double load_factor, bool path) const;
  AffineIntensity turning_of(const GrowingTip& tip, const AffineIntensity& by_fit, const coupling::Affine& displacement,
                             double present) const;
  // Largest hoop intensity over the toughness.
  double hoop_ratio(const GrowingTip& tip, const coupling::Affine& displacement, double load_factor) const;

  LoadedBody& body_;
  const coupling::EquilibriumSystem& system_;
  TipStress stress_;
  LineWay way_;
  pd::TipLaws laws_;
};

}  // namespace bempd::fracture
