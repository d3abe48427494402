#pragma once

namespace bempd::pd {

// Bond ahead of the end of a crack that keeps only a share of its stiffness, so that the effective tip of the crack
// lies at the crack's described end.
struct WeakenedTerm {
  int term;  // number of the energy term in the scene
  double share;
  int crack;  // id of the crack
};

}  // namespace bempd::pd
