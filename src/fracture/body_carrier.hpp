#pragma once

#include <vector>

#include "coupling/term_law.hpp"
#include "crack/carrier.hpp"

namespace bempd::fracture {

class CrackEvolution;

// Carrier whose cracks grow by a change of the body: after a step the run goes on in another one.
class BodyCarrier : public crack::Carrier {
 public:
  // Body in which the run goes on. The first body of a run lives until the run has ended.
  virtual CrackEvolution& body() = 0;

  // Lets lattices grow around bonds that have broken by themselves, given as changes of the body's terms, where they
  // are near this carrier. Returns whether one has no room for that.
  virtual bool follow_breaks(const std::vector<coupling::StageChange>& broken) = 0;

  // Lets crack lines that have come to the border of this carrier since the last call go on in it; with `run_ends` they
  // stop there. Returns whether a line has stopped. Throws crack::FreesLoadedPart.
  virtual bool take_over_lines(bool run_ends) = 0;
};

}  // namespace bempd::fracture
