#pragma once

#include <memory>
#include <vector>

#include "pd/outlined/cell_stencils.hpp"
#include "regions/lattice/shared_bonds.hpp"
#include "regions/outlined/cell_parts.hpp"
#include "regions/outlined/divided_outline.hpp"

namespace bempd::regions {

class OutlinedRegion;

// Group of regions with any outline that touch and form one lattice: points and bonds are those of one body with the
// outline around all of them. A region has the points of all cells of the body that it has a share of.
class OutlinedGroup {
 public:
  explicit OutlinedGroup(std::vector<OutlinedRegion*> members) : members_(std::move(members)) {}

  // Builds the body and lets the members join the group. Returns false, and changes nothing, if there is no network of
  // bonds for it, or if a support or a load acts at a point that the body does not have.
  static bool join(const std::shared_ptr<OutlinedGroup>& group, const Preparation& preparation);
  const std::vector<OutlinedRegion*>& members() const { return members_; }  // by id

  // Number of the scene's node of each point of a member, which adds those that no other member has added.
  std::vector<int> add_nodes(const OutlinedRegion& member, const Preparation& preparation,
                             const Contributions& contributions);
  // Adds the bonds of the body, once all members have their nodes.
  void add_bonds(const Preparation& preparation, const Contributions& contributions);

 private:
  // Part of the body that a member has.
  struct Part {
    std::vector<int> points;      // numbers in the body
    std::vector<double> shares;   // of the area of each, which lie in the member
    pd::FillingCells cells;       // of the member's points
    std::vector<int> own_number;  // of each point of the body; -1 for points of others
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
  std::vector<Part> parts_;  // by member
  std::vector<int> nodes_;   // of the scene, by points of the body
};

}  // namespace bempd::regions
