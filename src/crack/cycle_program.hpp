#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace bempd::crack {

// Cycles between two loads, one after another. Loads have numbers, which are those of a tip's factors.
struct Block {
  std::size_t high = 0, low = 0;
  double cycles = 0;
};

// Blocks of cycles that follow each other and are repeated for ever; one block is a constant amplitude.
class CycleProgram {
 public:
  // Place in the program to which a run has come.
  struct Place {
    std::size_t block = 0;
    double done = 0;  // cycles of this block
  };

  explicit CycleProgram(std::span<const Block> blocks);

  std::size_t size() const { return blocks_.size(); }
  const Block& block(std::size_t number) const { return blocks_[number]; }
  double cycles() const { return cycles_; }  // of the whole program

  Place place_after(double cycles) const;
  double left(const Place& place) const;  // cycles that are left of the block
  // Goes on by cycles, not beyond the end of the block.
  void go_on(Place& place, double cycles) const;

 private:
  std::vector<Block> blocks_;
  double cycles_ = 0;
};

}  // namespace bempd::crack
