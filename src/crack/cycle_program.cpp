#include "crack/cycle_program.hpp"

#include <cmath>
#include <limits>

namespace bempd::crack {

CycleProgram::CycleProgram(std::span<const Block> blocks) : blocks_(blocks.begin(), blocks.end()) {
  if (blocks_.size() == 1) blocks_.front().cycles = std::numeric_limits<double>::infinity();
  for (const Block& block : blocks_) cycles_ += block.cycles;
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
