#pragma once

#include <vector>

#include "geometry/point.hpp"
#include "pd/network.hpp"

namespace bempd::pd {

// Bond of a network that is being made, with a stiffness for C1111 = 1 and thickness 1.
struct DraftBond {
  int first, second;
  int offset;     // index in the list of offsets
  bool in_layer;  // whether its stiffness may differ from the bulk stiffness
  bool free;      // whether balance_layer() may change its stiffness
  double stiffness;
};

// Bonds of a body whose network is being made. For outlines along lattice rows the first stiffnesses come from
// templates (network.cpp), for other outlines from the kernel (outlined_bonds.hpp). The corrections that follow are the
// same for both kinds of outlines.
struct DraftBonds {
  std::vector<BondOffset> offsets;
  std::vector<DraftBond> bonds;  // sorted by (first, second)
};

// Missing third moments (components 111, 112, 122, 222) of every point: the amounts by which the third moments of its
// bonds fall short of balancing the tractions of any constant stress on the faces at the point. `surface` has the
// surface vectors of the points (CellGrid::surface_vector()).
std::vector<Eigen::Vector4d> missing_moments(const std::vector<Point>& surface, const DraftBonds& bonds);

// Free bonds (bonds whose stiffness balance_layer() may change), divided into parts that have no point in common.
struct LayerParts {
  // Part of a layer: free bonds that share no point with free bonds of other parts, and the points of these bonds.
  struct Part {
    std::vector<int> bonds, points;
  };
  std::vector<Part> parts;
  std::vector<int> number;  // number of every point within its part; -1 for a point of no part
};

LayerParts parts_of_layer(const DraftBonds& bonds, std::size_t point_count);

// Index of the first part that poses the same balance problem, for each part of a layer; often the index of the part
// itself. Parts with the same problem have the same solution. `missing` has the missing third moments of all points.
std::vector<std::size_t> alike_parts(const LayerParts& all, const DraftBonds& bonds,
                                     const std::vector<Eigen::Vector4d>& missing);

// Order of the points of a part in which points joined by bonds are close to each other. `number` is
// LayerParts::number.
std::vector<int> order_of(const DraftBonds& bonds, const LayerParts::Part& part, const std::vector<int>& number);

// Makes the network from drafted bonds: their stiffnesses are multiplied by the thickness and the material's C1111.
Network finish_network(const std::vector<Point>& surface, DraftBonds draft, const PlaneElasticity& elasticity);

}  // namespace bempd::pd
