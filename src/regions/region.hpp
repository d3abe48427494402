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
#include "crack/tip.hpp"
#include "elasticity/free_swelling.hpp"
#include "elasticity/linear_body_force.hpp"
#include "geometry/crack_lines.hpp"
#include "geometry/edge.hpp"
#include "output/vtu.hpp"
#include "pd/crack.hpp"
#include "pd/face_places.hpp"
#include "pd/network.hpp"
#include "pd/tip_law.hpp"
#include "pd/varied_energy.hpp"
#include "regions/cell_splits.hpp"
#include "regions/fields.hpp"
#include "regions/preparation.hpp"
#include "regions/region_statistics.hpp"
#include "scene/material.hpp"

namespace bempd::regions {

class LatticeSwelling;

// Part of an edge of a region, between the fractions `from` and `to` of its length.
struct EdgeSpan {
  int edge;  // number in its region
  Edge geometry;
  double from, to;
};

// Node of the scene on a part of an edge, with its place as a fraction of the part.
struct PlacedNode {
  int node;
  double fraction;
};

// Boundary elements along a straight interface that the nodes of the other region follow, where meshes do not match.
// `places` and `nodes`: the start of the first element, then the middle and the end of every element.
struct LeadingElements {
  int edge;      // of the region that has the elements
  int follower;  // id of the other region
  std::vector<Point> places;
  std::vector<int> nodes;  // of the scene
};

enum class TipMethod { elements = 1, contours = 2, stress_ahead = 3 };

// Tip of a crack with its results; unknown results are NaN.
struct TipValues {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  int crack = 0, end = 0;                    // id; 1: the crack's last point, 0: its first
  Point place{0, 0}, direction{1, 0};        // unit vector in which a straight crack would go on
  Point factors{unknown, unknown};           // K_I, K_II [Pa m^(1/2)]
  double energy_release_rate = unknown;      // of growth straight on [J/m^2]
  double stress_along = unknown;             // T [Pa]
  double error = unknown;                    // of the factors [Pa m^(1/2)]
  Point constant_factors{unknown, unknown};  // K_I and K_II of the constant part of the loads
  Point proportional_factors{unknown, unknown};
  double toughness = 0;      // K_I at which it grows straight on; 0: it does not [Pa m^(1/2)]
  double plane_modulus = 0;  // [Pa]

  // Results of the growth criterion in force (Model::complete()); load factors: +- largest double if it never grows.
  double kink_angle = unknown;                 // from the direction, counter-clockwise, at the present loads [rad]
  double critical_load_factor = unknown;       // load factor at which the tip grows while it rises
  double critical_load_factor_down = unknown;  // load factor at which the tip grows while it falls
  double critical_kink_angle = unknown;        // angle by which it turns at critical_load_factor [rad]
  double straight_load_factor = unknown;       // smallest >= 0 at which G of growth straight on is the fracture energy
  crack::LoadRule load_rule = crack::LoadRule::unknown;  // what the critical load factors come from
  double load_error = unknown, valid_radius = unknown;   // of critical_load_factor, relative; free of disturbances [m]

  // The next members are set for tips in lattices only.
  TipMethod method = TipMethod::elements;
  int contours = 0;
  bool grown = false, branched = false, closed = false;  // closed: faces press on each other at the tip
  double contour_radius = 0, felt_ahead = 0;             // [m]
};

enum class TipDetail { factors, everything };

// Elements on a crack for a picture: start, middle and end of each, the openings and mean displacements there [m].
struct CrackPicture {
  int crack;
  std::vector<Point> places, openings, displacements;
};

// Lattice of material points at origin + spacing * (i, j), turned about the origin by the angle (counter-clockwise).
struct LatticeGrid {
  Point origin;
  double spacing, horizon;  // [m]
  double angle = 0;         // [rad]
};

struct RegionOperator {
  const class Region* region;
  coupling::DenseOperator dense;
};

// Cells of a region: quadrilaterals between its nodes, or elements of its boundary.
struct Cells {
  int nodes_per_cell;
  std::vector<std::int32_t> nodes;  // in the region's own numbering
};

// Cells of a region as a picture shows them, split along cracks, with the points that this adds.
struct RegionPicture {
  std::vector<AddedPoint> added;  // numbered after the nodes
  Cells cells;
};

// Block of a snapshot file to which a region is written, together with other regions that give the same name.
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

// Region: its contribution to the equations of the scene's nodes, and its results. Its own nodes are numbered from 0;
// `nodes()` gives their numbers in the scene.
class Region {
 public:
  Region(int id, const scene::Material& material) : id_(id), material_(material) {}
  virtual ~Region() = default;
  Region(const Region&) = delete;
  Region& operator=(const Region&) = delete;

  int id() const { return id_; }
  const scene::Material& material() const { return material_; }
  const PlaneElasticity& elasticity() const { return material_.elasticity; }
  const pd::VariedEnergy& toughness() const { return toughness_; }
  void vary_toughness(pd::VariedEnergy toughness) { toughness_ = std::move(toughness); }
  const std::vector<int>& nodes() const { return nodes_; }

