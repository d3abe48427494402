#pragma once

#include <memory>
#include <vector>

#include "pd/outlined/cell_stencils.hpp"
#include "regions/lattice/shared_bonds.hpp"
#include "regions/outlined/cell_parts.hpp"
#include "regions/outlined/divided_outline.hpp"

namespace bempd::regions {

class OutlinedRegion;

// Group of touching regions that have one lattice and outlines of any shape. Their material points and bonds are those
// of one body inside their common outline. A region has the corners of all cells of the body that overlap the region.
class OutlinedGroup {
 public:
  explicit OutlinedGroup(std::vector<OutlinedRegion*> members) : members_(std::move(members)) {}

  // Builds the body of a group and makes the members parts of it. Returns false, and leaves the members as they are, if
  // there is no network of bonds for the body, if the body lacks a point at which a support or a load acts, or if a
  // member lacks points of its own edges.
  static bool join(const std::shared_ptr<OutlinedGroup>& group, const Preparation& preparation);
  const std::vector<OutlinedRegion*>& members() const { return members_; }  // by ascending id

  // Adds the points of a member to the nodes of the scene, except points that another member has added. Returns the
  // number of the node of each point of the member.
  std::vector<int> add_nodes(const OutlinedRegion& member, const Preparation& preparation,
                             const Contributions& contributions);
  // Adds the bonds of the body to the scene; called when all members have added their nodes.
  void add_bonds(const Preparation& preparation, const Contributions& contributions);

 private:
  // Part of the body that a member has.
  struct Part {
    std::vector<int> points;      // numbers of the member's points in the body
    std::vector<double> areas;    // area of each of these points that lies in the member, in squared spacings
    pd::FillingCells cells;       // cells, with the member's numbers of their corners
    std::vector<int> own_number;  // the member's number of each point of the body; -1: the member lacks the point
  };

  bool build(const Preparation& preparation);
  bool divide_among_members(const Preparation& preparation);
  Part part_of(const std::vector<CellPart>& cells) const;
  pd::CellStencils stencils_of(std::size_t member, const std::vector<int>& squares, SharedBonds& bonds,
                               std::vector<int>& own_squares) const;

  std::vector<OutlinedRegion*> members_;
  std::shared_ptr<DividedOutline> outline_;
  pd::OutlinedBody body_;
  pd::CellStencils stencils_;
  std::vector<Part> parts_;  // part of each member
  std::vector<int> nodes_;   // number of the scene's node of each point of the body
};

}  // namespace bempd::regions
