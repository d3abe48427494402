#pragma once

#include <memory>
#include <vector>

#include "pd/outlined/outlined_body.hpp"
#include "regions/lattice/bonded_region.hpp"
#include "regions/lattice/peridynamic_description.hpp"
#include "regions/outlined/divided_outline.hpp"
#include "regions/outlined/stencil_squares.hpp"

namespace bempd::regions {

class OutlinedGroup;

// Peridynamic region with any outline: material points on equal chords along its edges and, inside, on a lattice.
// Uniform stress is in balance with the tractions on the chords, which coincide with straight edges.
class OutlinedRegion final : public BondedRegion {
 public:
  OutlinedRegion(int id, const PeridynamicDescription& described, const scene::Material& material);

  void mesh(const Preparation& preparation) override;
  void build(const Preparation& preparation, Contributions& contributions) override;
  void follow(const LeadingElements& leading, int leader, coupling::NodeTies& ties) const override;

  std::vector<Point> interface_points(const Preparation& preparation, const Contact& own) override;

  std::vector<PlacedNode> nodes_on(const EdgeSpan& span, double tolerance) const override;
  void add_traction(const EdgeSpan& span, const std::function<Point(const Point&)>& traction,
                    Eigen::Ref<Eigen::VectorXd> force) const override;

  std::optional<LatticeGrid> lattice_grid() const override;
  void cut(const scene::Crack& crack, int number, std::vector<int>& bonds,
           std::vector<std::string>& warnings) const override;
  std::optional<pd::FaceLattice> face_lattice() const override {
    return pd::FaceLattice{from_grid(body_.place.origin), spacing(), choice_.angle};
  }

  std::vector<double> cell_shares() const override { return part_.shares.empty() ? body_.areas : part_.shares; }
  const RegionSquares* squares() const override { return &squares_; }
  bool shares_bonds_with(const BondedRegion& other) const override;

  std::int64_t cell_count() const override { return static_cast<std::int64_t>(body_.cells.size()); }
  Cells cells() const override;
  std::unique_ptr<Evaluator> evaluator(const Solution& solution, const FieldsOfRegion& fields,
                                       bool with_stress) const override;

  // --- Functions for the group of regions that are one body

  static constexpr double most_places = 1e8;  // of a lattice in the rectangle around a body

  // Whether two regions are one body where they touch along an edge: material, spacing, horizon and angle are equal.
  bool acts_as_one_with(const OutlinedRegion& other) const;
  pd::LatticePlace place_of_lattice(const Preparation& preparation) const;
  void move_origin(const Point& origin) { origin_ = origin; }
  // The region's part of a body of several: its points (those of others at which its bonds end follow) and cells.
  struct Part {
    std::shared_ptr<DividedOutline> outline;  // of the body
    std::vector<int> own_number;              // of the body's points; -1 for points of others
    std::vector<double> shares;               // of the points' areas, which lie in the region
  };
  void join(std::shared_ptr<OutlinedGroup> group, Part part, pd::OutlinedBody body);
  void set_stencils(pd::CellStencils stencils);

 private:
  class CellEvaluator;

  // Divides the outline, or that of the group, unless that is done: neighbours may ask for points before the region is
  // meshed. Throws CannotLeaveRows.
  void divide(const Preparation& preparation);
  void build_alone(const Preparation& preparation, Contributions& contributions);
  void require_common_points(const Preparation& preparation, const Contact& contact) const;
  const DividedOutline& outline() const { return *part_.outline; }
  int point_at_node(int node_of_outline) const {
    return part_.own_number.empty() ? node_of_outline : part_.own_number[static_cast<std::size_t>(node_of_outline)];
  }

  PointChoice choice_;
  Part part_;  // all of the body if the region is alone
  pd::OutlinedBody body_;
  std::shared_ptr<OutlinedGroup> group_;  // null if the region is alone, or once its bonds exist
  StencilSquares squares_;
};

}  // namespace bempd::regions
