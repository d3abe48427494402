#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "coupling/terms.hpp"

namespace bempd::fracture {

// What compression across bonds adds to their stretch by Poisson's effect, as shares of their critical stretch and
// affine functions of the load factor. Negative where what lies across is pulled.
struct AffineRelief {
  std::vector<double> constant, proportional;

  bool empty() const { return constant.empty(); }
  double at(std::size_t bond, double load_factor) const { return constant[bond] + load_factor * proportional[bond]; }
};

// What lies across a bond, from the bonds that begin or end where it does: with the strain a along it and b across it
// the stress across it is C11 (b + nu a), nu = C12 / C11 being Poisson's ratio in the plane, and of the bond's strain
// it makes -nu / (1 - nu^2) (b + nu a), by Hooke's law. b is the stretch of a bond at right angles that is as long;
// where there is none at either end, what two bonds there and the bond itself say of it that is right for every
// constant strain. The mean of all such estimates counts, of bonds that are there. Bonds are numbered by a list; those
// that do not count it, and those without an estimate, have no relief.
class BondsAcross {
 public:
  BondsAcross() = default;
  explicit BondsAcross(const coupling::Terms& terms);

  bool empty() const { return contraction_.empty(); }

  // Those of a list of them, `number[k]` being the k-th: what is across goes by `place_of`, -1 where it is not in the
  // list. An estimate counts if all its bonds do; where one of these is not in the list the relief is not known.
  BondsAcross chosen(std::span<const int> number, const std::function<int(int)>& place_of,
                     const std::function<bool(int)>& counts) const;
  // Whether the bond's relief is what it is in the whole list; otherwise it is 0.
  bool is_known(std::size_t bond) const { return known_.empty() || known_[bond] != 0; }

  // From stretches over critical stretches of all bonds, `scale` being what makes them of elongations. Estimates by
  // bonds that are not present do not count.
  void relieve(const std::vector<double>& constant, const std::vector<double>& proportional,
               const std::vector<double>& scale, const std::vector<char>& present, AffineRelief& relief) const;

 private:
  // b over the bond's critical stretch, where elongations of equal scales were asked of all bonds: weights of the bond
  // itself and of up to two others, equal ones where it is one.
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
