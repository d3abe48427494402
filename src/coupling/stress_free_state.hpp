#pragma once

#include <algorithm>
#include <cmath>

#include "coupling/condensed_operators.hpp"
#include "coupling/operators.hpp"
#include "coupling/terms.hpp"

namespace bempd::coupling {

// Stress-free state of a body, which free swelling (by heat, for instance) changes: rest elongations of its energy
// terms and rest displacements of its operators. Terms and operators must outlive the object.
class StressFreeState {
 public:
  StressFreeState(Terms& terms, CondensedOperators& operators) : terms_(terms), operators_(operators) { measure(); }

  Rests rests() const { return {terms_.rest_elongation, operators_.rests()}; }
  // Exchanges the rest elongations and rest displacements with those in `others`, which must have the same sizes; a
  // system's set_load() has to follow.
  void exchange(Rests& others) noexcept {
    terms_.rest_elongation.swap(others.of_terms);
    operators_.exchange_rests(others.of_operators);
    measure();
  }

  // Largest displacement that free swelling would cause [m], in the proportional part, that is per unit of the load
  // factor.
  double largest_motion() const { return largest_of(1); }
  // Largest displacement by free swelling in the constant part plus the largest in |load factor * proportional part|
  // [m].
  double largest_motion(double load_factor) const { return largest_of(0) + std::abs(load_factor) * largest_of(1); }

 private:
  void measure() noexcept {
    for (int part = 0; part < 2; ++part) {
      largest_of_terms_[part] = 0;
      for (const double rest : terms_.rest_elongation[part])
        largest_of_terms_[part] = std::max(largest_of_terms_[part], std::abs(rest));
    }
  }
  double largest_of(int part) const { return std::max(largest_of_terms_[part], operators_.rest_motion(part)); }

  Terms& terms_;
  CondensedOperators& operators_;
  double largest_of_terms_[2] = {0, 0};  // largest rest elongation in each part
};

}  // namespace bempd::coupling