  // --- Preparation: every step is done for all regions in the order of their ids before the next step begins.

  virtual void mesh(const Preparation& /*preparation*/) {}
  // Numbers the region's nodes, builds its operators, and adds its bonds to the scene's.
  virtual void build(const Preparation& preparation, Contributions& contributions) = 0;
  // Non-matching interfaces: elements of this region that nodes on the other side follow; then ties this region's nodes
  // to the elements of the region `leader`.
  virtual std::vector<LeadingElements> leading_elements() const { return {}; }
  virtual void follow(const LeadingElements& leading, int leader, coupling::NodeTies& ties) const;
  // Places of this region's nodes on interfaces with another region; known once it is meshed [m].
  virtual std::vector<Point> places_facing(int /*other_region*/) const { return {}; }

  // Material points on an interface, in order along this region's edge [m]. Neighbours may ask before it is meshed.
  virtual std::vector<Point> interface_points(const Preparation& /*preparation*/, const Contact& /*own*/) { return {}; }
  // --- Swelling: strains of the free material, caused by temperature; set before operators are asked for.

  // Takes a swelling strain. Throws Error (argument) if the region cannot swell in that way.
  virtual void swell(const Swelling& /*strain*/, LatticeSwelling& /*lattices*/) {}
  // Sets the rest elongations of the region's terms. Called after swell() of all regions.
  virtual void set_rests(const LatticeSwelling& /*lattices*/, coupling::Terms& /*terms*/) const {}
  // Displacement of the dense operator's nodes in the stress-free, swollen state; null without swelling.
  virtual const coupling::Affine* rest_of_operator() const { return nullptr; }
  // Displacement when the region swells freely (columns: constant, proportional part); empty if that causes stress.
  virtual std::optional<Eigen::Matrix2d> free_displacement(const Point& /*place*/) const {
    return Eigen::Matrix2d::Zero();
  }

  // --- Contribution to equilibrium

  // Stiffness on the nodes as a dense matrix, empty without one; an equal region in `before` shares its matrix.
  virtual std::optional<coupling::DenseOperator> dense_operator(std::span<const RegionOperator> before) const;
  // Volume that flows out of an incompressible region per displacement of each degree of freedom; empty otherwise.
  virtual std::optional<Eigen::VectorXd> outflow(Eigen::Index /*dof_count*/) const { return std::nullopt; }

  // --- Supports and loads

  // Nodes on a part of an edge, including its ends.
  virtual std::vector<PlacedNode> nodes_on(const EdgeSpan& span, double tolerance) const = 0;
  // Adds nodal forces [N] of a traction [Pa] on a part of a free edge to entries 2 * scene node + component.
  virtual void add_traction(const EdgeSpan& span, const std::function<Point(const Point&)>& traction,
                            Eigen::Ref<Eigen::VectorXd> force) const = 0;
  // Adds nodal forces [N] of a body force to `force`.
  virtual void add_body_force(const BodyForce& body_force, Eigen::Ref<Eigen::VectorXd> force) const = 0;
  // Work [J] of loads inside the region (body forces, tractions on cracks) that nodal forces do not include. Entry (i,
  // j): loads of part i on displacements of part j; parts are 0 (constant) and 1 (proportional).
  virtual Eigen::Matrix2d work_within(const std::array<BodyForce, 2>& /*body_force*/,
                                      const std::vector<CrackLoad>& /*crack_loads*/) const {
    return Eigen::Matrix2d::Zero();
  }

  // Gaps of contact constraints due to loads inside the region [m]; no rows if no crack can close.
  virtual coupling::Affine face_offsets(const std::array<BodyForce, 2>& /*body_force*/,
                                        const std::vector<CrackLoad>& /*crack_loads*/) const {
    return coupling::Affine(0, 2);
  }

  // Force [N] of the tractions on this edge at each node. Edges that meet in a node share its reaction in this ratio.
  virtual std::vector<Point> forces_on_edge(const EdgeSpan& /*span*/, const std::vector<int>& nodes_of_scene,
                                            const FieldsOfRegion& /*fields*/) const {
    return std::vector<Point>(nodes_of_scene.size(), Point::Zero());
  }

  // --- Cracks and bonds

