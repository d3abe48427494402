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

// Peridynamic region with an outline of any shape. Material points are the ends of equal chords along the edges and,
// inside, points of a lattice. Under a constant stress the bonds are in balance with its tractions on the chords.
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

  std::vector<double> cell_shares() const override { return part_.areas.empty() ? body_.areas : part_.areas; }
  const RegionSquares* squares() const override { return &squares_; }
  bool shares_bonds_with(const BondedRegion& other) const override;

  std::int64_t cell_count() const override { return static_cast<std::int64_t>(body_.cells.size()); }
  Cells cells() const override;
  std::unique_ptr<Evaluator> evaluator(const Solution& solution, const FieldsOfRegion& fields,
                                       bool with_stress) const override;

  // --- Functions for the group of regions that are one body

  static constexpr double most_places = 1e8;  // largest number of lattice points in the rectangle around a body

  pd::LatticePlace place_of_lattice(const Preparation& preparation) const;
  void move_origin(const Point& origin) { origin_ = origin; }
  // Part of the region in the body that it forms with its neighbours.
  struct Part {
    std::shared_ptr<DividedOutline> outline;  // outline of the body
    std::vector<int> own_number;  // the region's number of each point of the body; -1: the region lacks the point
    std::vector<double> areas;    // area of each point of the region that lies in the region, in squared spacings
  };
  void join(std::shared_ptr<OutlinedGroup> group, Part part, pd::OutlinedBody body);
  void set_stencils(pd::CellStencils stencils);

 private:
  class CellEvaluator;

  // Divides the outline of the region, or of its group, into chords, unless that is done: neighbours may ask for points
  // before mesh() of this region is called. Throws CannotLeaveRows.
  void divide(const Preparation& preparation);
  void build_alone(const Preparation& preparation, Contributions& contributions);
  void require_common_points(const Preparation& preparation, const Contact& contact) const;
  const DividedOutline& outline() const { return *part_.outline; }
  // Number of the region's point at a node of the outline; -1 if the region lacks the point.
  int point_at_node(int node_of_outline) const {
    return part_.own_number.empty() ? node_of_outline : part_.own_number[static_cast<std::size_t>(node_of_outline)];
  }

  PointChoice choice_;
  Part part_;  // without own numbers and areas if the region is a body of its own
  pd::OutlinedBody body_;
  std::shared_ptr<OutlinedGroup> group_;  // null if the region is a body of its own, and after the bonds are built
  StencilSquares squares_;
};

}  // namespace bempd::regions
