#pragma once

namespace bempd::pd {

// Term ahead of the end of a crack that has a share of its stiffness only, so that the crack is felt where it is said
// to end.
struct WeakenedTerm {
  int term;  // of the scene
  double share;
  int crack;  // id
};

}  // namespace bempd::pd
