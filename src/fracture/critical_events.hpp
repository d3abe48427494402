#pragma once

#include <optional>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/operators.hpp"

namespace bempd::fracture {

// Stretch of every bond over its critical stretch as an affine function of the load factor.
class StretchRatios {
 public:
  // An infinite critical stretch marks a bond that cannot break.
  StretchRatios(const coupling::BondSet& bonds, std::vector<double> critical_stretch);

  void update(const coupling::Affine& displacement);

  double at(std::size_t bond, double load_factor) const { return constant_[bond] + load_factor * proportional_[bond]; }
  double stretch(std::size_t bond, double load_factor) const;
  const std::vector<double>& critical_stretch() const { return critical_stretch_; }

  // Load factor of the next break on the way from `from` towards `to` (which may be infinite): `from` itself while a
  // bond exceeds its critical stretch there. Empty if no intact bond becomes critical.
  std::optional<double> next_break(const std::vector<char>& intact, double from, double to) const;

  // Intact bonds at or beyond their critical stretch at this load factor, in bond order.
  std::vector<int> overstretched(const std::vector<char>& intact, double load_factor) const;

  // Intact bonds within the relative band of the largest ratio at this load factor, in bond order; at most
  // `limit` of them (0: all), the most stretched ones.
  std::vector<int> most_stretched(const std::vector<char>& intact, double load_factor, double band, int limit) const;

 private:
  const coupling::BondSet& bonds_;
  std::vector<double> critical_stretch_;
  std::vector<double> constant_, proportional_;
};

}  // namespace bempd::fracture
