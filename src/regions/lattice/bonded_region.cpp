#include "regions/lattice/bonded_region.hpp"

#include <algorithm>
#include <cmath>

#include "crack/growth_law.hpp"
#include "error.hpp"
#include "pd/cell_squares.hpp"
#include "pd/crack.hpp"
#include "pd/critical_stretch.hpp"

namespace bempd::regions {

double BondedRegion::critical_stretch(const scene::Options& options) const {
  const bool as_printed = options.text_value("critical_stretch") == "printed";
  return material().critical_stretch_for(horizon_ratio() * spacing(), as_printed);
}

double BondedRegion::critical_stretch(const Preparation& preparation) const {
  const double of_the_material = critical_stretch(preparation.options);
  const bool of_running =
      material().fracture_energy > 0 && preparation.options.text_value("critical_stretch") == "running";
  return of_running ? of_the_material / std::sqrt(pd::running_energy(horizon_ratio())) : of_the_material;
}

std::vector<int> BondedRegion::terms() const {
  std::vector<int> all;
  all.reserve(network()->bonds.size());
  for (std::size_t bond = 0; bond < network()->bonds.size(); ++bond)
    all.push_back(static_cast<int>(bonds_.number(bond)));
  const auto of_a_cell = static_cast<int>(bonds_.squares.empty() ? 0 : pd::cell_squares(elasticity()).size());
  for (const int first : bonds_.squares)
    for (int k = 0; first >= 0 && k < of_a_cell; ++k) all.push_back(first + k);
  return all;
}

Contributions::Breaking BondedRegion::breaking(const Preparation& preparation,
                                               const Contributions& contributions) const {
  const bool opening = preparation.options.text_value("pd.criterion") == "opening";
  return {critical_stretch(preparation), contributions.terms.add_law(material().bond_law),
          opening ? elasticity().c12() / elasticity().c11() : 0.0};
}

std::optional<pd::TipLaw> BondedRegion::tip_law(const scene::Options& options) const {
  const double horizon = horizon_ratio() * spacing();
  const PlaneElasticity& e = elasticity();
  const double energy = pd::fracture_energy(critical_stretch(options), e, horizon);
  const double modulus =
      e.state == PlaneState::stress ? e.young_modulus : e.young_modulus / (1 - e.poisson_ratio * e.poisson_ratio);
  const crack::Resistance& resistance = material().resistance;
  return {{spacing(), horizon, e.thickness, modulus, crack::toughness_of(energy, modulus), toughness().if_any(),
           resistance.curve.get(), resistance.directions.get(), resistance.function.get()}};
}

void BondedRegion::add_own_bonds(const Preparation& preparation, const Contributions& contributions) {
  bonds_.first = contributions.terms.size();
  bonds_.listed = network()->bonds.size();
  const Contributions::Breaking breaking = this->breaking(preparation, contributions);
  const std::vector<double> shares = energy_shares();
  for (const pd::Bond& bond : network()->bonds)
    contributions.add_bond({nodes_[bond.first], nodes_[bond.second], bond.stiffness},
                           points_[bond.second] - points_[bond.first], spacing(),
                           breaking.between(shares, bond.first, bond.second));
}

// Force at each node that the tractions on this edge make, without those on other edges; they follow from the stress at
// the node. (Edges that meet at a node share the node's reaction in the ratio of these forces.)
std::vector<Point> BondedRegion::forces_on_edge(const EdgeSpan& span, const std::vector<int>& nodes_of_scene,
                                                const FieldsOfRegion& fields) const {
  const std::vector<double>& stress = fields(Field::stress).values;
  const auto normal_at = [&](const Point& p) {
    const Edge& edge = span.geometry;
    const Point along = edge.straight() ? edge.direction().normalized() : edge.tangent(closest_fraction(edge, p));
    return Point(along.y(), -along.x());
  };
  std::vector<Point> forces;
  for (const int node : nodes_of_scene) {
    const auto place = static_cast<std::size_t>(std::find(nodes_.begin(), nodes_.end(), node) - nodes_.begin());
    const double* s = &stress[3 * place];
    const auto traction = [&](const Point& p) {
      const Point normal = normal_at(p);
      return Point(s[0] * normal.x() + s[2] * normal.y(), s[2] * normal.x() + s[1] * normal.y());
    };
    Eigen::VectorXd of_edge = Eigen::VectorXd::Zero(2 * (1 + *std::max_element(nodes_.begin(), nodes_.end())));
    add_traction({span.edge, span.geometry, 0, 1}, traction, of_edge);
    forces.emplace_back(of_edge.segment<2>(2 * node));
  }
  return forces;
}

void BondedRegion::add_body_force(const BodyForce& body_force, Eigen::Ref<Eigen::VectorXd> force) const {
  const double volume = elasticity().thickness * spacing() * spacing();
  const Point of_cell = volume * body_force.uniform;
  const std::vector<double> shares = cell_shares();
  for (std::size_t i = 0; i < shares.size(); ++i) {
    force.segment<2>(2 * nodes_[i]) += shares[i] * of_cell;
    if (body_force.growth != 0)
      force.segment<2>(2 * nodes_[i]) += shares[i] * volume * body_force.growth * position(static_cast<int>(i));
  }
}

std::vector<Point> BondedRegion::on_grid(const scene::Crack& crack) const {
  std::vector<Point> polyline;
  for (const Point& p : crack.points) polyline.push_back(to_grid(p));
  return polyline;
}

std::vector<Point> BondedRegion::points_on_crack(const scene::Crack& crack) const {
  std::vector<Point> met;
  if (cracks_may_meet_points()) return met;
  for (const int point : pd::points_on(points_, on_grid(crack))) met.push_back(position(point));
  return met;
}

void BondedRegion::cut(const scene::Crack& crack, int number, std::vector<int>& bonds,
                       std::vector<std::string>& warnings) const {
  const std::vector<Point> polyline = on_grid(crack);
  const std::vector<int> touched = pd::points_on(points_, polyline);
  if (!touched.empty()) {
    const Point where = position(touched.front());
    const std::string finding =
        text("crack ", number, " passes through ", touched.size(), " material points of region ", id(),
             ", the first at (", where.x(), ", ", where.y(), ")");
    require(cracks_may_meet_points(), finding,
            "; a point on a crack belongs to neither side: shift the crack or "
            "the region by half a spacing (",
            0.5 * spacing(), ")");
    warnings.push_back(finding + "; they stay bonded to both of its faces and bridge it");
  }
  const pd::Touching touching =
      cracks_may_meet_points() ? pd::Touching::spares_bonds_ending_on_it : pd::Touching::cuts_all;
  std::vector<Point> bond_ends = points_;
  bond_ends.insert(bond_ends.end(), bonds_.far_points.begin(), bonds_.far_points.end());
  for (int bond : pd::bonds_cut_by(bond_ends, network()->bonds, polyline, touching))
    bonds.push_back(static_cast<int>(bonds_.number(bond)));
}

void BondedRegion::add_statistics(RegionStatistics& statistics) const {
  statistics.material_points += point_count();
  statistics.seconds_lattice += seconds_preparing;
}

PointRow BondedRegion::row_of(const std::vector<int>& points, double point_distance) const {
  PointRow row{id(), {}, {}, point_distance};
  for (const int point : points) {
    row.places.push_back(position(point));
    row.nodes.push_back(nodes_[static_cast<std::size_t>(point)]);
  }
  return row;
}

}  // namespace bempd::regions
