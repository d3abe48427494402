#pragma once

#include "coupling/affine.hpp"
#include "coupling/system_parts.hpp"

namespace bempd::coupling {

// Right-hand side of a system under its present loads: forces on its unknowns due to loads, to supports that move, and
// to rest elongations. The loads must be condensed before.
class RightHandSide {
 public:
  explicit RightHandSide(const SystemParts& parts) : parts_(parts) {}

  // Whether loads, moved supports, rest elongations or rest displacements act on the body in the constant (0) or the
  // proportional (1) part. Holding springs do not count.
  bool is_loaded(int part) const {
    return !parts_.load.is_zero(part) || parts_.terms.have_offsets(part) || parts_.operators.have_rest(part);
  }
  Affine sum() const;  // one row per unknown

 private:
  void add_supports_of_terms(const Affine& support, Affine& load) const;
  void add_supports_of_penalties(const Affine& support, Affine& load) const;
  void add_supports_of_springs(const Affine& support, Affine& load) const;
  void add_offsets(Affine& load) const;

  const SystemParts& parts_;
};

}  // namespace bempd::coupling
