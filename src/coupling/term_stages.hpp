#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "coupling/term_law.hpp"
#include "coupling/terms.hpp"
#include "linalg/adjacency.hpp"

namespace bempd::coupling {

// Damage stage of every energy term (bond or cell square) of a body, and what follows from the stage: the present
// stiffness, and whether the term is intact (not broken).
class TermStages {
 public:
  // Puts all energy terms into their first damage stage. `terms` must outlive the object.
  explicit TermStages(const Terms& terms);
  TermStages(const TermStages&) = delete;
  TermStages& operator=(const TermStages&) = delete;

  const std::vector<std::uint8_t>& numbers() const { return numbers_; }
  const std::vector<char>& intact() const { return intact_; }
  const std::vector<double>& stiffness() const { return stiffness_; }  // present stiffness of each term [N/m]
  double stiffness_after(const StageChange& change) const {
    return terms_.law_of(static_cast<std::size_t>(change.term)).stiffness_share(change.stage) *
           terms_.stiffness[change.term];
  }
  // Stage change of a term that has reached the critical elongation of its present stage.
  StageChange after_critical(int term) const {
    return {term, terms_.law_of(static_cast<std::size_t>(term)).after_critical(numbers_[term])};
  }
  // Adds to `changes` the breaks of all followers of terms that break. The result is sorted by terms, and has each term
  // once.
  std::vector<StageChange> with_followers(std::vector<StageChange> changes) const;
  // Changes that break `terms` and all terms that follow them.
  std::vector<StageChange> breaking(std::span<const int> terms) const;
  // Number of terms that the changes break; followers, which break along with another term, do not count.
  std::int64_t count_broken(std::span<const StageChange> changes) const;

  // Sets the damage stages of terms without changing their stiffness, so that fragments can be found before a system
  // loses resistance.
  void mark(std::span<const StageChange> changes);
  // Puts terms into other damage stages, and changes their stiffness. A system's factor then belongs to another matrix;
  // EquilibriumSystem::commit() changes the factor as well.
  void enter(std::span<const StageChange> changes);
  void enter_all(std::span<const std::uint8_t> numbers);  // one stage for each term

 private:
  const Terms& terms_;
  std::vector<std::uint8_t> numbers_;
  std::vector<char> intact_;
  std::vector<double> stiffness_;
  linalg::Adjacency followers_of_;  // followers of every term; empty if no term follows another
};

}  // namespace bempd::coupling
