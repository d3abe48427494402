// Which faces of a body's cracks press on each other at its load factor.
#include <algorithm>
#include <set>

#include "cancellation.hpp"
#include "error.hpp"
#include "fracture/loaded_body.hpp"

namespace bempd::fracture {

namespace {

// Newton takes 1 to 6 for the places of contact; one by one each may be met several times.
constexpr std::int64_t newton_rounds = 64, rounds_per_place = 16;

}  // namespace

// What springs hold where it is would be pushed away.
void LoadedBody::bar_contacts_of_held_parts() {
  const std::size_t count = system_.contacts().size(), springs = system_.springs().size();
  if (count == 0 || springs == 0) return system_.bar_contacts({});
  if (system_.contacts().barred_count() == count && springs_that_bar_ == springs) return;
  springs_that_bar_ = springs;
  const std::vector<char> held = freed_parts_.held_nodes();
  std::vector<char> barred;
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<coupling::TermEntry>& pull = system_.contacts()[i].pull;
    const auto is_held = [&](const coupling::TermEntry& e) { return held[e.node] != 0; };
    barred.push_back(std::any_of(pull.begin(), pull.end(), is_held) ? 1 : 0);
  }
  system_.bar_contacts(std::move(barred));
}

std::int64_t LoadedBody::settle_contacts(double direction) {
  bar_contacts_of_held_parts();
  // Newton's method, as the energy is convex and once differentiable; where it comes back to the same places, one at a
  // time by the least number, which ends (Murty 1974).
  std::int64_t switched = 0;
  std::set<std::vector<char>> met;
  bool one_by_one = false;
  const std::int64_t most = newton_rounds + rounds_per_place * static_cast<std::int64_t>(system_.contacts().size());
  for (std::int64_t round = 0;; ++round) {
    std::vector<int> wrong = wrong_places(system_.contacts(), state_.displacement, state_.load_factor, direction);
    if (wrong.empty()) break;
    check_cancelled();
    if (round == most) fail(Failure::convergence, "faces of cracks open and close without an end");
    one_by_one = one_by_one || !met.insert(system_.contacts().closed()).second;
    if (one_by_one) wrong.resize(1);
    system_.switch_contacts(wrong);
    switched += static_cast<std::int64_t>(wrong.size());
    solve();
  }
  state_.faces.closed = system_.contacts().closed();
  return switched;
}

}  // namespace bempd::fracture
