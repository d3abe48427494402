#pragma once

#include <functional>
#include <limits>
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
#include "geometry/turning.hpp"

namespace bempd::fracture {

// Next step of a tip.
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

  // Whether the fit gives the load, because the field ahead is that of the tip alone. Then the relative error of the
  // load, and the residual of the fit as a share of the stress.
  bool fit_holds = true, is_shut = false;  // shut: its faces press on each other at the tip
  double error = 0, residual = 0;
  // Whether sums around the tip are asked for its factors, direction and load (`by_factors`: it had room for them), and
  // whether their load stands without that of an energy. `at_border`: the fit lacks points beside a border with
  // boundary elements. If by factors: the square of their ratio to those of the fit.
  bool asks_around = false, factors_suffice = true, by_factors = false;
  bool at_border = false, fit_would_hold = true;
  double rate_over_fit = 1;
  // Whether the load by the fit counts beside that by an energy: for a sheared tip with no other tip near.
  bool blends = false;
  // Whether the load comes from the energy of a trial step. If so: the ratio (see ratio_at) after the step over that
  // before it, and the energy that the step's bonds take [J].
  bool by_energy = false;
  double toughness = 0;  // at that load factor by a function of the host; 0 without one [Pa m^(1/2)]
  double after_step = 1, taken_energy = 0;
  bool is_loaded = true;  // the tip bears a load at the step's load factor; false only for steps in a given direction

  double ratio_at(double at) const { return constant + at * growing; }
};

class LineSteps;
// Step of a tip in a direction, whatever its load. `by_load` is the one that the present loads let it take, if any.
// Empty if no bond lies ahead.
std::optional<LineStep> step_towards(const Point& direction, const crack::TipId& tip, const LineSteps& steps,
                                     const BodyState& state, const std::optional<LineStep>& by_load);

// Whether one of the steps whose fits do not hold may be the first, where `steps` have the loads of their fits. Its
// load then has to come from the energy of a trial step, which a TrialBody is needed for.
bool need_body(const std::vector<LineStep>& steps, const LoadWay& way);

// Steps of crack lines for given displacements, which need to be known around tips only. The tip that first reaches its
// toughness grows by a spacing in the direction of maximum hoop stress. The load factor is corrected by the energy that
// the last steps released, so that the growth absorbs the fracture energy.
class LineSteps {
 public:
  LineSteps(LoadedBody& body, pd::TipLaws laws);

  const pd::TipLaws& laws() const { return laws_; }
  const pd::TipLaw& law_of(const GrowingTip& tip) const { return laws_.laws[static_cast<std::size_t>(tip.law)]; }
  // Law of a tip at a place.
  crack::GrowthLaw growth_law(const GrowingTip& tip, const Point& place) const {
    return growth_law(law_of(tip).at(place, tip.grown), tip, place);
  }
  crack::GrowthLaw growth_law(const pd::TipLaw& there, const GrowingTip& tip, const Point& place) const {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return {there.toughness,           there.modulus,
            laws_.criterion,           there.directions,
            heading_of(tip.direction), {there.function, tip.id, place, tip.grown, {unknown, unknown}}};
  }

  // Sets the tips that the host has frozen.
  void freeze(std::set<crack::TipId> tips) { frozen_ = std::move(tips); }
  const std::set<crack::TipId>& frozen() const { return frozen_; }
  // Whether a tip does not grow at any load: it is frozen, or has stopped at an interface.
  bool rests(const GrowingTip& tip) const {
    return tip.state == crack::TipState::at_interface || (!has_ended(tip) && frozen_.count(tip.id) > 0);
  }

  // One step for each tip that is loaded and whose path meets bonds; frozen tips are included on request, as if they
  // were free. If a fit does not hold, a trial step of `body` gives the load; without a body, as in a window, the fit
  // is used all the same.
  std::vector<LineStep> all(const std::vector<GrowingTip>& tips, const coupling::Affine& displacement,
                            const LoadWay& way, TrialBody* body = nullptr, bool with_frozen = false) const;
  // Candidates for the order of growth: the load factors of the steps.
  static std::vector<crack::Candidate> candidates(const std::vector<LineStep>& steps, const LoadWay& way);
  // Tip that grows first on a path (crack/order.hpp), used for the whole body and in windows alike.
  struct Choice {
    std::vector<LineStep> steps;    // of all tips that could grow
    std::optional<LineStep> first;  // null if no tip grows
    double load_factor;             // of its event; without one the end of the way
    int ties = 0;                   // other tips that would have grown as soon
    bool needs_body = false;        // without one: an energy has to tell the load of a step that may matter
  };
  Choice choose(const std::vector<GrowingTip>& tips, const coupling::Affine& displacement, const LoadWay& way,
                TrialBody* body = nullptr) const;
  // Event at which a step is taken, without the followers of the bonds that it breaks.
  Event event_of(const LineStep& step, double load_factor) const;
  // Whether a tip is loaded by more than rounding, compared with the load factor at which something else happens.
  static bool is_driven(const LineStep& step, const LoadWay& way, double load_factor);
  // Tips that guard the bonds near them, none of which breaks by itself: those whose steps are driven, and those that
  // do not grow.
  std::vector<GrowingTip> guarded(const std::vector<LineStep>& steps, const std::vector<GrowingTip>& tips,
                                  const LoadWay& way, double load_factor) const;

