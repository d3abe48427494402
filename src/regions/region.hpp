#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "coupling/node_ties.hpp"
#include "coupling/operators.hpp"
#include "elasticity/free_swelling.hpp"
#include "elasticity/linear_body_force.hpp"
#include "geometry/crack_lines.hpp"
#include "geometry/edge.hpp"
#include "output/vtu.hpp"
#include "pd/crack.hpp"
#include "pd/face_places.hpp"
#include "pd/network.hpp"
#include "pd/tip_law.hpp"
#include "regions/cell_splits.hpp"
#include "regions/fields.hpp"
#include "regions/preparation.hpp"
#include "scene/material.hpp"

namespace bempd::regions {

class LatticeSwelling;

// Part of an edge between two fractions of its length.
struct EdgeSpan {
  int edge;  // number in its region
  Edge geometry;
  double from, to;
};

// Node of the scene and its place on a part of an edge, as a fraction of the part.
struct PlacedNode {
  int node;
  double fraction;
};

// Elements along a straight interface, which the nodes of the region on the other side follow: start and, for every
// element, its middle and its end.
struct LeadingElements {
  int edge;      // of the region that has the elements
  int follower;  // id of the other region
  std::vector<Point> places;
  std::vector<int> nodes;  // of the scene
};

enum class TipMethod { elements = 1, contours = 2, stress_ahead = 3 };

// Tip of a crack with its values; unknown ones are NaN.
struct TipValues {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  int crack = 0;                             // id
  int end = 0;                               // 1: the crack's last point, 0: its first
  Point place{0, 0}, direction{1, 0};        // unit vector in which a straight crack would go on
  Point factors{unknown, unknown};           // K_I, K_II [Pa m^(1/2)]
  double energy_release_rate = unknown;      // of growth straight on [J/m^2]
  double stress_along = unknown;             // T [Pa]
  double error = unknown;                    // of the factors [Pa m^(1/2)]
  Point constant_factors{unknown, unknown};  // K_I and K_II of the constant part of the loads
  Point proportional_factors{unknown, unknown};
  double toughness = 0;      // K_I at which it grows straight on; 0: it does not [Pa m^(1/2)]
  double plane_modulus = 0;  // [Pa]

  // Values by the growth criterion in force (Model::complete()); the largest double, or minus it, where it never grows.
  double kink_angle = unknown;                 // from the direction, counter-clockwise, at the present loads [rad]
  double critical_load_factor = unknown;       // load factor at which the tip grows while it rises
  double critical_load_factor_down = unknown;  // load factor at which the tip grows while it falls
  double critical_kink_angle = unknown;        // angle by which it turns at critical_load_factor [rad]
  double straight_load_factor = unknown;       // smallest >= 0 at which G of growth straight on is the fracture energy

  // Members from here on belong to tips among bonds.
  TipMethod method = TipMethod::elements;
  int contours = 0;
  bool grown = false, branched = false;
  double contour_radius = 0, felt_ahead = 0;  // [m]
};

enum class TipDetail { factors, everything };

// Elements on a crack for a picture: start, middle and end of each one, with the openings there and the mean of the
// displacements of both faces [m].
struct CrackPicture {
  int crack;
  std::vector<Point> places, openings, displacements;
};

// Places of material points: origin + spacing * (i, j), turned about the origin by the angle.
struct LatticeGrid {
  Point origin;
  double spacing, horizon;  // [m]
  double angle = 0;         // [rad]
};

struct RegionOperator {
  const class Region* region;
  coupling::DenseOperator dense;
};

// Cells between the nodes of a region, or elements of its boundary.
struct Cells {
  int nodes_per_cell;
  std::vector<std::int32_t> nodes;  // in the region's own numbering
};

// Cells as a picture shows them, with points beside the nodes.
struct RegionPicture {
  std::vector<AddedPoint> added;  // numbered after the nodes
  Cells cells;
};

// Part of a snapshot to which a region is written, together with other regions that name the same part.
struct SnapshotBlock {
  std::string name;
  int number;  // blocks are written in this order
  output::VtuCell cell;
  struct Array {
    const char* name;
    Field field;
  };
  std::vector<Array> arrays;
};

// Sizes of regions, summed up.
struct RegionStatistics {
  std::int64_t boundary_nodes = 0, boundary_elements = 0, material_points = 0, kernel_evaluations = 0;
  double seconds_boundary = 0, seconds_lattice = 0;
  std::set<const void*> counted;  // shared data counts once
};

// Region as operators on the scene's nodes. Its own nodes are numbered from 0; `nodes()` gives their numbers in the
// scene.
class Region {
 public:
  Region(int id, const scene::Material& material) : id_(id), material_(material) {}
  virtual ~Region() = default;
  Region(const Region&) = delete;
  Region& operator=(const Region&) = delete;

