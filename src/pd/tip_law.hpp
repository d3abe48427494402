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

// Data of the lattice and the material around a tip, for a crack that grows as a line (in steps of one lattice
// spacing).
struct TipLaw {
  double spacing = 0;                      // [m]
  double horizon = 0;                      // [m]
  double thickness = 1;                    // [m]
  double modulus = 0;                      // E, in plane strain E / (1 - nu^2) [Pa]
  double toughness = 0;                    // [Pa m^(1/2)]; infinite for a material that does not break
  const VariedEnergy* energies = nullptr;  // fracture energy by place; null if it is the same everywhere

  double point_volume() const { return spacing * spacing * thickness; }  // of a full point [m^3]

  // Fracture energy as a function of the length of growth; null if it does not depend on that length.
  const crack::ResistanceCurve* curve = nullptr;
  // Fracture energy as a function of the direction of growth; null if it does not depend on the direction.
  const crack::ResistanceDirections* directions = nullptr;
  // Function of the host for the fracture energy, which replaces the toughness and the functions above; null if there
  // is none.
  const crack::HostResistance* function = nullptr;

  // Copy of this law with the toughness at a place, for a tip that has grown by the length `grown` [m].
  TipLaw at(const Point& place, double grown) const {
    TipLaw there = *this;
    if (energies) there.toughness *= std::sqrt(energies->share(place));
    if (curve) there.toughness *= std::sqrt(curve->share(grown));
    return there;
  }
  // Fracture energy for a step in a direction by a tip that has grown by the length `grown` [m], relative to the
  // fracture energy of the material.
  double energy_share(double grown, const Point& direction) const {
    return (curve ? curve->share(grown) : 1) * (directions ? directions->share(heading_of(direction)) : 1);
  }
};

// Length of a crack between its described ends, and the distance by which its cut through bonds reaches beyond each end
// [m]. Growth begins at the end of the cut.
struct CrackLength {
  double length = 0;
  std::array<double, 2> to_cut{};
};

// Data of all regions in which cracks grow as lines.
struct TipLaws {
  std::vector<TipLaw> laws;
  std::vector<int> of_node;                    // index of the law of the node's region; -1 where there is none
  std::vector<double> share_of_node{};         // area of the node's cells relative to a full point; 0 if unknown
  std::vector<double> energy_share_of_node{};  // fracture energy relative to the material's (VariedEnergy); empty: 1
  KinkCriterion criterion = KinkCriterion::hoop_stress;  // says when tips grow, not where to
  bool loads_by_energy = false;                          // step loads from energy where the fit of stresses fails
  std::vector<Edge> outer_edges{}, hole_edges{};         // edges of these regions: outer loops, and holes
  bool more_begin = false;                               // whether cracks begin besides those that the host described
  std::vector<CrackLength> of_crack{};                   // length of each crack that the host described
  std::vector<WeakenedTerm> weakened{};                  // at the ends of initial cracks
  std::vector<char> joined{};  // flag of each node: 1 if boundary elements of the same material lie beyond it

  double energy_share_at(std::size_t node) const {
    return node < energy_share_of_node.size() ? energy_share_of_node[node] : 1;
  }
  bool is_joined(int node) const {
    const auto n = static_cast<std::size_t>(node);
    return n < joined.size() && joined[n] != 0;
  }
};

}  // namespace bempd::pd
