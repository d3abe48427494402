#include "regions/lattice/lattice_group.hpp"

#include "regions/lattice/shared_bonds.hpp"

namespace bempd::regions {

namespace {

Eigen::Vector2i shift_of(const LatticeRegion& member, const LatticeRegion& leader) {
  const Point offset = (member.origin() - leader.origin()) / leader.spacing();
  return offset.array().round().cast<int>().matrix();
}

pd::CellLattice union_of(const std::vector<LatticeRegion*>& members) {
  std::vector<pd::CellLattice::Part> parts;
  parts.reserve(members.size());
  for (const LatticeRegion* member : members) parts.push_back({&member->grid(), shift_of(*member, *members.front())});
  return pd::CellLattice::union_of(parts);
}

// Points of all members as points of the union of their cells, in grid coordinates of the first member.
SharedPoints points_of(const std::vector<LatticeRegion*>& members, const pd::CellLattice& cells) {
  std::vector<SharedPoints::Member> shared;
  for (LatticeRegion* member : members) {
    const Eigen::Vector2i shift = shift_of(*member, *members.front());
    std::vector<int> points;
    for (int i = 0; i < member->grid().point_count(); ++i)
      points.push_back(cells.find_point(member->grid().point(i) + shift));
    shared.push_back({member, std::move(points), shift.cast<double>()});
  }
  std::vector<Point> places;
  for (int i = 0; i < cells.point_count(); ++i) places.push_back(cells.point(i).cast<double>());
  return {std::move(shared), std::move(places)};
}

// Numbers of a member's cell squares (SceneBonds::squares), taken from those of the union of all cells.
std::vector<int> squares_of(const SharedPoints::Member& member, const pd::CellLattice& grid,
                            const std::vector<int>& squares) {
  if (squares.empty()) return {};
  std::vector<int> own(static_cast<std::size_t>(grid.point_count()), -1);
  for (int i = 0; i < grid.point_count(); ++i)
    if (grid.has_cell(grid.point(i))) own[i] = squares[member.points[i]];
  return own;
}

}  // namespace

bool LatticeGroup::add_bonds(const Preparation& preparation, const Contributions& contributions) const {
  const pd::CellLattice cells = union_of(members_);
  const SharedPoints points = points_of(members_, cells);
  // Cells that share only a corner are not bonded there, so there is no network for the union of the members' cells.
  for (int i = 0; i < cells.point_count(); ++i)
    if (cells.is_pinched(i)) return false;
  if (!points.has_one_node_each()) return false;
  const LatticeRegion& leader = *members_.front();
  const pd::Network network = leader.make_network(cells, preparation.options.whole_number("threads"));
  if (network.reduced) return false;
  SharedBonds bonds(points, network, preparation, contributions);
  const std::vector<int> squares = contributions.add_squares(
      cells, network.bonds, leader.elasticity(), leader.spacing(), [&](int point) { return points.node(point); },
      [&](int bond) { return bonds.term(bond); });
  for (std::size_t m = 0; m < members_.size(); ++m)
    bonds.give(static_cast<int>(m), squares_of(points.members()[m], members_[m]->grid(), squares));
  return true;
}

}  // namespace bempd::regions
