#include "model/driven_growth.hpp"

#include <algorithm>

#include "cancellation.hpp"
#include "crack/cannot_grow.hpp"
#include "model/element_growth.hpp"
#include "model/model.hpp"

// Growth of cracks with boundary elements in steps of the run.
namespace bempd::model {

// Whether cracks with elements can grow in this step; in a material without a fracture energy they are stationary.
bool Model::drives_elements(const fracture::SteppingOptions& stepping) const {
  if (stepping.mode != fracture::SteppingMode::events) return false;
  const std::vector<regions::PartedCrack>& cracks = prepared_->discretization.cracks;
  return std::any_of(cracks.begin(), cracks.end(), [&](const regions::PartedCrack& crack) {
    return std::any_of(crack.parts.begin(), crack.parts.end(), [&](const regions::CrackPart& part) {
      return part.region > 0 && scene_.material_of(part.region).fracture_energy > 0;
    });
  });
}

// Runs from one growth of cracks with elements to the next; each growth continues in a scene prepared anew.
fracture::StopReason Model::advance_growing(DrivenRun& run) {
  ElementTips tips(options_, [this] { return growing_tips(); });
  if (drives_elements(run.stepping)) {
    run.stepping.elements = &tips;
    run.cracks = scene_.cracks();
    tips.follow(*prepared_->evolution);
    say([&] { tell_of_whole_body(); });
  }
  const std::int64_t before = prepared_->evolution->progress().events;
  for (;;) {
    // The cracks are copied before the step: a copy that fails after it would leave the step done behind an error.
    const std::vector<scene::Crack> cracks = scene_.cracks();
    const fracture::StopReason reason =
        prepared_->evolution->advance(run.target, run.goal, run.stepping, run.on_event, run.on_end);
    const bool one_event = reason == fracture::StopReason::event;
    try {
      if ((one_event || reason == fracture::StopReason::requested) && go_on_in_elements(tips, run)) {
        if (one_event) return reason;
        continue;
      }
      if (reason != fracture::StopReason::growth) return with_stopped_lines(reason, run);
      check_cancelled();
      if (!grow_next(tips, run)) return fracture::StopReason::crack_stopped;
    } catch (const crack::FreesLoadedPart& error) {
      scene_.set_cracks(cracks);
      say([&] { log(1, text(error.what(), "; without it the body is separated, and the run ends just before")); });
      return separated_before_growth(reason == fracture::StopReason::growth, run);
    }
    const fracture::EvolutionState& state = prepared_->evolution->progress();
    run.stepping.events_so_far = state.events - before;
    run.on_event(state);
    const bool is_done = run.goal == fracture::Goal::next_event;
    if (!is_done && !run.crack_stopped) continue;
    run.on_end();
    if (state.separated && run.goal != fracture::Goal::load_factor) return fracture::StopReason::separated;
    return run.crack_stopped ? fracture::StopReason::crack_stopped : fracture::StopReason::event;
  }
}

// Ends a run just before a growth that leaves no equilibrium; `is_open`: the run waits for that growth. A step to a
// load factor has not arrived there.
fracture::StopReason Model::separated_before_growth(bool is_open, DrivenRun& run) {
  prepared_->evolution->note_separation();
  if (is_open) prepared_->evolution->end_with_stopped({}, run.on_end);
  if (!run.stopped_lines.empty()) stop_requested_ = false;  // set by look_after_lines()
  return run.goal == fracture::Goal::load_factor ? fracture::StopReason::no_equilibrium
                                                 : fracture::StopReason::separated;
}

// Collects crack lines that have come to the border of their lattice and asks the run to end its step there.
void Model::look_after_lines(DrivenRun& run) {
  const std::vector<fracture::CrackExtension>& all = prepared_->evolution->progress().extensions;
  for (; run.extensions_seen < all.size(); ++run.extensions_seen) {
    const fracture::CrackExtension& e = all[run.extensions_seen];
    if (!e.has_ended() && leaves_lattice(e, scene_, prepared_->discretization))
      run.stopped_lines.push_back({e.crack, e.end});
  }
  if (!run.stopped_lines.empty()) stop_requested_ = true;
}

fracture::StopReason Model::with_stopped_lines(fracture::StopReason reason, const DrivenRun& run) {
  using fracture::StopReason;
  if (run.stopped_lines.empty()) return reason;
  stop_requested_ = false;  // by look_after_lines()
  for (const crack::TipId& tip : run.stopped_lines) prepared_->evolution->stop_line(tip);
  say([&] {
    for (const crack::TipId& tip : run.stopped_lines)
      log(1, text("crack ", tip.crack,
                  " has come to the border of its lattice, where it cannot go on into a boundary "
                  "element region; give the peridynamic region more room there if it should"));
  });
  return reason == StopReason::requested || reason == StopReason::event ? StopReason::crack_stopped : reason;
}

namespace {

// One tip with its extension, out of several that were to grow together.
Growing alone(const Growing& together, std::size_t number) {
  Growing one = together;
  one.tips = {together.tips[number]}, one.extensions = {together.extensions[number]};
  one.lengths = {together.lengths[number]};
  return one;
}

}  // namespace

// Lets the tip that is due grow, with those that tie with it. Returns false if that is impossible: the tips that cannot
// grow alone either are stopped (the due tip if each could), and the step ends.
bool Model::grow_next(ElementTips& tips, DrivenRun& run) {
  const fracture::CrackEvolution::Due due = prepared_->evolution->due();
  Growing growing = growing_with(tips.values(), tips.number_of(due.tip), load_factor(), options_);
  growing.ties = due.ties;
  set_lengths(growing, chosen_length(scene_, growing, options_), options_);
  const std::vector<scene::Crack> before = scene_.cracks();
  const auto cannot_grow_alone = [&](std::size_t number) {
    Growing one = alone(growing, number);
    bool cannot = false;
    try {
      extended_scene(before, one, run.on_way);
    } catch (const crack::CannotGrow&) {
      cannot = true;
    }
    scene_.set_cracks(before);
    return cannot;
  };
  Grown next;
  try {
    next = grown(before, growing, true, run.on_way);
  } catch (const crack::CannotGrow& error) {
    scene_.set_cracks(before);
    say([&] { log(1, error.what()); });
    std::vector<crack::TipId> stopped;
    for (std::size_t k = 0; k < growing.tips.size() && growing.tips.size() > 1; ++k)
      if (cannot_grow_alone(k)) stopped.push_back({growing.tips[k].crack, growing.tips[k].end});
    if (stopped.empty()) stopped.push_back(due.tip);
    prepared_->evolution->end_with_stopped(stopped, run.on_end);
    return false;
  }
  run.crack_stopped = std::any_of(next.growth.extensions.begin(), next.growth.extensions.end(),
                                  [](const auto& e) { return e.state == crack::TipState::at_interface; });
  go_on_in(std::move(next.scene), next.growth, tips, run);
  return true;
}

void Model::go_on_in(std::unique_ptr<PreparedScene> next, const fracture::Growth& growth, ElementTips& tips,
                     DrivenRun& run) {
  const Seconds spent = seconds_of(*prepared_);
  run.seconds.solve -= spent.solve, run.seconds.update -= spent.update, run.seconds.search -= spent.search;
  prepared_.swap(next);
  ++generation_;
  tips.follow(*prepared_->evolution);
  say([&] { tell_of_growth(growth, *next); });
  if (!run.start) run.start = std::move(next);
}

// Returns the model to the start of the run after a failure, at whatever point that happened.
void Model::take_back(DrivenRun& run) noexcept {
  if (run.stepping.elements) scene_.set_cracks(std::move(run.cracks));
  if (run.start) prepared_ = std::move(run.start);
  prepared_->evolution->take_back();
  ++generation_;
}

}  // namespace bempd::model
