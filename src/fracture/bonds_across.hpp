#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "coupling/terms.hpp"
#include "linalg/adjacency.hpp"

namespace bempd::fracture {

// What compression across bonds adds to their stretch by Poisson's effect, as shares of their critical stretch and
// affine functions of the load factor. Negative where what lies across is pulled.
struct AffineRelief {
  std::vector<double> constant, proportional;

  bool empty() const { return constant.empty(); }
  double at(std::size_t bond, double load_factor) const { return constant[bond] + load_factor * proportional[bond]; }
};

// Bonds at right angles that begin or end where a bond does, as long as it: with the strain a along a bond and b across
// it, the mean stretch of these, the stress across it is C11 (b + nu a), nu = C12 / C11 being Poisson's ratio in the
// plane, and shortens what lies across. Of the bond's strain it makes -nu / (1 - nu^2) (b + nu a), from Hooke's law.
// Bonds are numbered by a list; those that do not count it, and those with nothing across, have no relief.
class BondsAcross {
 public:
  BondsAcross() = default;
  explicit BondsAcross(const coupling::Terms& terms);

  bool empty() const { return contraction_.empty(); }
  std::span<const int> of(std::size_t bond) const { return across_.of(static_cast<int>(bond)); }

  // Those of a list of them, `number[k]` being the k-th: what is across goes by `place_of`, -1 where it is not in the
  // list. One that is not there but counts, and one that is, make the bond's relief known or not.
  BondsAcross chosen(std::span<const int> number, const std::function<int(int)>& place_of,
                     const std::function<bool(int)>& counts) const;
  // Whether the bond's relief is what it is in the whole list; otherwise it is 0.
  bool is_known(std::size_t bond) const { return known_.empty() || known_[bond] != 0; }

  // From stretches over critical stretches of all bonds, `scale` being what makes them of elongations. Bonds that are
  // not present have no part in it.
  void relieve(const std::vector<double>& constant, const std::vector<double>& proportional,
               const std::vector<double>& scale, const std::vector<char>& present, AffineRelief& relief) const;

 private:
  std::vector<double> contraction_;  // Poisson's ratio in the plane
  linalg::Adjacency across_;
  std::vector<char> known_;
};

}  // namespace bempd::fracture
