#pragma once

#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace bempd::fracture {

// Newton's method for unilateral constraints: a round switches all constraints that are wrong, until it comes back to
// the same active set. From then on one is switched at a time, always the first that is wrong, until fewer are wrong
// than ever before, and all again for some rounds. One by one alone ends (Murty 1974), but after very many rounds; both
// together do after few (Judice and Pires 1994).
class NewtonRounds {
 public:
  // Whether the next round switches all: so many constraints are wrong, and these are closed.
  bool takes_all(std::size_t wrong, std::vector<char> closed) {
    comes_back_ = comes_back_ || !met_.insert(std::move(closed)).second;
    if (wrong < fewest_) {
      fewest_ = wrong, left_ = rounds_of_all;
    } else if (comes_back_ && left_ > 0) {
      --left_;
    }
    return !comes_back_ || left_ > 0;
  }

  // Whether some round began with the same active set as one before it.
  bool comes_back() const { return comes_back_; }

 private:
  static constexpr int rounds_of_all = 10;
  std::set<std::vector<char>> met_;
  std::size_t fewest_ = std::numeric_limits<std::size_t>::max();
  bool comes_back_ = false;
  int left_ = 0;
};

}  // namespace bempd::fracture
