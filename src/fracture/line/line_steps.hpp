#pragma once

#include <functional>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "crack/carrier.hpp"
#include "fracture/event_source.hpp"
#include "fracture/evolution_state.hpp"
#include "fracture/line/line_load.hpp"
#include "fracture/line/line_way.hpp"
#include "fracture/line/tip_stress.hpp"
#include "fracture/line/trial_steps.hpp"
#include "fracture/load_way.hpp"
#include "fracture/loaded_body.hpp"

namespace bempd::fracture {

// What a tip does next.
struct LineStep {
  std::size_t tip = 0;
  crack::TipId id{};  // of the tip
  Point direction{1, 0};
  LineWay::Step way{};
  double load_factor = 0;            // critical
  double constant = 0, growing = 0;  // hoop intensity there, over the toughness, corrected
  int law = 0;                       // by which it grows
  double angle = 0;                  // by which it turns, counter-clockwise
  crack::AffineFactors factors{};    // of the tip

  // Whether the stress ahead is the tip's own, so that its fit says when the tip grows; how far off the load may be, as
  // a share of it; and what the fit leaves of the stress.
  bool fit_holds = true, is_shut = false;  // shut: its faces press on each other at the tip
  double error = 0, residual = 0;
  // The load is that of the energy of a trial step; then: the ratio of energy rates after the step to that before it,
  // and what its bonds take [J].
  bool by_energy = false;
  double after_step = 1, taken_energy = 0;

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
  crack::GrowthLaw growth_law(int law) const {
    const pd::TipLaw& of_region = laws_.laws[static_cast<std::size_t>(law)];
    return {of_region.toughness, of_region.modulus, laws_.criterion};
  }

  // Tips that the host keeps where they are.
  void freeze(std::set<crack::TipId> tips) { frozen_ = std::move(tips); }
  const std::set<crack::TipId>& frozen() const { return frozen_; }
  // Whether a tip stays where it is, whatever it carries: it is frozen, or has stopped at an interface.
  bool rests(const GrowingTip& tip) const {
    return tip.state == crack::TipState::at_interface || (!has_ended(tip) && frozen_.count(tip.id) > 0);
  }

  // One step for each tip whose way meets bonds and that something drives; on request also for frozen ones, as if they
  // were free. Where the fit does not hold a trial step of the body tells the load. Without a body, as in a window, the
  // step is told by the fit that does not hold.
  std::vector<LineStep> all(const std::vector<GrowingTip>& tips, const coupling::Affine& displacement,
                            const LoadWay& way, TrialBody* body = nullptr, bool with_frozen = false) const;
  // Whether one of these steps, which were told without a body, may matter and needs one.
  static bool need_body(const std::vector<LineStep>& steps, const LoadWay& way);
  // Load factors at which steps are taken.
  static std::vector<crack::Candidate> candidates(const std::vector<LineStep>& steps, const LoadWay& way);
  // The tip that grows first on a way (crack/order.hpp), and where: in the whole body and in windows.
  struct Choice {
    std::vector<LineStep> steps;    // of all tips that could grow
    std::optional<LineStep> first;  // null if no tip grows
    double load_factor;             // of its event; without one the end of the way
    int ties = 0;                   // other tips that would have grown as soon
    bool needs_body = false;        // without one: an energy has to tell the load of a step that may matter
  };
  Choice choose(const std::vector<GrowingTip>& tips, const coupling::Affine& displacement, const LoadWay& way,
                TrialBody* body = nullptr) const;
  // The event at which a step is taken, but for what follows the bonds that it breaks.
  Event event_of(const LineStep& step, double load_factor) const;
  // Whether what drives the tip is more than rounding, where something happens at this load factor.
  static bool is_driven(const LineStep& step, const LoadWay& way, double load_factor);
  // The tips of the steps that are driven, and those that rest: beside these no bond breaks by itself.
  std::vector<GrowingTip> guarded(const std::vector<LineStep>& steps, const std::vector<GrowingTip>& tips,
                                  const LoadWay& way, double load_factor) const;

  // Stress intensity factors of a tip.
  AffineIntensity intensity_at(const GrowingTip& tip, const coupling::Affine& displacement) const;
  // The angle by which a tip that grows at a load factor turns, counter-clockwise [rad].
  double kink_at(const GrowingTip& tip, const coupling::Affine& displacement, double load_factor) const;

  // Moves the tip of a step after its event, which has released an energy; the tip remembers what was released, or
  // ends. `displacement_at` tells the displacements after the event where moved tips ask for them.
  using DisplacementAt = std::function<const coupling::Affine&(const std::vector<GrowingTip>&)>;
  crack::Extension take(const LineStep& step, const Event& event, double released_energy,
                        const DisplacementAt& displacement_at, std::vector<GrowingTip>& tips) const;

  // Nodes whose displacements are asked for where these tips are, each once.
  std::vector<int> nodes_asked(const std::vector<GrowingTip>& tips) const;
  static bool has_ended(const GrowingTip& tip) { return crack::has_ended(tip.state); }

  // Whether a term is too near to a tip that grows to break by itself.
  bool is_spared(int term, const GrowingTip& tip) const;

  std::vector<int> across(const Point& from, const Point& to, double horizon) const {
    return way_.across(from, to, horizon);
  }
  // Marks as broken the terms near a tip, all or those that are overloaded at a load factor: they do not break by
  // themselves.
  void spare(const GrowingTip& tip, std::vector<char>& intact, std::optional<double> overloaded_at = {}) const;

  const TipStress& stress() const { return stress_; }

 private:
  void move(const LineStep& step, std::vector<GrowingTip>& tips) const;
  crack::Extension remember(const LineStep& step, double ratio, double released_energy,
                            const coupling::Affine& displacement, double load_factor,
                            std::vector<GrowingTip>& tips) const;
  std::optional<LineStep> next(const std::vector<GrowingTip>& tips, std::size_t tip,
                               const coupling::Affine& displacement, const LoadWay& way) const;
  // Factors as read from the fit; with loads by energy K_I of a tip whose faces press on each other is 0.
  AffineIntensity intensity_of(const GrowingTip& tip, const WilliamsFit& fit) const;
  bool faces_press_at(const GrowingTip& tip) const;
  bool is_shut(const GrowingTip& tip, const WilliamsFit& fit) const;
  void judge_fit(const std::vector<GrowingTip>& tips, const WilliamsFit& fit, LineStep& step) const;
  KinkShape shape_of(const GrowingTip& tip, const coupling::Affine& displacement, const LineStep& step) const;
  // The energy of a trial step replaces the fit; the fit stays where that step would close, or the body cannot tell.
  void try_step(const GrowingTip& tip, const coupling::Affine& displacement, const LoadWay& way, TrialBody& body,
                LineStep& step) const;
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
  std::set<crack::TipId> frozen_;
  TrialSteps trials_;
};

}  // namespace bempd::fracture
