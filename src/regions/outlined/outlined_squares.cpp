// Squares of cells in bodies with any outline: terms of the energy that make any Poisson's ratio possible.
#include <algorithm>
#include <limits>

#include "linalg/least_squares.hpp"
#include "pd/deformation.hpp"
#include "regions/lattice/lattice_swelling.hpp"
#include "regions/outlined/outlined_region.hpp"

namespace bempd::regions {

namespace {

// Mean stress (xx, yy, xy) over a patch of cells due to a unit force in a square, for unit spacing and thickness. `at`
// are the patch's points, `area` its area.
Eigen::Vector3d unit_stress_of(const pd::StencilSquare& square, std::span<const int> at, double area,
                               const std::vector<Point>& points) {
  Eigen::Matrix2d moment = Eigen::Matrix2d::Zero();
  for (std::size_t k = 0; k < at.size(); ++k) moment += square.pull[k] * (points[at[k]] - points[at[0]]).transpose();
  return Eigen::Vector3d(moment(0, 0), moment(1, 1), 0.5 * (moment(0, 1) + moment(1, 0))) / area;
}

}  // namespace

void OutlinedRegion::add_squares(const Contributions& contributions) {
  const auto first_bond = static_cast<int>(bonds_.first);
  std::vector<coupling::TermEntry> entries;
  std::vector<int> leaders;
  for (std::size_t p = 0; p < stencils_.count(); ++p) {
    const std::span<const int> at = stencils_.points(p);
    leaders.clear();
    for (const int bond : stencils_.bonds(p)) leaders.push_back(first_bond + bond);
    bonds_.squares.push_back(static_cast<int>(contributions.terms.size()));
    for (const pd::StencilSquare& square : pd::squares_of(stencils_, p, elasticity())) {
      entries.clear();
      for (std::size_t k = 0; k < at.size(); ++k)
        entries.push_back({nodes_[at[k]], square.pull[k].x(), square.pull[k].y()});
      const int number = contributions.terms.add_wide(entries, spacing(), square.stiffness);
      contributions.critical_stretch.push_back(std::numeric_limits<double>::infinity());
      contributions.terms.add_follower(number, leaders);
    }
  }
}

Eigen::Vector3d OutlinedRegion::stress_of_squares(const Solution& solution, std::size_t patch) const {
  Eigen::Vector3d stress = Eigen::Vector3d::Zero();
  auto term = static_cast<std::size_t>(bonds_.squares[patch]);
  for (const pd::StencilSquare& square : pd::squares_of(stencils_, patch, elasticity())) {
    const double force = solution.bonds.tension(term, solution.bonds.stiffness[term], solution.displacement.data(),
                                                solution.load_factor);
    stress += force / (spacing() * elasticity().thickness) *
              unit_stress_of(square, stencils_.points(patch), stencils_.area[patch], points_);
    ++term;
  }
  return stress;
}

// Corrects stresses at points where bonds or squares are broken: the mean of what the remaining bonds and squares
// carry, over the cells at the point, weighted by their shares of its area.
void OutlinedRegion::correct_at_losses(const Solution& solution, const std::vector<Eigen::Vector3d>& strains,
                                       const pd::BondStates& states, std::vector<Eigen::Vector3d>& stresses) const {
  if (stencils_.empty()) return;
  std::vector<char> lost(points_.size(), 0);
  for (std::size_t b = 0; b < states.share.size(); ++b) {
    if (states.share[b] < 1) lost[network()->bonds[b].first] = lost[network()->bonds[b].second] = 1;
  }
  for (std::size_t p = 0; p < stencils_.count(); ++p) {
    if (solution.intact[bonds_.squares[p]]) continue;
    const std::span<const int> at = stencils_.points(p);
    for (std::size_t k = 0; k < at.size(); ++k) lost[at[k]] = lost[at[k]] || stencils_.shares(p)[k] > 0;
  }
  for (std::size_t i = 0; i < stresses.size(); ++i) {
    if (lost[i]) stresses[i] = pd::bond_stress(strains[i], elasticity());
  }
  for (std::size_t p = 0; p < stencils_.count(); ++p) {
    const std::span<const int> at = stencils_.points(p);
    if (!solution.intact[bonds_.squares[p]] || std::none_of(at.begin(), at.end(), [&](int i) { return lost[i]; }))
      continue;
    const Eigen::Vector3d stress = stress_of_squares(solution, p);
    for (std::size_t k = 0; k < at.size(); ++k)
      if (lost[at[k]]) stresses[at[k]] += stencils_.shares(p)[k] / body_.areas[at[k]] * stress;
  }
}

// Sets the rest elongations for a swelling strain. If the strain is linear, e = e0 + a x + b y, they are those of the
// stress-free displacement (e0 x + a (x^2 - y^2) / 2 + b x y, e0 y + a x y + b (y^2 - x^2) / 2).
void OutlinedRegion::set_rests(const LatticeSwelling& lattices, coupling::Terms& terms) const {
  BondedRegion::set_rests(lattices, terms);
  const std::vector<Eigen::RowVector2d> strains =
      stencils_.empty() ? std::vector<Eigen::RowVector2d>{} : strains_of_points(lattices);
  for (std::size_t p = 0; p < stencils_.count(); ++p) {
    const std::span<const int> at = stencils_.points(p);
    const auto count = static_cast<Eigen::Index>(at.size());
    Point middle = Point::Zero();
    for (const int i : at) middle += points_[i] / static_cast<double>(count);
    Eigen::MatrixXd linear(count, 3), given(count, 2);
    for (Eigen::Index k = 0; k < count; ++k) {
      linear.row(k) << 1, (points_[at[k]] - middle).transpose();
      given.row(k) = strains[at[k]];
    }
    if (given.isZero(0)) continue;
    const Eigen::MatrixXd strain = linalg::LeastSquares(linear).solve(given);
    int term = bonds_.squares[p];
    for (const pd::StencilSquare& square : pd::squares_of(stencils_, p, elasticity())) {
      Eigen::RowVector2d rest = Eigen::RowVector2d::Zero();
      for (std::size_t k = 0; k < at.size(); ++k) {
        const Point q = points_[at[k]] - middle;
        const double half = 0.5 * (q.x() * q.x() - q.y() * q.y()), product = q.x() * q.y();
        Eigen::Matrix<double, 2, 3> displacement;
        displacement << q.x(), half, product, q.y(), product, -half;
        rest += square.pull[k].transpose() * displacement * strain;
      }
      terms.set_rest_elongation(term++, spacing() * rest[0], spacing() * rest[1]);
    }
  }
}

}  // namespace bempd::regions
