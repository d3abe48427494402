#pragma once

#include <vector>

#include "pd/bond_family.hpp"
#include "pd/outlined/outlined_points.hpp"

namespace bempd::pd {

// Bond during set-up, for C1111 = thickness = 1.
struct OutlinedBond {
  int first, second;
  int offset;  // in the list of offsets
  double stiffness;
  bool in_layer, free;  // see Layer
};

struct OutlinedBonds {
  std::vector<BondOffset> offsets;  // offsets of the lattice, turned, then one for each bond with an end on the outline
  std::vector<OutlinedBond> bonds;  // by first and second point
};

// All pairs closer than the horizon that see each other, with the stiffness of the bulk or, on the outline, of the
// kernel at their length.
OutlinedBonds draft_outlined_bonds(const Chords& chords, const OutlinedPoints& points, int horizon_ratio,
                                   const BondKernel& kernel);

// Layer of bonds that differ from those of the bulk: one end is less deep than `depth`, and the other less deep than
// `deepest`; bonds shorter than `reach` among them are free. Points deeper than the longest bond and the gap at the
// outline have no missing moments.
struct Layer {
  double depth, deepest, reach;
};
void mark_layer(const OutlinedPoints& points, const Layer& layer, OutlinedBonds& bonds);

// Multiplies the bonds in the layer by factors of their ends, so that every point resists a change of volume in
// proportion to its area: half of the sum of k L^2 becomes 8/3 C1111 times the area.
void share_by_area(const std::vector<double>& areas, OutlinedBonds& bonds);

// Missing third moments 111, 112, 122, 222 of every point. `surface`: outward vectors of points.
std::vector<Eigen::Vector4d> missing_moments(const std::vector<Point>& surface, const OutlinedBonds& bonds);

// Even moment of a bond: second and fourth harmonic of length^2 over the direction, real and imaginary part of each. If
// the sums of k times these vanish, and the points have no missing third moments, then a stress that varies linearly,
// without forces inside and on the outline, leaves no forces: a strain's gradient g does k L^2 / 2 e e e e : g on the
// point of the bond.
Eigen::Vector4d even_moment(const BondOffset& offset);
std::vector<Eigen::Vector4d> missing_even_moments(std::size_t point_count, const OutlinedBonds& bonds);

// Free bonds of a layer by connected parts.
struct LayerParts {
  // Free bonds that share no point with those of other parts, and their points.
  struct Part {
    std::vector<int> bonds, points;
  };
  std::vector<Part> parts;
  std::vector<int> number;  // of every point in its part
};

LayerParts parts_of_layer(const OutlinedBonds& bonds, std::size_t point_count);

// Order of a part's points in which points joined by bonds are close to each other.
std::vector<int> order_of(const OutlinedBonds& bonds, const LayerParts::Part& part, const std::vector<int>& number);

}  // namespace bempd::pd
