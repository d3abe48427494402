#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "coupling/terms.hpp"

namespace bempd::fracture {

// Relief of bonds: the part of each bond's stretch that compression across the bond causes by Poisson's effect, as a
// share of its critical stretch and an affine function of the load factor. The relief is negative under tension across
// the bond.
struct AffineRelief {
  std::vector<double> constant, proportional;

  bool empty() const { return constant.empty(); }
  double at(std::size_t bond, double load_factor) const { return constant[bond] + load_factor * proportional[bond]; }
};

// Strain across each bond, from the bonds that share its ends. With the strain a along the bond and b across it, the
// stress across it is C11 (b + nu a), where nu = C12 / C11 is Poisson's ratio in the plane. The part of the bond's
// strain due to that stress is -nu / (1 - nu^2) (b + nu a), by Hooke's law. b is the stretch of a bond of the same
// length at right angles. If neither end has such a bond, b is estimated from two other bonds at an end and the bond
// itself, exactly for every constant strain. The mean of all estimates by intact bonds counts. The relief is zero for
// bonds whose law takes no account of compression, and for bonds without an estimate.
class BondsAcross {
 public:
  BondsAcross() = default;
  explicit BondsAcross(const coupling::Terms& terms);

  bool empty() const { return contraction_.empty(); }

  // Strains across the bonds `number`, which the result numbers by their places in that list. `place_of` gives the
  // place of a bond in the list, or -1. Only estimates whose bonds all count (`counts`) are used; if one of these bonds
  // is not in the list, the relief is unknown.
  BondsAcross chosen(std::span<const int> number, const std::function<int(int)>& place_of,
                     const std::function<bool(int)>& counts) const;
  // Whether the relief of a bond is known, and so the same as among all bonds; an unknown relief is 0.
  bool is_known(std::size_t bond) const { return known_.empty() || known_[bond] != 0; }

  // Computes the relief of all bonds. `constant` and `proportional` are the parts of their stretch ratios (stretch over
  // critical stretch), `scale` is the ratio per elongation of each bond. Estimates by bonds that are not present do not
  // count.
  void relieve(const std::vector<double>& constant, const std::vector<double>& proportional,
               const std::vector<double>& scale, const std::vector<char>& present, AffineRelief& relief) const;

 private:
  // Estimate of the strain b across a bond, over its critical stretch: the bond's scale times a weighted sum of
  // elongations, of the bond itself (weight `own`) and of two other bonds (weights `of`). If there is only one other
  // bond, both entries name it.
  struct Estimate {
    int bonds[2];
    double own, of[2];
  };

  std::span<const Estimate> of(std::size_t bond) const {
    return {estimates_.data() + start_[bond], start_[bond + 1] - start_[bond]};
  }
  void add_at_right_angles(const coupling::Terms& terms, std::size_t bond, std::span<const int> at_node);
  void add_by_two(const coupling::Terms& terms, std::size_t bond, std::span<const int> at_node);

  std::vector<double> contraction_;  // Poisson's ratio in the plane, of every bond
  std::vector<std::size_t> start_{0};
  std::vector<Estimate> estimates_;  // sorted by bonds, with the beginnings start_
  std::vector<char> known_;
};

}  // namespace bempd::fracture
