#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "crack/laws/resistance.hpp"
#include "elasticity/kinked_tip.hpp"
#include "geometry/edge.hpp"
#include "geometry/turning.hpp"
#include "pd/varied_energy.hpp"
#include "pd/weakened_term.hpp"

namespace bempd::pd {

// Data of the lattice and the material around a tip, which the growth of a crack line needs.
struct TipLaw {
  double spacing = 0;                      // [m]
  double horizon = 0;                      // [m]
  double thickness = 1;                    // [m]
  double modulus = 0;                      // E, in plane strain E / (1 - nu^2) [Pa]
  double toughness = 0;                    // [Pa m^(1/2)]; infinite for a material that does not break
  const VariedEnergy* energies = nullptr;  // by place; null where the toughness holds everywhere

  double point_volume() const { return spacing * spacing * thickness; }  // of a full point [m^3]

  // Fracture energy by growth and by direction; null where it depends on neither.
  const crack::ResistanceCurve* curve = nullptr;
  const crack::ResistanceDirections* directions = nullptr;
  const crack::HostResistance* function = nullptr;  // takes the place of all of them

  // The law with the toughness at a place, of a tip that has grown by a length.
  TipLaw at(const Point& place, double grown) const {
    TipLaw there = *this;
    if (energies) there.toughness *= std::sqrt(energies->share(place));
    if (curve) there.toughness *= std::sqrt(curve->share(grown));
    return there;
  }
  // Fracture energy of a tip that has grown by a length, for a step in a direction, over that of the material.
  double energy_share(double grown, const Point& direction) const {
    return (curve ? curve->share(grown) : 1) * (directions ? directions->share(heading_of(direction)) : 1);
  }
};

// Length of a crack between its ends as they are described, and by how much its cut reaches beyond each end [m]: growth
// begins where the cut ends.
struct CrackLength {
  double length = 0;
  std::array<double, 2> to_cut{};
};

// Data of all regions in which cracks grow as lines.
struct TipLaws {
  std::vector<TipLaw> laws;
  std::vector<int> of_node;                              // law of its region; -1 where there is none
  std::vector<double> share_of_node{};                   // share of the area of a full point; 0 if unknown
  std::vector<double> energy_share_of_node{};            // of VariedEnergy; empty if it is 1 everywhere
  KinkCriterion criterion = KinkCriterion::hoop_stress;  // says when tips grow, not where to
  bool loads_by_energy = false;                          // where the fit of stresses does not hold
  std::vector<Edge> outer_edges{}, hole_edges{};         // of these regions
  bool more_begin = false;                               // whether cracks begin besides those that the host described
  std::vector<CrackLength> of_crack{};                   // each that the host described
  std::vector<WeakenedTerm> weakened{};                  // at the ends of initial cracks
  std::vector<char> joined{};                            // by node, 1: boundary elements of its material lie behind it

  double energy_share_at(std::size_t node) const {
    return node < energy_share_of_node.size() ? energy_share_of_node[node] : 1;
  }
  bool is_joined(int node) const {
    const auto n = static_cast<std::size_t>(node);
    return n < joined.size() && joined[n] != 0;
  }
};

}  // namespace bempd::pd