  virtual bool takes_cracks() const { return false; }
  // Area of each node's cells over that of a full cell of the lattice; empty for a region without cells.
  virtual std::vector<double> shares_of_cells() const { return {}; }
  // Data for the growth of crack lines in this region; empty if cracks cannot grow as lines in it.
  virtual std::optional<pd::TipLaw> tip_law(const scene::Options& /*options*/) const { return {}; }
  // Whether cracks cut the region into separate pieces.
  virtual bool is_cut() const { return false; }
  // Whether part of a crack lies inside a piece of the region, so that it does not separate two pieces.
  virtual bool has_inner_crack(int /*crack*/) const { return false; }
  // Whether the region puts elements on cracks (parts of Preparation::cracks): the next functions are about these.
  virtual bool has_crack_elements() const { return false; }
  // Adds nodal forces [N] of a load on one of its cracks; `part` is 0 for the constant, 1 for the proportional part.
  virtual void add_crack_load(const CrackLoad& /*load*/, int /*part*/, Eigen::Ref<Eigen::VectorXd> /*force*/) const {}
  // Tips of its cracks with results. TipDetail::factors leaves out T-stress and errors, which growth does not need.
  virtual std::vector<TipValues> tips(const Solution& /*solution*/, TipDetail /*detail*/) const { return {}; }
  // Openings of one of its cracks at fractions of the length: tangential, and normal (positive if open) [m].
  virtual std::vector<Point> crack_openings(int /*crack*/, const std::vector<double>& /*fractions*/,
                                            const Solution& /*solution*/) const {
    return {};
  }
  virtual std::vector<CrackPicture> crack_pictures(const Solution& /*solution*/) const { return {}; }
  // Largest overlap of crack faces in the region; empty if there is none.
  virtual std::optional<Overlap> overlap(const Solution& /*solution*/) const { return std::nullopt; }
  // End of the cut that puts a crack's effective tip at `tip`, in this region. The crack arrives along `direction`; the
  // cut ends at most `backward` [m] behind the tip. Bonds are numbered as in the scene.
  virtual pd::FeltEnd end_felt_at(const Point& tip, const Point& /*direction*/, double /*backward*/) const {
    return {tip, {}};
  }
  // Material points on which a crack lies. It must not: they would belong to neither face.
  virtual std::vector<Point> points_on_crack(const scene::Crack& /*crack*/) const { return {}; }
  // Adds the scene's bonds that a crack cuts to `bonds`; `number` is the crack's id.
  virtual void cut(const scene::Crack& /*crack*/, int /*number*/, std::vector<int>& /*bonds*/,
                   std::vector<std::string>& /*warnings*/) const {}
  // Bonds of the region as pairs of its own nodes, the scene's bonds from first_bond() on; empty without bonds. Bonds
  // of the scene across interfaces belong to no region.
  virtual std::optional<std::span<const pd::Bond>> bonds() const { return std::nullopt; }
  virtual std::size_t first_bond() const { return 0; }
  // Numbers of the scene's terms at its nodes, each once, including those that connect it to other lattices.
  virtual std::vector<int> terms() const { return {}; }
  // Lattice of the region; empty if stress intensity factors cannot be computed from its bonds.
  virtual std::optional<LatticeGrid> lattice_grid() const { return std::nullopt; }
  // Lattice on whose rows contact of crack faces is possible; empty if it is not.
  virtual std::optional<pd::FaceLattice> face_lattice() const { return std::nullopt; }

  // --- Results

  // Entry of each of the region's nodes in fields that are given at nodes.
  virtual std::vector<int> entries_of_nodes() const;
  // Scene node for each entry of a field given at nodes: the node with whose displacement the entry moves.
  virtual std::vector<int> nodes_of_entries() const { return nodes_; }
  // Size of a field. Throws Error (argument) if the region does not have the field.
  virtual FieldSize field_size(Field field) const = 0;
  virtual FieldValues field(Field field, const Solution& solution) const = 0;
  virtual std::int64_t cell_count() const = 0;
  virtual Cells cells() const = 0;
  virtual SnapshotBlock snapshot_block() const = 0;
  virtual RegionPicture picture(const Solution& /*solution*/) const { return {{}, cells()}; }
  // Whether its cells are boundary elements, so that its interior needs a picture of its own.
  virtual bool has_inside() const { return false; }
  // Lines of the region's cracks with elements; null if it has none.
  virtual const CrackLines* crack_lines() const { return nullptr; }
  // Field as written to snapshots, with one entry for each node.
  virtual FieldValues at_nodes(Field /*field*/, const FieldValues& values) const { return values; }
  // Evaluator for places inside. `fields` and `solution` must outlive it; it has no stresses unless `with_stress`.
  virtual std::unique_ptr<Evaluator> evaluator(const Solution& solution, const FieldsOfRegion& fields,
                                               bool with_stress) const = 0;
  // Rank at interfaces: the region with the highest rank gives the values of places on an interface.
  virtual int rank_at_interfaces() const = 0;
  virtual void add_statistics(RegionStatistics& statistics) const = 0;

  double seconds_preparing = 0;

 protected:
  // gather(): values of the region's nodes (two each) out of all nodes'. scatter(): adds them to those of all nodes.
  Eigen::VectorXd gather(const Eigen::VectorXd& of_scene) const;
  void scatter(const Eigen::VectorXd& own, Eigen::Ref<Eigen::VectorXd> of_scene) const;

  std::vector<int> nodes_;

 private:
  int id_;
  scene::Material material_;
  pd::VariedEnergy toughness_;
};

}  // namespace bempd::regions
