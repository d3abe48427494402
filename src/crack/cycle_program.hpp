#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace bempd::crack {

// Cycles between two load factors, one after another.
struct Block {
  double high = 0, low = 0;  // load factors
  double cycles = 0;
};

// Blocks of cycles that follow each other and are repeated for ever; one block is a constant amplitude.
class CycleProgram {
 public:
  // A block as numbers of load factors.
  struct Levels {
    std::size_t high, low;
    double cycles;
  };
  // Place in the program to which a run has come.
  struct Place {
    std::size_t block = 0;
    double done = 0;  // cycles of this block
  };

  explicit CycleProgram(std::span<const Block> blocks);

  std::size_t size() const { return blocks_.size(); }
  const Levels& block(std::size_t number) const { return blocks_[number]; }
  // All upper and lower load factors of the blocks, ascending, each once. Number highest() is the largest upper one.
  const std::vector<double>& load_factors() const { return load_factors_; }
  std::size_t highest() const { return highest_; }
  std::size_t lowest() const { return 0; }
  double cycles() const { return cycles_; }  // of the whole program

  Place place_after(double cycles) const;
  double left(const Place& place) const;  // cycles that are left of the block
  // Goes on by cycles, not beyond the end of the block.
  void go_on(Place& place, double cycles) const;

 private:
  std::vector<Levels> blocks_;
  std::vector<double> load_factors_;
  std::size_t highest_ = 0;
  double cycles_ = 0;
};

}  // namespace bempd::crack
