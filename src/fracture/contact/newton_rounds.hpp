#pragma once

#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace bempd::fracture {

// Newton's method for unilateral constraints. A round switches all wrong constraints, until an active set occurs again.
// From then on one constraint is switched at a time (the first wrong one), until fewer are wrong than ever before; then
// all again for some rounds. Switching one at a time always ends (Murty 1974), but slowly; both together end soon
// (Judice and Pires 1994).
class NewtonRounds {
 public:
  // Whether the next round switches all wrong constraints. `wrong` is their number, `closed` the present active set.
  bool takes_all(std::size_t wrong, std::vector<char> closed) {
    comes_back_ = comes_back_ || !met_.insert(std::move(closed)).second;
    if (wrong < fewest_) {
      fewest_ = wrong, left_ = rounds_of_all;
    } else if (comes_back_ && left_ > 0) {
      --left_;
    }
    return !comes_back_ || left_ > 0;
  }

  // Whether some round began with the same active set as an earlier one.
  bool comes_back() const { return comes_back_; }

 private:
  static constexpr int rounds_of_all = 10;
  std::set<std::vector<char>> met_;
  std::size_t fewest_ = std::numeric_limits<std::size_t>::max();
  bool comes_back_ = false;
  int left_ = 0;
};

}  // namespace bempd::fracture
