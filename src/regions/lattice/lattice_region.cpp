#include "regions/lattice/lattice_region.hpp"

#include <algorithm>
#include <cmath>
#include <typeinfo>

#include "coupling/interface_trace.hpp"
#include "error.hpp"

namespace bempd::regions {

LatticeRegion::LatticeRegion(int id, const LatticeDescription& described, const scene::Material& material)
    : Region(id, material), outline_(described.lattice()), horizon_ratio_(described.horizon_ratio()) {
  use_grid(pd::CellLattice(outline_.loops), outline_.origin);
}

void LatticeRegion::use_grid(pd::CellLattice grid, const Point& origin) {
  grid_ = std::make_unique<pd::CellLattice>(std::move(grid));
  origin_ = origin;
  points_.clear();
  for (int i = 0; i < grid_->point_count(); ++i) points_.push_back(grid_->point(i).cast<double>());
}

std::vector<int> LatticeRegion::points_along(const Point& start, const Point& end) const {
  const LatticePoint from = to_grid(start).array().round().cast<int>().matrix();
  const LatticePoint span = LatticePoint(to_grid(end).array().round().cast<int>().matrix()) - from;
  const int count = span.cwiseAbs().maxCoeff();
  std::vector<int> found{grid_->find_point(from)};
  for (int i = 1; i <= count; ++i) found.push_back(grid_->find_point(from + span / count * i));
  return found;
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

void LatticeRegion::build(const Preparation& preparation, Contributions& contributions) {
  place_points(preparation);
  const std::vector<char> is_shared = shared_points(preparation);
  nodes_.resize(points_.size());
  for (int i = 0; i < point_count(); ++i) {
    nodes_[i] =
        is_shared[i] ? contributions.registry.add_shared(position(i), id()) : contributions.registry.add(position(i));
  }
  take_network(preparation, contributions.warnings);
  add_bonds(critical_stretch(preparation), contributions);
}

bool LatticeRegion::is_alike(const LatticeRegion& other) const {
  return outline_.loops == other.outline_.loops && points_ == other.points_ && horizon_ratio_ == other.horizon_ratio_ &&
         elasticity() == other.elasticity();
}

pd::Network LatticeRegion::make_network(int threads) const {
  return pd::build_network(*grid_, horizon_ratio_, elasticity(), threads);
}

double LatticeRegion::critical_stretch(const Preparation& preparation) const {
  const bool as_printed = preparation.options.text_value("critical_stretch") == "printed";
  return material().critical_stretch_for(horizon_ratio_ * spacing(), as_printed);
}

// The network of a region before that differs by a translation or the spacing only, or one of its own.
void LatticeRegion::take_network(const Preparation& preparation, std::vector<std::string>& warnings) {
  for (const auto& other : preparation.regions) {
    if (other.get() == this) break;
    if (typeid(*other) != typeid(*this)) continue;
    const auto& lattice = static_cast<const LatticeRegion&>(*other);
    if (is_alike(lattice)) network_ = lattice.network_;
    if (network_) break;
  }
  if (!network_)
    network_ = std::make_shared<const pd::Network>(make_network(preparation.options.whole_number("threads")));
  if (network_->reduced) {
    warnings.push_back(text("region ", id(), " has a shape for which no network of positive bonds with horizon ratio ",
                            horizon_ratio_, " was found; it has bonds between nearest neighbours only"));
  }
}

void LatticeRegion::add_bonds(double critical_stretch, Contributions& contributions) {
  coupling::BondSet& bonds = contributions.bonds;
  first_bond_ = bonds.size();
  for (const pd::Bond& bond : network_->bonds) {
    const Point offset = points_[bond.second] - points_[bond.first];
    const double length = offset.norm();
    bonds.first.push_back(nodes_[bond.first]);
    bonds.second.push_back(nodes_[bond.second]);
    bonds.cosine.push_back(offset.x() / length);
    bonds.sine.push_back(offset.y() / length);
    bonds.length.push_back(spacing() * length);
    bonds.stiffness.push_back(bond.stiffness);
    contributions.critical_stretch.push_back(critical_stretch);
  }
}

void LatticeRegion::follow(const LeadingElements& leading, int leader, coupling::NodeTies& ties) const {
  const Point &start = leading.places.front(), &end = leading.places.back();
  const std::vector<int> points = points_along(start, end);
  std::vector<double> stations;
  for (std::size_t a = 0; a < leading.places.size(); a += 2)
    stations.push_back((leading.places[a] - start).norm() / spacing());
  stations.back() = static_cast<double>(points.size() - 1);
  const auto trace = coupling::interface_trace(stations);
  require(trace.has_value(), "edge ", leading.edge, " of region ", leader,
          " has elements of its own on the interface with region ", id(), ", from (", start.x(), ", ", start.y(),
          ") to (", end.x(), ", ", end.y(), "), that cannot be joined to its ", points.size(),
          " lattice points; leave out bempd_set_edge_mesh() for this edge, so that its elements follow the lattice");
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    std::vector<coupling::NodeTies::Master> masters;
    using Row = Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator;
    for (Row it(*trace, static_cast<Eigen::Index>(i)); it; ++it)
      masters.push_back({leading.nodes[static_cast<std::size_t>(it.col())], it.value()});
    ties.add(nodes_[points[i]], std::move(masters));
  }
}

void LatticeRegion::add_statistics(RegionStatistics& statistics) const {
  statistics.material_points += point_count();
  statistics.seconds_lattice += seconds_preparing;
}

}  // namespace bempd::regions
