#include "crack/cycle_program.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bempd::crack {

CycleProgram::CycleProgram(std::span<const Block> blocks) {
  for (const Block& block : blocks)
    for (const double load_factor : {block.high, block.low}) load_factors_.push_back(load_factor);
  std::sort(load_factors_.begin(), load_factors_.end());
  load_factors_.erase(std::unique(load_factors_.begin(), load_factors_.end()), load_factors_.end());
  const auto number = [&](double load_factor) {
    return static_cast<std::size_t>(std::lower_bound(load_factors_.begin(), load_factors_.end(), load_factor) -
                                    load_factors_.begin());
  };
  for (const Block& block : blocks) {
    const bool is_alone = blocks.size() == 1;
    blocks_.push_back(
        {number(block.high), number(block.low), is_alone ? std::numeric_limits<double>::infinity() : block.cycles});
    highest_ = std::max(highest_, blocks_.back().high);
    cycles_ += blocks_.back().cycles;
  }
}

CycleProgram::Place CycleProgram::place_after(double cycles) const {
  Place place;
  double left = blocks_.size() == 1 ? cycles : std::fmod(cycles, cycles_);
  while (blocks_.size() > 1 && left >= blocks_[place.block].cycles) {
    left -= blocks_[place.block].cycles;
    place.block = (place.block + 1) % blocks_.size();
  }
  place.done = left;
  return place;
}

double CycleProgram::left(const Place& place) const { return blocks_[place.block].cycles - place.done; }

void CycleProgram::go_on(Place& place, double cycles) const {
  place.done += cycles;
  const double whole = blocks_[place.block].cycles;
  if (place.done < whole * (1 - 1e-12)) return;
  place = {(place.block + 1) % blocks_.size(), 0};
}

}  // namespace bempd::crack
