#include "regions/outlined/stencil_squares.hpp"

#include <algorithm>
#include <limits>

#include "linalg/least_squares.hpp"
#include "pd/cell_squares.hpp"
#include "pd/deformation.hpp"

namespace bempd::regions {

namespace {

// Mean stress (xx, yy, xy) over a patch of cells due to a unit force in a cell square, for unit spacing and thickness.
// `at` has the patch's points, `area` is the patch's area.
Eigen::Vector3d unit_stress_of(const pd::StencilSquare& square, std::span<const int> at, double area,
                               const std::vector<Point>& points) {
  Eigen::Matrix2d moment = Eigen::Matrix2d::Zero();
  for (std::size_t k = 0; k < at.size(); ++k) moment += square.pull[k] * (points[at[k]] - points[at[0]]).transpose();
  return Eigen::Vector3d(moment(0, 0), moment(1, 1), 0.5 * (moment(0, 1) + moment(1, 0))) / area;
}

}  // namespace

std::vector<int> add_squares(const pd::CellStencils& stencils, const PlaneElasticity& elasticity, double spacing,
                             const std::function<int(int)>& node, const std::function<int(int)>& term,
                             const Contributions& contributions) {
  std::vector<int> first_of, leaders;
  std::vector<coupling::TermEntry> entries;
  for (std::size_t p = 0; p < stencils.count(); ++p) {
    const std::span<const int> at = stencils.points(p);
    leaders.clear();
    for (const int bond : stencils.bonds(p)) leaders.push_back(term(bond));
    first_of.push_back(static_cast<int>(contributions.terms.size()));
    for (const pd::StencilSquare& square : pd::squares_of(stencils, p, elasticity)) {
      entries.clear();
      for (std::size_t k = 0; k < at.size(); ++k)
        entries.push_back({node(at[k]), square.pull[k].x(), square.pull[k].y()});
      const int number = contributions.terms.add_wide(entries, spacing, square.stiffness);
      contributions.critical_stretch.push_back(std::numeric_limits<double>::infinity());
      contributions.terms.add_follower(number, leaders);
    }
  }
  return first_of;
}

Eigen::Vector3d StencilSquares::stress(const Solution& solution, std::size_t patch) const {
  Eigen::Vector3d stress = Eigen::Vector3d::Zero();
  auto term = static_cast<std::size_t>(bonds_.squares[patch]);
  for (const pd::StencilSquare& square : pd::squares_of(stencils_, patch, elasticity_)) {
    const double force = solution.bonds.tension(term, solution.bonds.stiffness[term], solution.displacement.data(),
                                                solution.load_factor);
    stress += force / (spacing_ * elasticity_.thickness) *
              unit_stress_of(square, stencils_.points(patch), stencils_.area[patch], body_.points);
    ++term;
  }
  return stress;
}

void StencilSquares::correct_at_losses(const Solution& solution, const std::vector<Eigen::Vector3d>& strains,
                                       const pd::BondStates& states, std::vector<Eigen::Vector3d>& stresses) const {
  if (stencils_.empty()) return;
  std::vector<char> lost(body_.points.size(), 0);
  for (std::size_t b = 0; b < states.share.size(); ++b) {
    if (states.share[b] < 1) lost[bonds_.all()[b].first] = lost[bonds_.all()[b].second] = 1;
  }
  for (std::size_t p = 0; p < stencils_.count(); ++p) {
    if (solution.intact[bonds_.squares[p]]) continue;
    const std::span<const int> at = stencils_.points(p);
    for (std::size_t k = 0; k < at.size(); ++k) lost[at[k]] = lost[at[k]] || stencils_.shares(p)[k] > 0;
  }
  const auto is_lost = [&](int point) { return static_cast<std::size_t>(point) < stresses.size() && lost[point]; };
  for (std::size_t i = 0; i < stresses.size(); ++i) {
    if (lost[i]) stresses[i] = pd::bond_stress(strains[i], elasticity_);
  }
  for (std::size_t p = 0; p < stencils_.count(); ++p) {
    const std::span<const int> at = stencils_.points(p);
    if (!solution.intact[bonds_.squares[p]] || std::none_of(at.begin(), at.end(), is_lost)) continue;
    const Eigen::Vector3d stress = this->stress(solution, p);
    for (std::size_t k = 0; k < at.size(); ++k)
      if (is_lost(at[k])) stresses[at[k]] += stencils_.shares(p)[k] / body_.areas[at[k]] * stress;
  }
}

void StencilSquares::set_rests(const std::vector<Eigen::RowVector2d>& strains, coupling::Terms& terms) const {
  for (std::size_t p = 0; p < stencils_.count(); ++p) {
    const std::span<const int> at = stencils_.points(p);
    const auto count = static_cast<Eigen::Index>(at.size());
    Point middle = Point::Zero();
    for (const int i : at) middle += body_.points[i] / static_cast<double>(count);
    Eigen::MatrixXd linear(count, 3), given(count, 2);
    for (Eigen::Index k = 0; k < count; ++k) {
      linear.row(k) << 1, (body_.points[at[k]] - middle).transpose();
      given.row(k) = strains[at[k]];
    }
    if (given.isZero(0)) continue;
    const Eigen::MatrixXd strain = linalg::LeastSquares(linear).solve(given);
    int term = bonds_.squares[p];
    for (const pd::StencilSquare& square : pd::squares_of(stencils_, p, elasticity_)) {
      Eigen::RowVector2d rest = Eigen::RowVector2d::Zero();
      for (std::size_t k = 0; k < at.size(); ++k) {
        const Point q = body_.points[at[k]] - middle;
        const double half = 0.5 * (q.x() * q.x() - q.y() * q.y()), product = q.x() * q.y();
        Eigen::Matrix<double, 2, 3> displacement;
        displacement << q.x(), half, product, q.y(), product, -half;
        rest += square.pull[k].transpose() * displacement * strain;
      }
      terms.set_rest_elongation(term++, spacing_ * rest[0], spacing_ * rest[1]);
    }
  }
}

}  // namespace bempd::regions
