#pragma once

#include <vector>

#include "pd/bond_family.hpp"
#include "pd/outlined/outlined_points.hpp"

namespace bempd::pd {

// Bond while the network is made, for C1111 = thickness = 1.
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

// Makes the bonds between all pairs of points closer than the horizon that see each other. Between lattice points they
// have the bulk stiffness, at points of the outline that of the kernel at their length.
OutlinedBonds draft_outlined_bonds(const Chords& chords, const OutlinedPoints& points, int horizon_ratio,
                                   const BondKernel& kernel);

// Layer of bonds at the outline whose stiffness may differ from the bulk: one end is less deep than `depth`, the other
// less deep than `deepest`. Those shorter than `reach` are free. Points deeper than the longest bond plus the gap at
// the outline have no missing moments.
struct Layer {
  double depth, deepest, reach;
};
void mark_layer(const OutlinedPoints& points, const Layer& layer, OutlinedBonds& bonds);

// Multiplies the stiffness k of every bond in the layer by a factor of either end, so that points resist a change of
// volume in proportion to their area. Half of the sum of k L^2 over a point's bonds of lengths L becomes 8/3 C1111
// times its area.
void share_by_area(const std::vector<double>& areas, OutlinedBonds& bonds);

// Missing third moments 111, 112, 122, 222 of every point; `surface` has the surface vectors of the points.
std::vector<Eigen::Vector4d> missing_moments(const std::vector<Point>& surface, const OutlinedBonds& bonds);

// Even moment of a bond: second and fourth harmonic of length^2 over the direction, real and imaginary part of each.
// Suppose that the sums of k times these vanish at each point, and that no third moments are missing. Then a linear
// stress without forces inside and on the outline leaves no forces on points: by a strain gradient g, a bond pulls its
// point with the force k L^2 / 2 e e e e : g.
Eigen::Vector4d even_moment(const BondOffset& offset);
std::vector<Eigen::Vector4d> missing_even_moments(std::size_t point_count, const OutlinedBonds& bonds);

// Free bonds of a layer, divided into connected parts.
struct LayerParts {
  // Part of a layer: free bonds that share no point with those of other parts, and their points.
  struct Part {
    std::vector<int> bonds, points;
  };
  std::vector<Part> parts;
  std::vector<int> number;  // of every point in its part
};

LayerParts parts_of_layer(const OutlinedBonds& bonds, std::size_t point_count);

// Order of a part's points in which points joined by bonds are near each other.
std::vector<int> order_of(const OutlinedBonds& bonds, const LayerParts::Part& part, const std::vector<int>& number);

}  // namespace bempd::pd
