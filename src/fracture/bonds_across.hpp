#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "coupling/terms.hpp"

namespace bempd::fracture {

// Relief of bonds: the contribution of compression across them to their stretch by Poisson's effect, as shares of their
// critical stretch and affine functions of the load factor. It is negative under tension across them.
struct AffineRelief {
  std::vector<double> constant, proportional;

  bool empty() const { return constant.empty(); }
  double at(std::size_t bond, double load_factor) const { return constant[bond] + load_factor * proportional[bond]; }
};

// Strain across each bond, from the bonds that share its ends. With the strain a along the bond and b across it, the
// stress across it is C11 (b + nu a), where nu = C12 / C11 is Poisson's ratio in the plane, and the part of the bond's
// strain due to it is -nu / (1 - nu^2) (b + nu a), by Hooke's law. b is the stretch of a bond of the same length at
// right angles. If neither end has one, b is estimated from two bonds there and the bond itself, exactly for every
// constant strain. The mean of all such estimates from intact bonds counts. Bonds are numbered by a list; bonds that do
// not count the relief, and those without an estimate, have none.
class BondsAcross {
 public:
  BondsAcross() = default;
  explicit BondsAcross(const coupling::Terms& terms);

  bool empty() const { return contraction_.empty(); }

  // Strains across the bonds `number` alone, which are numbered anew by their places in this list. `place_of` finds the
  // place of a bond, -1 if it has none. An estimate is used if all its bonds count (`counts`); if one of them is not in
  // the list, the bond's relief is unknown.
  BondsAcross chosen(std::span<const int> number, const std::function<int(int)>& place_of,
                     const std::function<bool(int)>& counts) const;
  // Whether the bond's relief is the same as in the whole list; otherwise it is 0.
  bool is_known(std::size_t bond) const { return known_.empty() || known_[bond] != 0; }

  // Computes the relief from stretches over critical stretches of all bonds; `scale` turns elongations into these.
  // Estimates by bonds that are not present do not count.
  void relieve(const std::vector<double>& constant, const std::vector<double>& proportional,
               const std::vector<double>& scale, const std::vector<char>& present, AffineRelief& relief) const;

 private:
  // Estimate of b over the bond's critical stretch, as a weighted sum of elongations (over the scale of the bond): of
  // the bond itself with the weight `own`, and of up to two others. If there is only one other bond, both entries name
  // it.
  struct Estimate {
    int bonds[2];
    double own, of[2];
  };

  std::span<const Estimate> of(std::size_t bond) const {
    return {estimates_.data() + start_[bond], start_[bond + 1] - start_[bond]};
  }
  void add_at_right_angles(const coupling::Terms& terms, std::size_t bond, std::span<const int> at_node);
  void add_by_two(const coupling::Terms& terms, std::size_t bond, std::span<const int> at_node);

  std::vector<double> contraction_;  // Poisson's ratio in the plane
  std::vector<std::size_t> start_{0};
  std::vector<Estimate> estimates_;  // by bonds
  std::vector<char> known_;
};

}  // namespace bempd::fracture
