#pragma once

#include <limits>
#include <span>
#include <vector>

namespace bempd::coupling {

// Law of an energy term (bond or cell square): a list of damage stages. In each stage the term has a share of its
// virgin stiffness. The term goes on to the next stage when its elongation reaches a share of its nominal critical
// elongation. After the last stage the term is broken.
class TermLaw {
 public:
  struct Stage {
    double stiffness_share, critical_share;
    bool operator==(const Stage&) const = default;
  };

  // Creates a law from its damage stages. Throws Error (argument) if the list is empty, or a share in it is not
  // positive and finite.
  explicit TermLaw(std::vector<Stage> stages);

  // Law of a term that breaks at its critical elongation.
  static const TermLaw& brittle();

  bool operator==(const TermLaw&) const = default;

  const std::vector<Stage>& stages() const { return stages_; }
  // Number of the stage in which a term is broken: it follows the last damage stage of the list. Only this function
  // decides which stage is broken.
  int broken_stage() const { return static_cast<int>(stages_.size()); }
  bool is_broken(int stage) const { return stage >= broken_stage(); }
  double stiffness_share(int stage) const { return is_broken(stage) ? 0 : stages_[stage].stiffness_share; }
  double critical_share(int stage) const {
    return is_broken(stage) ? std::numeric_limits<double>::infinity() : stages_[stage].critical_share;
  }
  int after_critical(int stage) const { return is_broken(stage) ? stage : stage + 1; }

 private:
  std::vector<Stage> stages_;
};

// Change of an energy term to another damage stage of its law.
struct StageChange {
  int term, stage;
};

std::vector<int> terms_of(std::span<const StageChange> changes);

}  // namespace bempd::coupling
