#include "model/crack_growth.hpp"

#include <algorithm>
#include <cmath>

#include "crack/cannot_grow.hpp"
#include "error.hpp"
#include "model/crack_lengthening.hpp"
#include "model/driven_growth.hpp"
#include "model/element_growth.hpp"
#include "model/model.hpp"

// Growth of cracks with boundary elements: the scene is prepared again with longer cracks, and its run continues.
namespace bempd::model {

namespace {

constexpr int most_rounds_of_faces = 64;

// Thickness of the body at the beginning of each extension [m].
std::vector<double> thickness_at(const scene::Scene& scene, const PreparedScene& prepared,
                                 const std::vector<fracture::CrackExtension>& extensions) {
  std::vector<double> thickness;
  for (const fracture::CrackExtension& e : extensions) {
    const int region = prepared.discretization.cracks[static_cast<std::size_t>(e.crack) - 1].region_at(e.end);
    thickness.push_back(scene.material_of(region).elasticity.thickness);
  }
  return thickness;
}

constexpr const char* no_tip_with_elements =
    "no crack in a BEM region has a tip; add one, or let cracks in peridynamic regions grow by steps";

// Smallest load factor >= 0 at which a tip grows, and the tip that grows at this load factor. Throws Error (unsolvable)
// if no tip grows.
std::pair<double, crack::FirstToGrow> first_growth(const std::vector<regions::TipValues>& tips,
                                                   const scene::Options& options) {
  std::vector<crack::Candidate> candidates;
  for (const regions::TipValues& tip : tips) {
    const double load_factor = law_of(tip, options).first_load_factor(factors_of(tip));
    const bool overloaded = load_factor == 0 && tip.toughness > 0;
    const double ratio = overloaded ? law_of(tip, options).ratio(factors_of(tip), 0) : 1;
    candidates.push_back({tip.id(), load_factor, ratio, overloaded});
  }
  const crack::FirstToGrow found = *crack::first_to_grow(candidates, true);
  const double first = candidates[found.index].load_factor;
  if (!std::isfinite(first))
    fail(Failure::unsolvable,
         "no crack grows however large the load factor is; give their materials a fracture_energy, "
         "and loads that open them");
  return {first, found};
}

}  // namespace

bool CrackGrowth::is_driven_by(const fracture::SteppingOptions& stepping) const {
  if (stepping.mode != fracture::SteppingMode::events) return false;
  const std::vector<regions::PartedCrack>& cracks = model_.prepared().discretization.cracks;
  return std::any_of(cracks.begin(), cracks.end(), [&](const regions::PartedCrack& crack) {
    return std::any_of(crack.parts.begin(), crack.parts.end(), [&](const regions::CrackPart& part) {
      return part.region > 0 && model_.scene().material_of(part.region).fracture_energy > 0;
    });
  });
}

void CrackGrowth::set_frozen(int crack, int end, bool frozen) {
  if (crack < 1 || crack > model_.cracks().count()) model_.scene().crack(crack);  // throws
  if (frozen) {
    frozen_.insert({crack, end});
  } else {
    frozen_.erase({crack, end});
  }
}

// Stress intensity factors of tips with boundary elements, as affine functions of the load factor. They are computed
// again only if the scene, the displacement or the set of closed crack faces has changed.
const std::vector<regions::TipValues>& CrackGrowth::tip_factors() {
  const coupling::Affine& displacement = model_.prepared().evolution->state().displacement;
  const std::vector<char>& closed = model_.prepared().system->constraints().closed();
  const bool is_known = factors_.scene == model_.prepared_or_null() && factors_.closed == closed &&
                        factors_.displacement.rows() == displacement.rows() && factors_.displacement == displacement;
  if (!is_known) {
    factors_.scene = nullptr;
    factors_ = {nullptr, displacement, closed, model_.cracks().tips_of(model_.prepared(), regions::TipDetail::factors)};
    factors_.scene = model_.prepared_or_null();
  }
  return factors_.tips;
}

std::vector<regions::TipValues> CrackGrowth::growing_tips() {
  std::vector<regions::TipValues> tips = tip_factors();
  const fracture::EvolutionState& state = model_.prepared().evolution->progress();
  std::erase_if(
      tips, [&](const regions::TipValues& tip) { return frozen_.count(tip.id()) > 0 || has_stopped(tip.id(), state); });
  return tips;
}

// Tips with boundary elements that may grow; throws Error (argument) if there are none.
std::vector<regions::TipValues> CrackGrowth::free_tips() {
  const std::vector<regions::TipValues> tips = growing_tips();
  if (!tips.empty()) return tips;
  require(!tip_factors().empty(), no_tip_with_elements);
  fail(Failure::argument, crack::no_free_tip);
}

// Moves to the load factor at which the first tip becomes critical. If faces close or open or bonds break before that,
// the first tip and its load factor are found again. Returns the tips that grow; set_lengths() derives the lengths of
// their extensions from `length`.
Growing CrackGrowth::go_to_growth(double length) {
  for (int round = 0;; ++round) {
    const std::vector<regions::TipValues> tips = free_tips();
    const auto [goal, first] = first_growth(tips, model_.options());
    const fracture::EvolutionState& state = model_.prepared().evolution->progress();
    const std::int64_t switches = state.contact_switches, events = state.events;
    if (model_.load_factor() != goal) {
      if (round == most_rounds_of_faces)
        fail(Failure::convergence, "faces of cracks close and open without an end where cracks are to grow");
      fracture::SteppingOptions stepping;
      stepping.frozen = frozen_;
      model_.prepared().evolution->advance(goal, fracture::Goal::load_factor, stepping, {}, {});
      model_.preparation().has_changed();
      if (state.contact_switches != switches || state.events != events) continue;
    }
    Growing growing = growing_with(tips, first.index, goal, model_.options());
    growing.ties = first.ties;
    set_lengths(growing, length, model_.options());
    return growing;
  }
}

std::unique_ptr<PreparedScene> CrackGrowth::extended_scene(const std::vector<scene::Crack>& before, Growing& growing,
                                                           const scene::SceneValues* on_way) {
  return with_cracks(extended(model_.scene(), before, model_.prepared().discretization.tolerance, growing), on_way);
}

Grown CrackGrowth::grown(const std::vector<scene::Crack>& before, Growing growing, ExtensionDirections directions,
                         const scene::SceneValues* on_way) {
  constexpr double turns = 0.01;  // turn above which extensions become chords [rad]
  const double turns_too_much = 0.35 * model_.accuracy().step_share();  // turn above which extensions are halved [rad]
  constexpr int most_halvings = 4;
  const std::vector<double> angles = [&] {
    std::vector<double> all;
    for (const fracture::CrackExtension& e : growing.extensions) all.push_back(e.angle);
    return all;
  }();
  const bool chosen = directions == ExtensionDirections::chosen;
  const bool chords =
      directions != ExtensionDirections::given && model_.options().text_value("crack.direction") == "chord";
  Grown result;
  for (int halvings = 0;; ++halvings) {
    result.scene = extended_scene(before, growing, on_way);
    result.tips = model_.cracks().tips_of(*result.scene, regions::TipDetail::factors);
    const double turn = largest_turn(growing, result.tips, model_.options());
    const bool too_long = chosen && turn > turns_too_much && halvings < most_halvings;
    if (!too_long && (chords || (chosen && turn > turns))) {
      turn_to_chords(growing, result.tips, model_.options());
      result.scene = extended_scene(before, growing, on_way);
      result.tips = model_.cracks().tips_of(*result.scene, regions::TipDetail::factors);
    }
    if (!too_long) break;
    for (std::size_t k = 0; k < angles.size(); ++k) growing.lengths[k] /= 2, growing.extensions[k].angle = angles[k];
  }
  const std::vector<double> thickness = thickness_at(model_.scene(), model_.prepared(), growing.extensions);
  fracture::CrackEvolution& evolution = *result.scene->evolution;
  const bool by_other_process = !growing.is_driven && growing.is_in_equilibrium();
  std::optional<double> beyond_path;
  if (growing.is_driven)
    if (const std::optional<double> end = end_of_path(growing, result.tips, model_.options()))
      beyond_path = evolution.growth().released_beyond_path(model_.prepared().evolution->growth(), *end);
  result.growth = with_energies(std::move(growing), result.tips, thickness, evolution.growth().released(), beyond_path);
  if (by_other_process) {
    result.growth.surface_energy = evolution.growth().released();
    for (crack::Extension& e : result.growth.extensions) e.surface_energy = e.released_energy;
  }
  evolution.growth().book(result.growth);
  return result;
}

GrowthResult CrackGrowth::grow(double length) {
  require(std::isfinite(length) && length > 0, "length is ", length, "; it must be > 0");
  CrackLengthening call(model_);
  try {
    const GrowthResult result = call.grown_first(go_to_growth(length));
    call.keep_result();
    say([&] {
      model_.reports().log(
          2, text("load factor ", result.load_factor, ": ", result.tips, " tips have grown by ", result.length));
    });
    return result;
  } catch (...) {
    call.take_back();
    throw;
  }
}

}  // namespace bempd::model
