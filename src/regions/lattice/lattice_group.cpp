#include "regions/lattice/lattice_group.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <unordered_map>

#include "linalg/adjacency.hpp"

namespace bempd::regions {

namespace {

constexpr int nobody = -1;

// Number of a material point in a member region of the group.
struct Holder {
  int member, point;
};

// Union of the cells of all member regions in grid coordinates of the first one. It knows which members have each
// point.
class Union {
 public:
  explicit Union(const std::vector<LatticeRegion*>& members)
      : cells_(pd::CellLattice::union_of(parts(members))), nodes_(cells_.point_count(), nobody) {
    std::vector<int> places;
    for (std::size_t m = 0; m < members.size(); ++m) {
      const pd::CellLattice& grid = members[m]->grid();
      const Eigen::Vector2i shift = shift_of(members, m);
      for (int i = 0; i < grid.point_count(); ++i) {
        const int at = cells_.find_point(grid.point(i) + shift), node = members[m]->nodes()[i];
        sound_ = sound_ && (nodes_[at] == nobody || nodes_[at] == node);
        nodes_[at] = node;
        holders_.push_back({static_cast<int>(m), i});
        places.push_back(at);
      }
    }
    for (int i = 0; i < cells_.point_count(); ++i) sound_ = sound_ && !cells_.is_pinched(i);
    holders_at_ = linalg::make_adjacency(cells_.point_count(), [&](const auto& add) {
      for (std::size_t h = 0; h < places.size(); ++h) add(places[h], static_cast<int>(h));
    });
  }

  // Whether each point is one and the same node for all members, and no two cells share only a corner.
  bool is_sound() const { return sound_; }
  const pd::CellLattice& cells() const { return cells_; }
  int node(int point) const { return nodes_[point]; }

  // Number of a point of the union in a member; `nobody` if the member does not have it.
  int number_in(int member, int point) const {
    for (int h : holders_at_.of(point)) {
      if (holders_[h].member == member) return holders_[h].point;
    }
    return nobody;
  }
  // First member that has both ends of a bond of the union; `nobody` if there is none.
  int owner(const pd::Bond& bond) const {
    for (int h : holders_at_.of(bond.first)) {
      if (number_in(holders_[h].member, bond.second) != nobody) return holders_[h].member;
    }
    return nobody;
  }
  // Values at the points of the union, from those at the points of the members. At a point that several members have,
  // the first one's value counts. Empty if no member has values; a member without values counts as 1.
  std::vector<double> of_points(const std::vector<std::vector<double>>& of_members) const {
    if (std::ranges::all_of(of_members, [](const auto& values) { return values.empty(); })) return {};
    std::vector<double> all(static_cast<std::size_t>(cells_.point_count()), 1);
    for (int i = 0; i < cells_.point_count(); ++i) {
      const Holder& first = holders_[*holders_at_.of(i).begin()];
      const std::vector<double>& values = of_members[static_cast<std::size_t>(first.member)];
      if (!values.empty()) all[static_cast<std::size_t>(i)] = values[static_cast<std::size_t>(first.point)];
    }
    return all;
  }
  // Whether one member has both ends of a bond and no other member has either end.
  bool is_within_one(const pd::Bond& bond) const {
    const auto first = holders_at_.of(bond.first), second = holders_at_.of(bond.second);
    return first.size() == 1 && second.size() == 1 && holders_[first[0]].member == holders_[second[0]].member;
  }
  // Members that have at least one end of a bond.
  std::set<int> members_at(const pd::Bond& bond) const {
    std::set<int> found;
    for (int end : {bond.first, bond.second}) {
      for (int h : holders_at_.of(end)) found.insert(holders_[h].member);
    }
    return found;
  }

  // Values at the points of a member, taken from those at the points of the union; -1 at points that are not the lower
  // left corner of one of the member's cells.
  std::vector<int> of_member(const pd::CellLattice& grid, const Eigen::Vector2i& shift,
                             const std::vector<int>& values) const {
    std::vector<int> own(static_cast<std::size_t>(grid.point_count()), -1);
    for (int i = 0; i < grid.point_count(); ++i) {
      if (grid.has_cell(grid.point(i))) own[i] = values[cells_.find_point(grid.point(i) + shift)];
    }
    return own;
  }

  static Eigen::Vector2i shift_of(const std::vector<LatticeRegion*>& members, std::size_t m) {
    const Point offset = (members[m]->origin() - members.front()->origin()) / members.front()->spacing();
    return offset.array().round().cast<int>().matrix();
  }

 private:
  static std::vector<pd::CellLattice::Part> parts(const std::vector<LatticeRegion*>& members) {
    std::vector<pd::CellLattice::Part> parts;
    parts.reserve(members.size());
    for (std::size_t m = 0; m < members.size(); ++m) parts.push_back({&members[m]->grid(), shift_of(members, m)});
    return parts;
  }

  pd::CellLattice cells_;
  std::vector<int> nodes_;  // of the scene
  std::vector<Holder> holders_;
  linalg::Adjacency holders_at_;  // per point, in the order of members
  bool sound_ = true;
};

// Builder that collects the bonds of one member one by one.
class MemberBonds {
 public:
  MemberBonds(const Union& all, const pd::Network& network, int member, const Eigen::Vector2i& shift, int own_points)
      : all_(all), network_(network), member_(member), shift_(shift), own_points_(own_points) {
    own_.offsets = network.offsets;
    own_.max_residual = network.max_residual;
    own_.min_weight_ratio = network.min_weight_ratio;
  }

