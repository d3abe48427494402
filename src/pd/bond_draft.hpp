#pragma once

#include <vector>

#include "geometry/point.hpp"
#include "pd/network.hpp"

namespace bempd::pd {

// Bond while the network is made, for C1111 = thickness = 1.
struct DraftBond {
  int first, second;
  int offset;           // in the list of offsets
  bool in_layer, free;  // whether its stiffness may differ from the bulk, and whether balance_layer() may change it
  double stiffness;
};

// Bonds of a body while its network is made. How they are drafted depends on the outline: along lattice rows from
// templates (network.cpp), along other outlines from the kernel (outlined_bonds.hpp). What follows is the same.
struct DraftBonds {
  std::vector<BondOffset> offsets;
  std::vector<DraftBond> bonds;  // sorted by (first, second)
};

// Missing third moments 111, 112, 122, 222 of every point: what its bonds lack for balance with the tractions of every
// constant stress on the faces there. `surface` has the surface vectors of the points.
std::vector<Eigen::Vector4d> missing_moments(const std::vector<Point>& surface, const DraftBonds& bonds);

// Free bonds of a layer, divided into connected parts.
struct LayerParts {
  // Part of a layer: free bonds that share no point with those of other parts, and their points.
  struct Part {
    std::vector<int> bonds, points;
  };
  std::vector<Part> parts;
  std::vector<int> number;  // of every point in its part
};

LayerParts parts_of_layer(const DraftBonds& bonds, std::size_t point_count);

// Number, for each part of a layer, of the first part that poses the same problem; often its own. One solution serves
// both. `missing` has the missing third moments of all points.
std::vector<std::size_t> alike_parts(const LayerParts& all, const DraftBonds& bonds,
                                     const std::vector<Eigen::Vector4d>& missing);

// Order of a part's points in which points joined by bonds are near each other.
std::vector<int> order_of(const DraftBonds& bonds, const LayerParts::Part& part, const std::vector<int>& number);

// Network of the drafted bonds, with the stiffnesses of the material.
Network finish_network(const std::vector<Point>& surface, DraftBonds draft, const PlaneElasticity& elasticity);

}  // namespace bempd::pd