  int id() const { return id_; }
  const scene::Material& material() const { return material_; }
  const PlaneElasticity& elasticity() const { return material_.elasticity; }
  const std::vector<int>& nodes() const { return nodes_; }

  // --- Preparation: each step for all regions, in the order of their ids, before the next one.

  virtual void mesh(const Preparation& /*preparation*/) {}
  // Numbers the nodes and builds operators; bonds are added to the scene's.
  virtual void build(const Preparation& preparation, Contributions& contributions) = 0;
  // Interfaces at which nodes of the other side are to follow this region's elements; then the other side's part in it.
  virtual std::vector<LeadingElements> leading_elements() const { return {}; }
  virtual void follow(const LeadingElements& leading, int leader, coupling::NodeTies& ties) const;
  // Places of nodes on interfaces with another region, once meshed [m].
  virtual std::vector<Point> places_facing(int /*other_region*/) const { return {}; }

  // Material points on an interface, in order along its own edge [m]; others may ask before it is meshed itself.
  virtual std::vector<Point> interface_points(const Preparation& /*preparation*/, const Contact& /*own*/) { return {}; }
  // --- Strains that its material wants, which loads make of heat; before operators are asked for

  // Takes a swelling strain. Throws Error (argument) if the region cannot swell like that.
  virtual void swell(const Swelling& /*strain*/, LatticeSwelling& /*lattices*/) {}
  // Sets the rest elongations of the region's terms, once all regions have their swelling.
  virtual void set_rests(const LatticeSwelling& /*lattices*/, coupling::Terms& /*terms*/) const {}
  // Rest displacements of its dense operator, once it has its swelling; null without.
  virtual const coupling::Affine* rest_of_operator() const { return nullptr; }
  // Displacement at a place by which the region swells freely, constant and proportional part; empty if it cannot.
  virtual std::optional<Eigen::Matrix2d> free_displacement(const Point& /*place*/) const {
    return Eigen::Matrix2d::Zero();
  }

  // --- What it contributes to equilibrium

  // Stiffness on its nodes, if it has one as a matrix; taken over from a region before if it is the same.
  virtual std::optional<coupling::DenseOperator> dense_operator(std::span<const RegionOperator> before) const;
  // Volume that flows out per displacement of each degree of freedom, of a region that cannot change its volume.
  virtual std::optional<Eigen::VectorXd> outflow(Eigen::Index /*dof_count*/) const { return std::nullopt; }

  // --- Supports and loads

  // Nodes on a part of an edge, with its ends.
  virtual std::vector<PlacedNode> nodes_on(const EdgeSpan& span, double tolerance) const = 0;
  // Adds nodal forces [N] of a traction [Pa] on a part of a free edge. Forces are numbered 2 * scene node + component.
  virtual void add_traction(const EdgeSpan& span, const std::function<Point(const Point&)>& traction,
                            Eigen::Ref<Eigen::VectorXd> force) const = 0;
  // Adds nodal forces [N] of a force per volume.
  virtual void add_body_force(const BodyForce& body_force, Eigen::Ref<Eigen::VectorXd> force) const = 0;
  // Work [J] of the loads on the inside of the region (forces per volume and tractions on cracks, constant and
  // proportional part) on each other's displacements: the part that nodal forces do not include.
  virtual Eigen::Matrix2d work_within(const std::array<BodyForce, 2>& /*body_force*/,
                                      const std::vector<CrackLoad>& /*crack_loads*/) const {
    return Eigen::Matrix2d::Zero();
  }

  // Gaps that these loads cause at cracks that can close: openings of its dense operator [m].
  virtual coupling::Affine face_offsets(const std::array<BodyForce, 2>& /*body_force*/,
                                        const std::vector<CrackLoad>& /*crack_loads*/) const {
    return coupling::Affine(0, 2);
  }

  // Force [N] of the tractions of the body on this edge at each of some nodes; edges share a node's force in this
  // ratio.
  virtual std::vector<Point> forces_on_edge(const EdgeSpan& /*span*/, const std::vector<int>& nodes_of_scene,
                                            const FieldsOfRegion& /*fields*/) const {
    return std::vector<Point>(nodes_of_scene.size(), Point::Zero());
  }

  // --- Cracks and bonds