  void add(std::size_t bond, std::size_t of_scene, bool listed) {
    const pd::Bond& b = network_.bonds[bond];
    if (listed && bonds_.listed++ == 0) bonds_.first = of_scene;
    own_.bonds.push_back({number(b.first), number(b.second), b.stiffness});
    own_.offset_of.push_back(network_.offset_of[bond]);
    bonds_.of_scene.push_back(static_cast<int>(of_scene));
  }

  RegionBonds take() {
    bonds_.network = std::make_shared<const pd::Network>(std::move(own_));
    return std::move(bonds_);
  }

 private:
  int number(int point) {
    const int own = all_.number_in(member_, point);
    if (own != nobody) return own;
    const auto [found, is_new] = far_.try_emplace(point, own_points_ + static_cast<int>(far_.size()));
    if (is_new) {
      bonds_.far_nodes.push_back(all_.node(point));
      bonds_.far_points.push_back((all_.cells().point(point) - shift_).cast<double>());
    }
    return found->second;
  }

  const Union& all_;
  const pd::Network& network_;
  int member_;
  Eigen::Vector2i shift_;
  int own_points_;
  pd::Network own_;
  RegionBonds bonds_;
  std::unordered_map<int, int> far_;  // numbers of points that other members have
};

// Bonds of the union sorted by the member that lists them (its owner); those without an owner are the last list.
std::vector<std::vector<std::size_t>> bonds_by_owner(const Union& all, const pd::Network& network, std::size_t count) {
  std::vector<std::vector<std::size_t>> rows(count + 1);
  for (std::size_t b = 0; b < network.bonds.size(); ++b) {
    const int owner = all.owner(network.bonds[b]);
    rows[owner == nobody ? count : static_cast<std::size_t>(owner)].push_back(b);
  }
  return rows;
}

Region* region_of(const Preparation& preparation, int id) {
  const auto reaches = [](const std::unique_ptr<Region>& region, int wanted) { return region->id() < wanted; };
  return std::lower_bound(preparation.regions.begin(), preparation.regions.end(), id, reaches)->get();
}

}  // namespace

std::vector<LatticeRegion*> regions_acting_as_one(LatticeRegion& region, const Preparation& preparation) {
  const auto& contacts = preparation.arrangement.contacts;
  std::vector<LatticeRegion*> found{&region};
  std::set<int> ids{region.id()};
  const auto before = [](const Contact& contact, int number) { return contact.region < number; };
  for (std::size_t k = 0; k < found.size(); ++k) {
    LatticeRegion& at = *found[k];
    const int number = at.id() - 1;
    auto contact = std::lower_bound(contacts.begin(), contacts.end(), number, before);
    for (; contact != contacts.end() && contact->region == number; ++contact) {
      auto* other = dynamic_cast<LatticeRegion*>(region_of(preparation, contact->other_region + 1));
      if (other && at.acts_as_one_with(*other) && ids.insert(other->id()).second) found.push_back(other);
    }
  }
  std::sort(found.begin(), found.end(), [](const auto* a, const auto* b) { return a->id() < b->id(); });
  return found;
}

bool LatticeGroup::add_bonds(const Preparation& preparation, const Contributions& contributions) const {
  const Union all(members_);
  if (!all.is_sound()) return false;
  const LatticeRegion& leader = *members_.front();
  const pd::Network network = leader.make_network(all.cells(), preparation.options.whole_number("threads"));
  if (network.reduced) return false;
  const Contributions::Breaking breaking = leader.breaking(preparation, contributions);
  std::vector<std::vector<double>> of_members;
  for (const LatticeRegion* member : members_) of_members.push_back(member->energy_shares());
  const std::vector<double> shares = all.of_points(of_members);
  const auto rows = bonds_by_owner(all, network, members_.size());
  std::vector<std::size_t> of_scene(network.bonds.size());
  std::vector<MemberBonds> parts;
  parts.reserve(members_.size());
  for (std::size_t m = 0; m < members_.size(); ++m)
    parts.emplace_back(all, network, static_cast<int>(m), Union::shift_of(members_, m),
                       members_[m]->grid().point_count());
  for (std::size_t m = 0; m < rows.size(); ++m) {
    for (const std::size_t b : rows[m]) {
      const pd::Bond& bond = network.bonds[b];
      const Point step = (all.cells().point(bond.second) - all.cells().point(bond.first)).cast<double>();
      of_scene[b] = contributions.terms.size();
      contributions.add_bond({all.node(bond.first), all.node(bond.second), bond.stiffness}, step, leader.spacing(),
                             breaking.between(shares, bond.first, bond.second));
      if (m < parts.size()) parts[m].add(b, of_scene[b], true);
    }
  }
  for (std::size_t m = 0; m < rows.size(); ++m) {
    for (const std::size_t b : rows[m]) {
      if (all.is_within_one(network.bonds[b])) continue;
      for (const int member : all.members_at(network.bonds[b])) {
        if (static_cast<std::size_t>(member) != m) parts[static_cast<std::size_t>(member)].add(b, of_scene[b], false);
      }
    }
  }
  const std::vector<int> squares = contributions.add_squares(
      all.cells(), network.bonds, leader.elasticity(), leader.spacing(), [&](int point) { return all.node(point); },
      [&](int bond) { return static_cast<int>(of_scene[bond]); });
  for (std::size_t m = 0; m < parts.size(); ++m) {
    RegionBonds taken = parts[m].take();
    if (!squares.empty()) taken.squares = all.of_member(members_[m]->grid(), Union::shift_of(members_, m), squares);
    members_[m]->take_bonds(std::move(taken));
  }
  return true;
}

}  // namespace bempd::regions
