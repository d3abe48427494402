#include "coupling/term_stages.hpp"

#include <algorithm>
#include <utility>

namespace bempd::coupling {

TermStages::TermStages(const Terms& terms)
    : terms_(terms), numbers_(terms.size(), 0), intact_(terms.size(), 1), stiffness_(terms.stiffness) {
  for (std::size_t t = 0; t < terms_.law.size(); ++t) {
    const StageChange first{static_cast<int>(t), 0};
    enter({&first, 1});
  }
  if (terms_.following.empty()) return;
  followers_of_ = linalg::make_adjacency(terms_.size(), [&](const auto& add) {
    for (const Terms::Following& pair : terms_.following) add(pair.leader, pair.follower);
  });
}

std::vector<StageChange> TermStages::breaking(std::span<const int> terms) const {
  std::vector<StageChange> changes;
  changes.reserve(terms.size());
  for (int t : terms) changes.push_back(terms_.breaking(t));
  return with_followers(std::move(changes));
}

std::vector<StageChange> TermStages::with_followers(std::vector<StageChange> changes) const {
  if (followers_of_.value.empty()) return changes;
  for (const int broken : terms_.broken_by(changes)) {
    for (const int follower : followers_of_.of(broken)) {
      // A follower without stiffness is already broken, even if mark() has not been called for it.
      if (stiffness_[follower] == 0) continue;
      changes.push_back(terms_.breaking(follower));
    }
  }
  const auto before = [](const StageChange& a, const StageChange& b) { return a.term < b.term; };
  const auto same = [](const StageChange& a, const StageChange& b) { return a.term == b.term; };
  std::sort(changes.begin(), changes.end(), before);
  changes.erase(std::unique(changes.begin(), changes.end(), same), changes.end());
  return changes;
}

std::int64_t TermStages::count_broken(std::span<const StageChange> changes) const {
  const std::vector<int> broken = terms_.broken_by(changes);
  return std::count_if(broken.begin(), broken.end(), [&](int term) { return !terms_.follows(term); });
}

void TermStages::mark(std::span<const StageChange> changes) {
  for (const StageChange& c : changes) {
    numbers_[c.term] = static_cast<std::uint8_t>(c.stage);
    intact_[c.term] = terms_.is_broken(static_cast<std::size_t>(c.term), c.stage) ? 0 : 1;
  }
}

void TermStages::enter(std::span<const StageChange> changes) {
  mark(changes);
  for (const StageChange& c : changes) stiffness_[c.term] = stiffness_after(c);
}

void TermStages::enter_all(std::span<const std::uint8_t> numbers) {
  for (std::size_t t = 0; t < numbers.size(); ++t) {
    const StageChange change{static_cast<int>(t), numbers[t]};
    enter({&change, 1});
  }
}

}  // namespace bempd::coupling
