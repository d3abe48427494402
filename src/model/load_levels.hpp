#pragma once

#include <compare>
#include <cstddef>
#include <vector>

#include "crack/cycle_program.hpp"

namespace bempd::model {

// Loads on the body at the upper or lower end of a cycle: the body's own loads at a load factor, or a combination of
// load cases.
struct LoadLevel {
  double load_factor = 0;
  std::vector<double> cases{};  // factors of the cases 1, 2, ..; empty: the body's own loads

  auto operator<=>(const LoadLevel&) const = default;
};

// Cycles between two loads, as a host describes them. In a program either all blocks combine load cases, or none does.
struct LoadBlock {
  LoadLevel high, low;
  double cycles = 0;
};

// Different loads of a program of cycles, each with a number, and the blocks of cycles with loads given by these
// numbers.
class LoadLevels {
 public:
  explicit LoadLevels(const std::vector<LoadBlock>& blocks);

  std::size_t size() const { return levels_.size(); }
  const LoadLevel& operator[](std::size_t number) const { return levels_[number]; }
  const std::vector<crack::Block>& blocks() const { return blocks_; }

  bool combine_cases() const { return !levels_.front().cases.empty(); }
  // Number of the lowest load; only if no load cases are combined.
  std::size_t lowest() const { return 0; }
  // Number of the highest load at the upper end of a cycle; only if no load cases are combined.
  std::size_t highest() const { return highest_; }
  double factor(std::size_t number) const { return levels_[number].load_factor; }

 private:
  std::vector<LoadLevel> levels_;  // all different loads, ascending
  std::vector<crack::Block> blocks_;
  std::size_t highest_ = 0;
};

}  // namespace bempd::model
