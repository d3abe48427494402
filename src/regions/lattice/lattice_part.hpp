#pragma once

#include <memory>
#include <span>
#include <vector>

#include "coupling/operators.hpp"
#include "geometry/rectilinear.hpp"
#include "regions/formulation.hpp"
#include "regions/node_registry.hpp"
#include "scene/scene.hpp"
#include "pd/cell_lattice.hpp"
#include "pd/network.hpp"

namespace bempd::model {

// A peridynamic region on its material points: the points of a grid, which are the corners of the region's cells or (in
// scheme `paper`) their centres, then those that lie on interfaces between the centres.
struct LatticePart {
  int region = 0;
  LatticeOutline outline;                    // of the cells
  std::unique_ptr<pd::CellLattice> lattice;  // the grid and the cells between its points
  Point origin = Point::Zero();              // place of the grid's point (0, 0) [m]
  bool cell_centred = false;
  std::vector<Point> points;                   // all material points, in grid coordinates
  std::vector<double> volumes;                 // per point over a full cell's; empty where bonds stand for no volumes
  std::vector<int> nodes;                      // of the scene, per material point
  std::shared_ptr<const pd::Network> network;  // bonds between material points; shared by regions that are alike
  std::size_t first_bond = 0;                  // index of its bonds[0] among the scene's bonds

  const std::vector<pd::Bond>& bonds() const { return network->bonds; }
  int point_count() const { return static_cast<int>(points.size()); }
  double spacing() const { return outline.spacing; }

  Point position(int point) const { return from_grid(points[point]); }
  Point to_grid(const Point& p) const { return (p - origin) / spacing(); }
  Point from_grid(const Point& p) const { return origin + spacing() * p; }

  // Material points on an edge or a part of it between corners of cells, ends included; only where the corners are the
  // points.
  std::vector<int> points_along(const Point& start, const Point& end) const;

  // Where supports and loads on an edge act: the points on it, or those of the layer of cells behind it.
  struct EdgePoint {
    int point;
    double fraction;  // of the edge
  };
  std::vector<EdgePoint> edge_points(int edge) const;
};

// The part without nodes and bonds; `on_interfaces` are the places of boundary nodes on its interfaces [m].
LatticePart make_lattice_part(int id, const Region& region, const Formulation& formulation,
                              const std::vector<Point>& on_interfaces);

// `is_shared` tells which points may be nodes of other regions too.
void number_nodes(LatticePart& part, const std::vector<char>& is_shared, NodeRegistry& registry);

// Bonds of the part: those of one of the parts built before if they differ by a translation or the spacing only.
std::shared_ptr<const pd::Network> network_of(const LatticePart& part, std::span<const LatticePart> built,
                                              const Scene& scene, const Formulation& formulation, int threads);

// Adds the bonds to the scene's and their critical stretches.
void add_bonds(LatticePart& part, const Region& region, const Material& material, const Formulation& formulation,
               coupling::BondSet& bonds, std::vector<double>& critical_stretch);

}  // namespace bempd::model
