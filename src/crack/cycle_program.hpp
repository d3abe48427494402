#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace bempd::crack {

// Block of load cycles between a high and a low load. `high` and `low` are indices of loads in the list that each tip
// has of its stress intensity factors by load.
struct Block {
  std::size_t high = 0, low = 0;
  double cycles = 0;
};

// Program of load cycles: blocks one after another, repeated for ever. A single block is a constant amplitude.
class CycleProgram {
 public:
  // Place in the program: all blocks and cycles before the place have passed.
  struct Place {
    std::size_t block = 0;
    double done = 0;  // cycles of this block that have passed
  };

  explicit CycleProgram(std::span<const Block> blocks);

  std::size_t size() const { return blocks_.size(); }
  const Block& block(std::size_t number) const { return blocks_[number]; }
  double cycles() const { return cycles_; }  // of one pass through the program

  Place place_after(double cycles) const;
  double left(const Place& place) const;  // cycles of the block that have not passed yet
  // Moves the place forward by a number of cycles, at most to the end of the block.
  void go_on(Place& place, double cycles) const;

 private:
  std::vector<Block> blocks_;
  double cycles_ = 0;
};

}  // namespace bempd::crack
