#include "fracture/crack_evolution.hpp"

#include <optional>

#include "fracture/event_choice.hpp"
#include "fracture/event_loop.hpp"
#include "undo.hpp"

namespace bempd::fracture {

CrackEvolution::CrackEvolution(coupling::EquilibriumSystem& system, const std::vector<Point>& positions,
                               std::vector<double> critical_stretch, const std::vector<int>& cut,
                               coupling::SupportDofs supports, ContactPlan contact)
    : system_(system),
      body_(system, positions, std::move(critical_stretch), cut, std::move(supports), std::move(contact), state_),
      sources_(body_, cut),
      inner_work_(system, state_),
      records_(state_, body_, inner_work_),
      loads_(state_, body_, sources_, inner_work_, records_),
      events_(state_, body_, sources_, inner_work_, records_),
      growth_(state_, body_, sources_, inner_work_, records_) {
  state_.work = body_.response().energy_at_rest();
}

void CrackEvolution::grow_lines(pd::TipLaws laws, std::vector<GrowingTip> tips, LineCarrier::Openings openings,
                                FactorsAround factors) {
  state_.tips = std::move(tips);
  records_.set_lengths(laws.of_crack);
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

// Bond that breaks next by itself; bonds around the tips of crack lines do not, and are left out.
std::optional<NextBond> CrackEvolution::next_bond(bool upwards, Control control) {
  sources_.update_for_reader();
  std::vector<char> intact = system_.stages().intact();
  if (const LineSteps* lines = sources_.line_steps()) {
    if (!lines->fields().laws().more_begin) return std::nullopt;
    for (const GrowingTip& tip : state_.tips) lines->guard().exempt(tip, intact);
  }
  const BondList bonds{body_.response().ratios(), intact};
  const std::optional<double> at = next_critical(bonds, {state_.load_factor, upwards, control});
  if (!at) return std::nullopt;
  const std::vector<int> most = most_critical(bonds, *at, 0, 0);
  if (most.empty()) return std::nullopt;
  return NextBond{most.front(), *at,
                  body_.response().ratios().at(static_cast<std::size_t>(most.front()), state_.load_factor)};
}

bool CrackEvolution::look_past_switch(bool upwards, const std::function<void()>& visit) {
  sources_.update_for_reader();
  const double direction = upwards ? 1 : -1;
  if (!body_.contact().switches_at_once(direction)) return false;
  BodyState before = state_;
  Continuation continuation = sources_.resumption().present();
  const auto return_to_present = [&]() noexcept {
    static_cast<BodyState&>(state_) = std::move(before);
    sources_.abandon();
    sources_.resumption().await(std::move(continuation));
  };
  undone_afterwards(
      [&] {
        sources_.settle();
        body_.contact().look_ahead(direction);
        visit();
      },
      return_to_present);
  return true;
}

void CrackEvolution::restore(EvolutionState state, std::optional<Continuation> continuation) noexcept {
  state_ = std::move(state);
  sources_.abandon();
  if (continuation) sources_.resumption().await(std::move(*continuation));
}

void CrackEvolution::synchronize() {
  sources_.refresh();
  sources_.bring_up_to_date();
  sources_.forget();
  body_.contact().update_faces();
  system_.contact().bar({});  // barred constraints are found anew, as in a run that continues from the state alone
  system_.factor().forget();
  system_.matrix().set_places_met({});
}

}  // namespace bempd::fracture
