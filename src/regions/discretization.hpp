#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "coupling/node_ties.hpp"
#include "coupling/operators.hpp"
#include "geometry/arrangement.hpp"
#include "regions/boundary/boundary_part.hpp"
#include "regions/lattice/lattice_part.hpp"
#include "scene/options.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

struct Discretization {
  Formulation formulation;
  double tolerance;  // distance below which places are the same
  Arrangement arrangement;
  std::vector<Point> positions;  // of the scene's nodes
  std::vector<BoundaryPart> boundaries;
  std::vector<LatticePart> lattices;
  coupling::BondSet bonds;
  coupling::NodeTies ties;               // of lattice points on interfaces that do not match
  std::vector<double> critical_stretch;  // per bond
  std::vector<std::string> warnings;
  double seconds_boundary = 0, seconds_lattice = 0;

  const BoundaryPart* boundary_of(int region) const;
  const LatticePart* lattice_of(int region) const;
  std::vector<coupling::DenseOperator> dense_operators() const;
  std::int64_t kernel_evaluations() const;  // of all operators, those that regions share once
};

// Throws Error (argument) if regions overlap, touch at points only, or do not match at interfaces.
Discretization discretize(const Scene& scene, const Options& options);

}  // namespace bempd::model
