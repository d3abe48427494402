#include <algorithm>
#include <cmath>
#include <limits>

#include "elasticity/kinked_tip.hpp"
#include "error.hpp"
#include "model/crack_lengthening.hpp"
#include "model/crack_way.hpp"
#include "model/driven_growth.hpp"
#include "model/element_growth.hpp"
#include "model/growth_options.hpp"
#include "model/model.hpp"

// Growth of cracks with boundary elements: the scene is prepared again with longer cracks, and its run continues.
namespace bempd::model {

namespace {

constexpr int most_rounds_of_faces = 64;

// Thickness of the body at each extension, by the regions of the scene before the growth.
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

// Smallest load factor from zero upwards at which a tip grows, and which tip that is. Throws Error (unsolvable) if none
// grows.
std::pair<double, crack::FirstToGrow> first_growth(const std::vector<regions::TipValues>& tips,
                                                   const scene::Options& options) {
  std::vector<crack::Candidate> candidates;
  for (const regions::TipValues& tip : tips) {
    const double load_factor = law_of(tip, options).first_load_factor(factors_of(tip));
    const bool overloaded = load_factor == 0 && tip.toughness > 0;
    const double ratio = overloaded ? law_of(tip, options).ratio(factors_of(tip), 0) : 1;
    candidates.push_back({{tip.crack, tip.end}, load_factor, ratio, overloaded});
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

// Whether cracks with elements can grow in steps; in a material without a fracture energy they are stationary.
bool Model::drives_elements(const fracture::SteppingOptions& stepping) const {
  if (stepping.mode != fracture::SteppingMode::events) return false;
  const std::vector<regions::PartedCrack>& cracks = prepared_->discretization.cracks;
  return std::any_of(cracks.begin(), cracks.end(), [&](const regions::PartedCrack& crack) {
    return std::any_of(crack.parts.begin(), crack.parts.end(), [&](const regions::CrackPart& part) {
      return part.region > 0 && scene_.material_of(part.region).fracture_energy > 0;
    });
  });
}

void Model::set_tip_frozen(int crack, int end, bool frozen) {
  if (crack > crack_count()) scene_.crack(crack);  // throws
  if (frozen) {
    frozen_tips_.insert({crack, end});
  } else {
    frozen_tips_.erase({crack, end});
  }
}

std::span<const fracture::CrackExtension> Model::extensions() const {
  if (!prepared_) return {};
  return prepared_->evolution->progress().extensions;
}

// Stress intensity factors of tips with elements as affine functions of the load factor. They are computed again only
// if the scene, the displacement or the closed faces have changed.
const std::vector<regions::TipValues>& Model::tip_factors() {
  const coupling::Affine& displacement = prepared_->evolution->state().displacement;
  const std::vector<char>& closed = prepared_->system->constraints().closed();
  const bool is_known = tip_factors_.scene == prepared_.get() && tip_factors_.closed == closed &&
                        tip_factors_.displacement.rows() == displacement.rows() &&
                        tip_factors_.displacement == displacement;
  if (!is_known) {
    tip_factors_.scene = nullptr;
    tip_factors_ = {nullptr, displacement, closed, tips_of(*prepared_, regions::TipDetail::factors)};
    tip_factors_.scene = prepared_.get();
  }
  return tip_factors_.tips;
}

// Tips with elements that may grow: neither frozen by the host nor stopped before an interface.
std::vector<regions::TipValues> Model::growing_tips() {
  std::vector<regions::TipValues> tips = tip_factors();
  const fracture::EvolutionState& state = prepared_->evolution->progress();
  std::erase_if(tips, [&](const regions::TipValues& tip) {
    return frozen_tips_.count({tip.crack, tip.end}) > 0 || has_stopped({tip.crack, tip.end}, state);
  });
  return tips;
}

// Tips for bempd_grow_cracks(): throws Error (argument) if none may grow.
std::vector<regions::TipValues> Model::free_tips() {
  const std::vector<regions::TipValues> tips = growing_tips();
  if (!tips.empty()) return tips;
  require(!tip_factors().empty(), no_tip_with_elements);
  fail(Failure::argument,
       "all tips are frozen, or have stopped before an interface; let one grow again with bempd_set_tip_frozen()");
}

// Moves to the load factor at which the first tip becomes critical. If faces close or open or bonds break before that,
// the tips are computed again.
Growing Model::go_to_growth(double length) {
  for (int round = 0;; ++round) {
    const std::vector<regions::TipValues> tips = free_tips();
    const auto [goal, first] = first_growth(tips, options_);
    const fracture::EvolutionState& state = prepared_->evolution->progress();
    const std::int64_t switches = state.contact_switches, events = state.events;
    if (load_factor() != goal) {
      if (round == most_rounds_of_faces)
        fail(Failure::convergence, "faces of cracks close and open without an end where cracks are to grow");
      fracture::SteppingOptions stepping;
      stepping.frozen = frozen_tips_;
      prepared_->evolution->advance(goal, fracture::Goal::load_factor, stepping, {}, {});
      ++generation_;
      if (state.contact_switches != switches || state.events != events) continue;
    }
    Growing growing = growing_with(tips, first.index, goal, options_);
    growing.ties = first.ties;
    set_lengths(growing, length, options_);
    return growing;
  }
}

// Prepared scene with the extensions of `growing`. `on_way` are the values of loads that act; null for those of the
// host.
std::unique_ptr<PreparedScene> Model::extended_scene(const std::vector<scene::Crack>& before, Growing& growing,
                                                     const scene::SceneValues* on_way) {
  return with_cracks(extended(scene_, before, prepared_->discretization.tolerance, growing), on_way);
}

// Prepares the scene with the extended cracks and enters the growth in its history.
Grown Model::grown(const std::vector<scene::Crack>& before, Growing growing, Turning turning,
                   const scene::SceneValues* on_way) {
  constexpr double turns = 0.01, turns_too_much = 0.35;  // [rad]
  constexpr int most_halvings = 4;
  const std::vector<double> angles = [&] {
    std::vector<double> all;
    for (const fracture::CrackExtension& e : growing.extensions) all.push_back(e.angle);
    return all;
  }();
  const bool chosen = turning == Turning::chosen;
  const bool chords = turning != Turning::given && options_.text_value("crack.direction") == "chord";
  Grown result;
  for (int halvings = 0;; ++halvings) {
    result.scene = extended_scene(before, growing, on_way);
    result.tips = tips_of(*result.scene, regions::TipDetail::factors);
    const double turn = largest_turn(growing, result.tips, options_);
    const bool too_long = chosen && turn > turns_too_much && halvings < most_halvings;
    if (!too_long && (chords || (chosen && turn > turns))) {
      turn_to_chords(growing, result.tips, options_);
      result.scene = extended_scene(before, growing, on_way);
      result.tips = tips_of(*result.scene, regions::TipDetail::factors);
    }
    if (!too_long) break;
    for (std::size_t k = 0; k < angles.size(); ++k) growing.lengths[k] /= 2, growing.extensions[k].angle = angles[k];
  }
  const std::vector<double> thickness = thickness_at(scene_, *prepared_, growing.extensions);
  fracture::CrackEvolution& evolution = *result.scene->evolution;
  const bool by_other_process = !growing.is_driven && growing.is_in_equilibrium();
  std::optional<double> beyond_path;
  if (growing.is_driven)
    if (const std::optional<double> end = end_of_path(growing, result.tips, options_))
      beyond_path = evolution.released_beyond_path(*prepared_->evolution, *end);
  result.growth = booked(std::move(growing), result.tips, thickness, evolution.released_by_growth(), beyond_path);
  if (by_other_process) {
    result.growth.surface_energy = evolution.released_by_growth();
    for (crack::Extension& e : result.growth.extensions) e.surface_energy = e.released_energy;
  }
  evolution.book(result.growth);
  return result;
}

GrowthResult Model::grow_cracks(double length) {
  require(std::isfinite(length) && length > 0, "length is ", length, "; it must be > 0");
  CrackLengthening call(*this);
  try {
    const GrowthResult result = call.grown_first(go_to_growth(length));
    call.keep();
    say([&] {
      log(2, text("load factor ", result.load_factor, ": ", result.tips, " tips have grown by ", result.length));
    });
    return result;
  } catch (...) {
    call.take_back();
    throw;
  }
}

}  // namespace bempd::model
