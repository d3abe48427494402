#pragma once

#include <limits>
#include <span>
#include <vector>

namespace bempd::coupling {

// What a term goes through: in every stage it has a share of its virgin stiffness and a critical elongation, as a share
// of its own critical one; what reaches it is in the next stage. After the last of these stages the term is gone.
class TermLaw {
 public:
  struct Stage {
    double stiffness_share, critical_share;
    bool operator==(const Stage&) const = default;
  };

  // Throws Error (argument) if there is no stage, or a share is not positive and finite.
  explicit TermLaw(std::vector<Stage> stages);

  // Breaks at its critical elongation.
  static const TermLaw& brittle();

  bool operator==(const TermLaw&) const = default;

  const std::vector<Stage>& stages() const { return stages_; }
  int gone() const { return static_cast<int>(stages_.size()); }
  double stiffness_share(int stage) const { return stage < gone() ? stages_[stage].stiffness_share : 0; }
  double critical_share(int stage) const {
    return stage < gone() ? stages_[stage].critical_share : std::numeric_limits<double>::infinity();
  }
  int after_critical(int stage) const { return stage < gone() ? stage + 1 : stage; }

 private:
  std::vector<Stage> stages_;
};

// A term that goes into another stage.
struct StageChange {
  int term, stage;
};

std::vector<int> terms_of(std::span<const StageChange> changes);

}  // namespace bempd::coupling
