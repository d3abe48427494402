#pragma once

#include <vector>

#include "coupling/term_law.hpp"
#include "crack/carrier.hpp"

namespace bempd::fracture {

class CrackEvolution;

// Carrier of cracks (part of the model in which cracks grow) that replaces the body at each step: the run continues in
// a new body with the longer crack.
class BodyCarrier : public crack::Carrier {
 public:
  // Body in which the run continues at present, and the number of bodies before it. Only the first body of a run lives
  // until the run has ended: a later body may have the address of one that is gone.
  virtual CrackEvolution& body() = 0;
  virtual int bodies_before() const = 0;

  // Enlarges lattice patches (lattices in a body of boundary elements) around bonds that have broken by themselves near
  // a patch border. `broken` holds the changes of damage stages in the body's terms (bonds and cell squares). Returns
  // whether some patch has no room to grow.
  virtual bool follow_breaks(const std::vector<coupling::StageChange>& broken) = 0;

  // Lets crack lines (cracks that grow in a lattice by steps) that have reached boundary elements since the last call
  // continue in the elements; with `run_ends` they stop at the border. Returns whether a crack line has stopped. Throws
  // crack::FreesLoadedPart.
  virtual bool take_over_lines(bool run_ends) = 0;
};

}  // namespace bempd::fracture
