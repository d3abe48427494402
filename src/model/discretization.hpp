#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "bem/galerkin_operator.hpp"
#include "coupling/node_ties.hpp"
#include "coupling/operators.hpp"
#include "geometry/arrangement.hpp"
#include "geometry/boundary_mesh.hpp"
#include "model/options.hpp"
#include "model/scene.hpp"
#include "pd/cell_lattice.hpp"
#include "pd/network.hpp"

namespace bempd::model {

// What a piece of an edge borders on.
enum class Border { free, boundary_elements, peridynamics };

// Where a panel of a boundary mesh comes from.
struct PanelSource {
  int edge;         // number in its region
  double from, to;  // fractions of the edge
  Border border;
  int other_region;  // id of the region it borders on, 0 for none
  bool tied;         // an interface at which the elements do not follow the lattice: lattice points are tied to them
};

// A boundary element region on its nodes. Mid nodes of elements that follow a lattice are not nodes of the scene:
// there the displacement is linear between lattice points, so that a constant traction gives the lattice its exact
// forces.
struct BoundaryPart {
  int region;
  std::vector<PanelSource> panels;
  BoundaryMesh mesh;
  std::vector<int> nodes;              // of the scene
  std::vector<int> node_of_mesh_node;  // of the scene, or -1
  Eigen::SparseMatrix<double> trace;   // mesh displacements from those of `nodes`
  std::unique_ptr<bem::GalerkinOperator> galerkin;

  Eigen::VectorXd mesh_displacement(const Eigen::VectorXd& scene_displacement) const;
};

// A peridynamic region on its material points.
struct LatticePart {
  int region;
  LatticeOutline outline;
  std::unique_ptr<pd::CellLattice> lattice;
  std::vector<int> nodes;  // of the scene, per material point
  pd::Network network;     // bonds between material points
  std::size_t first_bond;  // index of its bonds[0] among the scene's bonds

  const std::vector<pd::Bond>& bonds() const { return network.bonds; }

  Point position(int point) const;
  // Material points on an edge or a part of it between lattice points, ends included.
  std::vector<int> points_along(const Point& start, const Point& end) const;
  Point to_lattice(const Point& p) const { return (p - outline.origin) / outline.spacing; }
  Point from_lattice(const Point& p) const { return outline.origin + outline.spacing * p; }
};

struct Discretization {
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
};

// Throws Error (argument) if regions overlap, touch at points only, or do not match at interfaces.
Discretization discretize(const Scene& scene, const Options& options);

// Panels and elements of one boundary element region, loop by loop (boundary_meshing.cpp).
struct BoundaryPanels {
  std::vector<std::vector<Panel>> loops;
  std::vector<PanelSource> sources;
};
BoundaryPanels mesh_edges(const Scene& scene, const Arrangement& arrangement, double tolerance, int region);

}  // namespace bempd::model