  // Stress intensity factors of a tip as affine functions of the load factor.
  AffineIntensity intensity_at(const GrowingTip& tip, const coupling::Affine& displacement) const;
  // T of a tip, constant and proportional part [Pa].
  Point t_stress_at(const GrowingTip& tip, const coupling::Affine& displacement) const {
    return stress_.fitted(tip, law_of(tip), displacement, body_.pressure_in(tip.id.crack)).t_stress();
  }
  // Whether the faces of a tip press on each other there.
  bool is_closed(const GrowingTip& tip, const coupling::Affine& displacement) const;
  // Angle by which a tip that grows at a load factor turns, counter-clockwise [rad].
  double kink_at(const GrowingTip& tip, const coupling::Affine& displacement, double load_factor) const;

  // Moves the tip of a step after its event, which has released `released_energy`. The tip remembers the ratio of
  // energies, or ends. `displacement_at` returns displacements after the event, known around the given tips.
  using DisplacementAt = std::function<const coupling::Affine&(const std::vector<GrowingTip>&)>;
  crack::Extension take(const LineStep& step, const Event& event, double released_energy,
                        const DisplacementAt& displacement_at, std::vector<GrowingTip>& tips) const;

  // State of a tip whose crack has just begun: at a free edge or a hole it has ended.
  crack::TipState state_of_begun(const GrowingTip& tip) const {
    const bool leaves = way_.leaves_body(tip.place, tip.direction, law_of(tip));
    return leaves ? state_at_edge(tip.place) : crack::TipState::grows;
  }

  // Nodes whose displacements are needed for these tips, each once.
  std::vector<int> nodes_asked(const std::vector<GrowingTip>& tips) const;
  static bool has_ended(const GrowingTip& tip) { return crack::has_ended(tip.state); }
  // Whether a term is too close to a tip to break by itself.
  bool is_spared(int term, const GrowingTip& tip) const;

  std::vector<int> across(const Point& from, const Point& to, double horizon) const {
    return way_.across(from, to, horizon);
  }
  // Marks terms near a tip as not intact in `intact`, because they do not break by themselves: all of them, or only
  // those overloaded at a load factor.
  void spare(const GrowingTip& tip, std::vector<char>& intact, std::optional<double> overloaded_at = {}) const;

  const TipStress& stress() const { return stress_; }
  const LineWay& way() const { return way_; }

 private:
  // Stress intensity factors as functions of the load factor times the sign of the load path.
  static AffineIntensity on_way(AffineIntensity intensity, const LoadWay& way);
  // Factor by which the energies of the last steps correct the loads of a fit.
  static double correction_of(const GrowingTip& tip);
  void move(const LineStep& step, std::vector<GrowingTip>& tips) const;
  crack::Extension remember(const LineStep& step, double ratio, double released_energy,
                            const coupling::Affine& displacement, double load_factor,
                            std::vector<GrowingTip>& tips) const;
  std::optional<LineStep> next(const std::vector<GrowingTip>& tips, std::size_t tip,
                               const coupling::Affine& displacement, const LoadWay& way) const;
  // Stress intensity factors from a fit, corrected as in TipStress::as_read(). If loads come from energies, K_I is 0
  // for a tip whose faces press on each other.
  AffineIntensity intensity_of(const GrowingTip& tip, const WilliamsFit& fit) const;
  bool faces_press_at(const GrowingTip& tip) const;
  // Factors that give the load of growth.
  AffineIntensity intensity_for_load(const GrowingTip& tip, const WilliamsFit& fit) const;
  bool is_shut(const GrowingTip& tip, const WilliamsFit& fit) const;
  void judge_fit(const std::vector<GrowingTip>& tips, const WilliamsFit& fit, LineStep& step) const;
  // Replaces the load of the fit by that of a trial step's energy; keeps it if the step would close, or if the body has
  // no answer.
  void try_step(const GrowingTip& tip, const coupling::Affine& displacement, const LoadWay& way, TrialBody& body,
                LineStep& step) const;
  // Replaces factors, load and direction of the fit by those of sums around the tip; false if it has no room for them.
  bool take_factors(const GrowingTip& tip, const coupling::Affine& displacement, const LoadWay& way, TrialBody& body,
                    LineStep& step) const;
  AffineIntensity turning_of(const GrowingTip& tip, const AffineIntensity& by_fit, const coupling::Affine& displacement,
                             double present) const;
  crack::TipState state_at_edge(const Point& place) const;
  // Ratio of a tip's equivalent stress intensity factor after a step to the toughness of `law`. `displacement` is that
  // after the step.
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
