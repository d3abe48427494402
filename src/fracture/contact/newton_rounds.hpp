#pragma once

#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace bempd::fracture {

// Choice of the contact constraints that a round of Newton's method switches. A round switches all wrong constraints
// (whose status contradicts their gaps), until an active set (set of closed constraints) occurs again. From that round
// on, only the first wrong constraint is switched, until fewer constraints are wrong than ever before; some rounds
// after that switch all again. Switching one at a time always ends (Murty 1974), but slowly; the combination ends soon
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
