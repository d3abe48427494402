#include "fracture/crack_evolution.hpp"

#include <optional>

#include "error.hpp"
#include "fracture/event_choice.hpp"
#include "fracture/event_loop.hpp"
#include "number_range.hpp"

namespace bempd::fracture {

CrackEvolution::CrackEvolution(coupling::EquilibriumSystem& system, const std::vector<Point>& positions,
                               std::vector<double> critical_stretch, const std::vector<int>& cut,
                               std::vector<std::vector<int>> reaction_dofs, ContactPlan contact)
    : system_(system),
      body_(system, positions, std::move(critical_stretch), cut, std::move(reaction_dofs), std::move(contact), state_),
      sources_(body_, cut) {
  state_.work = body_.energy_at_rest();
}

void CrackEvolution::grow_lines(pd::TipLaws laws, std::vector<GrowingTip> tips, LineCarrier::Openings openings,
                                FactorsAround factors) {
  state_.tips = std::move(tips);
  lengths_ = laws.of_crack;
  sources_.grow_lines(std::move(laws), std::move(factors));
  lines_.emplace(*this, std::move(openings));
}

bool CrackEvolution::energies_are_lost() const {
  const double displacement = state_.total_displacement.lpNorm<Eigen::Infinity>();
  const double force = state_.total_force.lpNorm<Eigen::Infinity>();
  return displacement > 0 && force > 0 && !std::isnormal(displacement * force);
}

StopReason CrackEvolution::advance(double target, Goal goal, const SteppingOptions& options,
                                   const std::function<void(const EvolutionState&)>& on_event,
                                   const std::function<void()>& on_end) {
  return EventLoop(*this, target, goal, options, on_event, on_end).run();
}

// Begins a part of a run in this body.
void CrackEvolution::begin_call(const SteppingOptions& options) {
  mode_ = options.mode;
  next_ = nullptr;
  sources_.refresh();
  sources_.freeze(options.frozen);
  sources_.go_on();
  sources_.begin_call();
}

const Event* CrackEvolution::next(double target, const SteppingOptions& options) {
  next_ = sources_.next(target, options);
  return next_;
}

void CrackEvolution::perform_and_book(const Event& event) {
  const double within_before = within(event.load_factor);
  Outcome outcome = sources_.perform();
  outcome.within_before = within_before;
  book(event, outcome);
}

// Performs an event. Returns false if no equilibrium exists after it, and the state before it is restored: the event
// has then not happened.
bool CrackEvolution::perform_if_possible(const Event& event) {
  BodyState before = state_;
  const Start start = this->start();
  try {
    perform_and_book(event);
    return true;
  } catch (const Error& error) {
    if (error.failure() != Failure::unsolvable) throw;
    forget_lines(start);
    static_cast<BodyState&>(state_) = std::move(before);
    sources_.abandon();
    sources_.refresh();
    return false;
  }
}

std::optional<CrackEvolution::BeforeEvent> CrackEvolution::before_event() {
  if (sources_.is_in_window()) return std::nullopt;
  return BeforeEvent{state_, start()};
}

void CrackEvolution::give_up_event(BeforeEvent before) {
  forget_lines(before.start);
  sources_.give_up_event(before.body);
  static_cast<BodyState&>(state_) = std::move(before.body);
  sources_.refresh();
}

void CrackEvolution::move_to(double load_factor) { state_.work = in_range(state_.work + body_.move_to(load_factor)); }

// Next bond that breaks by itself; bonds around the tips of crack lines are left out.
std::optional<NextBond> CrackEvolution::next_bond(bool upwards, Control control) {
  look();
  std::vector<char> intact = system_.intact();
  if (const LineSteps* lines = sources_.line_steps()) {
    if (!lines->laws().more_begin) return std::nullopt;
    for (const GrowingTip& tip : state_.tips) lines->spare(tip, intact);
  }
  const BondList bonds{body_.ratios(), intact};
  const std::optional<double> at = next_critical(bonds, {state_.load_factor, upwards, control});
  if (!at) return std::nullopt;
  const std::vector<int> most = most_critical(bonds, *at, 0, 0);
  if (most.empty()) return std::nullopt;
  return NextBond{most.front(), *at, body_.ratios().at(static_cast<std::size_t>(most.front()), state_.load_factor)};
}

bool CrackEvolution::look_past_switch(bool upwards, const std::function<void()>& visit) {
  look();
  const double direction = upwards ? 1 : -1;
  if (!body_.switches_at_once(direction)) return false;
  BodyState before = state_;
  Continuation way_on = sources_.continuation();
  const auto return_to_present = [&]() noexcept {
    static_cast<BodyState&>(state_) = std::move(before);
    sources_.abandon();
    sources_.continue_with(std::move(way_on));
  };
  try {
    sources_.settle();
    body_.look_ahead(direction);
    visit();
  } catch (...) {
    return_to_present();
    throw;
  }
  return_to_present();
  return true;
}

void CrackEvolution::restore(EvolutionState state, std::optional<Continuation> continuation) noexcept {
  state_ = std::move(state);
  sources_.abandon();
  if (continuation) sources_.continue_with(std::move(*continuation));
}

void CrackEvolution::synchronize() {
  sources_.refresh();
  sources_.bring_up_to_date();
  sources_.forget();
  body_.update_faces();
  system_.bar_constraints({});  // they are found anew, as by a run that goes on from the state
  system_.forget_factor();
  system_.forget_places_met();
}

}  // namespace bempd::fracture
