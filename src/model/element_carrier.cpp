#include "model/element_carrier.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "cancellation.hpp"
#include "crack/cannot_grow.hpp"
#include "error.hpp"
#include "model/element_growth.hpp"
#include "model/kept_cracks.hpp"
#include "model/model.hpp"

namespace bempd::model {

namespace {

void tell_of_loaded_part(Model& model, const crack::FreesLoadedPart& error) {
  say([&] {
    model.reports().log(1, text(error.what(), "; without it the body is separated, and the run ends just before"));
  });
}

}  // namespace

TimeSpent time_spent_in(const PreparedScene& prepared) {
  const coupling::SolverCounters& counters = prepared.system->counters();
  return {counters.seconds_solve, counters.seconds_update, prepared.evolution->seconds_search()};
}

ElementCarrier::ElementCarrier(Model& model, const scene::SceneValues* on_way, bool grows)
    : model_(model),
      on_way_(on_way),
      grows_(grows),
      cracks_(model.scene().cracks()),
      extensions_seen_(model.cracks().extensions().size()) {}

ElementCarrier::~ElementCarrier() = default;

fracture::CrackEvolution& ElementCarrier::body() { return *model_.prepared().evolution; }

void ElementCarrier::update() {
  const fracture::EvolutionState& state = body().progress();
  if (is_known_ && state.events == events_ && state.contact_switches == switches_) return;
  values_ = model_.growth().growing_tips();
  tips_.clear();
  for (const regions::TipValues& tip : values_) tips_.push_back(tip_for_carrier(tip, model_.options()));
  events_ = state.events;
  switches_ = state.contact_switches;
  is_known_ = true;
}

std::vector<crack::Tip> ElementCarrier::tips() {
  if (!grows_) return {};
  update();
  return tips_;
}

std::vector<crack::Candidate> ElementCarrier::candidates(const crack::LoadWay& way) {
  if (!grows_) return {};
  update();
  const bool path = way.control == crack::Control::path;
  if (path && crack::common_range(tips_).is_empty()) return {};
  std::vector<crack::Candidate> candidates;
  for (const crack::Tip& tip : tips_) {
    const bool is_due = !path && !tip.range.holds(way.present);
    const double critical = is_due ? way.present : way.upwards ? tip.range.highest : tip.range.lowest;
    const double ratio = is_due ? tip.law.ratio(tip.factors, way.present) : 1;
    if (std::isfinite(critical)) candidates.push_back(crack::candidate(tip.id, critical, ratio, way));
  }
  return candidates;
}

std::size_t ElementCarrier::index_of(const crack::TipId& tip) const {
  const auto found = std::find_if(tips_.begin(), tips_.end(), [&](const crack::Tip& one) { return one.id == tip; });
  return static_cast<std::size_t>(found - tips_.begin());
}

// Scene with longer cracks that `grow` prepares. If no such scene is possible, the cracks of the model are `before`
// again, and the error is thrown on.
Grown ElementCarrier::grown(const std::vector<scene::Crack>& before, const std::function<Grown()>& grow) {
  KeptCracks kept(model_.preparation().scene(), before);
  try {
    Grown next = grow();
    kept.release();
    return next;
  } catch (const crack::CannotGrow& error) {
    say([&] { model_.reports().log(1, error.what()); });
    throw;
  } catch (const crack::FreesLoadedPart& error) {
    tell_of_loaded_part(model_, error);
    throw;
  }
}

Grown ElementCarrier::longer(const std::vector<scene::Crack>& before, const Growing& growing,
                             ExtensionDirections directions) {
  KeptCracks kept(model_.preparation().scene(), before);
  Grown next = model_.growth().grown(before, growing, directions, on_way_);
  kept.release();
  return next;
}

// Lets the tip of `step` grow, together with the tips that tie with it. If that is impossible, stops those tips among
// them that cannot grow even alone; if there are none, stops the tip of `step`.
crack::Advance ElementCarrier::advance(const crack::Step& step) {
  check_cancelled();
  update();
  Growing growing = growing_with(values_, index_of(step.tip), model_.load_factor(), model_.options());
  growing.ties = step.ties;
  const bool chosen = step.length == 0;
  const double length =
      chosen ? chosen_length(model_.scene(), growing, model_.options()) * model_.accuracy().step_share() : step.length;
  set_lengths(growing, length, model_.options());
  const std::vector<scene::Crack> before = model_.scene().cracks();
  try {
    const ExtensionDirections directions = chosen ? ExtensionDirections::chosen : ExtensionDirections::by_option;
    Grown next = grown(before, [&] { return longer(before, growing, directions); });
    crack::Advance done{next.growth.extensions};
    for (const crack::Extension& e : done.extensions) done.has_stopped |= e.state == crack::TipState::at_interface;
    go_on_in(std::move(next.scene), next.growth);
    return done;
  } catch (const crack::CannotGrow&) {
    std::vector<crack::TipId> stopped = tips_that_cannot_grow(growing, before);
    if (stopped.empty()) stopped.push_back(step.tip);
    body().events().stop(stopped);
    return {{}, true};
  }
}

// Tips of `growing` that cannot grow even alone; empty if only one tip was to grow.
std::vector<crack::TipId> ElementCarrier::tips_that_cannot_grow(const Growing& growing,
                                                                const std::vector<scene::Crack>& before) {
  std::vector<crack::TipId> stopped;
  for (std::size_t k = 0; k < growing.tips.size() && growing.tips.size() > 1; ++k) {
    Growing one = growing;
    one.tips = {growing.tips[k]}, one.extensions = {growing.extensions[k]}, one.lengths = {growing.lengths[k]};
    const KeptCracks kept(model_.preparation().scene(), before);
    try {
      model_.growth().extended_scene(before, one, on_way_);
    } catch (const crack::CannotGrow&) {
      stopped.push_back({growing.tips[k].crack, growing.tips[k].end});
    } catch (const crack::FreesLoadedPart& error) {
      tell_of_loaded_part(model_, error);
      throw;
    }
  }
  return stopped;
}

void ElementCarrier::go_on_in(std::unique_ptr<PreparedScene> next, const fracture::Growth& growth) {
  grows_ = true;
  change_scene(std::move(next), [&](const PreparedScene& before) { model_.reports().tell_of_growth(growth, before); });
}

void ElementCarrier::change_scene(std::unique_ptr<PreparedScene> next,
                                  const std::function<void(const PreparedScene&)>& tell) {
  spent_ += time_spent_in(model_.prepared());
  next = model_.preparation().exchange(std::move(next));
  model_.growth().forget_factors();
  model_.preparation().has_changed();
  ++changes_;
  is_known_ = false;
  say([&] { tell(*next); });
  if (!start_) start_ = std::move(next);
}

// Gives lattice patches more blocks around crack lines that have grown since the last call, and gives blocks behind
// these lines back to boundary elements where the crack faces are separated.
void ElementCarrier::follow_lines() {
  const CrackTreatments& treatments = model_.treatments();
  if (treatments.patches().empty()) return;
  const std::size_t count = body().progress().extensions.size();
  for (std::size_t k = extensions_seen_; k < count; ++k) {
    const std::span all(body().progress().extensions);
    const auto layout = static_cast<std::int64_t>(k);
    std::optional<std::vector<regions::Patch>> larger = treatments.enlarged(all[k]);
    if (!larger) continue;
    body().sources().bring_up_to_date();
    std::optional<ShorterPatches> back = treatments.shorter_patches(*larger, all.first(k + 1));
    if (back && has_separated_faces(model_.prepared(), *back) &&
        change_patches(std::move(back->layout.patches), std::move(back->cracks), regions::giving_back + layout))
      continue;
    change_patches(std::move(*larger), std::nullopt, layout);
  }
}

// Gives lattice patches more blocks around bonds that have broken, where cracks grow bond by bond instead of as lines.
// Returns whether a patch has no room for more blocks.
bool ElementCarrier::follow_breaks(const std::vector<coupling::StageChange>& broken) {
  CrackTreatments& treatments = model_.treatments();
  if (treatments.patches().empty() || body().lines()) return false;
  std::vector<Point> places;
  for (const coupling::StageChange& change : broken) {
    std::vector<Point> nodes;
    model_.prepared().system->terms().for_each_node(static_cast<std::size_t>(change.term), [&](int node) {
      nodes.push_back(model_.prepared().discretization.positions[static_cast<std::size_t>(node)]);
    });
    places.push_back(std::accumulate(nodes.begin(), nodes.end(), Point(0, 0)) / static_cast<double>(nodes.size()));
  }
  bool has_no_room = false;
  for (const Point& place : places) {
    const std::size_t extensions = body().progress().extensions.size();
    const auto near = regions::broken_bond_near_border(treatments.patches(), place, extensions);
    if (!near) continue;
    auto larger = treatments.enlarged(*near);
    if (larger && regions::broken_bond_near_border(*larger, place, extensions)) larger.reset();
    if (larger && change_patches(std::move(*larger), std::nullopt, regions::layout_number(*near))) continue;
    has_no_room = true;
    say([&] { model_.reports().warn_of_break(place); });
  }
  return has_no_room;
}

// Continues the run with other lattice patches and, if given, other cracks in elements. Returns false and leaves the
// patches as they are if that scene is impossible, exceeds the memory limit, or has no equilibrium that can be found.
bool ElementCarrier::change_patches(std::vector<regions::Patch> patches,
                                    std::optional<std::vector<scene::Crack>> cracks, std::int64_t layout) {
  body().sources().bring_up_to_date();
  std::unique_ptr<PreparedScene> next;
  if (!patches_) patches_ = model_.treatments().copy();
  try {
    next = model_.growth().with_patches(std::move(patches), std::move(cracks), on_way_, layout);
  } catch (const Error& error) {
    if (error.failure() != Failure::argument && error.failure() != Failure::unsolvable &&
        error.failure() != Failure::convergence)
      throw;
    if (!regions::gives_back(layout)) say([&] { model_.reports().warn_of_patch(error.what()); });
    return false;
  }
  change_scene(std::move(next), [&](const PreparedScene&) { model_.reports().tell_of_layout(); });
  return true;
}

void ElementCarrier::take_back() noexcept {
  model_.preparation().scene().set_cracks(std::move(cracks_));
  if (patches_) model_.treatments().go_back_to(std::move(*patches_));
  if (start_) model_.preparation().exchange(std::move(start_));
  model_.growth().forget_factors();
  model_.preparation().has_changed();
}

}  // namespace bempd::model
