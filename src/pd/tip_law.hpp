#pragma once

#include <vector>

#include "elasticity/kinked_tip.hpp"
#include "geometry/edge.hpp"

namespace bempd::pd {

// Data of the lattice and the material around a tip, which the growth of a crack line needs.
struct TipLaw {
  double spacing = 0;    // [m]
  double horizon = 0;    // [m]
  double thickness = 1;  // [m]
  double modulus = 0;    // E, in plane strain E / (1 - nu^2) [Pa]
  double toughness = 0;  // [Pa m^(1/2)]; infinite for a material that does not break
};

// Data of all regions in which cracks grow as lines.
struct TipLaws {
  std::vector<TipLaw> laws;
  std::vector<int> of_node;                              // law of its region; -1 where there is none
  std::vector<double> share_of_node{};                   // share of the area of a full point; 0 if unknown
  KinkCriterion criterion = KinkCriterion::hoop_stress;  // says when tips grow, not where to
  bool loads_by_energy = false;                          // where the fit of stresses does not hold
  std::vector<Edge> outer_edges{}, hole_edges{};         // of these regions
  bool more_begin = false;                               // whether cracks begin besides those that the host described
  std::vector<double> of_crack{};                        // length of each crack that the host described [m]
  std::vector<char> joined{};                            // by node, 1: boundary elements of its material lie behind it

  bool is_joined(int node) const {
    const auto n = static_cast<std::size_t>(node);
    return n < joined.size() && joined[n] != 0;
  }
};

}  // namespace bempd::pd
