#include "regions/lattice/lattice_region.hpp"

#include <algorithm>
#include <typeinfo>

#include "error.hpp"
#include "regions/lattice/acting_as_one.hpp"
#include "regions/lattice/lattice_group.hpp"

namespace bempd::regions {

LatticeRegion::LatticeRegion(int id, const PeridynamicDescription& described, const scene::Material& material)
    : BondedRegion(id, material, described.spacing(), described.horizon_ratio()),
      outline_(described.lattice().value()),
      grid_(outline_.loops),
      squares_(elasticity(), *this, grid_, bonds_) {
  place_points_of_grid(outline_.origin);
}

void LatticeRegion::use_grid(pd::CellLattice grid, const Point& origin) {
  grid_ = std::move(grid);
  place_points_of_grid(origin);
}

void LatticeRegion::place_points_of_grid(const Point& origin) {
  origin_ = origin;
  points_.clear();
  for (int i = 0; i < grid_.point_count(); ++i) points_.push_back(grid_.point(i).cast<double>());
}

std::vector<int> LatticeRegion::points_along(const Point& start, const Point& end) const {
  const LatticePoint from = to_grid(start).array().round().cast<int>().matrix();
  const LatticePoint span = LatticePoint(to_grid(end).array().round().cast<int>().matrix()) - from;
  const int count = span.cwiseAbs().maxCoeff();
  std::vector<int> found{grid_.find_point(from)};
  for (int i = 1; i <= count; ++i) found.push_back(grid_.find_point(from + span / count * i));
  return found;
}

std::vector<Point> LatticeRegion::interface_points(const Preparation& preparation, const Contact& own) {
  const Edge edge = preparation.scene.region(id()).edge(own.edge + 1);
  std::vector<Point> places;
  for (const int point : points_along(edge.at(own.from), edge.at(own.to))) places.push_back(position(point));
  return places;
}

std::vector<char> LatticeRegion::shared_points(const Preparation& preparation) const {
  std::vector<char> shared(points_.size(), 0);
  for (const Contact& contact : preparation.arrangement.contacts) {
    if (contact.region != id() - 1) continue;
    const Edge edge = preparation.scene.region(id()).edge(contact.edge + 1);
    const std::vector<int> points = points_along(edge.at(contact.from), edge.at(contact.to));
    if (preparation.scene.region(contact.other_region + 1).has_own_mesh(contact.other_edge + 1)) {
      shared[points.front()] = shared[points.back()] = 1;
    } else {
      for (int point : points) shared[point] = 1;
    }
  }
  return shared;
}

void LatticeRegion::mesh(const Preparation& preparation) {
  if (group_) return;
  const auto of_rows = [&](int region) { return region_as<LatticeRegion>(preparation, region); };
  const std::vector<int> ids = regions_touching(id(), preparation.arrangement, [&](int first, int second) {
    return of_rows(second) && of_rows(first)->acts_as_one_with(*of_rows(second));
  });
  if (ids.size() < 2) return;
  std::vector<LatticeRegion*> members;
  for (const int region : ids) members.push_back(of_rows(region));
  const auto group = std::make_shared<LatticeGroup>(std::move(members));
  for (LatticeRegion* member : group->members()) member->group_ = group;
}

void LatticeRegion::build(const Preparation& preparation, Contributions& contributions) {
  place_points(preparation);
  const std::vector<char> is_shared = shared_points(preparation);
  nodes_.resize(points_.size());
  for (int i = 0; i < point_count(); ++i) {
    nodes_[i] =
        is_shared[i] ? contributions.registry.add_shared(position(i), id()) : contributions.registry.add(position(i));
  }
  if (!group_) {
    bond_alone(preparation, contributions);
  } else if (group_->members().back() == this) {
    // The last region of a group adds the bonds of all members, because all members need to have numbered their nodes.
    const std::shared_ptr<LatticeGroup> group = std::move(group_);
    const bool as_one = group->add_bonds(preparation, contributions);
    for (LatticeRegion* member : group->members()) {
      member->group_.reset();
      if (!as_one) member->bond_alone(preparation, contributions);
    }
  }
}

bool LatticeRegion::acts_as_one_with(const LatticeRegion& other) const {
  return typeid(other) == typeid(*this) && horizon_ratio() == other.horizon_ratio() && material() == other.material();
}

bool LatticeRegion::shares_bonds_with(const BondedRegion& other) const {
  if (this == &other) return true;  // also in schemes without groups, such as paper
  const auto* lattice = dynamic_cast<const LatticeRegion*>(&other);
  return lattice && acts_as_one_with(*lattice);
}

bool LatticeRegion::is_alike(const LatticeRegion& other) const {
  return outline_.loops == other.outline_.loops && points_ == other.points_ &&
         horizon_ratio() == other.horizon_ratio() && elasticity() == other.elasticity();
}

pd::Network LatticeRegion::make_network(const pd::CellLattice& cells, int threads) const {
  return pd::build_network(cells, horizon_ratio(), elasticity(), threads);
}

// Takes the network of an earlier region that differs only by a translation or by the spacing; builds a network if
// there is no such region.
void LatticeRegion::take_network(const Preparation& preparation, std::vector<std::string>& warnings) {
  for (const auto& other : preparation.regions) {
    if (other.get() == this) break;
    const Region& before = *other;
    if (typeid(before) != typeid(*this)) continue;
    const auto& lattice = static_cast<const LatticeRegion&>(before);
    if (lattice.network() && lattice.bonds_.of_scene.empty() && is_alike(lattice)) bonds_.network = lattice.network();
    if (network()) break;
  }
  if (!network()) {
    const int threads = preparation.options.whole_number("threads");
    bonds_.network = std::make_shared<const pd::Network>(make_network(grid_, threads));
  }
  if (network()->reduced) {
    warnings.push_back(text("region ", id(),
                            " has a shape for which no network of positive bonds with horizon "
                            "ratio ",
                            horizon_ratio(), " was found; it has bonds between nearest neighbours only"));
  }
}

void LatticeRegion::bond_alone(const Preparation& preparation, Contributions& contributions) {
  take_network(preparation, contributions.warnings);
  add_own_bonds(preparation, contributions);
  const auto node = [&](int point) { return nodes_[point]; };
  const auto term = [&](int bond) { return static_cast<int>(bonds_.first) + bond; };
  bonds_.squares = contributions.add_squares(grid_, network()->bonds, elasticity(), spacing(), node, term);
}

void LatticeRegion::follow(const LeadingElements& leading, int leader, coupling::NodeTies& ties) const {
  const Point &start = leading.places.front(), &end = leading.places.back();
  const Point half = 0.5 * spacing() * (end - start).normalized();
  const auto is_point = [&](const Point& place) {
    const Point scaled = to_grid(place), nearest = scaled.array().round();
    return (scaled - nearest).norm() < 0.25;
  };
  // A row of elements that ends at the mouth of a crack reaches half a spacing beyond the last material point.
  const Point first = is_point(start) ? start : start + half, last = is_point(end) ? end : end - half;
  tie(row_of(points_along(first, last), spacing()), leading, leader, ties);
}

}  // namespace bempd::regions