  virtual bool takes_cracks() const { return false; }
  // Share of a full cell's area that each of its nodes has; empty where it has no cells.
  virtual std::vector<double> shares_of_cells() const { return {}; }
  // Data for the growth of crack lines in the region, if it can have such cracks.
  virtual std::optional<pd::TipLaw> tip_law(const scene::Options& /*options*/) const { return {}; }
  // Whether cracks cut the region into pieces that do not hold each other.
  virtual bool is_cut() const { return false; }
  // Whether a crack has elements in the region that are no boundary of its pieces.
  virtual bool has_inner_crack(int /*crack*/) const { return false; }
  // Whether the region has elements on cracks: parts of Preparation::cracks. Then it has the functions below.
  virtual bool has_crack_elements() const { return false; }
  // Adds nodal forces [N] of a load on the faces of one of its cracks, the constant part or the proportional one.
  virtual void add_crack_load(const CrackLoad& /*load*/, int /*part*/, Eigen::Ref<Eigen::VectorXd> /*force*/) const {}
  // Tips of its cracks with their values; growth needs the factors only, without T and errors.
  virtual std::vector<TipValues> tips(const Solution& /*solution*/, TipDetail /*detail*/) const { return {}; }
  // Openings of one of its cracks at fractions of its length: along it and normal to it, positive if it is open [m].
  virtual std::vector<Point> crack_openings(int /*crack*/, const std::vector<double>& /*fractions*/,
                                            const Solution& /*solution*/) const {
    return {};
  }
  virtual std::vector<CrackPicture> crack_pictures(const Solution& /*solution*/) const { return {}; }
  // Largest overlap of crack faces; empty if there is none.
  virtual std::optional<Overlap> overlap(const Solution& /*solution*/) const { return std::nullopt; }
  // End of a crack cut that puts the effective tip at a place inside the region, to which the crack comes in a
  // direction; at most `backward` behind it. Bonds are the scene's.
  virtual pd::FeltEnd end_felt_at(const Point& tip, const Point& /*direction*/, double /*backward*/) const {
    return {tip, {}};
  }
  // Points on a crack through which it may not pass, as they would belong to neither of its faces.
  virtual std::vector<Point> points_on_crack(const scene::Crack& /*crack*/) const { return {}; }
  // Adds the scene's bonds that crack number `crack` cuts.
  virtual void cut(const scene::Crack& /*crack*/, int /*number*/, std::vector<int>& /*bonds*/,
                   std::vector<std::string>& /*warnings*/) const {}
  // Bonds as pairs of own nodes, a row of the scene's bonds; empty for a region without bonds. Other bonds of the scene
  // join nodes that no region has both of.
  virtual std::optional<std::span<const pd::Bond>> bonds() const { return std::nullopt; }
  virtual std::size_t first_bond() const { return 0; }
  // Numbers of the scene's terms at its nodes, each once; with those that cross to regions with which it acts as one.
  virtual std::vector<int> terms() const { return {}; }
  // Lattice of a region whose bonds show the stress field at a crack tip among them.
  virtual std::optional<LatticeGrid> lattice_grid() const { return std::nullopt; }
  // Rows of the lattice on which crack faces can touch; empty if they cannot.
  virtual std::optional<pd::FaceLattice> face_lattice() const { return std::nullopt; }

  // --- Results

  // Entries of its own nodes in fields of nodes.
  virtual std::vector<int> entries_of_nodes() const;
  // Node of the scene that moves with every entry of such fields.
  virtual std::vector<int> nodes_of_entries() const { return nodes_; }
  // Size of a field. Throws Error (argument) for a field that the region does not have.
  virtual FieldSize field_size(Field field) const = 0;
  virtual FieldValues field(Field field, const Solution& solution) const = 0;
  virtual std::int64_t cell_count() const = 0;
  virtual Cells cells() const = 0;
  virtual SnapshotBlock snapshot_block() const = 0;
  virtual RegionPicture picture(const Solution& /*solution*/) const { return {{}, cells()}; }
  // Whether its cells are elements of its boundary, so that its inside needs a picture of its own.
  virtual bool has_inside() const { return false; }
  // Lines of its cracks with elements; null without.
  virtual const CrackLines* crack_lines() const { return nullptr; }
  // Field as a snapshot shows it, one entry a node.
  virtual FieldValues at_nodes(Field /*field*/, const FieldValues& values) const { return values; }
  // `fields` and the solution outlive the evaluator.
  virtual std::unique_ptr<Evaluator> evaluator(const Solution& solution, const FieldsOfRegion& fields,
                                               bool with_stress) const = 0;
  // Rank of the region on interfaces: the region with the highest one is asked for values.
  virtual int rank_at_interfaces() const = 0;
  virtual void add_statistics(RegionStatistics& statistics) const = 0;

  double seconds_preparing = 0;

 protected:
  // Values at the region's own nodes from those of all nodes, two each, and their sums back.
  Eigen::VectorXd gather(const Eigen::VectorXd& of_scene) const;
  void scatter(const Eigen::VectorXd& own, Eigen::Ref<Eigen::VectorXd> of_scene) const;

  std::vector<int> nodes_;

 private:
  int id_;
  scene::Material material_;
};

}  // namespace bempd::regions
