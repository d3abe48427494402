#include "regions/lattice/shared_bonds.hpp"

#include <algorithm>

namespace bempd::regions {

SharedPoints::SharedPoints(std::vector<Member> members, std::vector<Point> places)
    : members_(std::move(members)), places_(std::move(places)), nodes_(places_.size(), nobody) {
  for (std::size_t m = 0; m < members_.size(); ++m) {
    for (std::size_t i = 0; i < members_[m].points.size(); ++i) {
      int& node = nodes_[static_cast<std::size_t>(members_[m].points[i])];
      const int own = members_[m].region->nodes()[i];
      one_node_each_ = one_node_each_ && (node == nobody || node == own);
      node = own;
      holders_.push_back({static_cast<int>(m), static_cast<int>(i)});
    }
  }
  holders_at_ = linalg::make_adjacency(static_cast<int>(places_.size()), [&](const auto& add) {
    int holder = 0;
    for (const Member& member : members_)
      for (const int point : member.points) add(point, holder++);
  });
}

int SharedPoints::number_in(int member, int point) const {
  for (int h : holders_at_.of(point)) {
    if (holders_[h].member == member) return holders_[h].point;
  }
  return nobody;
}

int SharedPoints::owner(const pd::Bond& bond) const {
  for (int h : holders_at_.of(bond.first)) {
    if (number_in(holders_[h].member, bond.second) != nobody) return holders_[h].member;
  }
  return nobody;
}

bool SharedPoints::is_within_one(const pd::Bond& bond) const {
  const auto first = holders_at_.of(bond.first), second = holders_at_.of(bond.second);
  return first.size() == 1 && second.size() == 1 && holders_[first[0]].member == holders_[second[0]].member;
}

std::set<int> SharedPoints::members_at(const pd::Bond& bond) const {
  std::set<int> found;
  for (int end : {bond.first, bond.second}) {
    for (int h : holders_at_.of(end)) found.insert(holders_[h].member);
  }
  return found;
}

std::vector<double> SharedPoints::energy_shares() const {
  std::vector<std::vector<double>> of_members;
  for (const Member& member : members_) of_members.push_back(member.region->energy_shares());
  if (std::ranges::all_of(of_members, [](const auto& values) { return values.empty(); })) return {};
  std::vector<double> all(places_.size(), 1);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Holder& first = holders_[*holders_at_.of(static_cast<int>(i)).begin()];
    const std::vector<double>& values = of_members[static_cast<std::size_t>(first.member)];
    if (!values.empty()) all[i] = values[static_cast<std::size_t>(first.point)];
  }
  return all;
}

SharedBonds::SharedBonds(const SharedPoints& points, const pd::Network& network, const Preparation& preparation,
                         const Contributions& contributions)
    : points_(points), network_(network), of_scene_(network.bonds.size()), parts_(points.members().size()) {
  const BondedRegion& leader = *points.members().front().region;
  const Contributions::Breaking breaking = leader.breaking(preparation, contributions);
  const std::vector<double> shares = points.energy_shares();
  for (Part& part : parts_) {
    part.network.offsets = network.offsets;
    part.network.max_residual = network.max_residual;
    part.network.min_weight_ratio = network.min_weight_ratio;
  }
  // Bonds by their owner (first member that has both ends of the bond). The last list has the bonds without an owner.
  std::vector<std::vector<std::size_t>> rows(parts_.size() + 1);
  for (std::size_t b = 0; b < network.bonds.size(); ++b) {
    const int owner = points.owner(network.bonds[b]);
    rows[owner == SharedPoints::nobody ? parts_.size() : static_cast<std::size_t>(owner)].push_back(b);
  }
  for (std::size_t m = 0; m < rows.size(); ++m) {
    for (const std::size_t b : rows[m]) {
      const pd::Bond& bond = network.bonds[b];
      of_scene_[b] = contributions.terms.size();
      contributions.add_bond({points.node(bond.first), points.node(bond.second), bond.stiffness},
                             points.place(bond.second) - points.place(bond.first), leader.spacing(),
                             breaking.between(shares, bond.first, bond.second));
      if (m < parts_.size()) add(static_cast<int>(m), b, true);
    }
  }
  for (std::size_t m = 0; m < rows.size(); ++m) {
    for (const std::size_t b : rows[m]) {
      if (points.is_within_one(network.bonds[b])) continue;
      for (const int member : points.members_at(network.bonds[b]))
        if (static_cast<std::size_t>(member) != m) add(member, b, false);
    }
  }
}

void SharedBonds::add(int member, std::size_t bond, bool listed) {
  Part& part = parts_[static_cast<std::size_t>(member)];
  const pd::Bond& b = network_.bonds[bond];
  if (listed && part.bonds.listed++ == 0) part.bonds.first = of_scene_[bond];
  const int first = number(member, b.first), second = number(member, b.second);
  part.network.bonds.push_back({first, second, b.stiffness});
  part.network.offset_of.push_back(network_.offset_of[bond]);
  part.bonds.of_scene.push_back(static_cast<int>(of_scene_[bond]));
}

int SharedBonds::number(int member, int point) {
  if (const int own = points_.number_in(member, point); own != SharedPoints::nobody) return own;
  Part& part = parts_[static_cast<std::size_t>(member)];
  const SharedPoints::Member& of = points_.members()[static_cast<std::size_t>(member)];
  const auto [found, is_new] = part.far.try_emplace(point, static_cast<int>(of.points.size() + part.far.size()));
  if (is_new) {
    part.bonds.far_nodes.push_back(points_.node(point));
    part.bonds.far_points.push_back(points_.place(point) - of.shift);
  }
  return found->second;
}

void SharedBonds::give(int member, std::vector<int> squares) {
  Part& part = parts_[static_cast<std::size_t>(member)];
  part.bonds.network = std::make_shared<const pd::Network>(std::move(part.network));
  part.bonds.squares = std::move(squares);
  points_.members()[static_cast<std::size_t>(member)].region->take_bonds(std::move(part.bonds));
}

}  // namespace bempd::regions
