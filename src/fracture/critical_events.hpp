#pragma once

#include <optional>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/operators.hpp"

namespace bempd::fracture {

// Stretch of bonds over their critical stretch as affine functions of the load factor.
struct AffineRatios {
  std::vector<double> constant, proportional;

  double at(std::size_t bond, double load_factor) const { return constant[bond] + load_factor * proportional[bond]; }

  // Load factor of the next break on the way from `from` towards `to` (which may be infinite): `from` itself while a
  // bond exceeds its critical stretch there. Empty if no intact bond becomes critical.
  std::optional<double> next_break(const std::vector<char>& intact, double from, double to) const;

  // The same upwards to any load factor, where all constant parts are 0, and the ratios of broken bonds too.
  std::optional<double> next_proportional_break(double from) const;
  double steepest() const;  // largest proportional part

  // Intact bonds at or beyond their critical stretch at this load factor, in bond order.
  std::vector<int> overstretched(const std::vector<char>& intact, double load_factor) const;

  // Intact bonds within the relative band of the largest ratio at this load factor, in bond order; at most
  // `limit` of them (0: all), the most stretched ones.
  std::vector<int> most_stretched(const std::vector<char>& intact, double load_factor, double band, int limit) const;
  std::vector<int> most_stretched(const std::vector<char>& intact, double load_factor, double band, int limit,
                                  double largest) const;
};

// Share of the largest ratio from which on bonds break together with it; wider than the band by the rounding in which
// mirrored bonds differ.
double tie_limit(double band);

// What a bond's stretch ratio is made of: the product of these with the difference of its ends' displacements.
struct RatioDirections {
  std::vector<double> cosine, sine;  // of the bond, over its length and its critical stretch

  RatioDirections(const coupling::BondSet& bonds, const std::vector<double>& critical_stretch);
};

// The ratios of all bonds of a system.
class StretchRatios : public AffineRatios {
 public:
  // An infinite critical stretch marks a bond that cannot break.
  StretchRatios(const coupling::BondSet& bonds, std::vector<double> critical_stretch);

  void update(const coupling::Affine& displacement);

  double stretch(std::size_t bond, double load_factor) const;
  const RatioDirections& directions() const { return directions_; }
  const coupling::BondSet& bonds() const { return bonds_; }

 private:
  const coupling::BondSet& bonds_;
  std::vector<double> critical_stretch_;
  RatioDirections directions_;
};

}  // namespace bempd::fracture
