#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "elasticity/plane_elasticity.hpp"
#include "geometry/arrangement.hpp"
#include "geometry/outline.hpp"
#include "geometry/rectilinear.hpp"

namespace bempd::model {

// The scene as the host described it. Ids are positions in these vectors plus 1; edges of a region are numbered from 1
// through its outer loop and then its holes.

struct Material {
  PlaneElasticity elasticity;
  double critical_stretch = 0;  // 0: not given
  double fracture_energy = 0;   // [J/m^2]; 0: not given

  // Infinite for a material that does not break. `as_printed`: with the constant of Yang and Liu 2021, Eq. 15.
  double critical_stretch_for(double horizon, bool as_printed) const;
};

struct EdgeMesh {
  double element_length;
  double grading;
};

enum class RegionKind { boundary_elements, peridynamics };

struct Region {
  RegionKind kind = RegionKind::boundary_elements;
  int material = 0;  // id
  Outline outline;
  double element_length = 0;          // boundary elements
  std::map<int, EdgeMesh> edge_mesh;  // by edge number
  int horizon_ratio = 0;              // peridynamics
  LatticeOutline lattice;

  int edge_count() const;
  Edge edge(int number) const { return outline.edge(number - 1); }
  // The host has chosen this edge's elements; on a lattice interface they need not match the lattice then.
  bool has_own_mesh(int edge) const { return edge_mesh.count(edge) > 0; }
};

struct Crack {
  std::vector<Point> points;
};

// Values along a boundary part as functions of the place: constant and proportional parts, x and y.
struct BoundaryValue {
  Point constant = Point::Zero();
  Point proportional = Point::Zero();
};
using BoundaryFunction = std::function<BoundaryValue(const Point&)>;

// Equally spaced samples, linear between them; one sample is a uniform value.
struct SampledValues {
  std::vector<double> constant, proportional;

  // At a fraction of the part, 0 .. 1.
  double constant_at(double fraction) const;
  double proportional_at(double fraction) const;
};

struct EdgePart {
  int region, edge;  // ids
  double from, to;   // fractions of the edge
};

// A support or a load. Components: 1 x, 2 y, 3 both.
struct Condition {
  std::variant<EdgePart, Point> place;
  int components;
  std::variant<SampledValues, BoundaryFunction> values;

  BoundaryValue value(const Point& where, double fraction_of_part) const;
  bool acts_on(int component) const { return (components >> component) & 1; }
};

class Scene {
 public:
  int add_material(const Material& material);
  int add_boundary_region(int material, const std::vector<Point>& vertices, double element_length);
  int add_lattice_region(int material, const std::vector<Point>& vertices, double spacing, int horizon_ratio);
  int add_hole(int region, const std::vector<Point>& vertices);  // number of its first edge
  int add_circular_hole(int region, const Point& centre, double radius);
  void set_edge_mesh(int region, int edge, const EdgeMesh& mesh);
  // The edge becomes the arc through a place between its ends.
  void set_edge_arc(int region, int edge, const Point& between);
  // A row of edges of one loop becomes a smooth curve through their vertices.
  void set_edges_smooth(int region, int first_edge, int last_edge);
  int add_crack(const std::vector<Point>& points);
  int add_support(Condition condition);
  int add_load(Condition condition);
  void set_values(Condition& condition, const char* what, int id, SampledValues values);

  const Material& material(int id) const;
  const Region& region(int id) const;
  const std::vector<Region>& regions() const { return regions_; }
  const std::vector<Crack>& cracks() const { return cracks_; }
  const std::vector<Condition>& supports() const { return supports_; }
  const std::vector<Condition>& loads() const { return loads_; }
  Condition& support(int id);
  Condition& load(int id);

  // Size of the whole scene.
  Box bounding_box() const;

 private:
  Region& mutable_region(int id);
  Region& region_with_edge(int id, int edge, const char* purpose);
  void check_condition(const Condition& condition, bool is_support) const;

  std::vector<Material> materials_;
  std::vector<Region> regions_;
  std::vector<Crack> cracks_;
  std::vector<Condition> supports_, loads_;
};

}  // namespace bempd::model
