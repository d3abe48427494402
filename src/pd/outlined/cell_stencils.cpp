#include "pd/outlined/cell_stencils.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "linalg/least_change.hpp"

namespace bempd::pd {

namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double negligible_factor = 1e-15;

int corner_count(const std::array<int, 4>& cell) { return is_triangle(cell) ? 3 : 4; }

// The bonds along a cell's edges and diagonals, as far as there are any.
class OwnBonds {
 public:
  explicit OwnBonds(const std::vector<Bond>& bonds) : bonds_(bonds) {}

  void add(const std::array<int, 4>& cell, std::vector<int>& found) const {
    const int count = corner_count(cell);
    for (int a = 0; a < count; ++a)
      for (int b = a + 1; b < count; ++b) add(std::min(cell[a], cell[b]), std::max(cell[a], cell[b]), found);
  }

 private:
  void add(int first, int second, std::vector<int>& found) const {
    const auto before = [](const Bond& bond, const std::pair<int, int>& ends) {
      return std::pair(bond.first, bond.second) < ends;
    };
    const auto at = std::lower_bound(bonds_.begin(), bonds_.end(), std::pair(first, second), before);
    if (at != bonds_.end() && at->first == first && at->second == second)
      found.push_back(static_cast<int>(at - bonds_.begin()));
  }

  const std::vector<Bond>& bonds_;
};

// Cells at the outline with those behind their edges. What is missing at the points of the outline goes to them as the
// shortest changes that leave the gradient of linear displacements as it is.
class CorrectedCells {
 public:
  explicit CorrectedCells(const OutlinedBody& body) : body_(body), neighbours_(body.cells.size()) {
    std::vector<char> near(body.points.size(), 0);
    for (const auto& cell : body.cells)
      for (const int p : cell) near[p] = near[p] || is_at_outline(cell);
    std::map<std::pair<int, int>, int> behind;  // cells by their directed edges
    for (std::size_t c = 0; c < body.cells.size(); ++c)
      for_each_edge(c, [&](int a, int b) {
        if (near[a] && near[b]) behind[{a, b}] = static_cast<int>(c);
      });
    for (std::size_t c = 0; c < body.cells.size(); ++c) {
      if (!is_at_outline(body.cells[c])) continue;
      for_each_edge(c, [&](int a, int b) {
        const auto found = behind.find({b, a});
        if (found != behind.end()) neighbours_[c].push_back(found->second);
      });
    }
  }

  // Its own corners first.
  std::vector<int> points(std::size_t cell) const {
    std::vector<int> all(body_.cells[cell].begin(), body_.cells[cell].begin() + corner_count(body_.cells[cell]));
    for (const int other : neighbours_[cell])
      for (const int p : body_.cells[static_cast<std::size_t>(other)])
        if (std::find(all.begin(), all.end(), p) == all.end()) all.push_back(p);
    return all;
  }
  const std::vector<int>& neighbours(std::size_t cell) const { return neighbours_[cell]; }

  // Changes of G, by cell and point of its stencil; and how much is left.
  double changes(std::vector<std::vector<Vector2d>>& found) const;

 private:
  bool is_at_outline(const std::array<int, 4>& cell) const { return *std::min_element(cell.begin(), cell.end()) < body_.chords.count(); }
  template <class Visit>
  void for_each_edge(std::size_t c, const Visit& visit) const {
    const std::array<int, 4>& cell = body_.cells[c];
    const int count = corner_count(cell);
    for (int k = 0; k < count; ++k) visit(cell[k], cell[(k + 1) % count]);
  }
  // Orthonormal, of what sees no linear function on the points.
  MatrixXd blind_to_linear(const std::vector<int>& points) const {
    MatrixXd linear(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Point from_first = body_.points[points[k]] - body_.points[points[0]];
      linear.row(static_cast<Eigen::Index>(k)) << 1, from_first.x(), from_first.y();
    }
    const Eigen::HouseholderQR<MatrixXd> parts(linear);
    const MatrixXd q = parts.householderQ();
    return q.rightCols(q.cols() - 3);
  }

  const OutlinedBody& body_;
  std::vector<std::vector<int>> neighbours_;
};

double CorrectedCells::changes(std::vector<std::vector<Vector2d>>& found) const {
  std::vector<MatrixXd> bases(body_.cells.size());
  std::vector<std::vector<int>> stencils(body_.cells.size());
  std::vector<int> row(body_.points.size(), -1), points_of_rows;
  std::vector<Eigen::Triplet<double>> entries;
  int column = 0;
  for (std::size_t c = 0; c < body_.cells.size(); ++c) {
    if (neighbours_[c].empty()) continue;
    stencils[c] = points(c);
    if (stencils[c].size() < 4) continue;
    bases[c] = blind_to_linear(stencils[c]);
    for (std::size_t k = 0; k < stencils[c].size(); ++k) {
      int& r = row[stencils[c][k]];
      if (r < 0) r = static_cast<int>(points_of_rows.size()), points_of_rows.push_back(stencils[c][k]);
      for (Eigen::Index b = 0; b < bases[c].cols(); ++b)
        entries.emplace_back(r, column + static_cast<int>(b), bases[c](static_cast<Eigen::Index>(k), b));
    }
    column += static_cast<int>(bases[c].cols());
  }
  linalg::LeastChange problem;
  problem.constraints.resize(static_cast<Eigen::Index>(points_of_rows.size()), column);
  problem.constraints.setFromTriplets(entries.begin(), entries.end());
  problem.start = VectorXd::Zero(column);
  problem.scale = VectorXd::Ones(column);
  problem.lower = -std::numeric_limits<double>::infinity();
  double residual = 0;
  found.resize(body_.cells.size());
  for (int axis = 0; axis < 2; ++axis) {
    problem.target = VectorXd::Zero(static_cast<Eigen::Index>(points_of_rows.size()));
    for (std::size_t r = 0; r < points_of_rows.size(); ++r) {
      const int p = points_of_rows[r];
      if (p < body_.chords.count())
        problem.target[static_cast<Eigen::Index>(r)] = (body_.factors[p] - 1) * body_.chords.surface_vector(p)[axis];
    }
    const linalg::LeastChangeResult result = linalg::solve_long_least_change(problem);
    residual = std::max(residual, result.residual);
    Eigen::Index at = 0;
    for (std::size_t c = 0; c < body_.cells.size(); ++c) {
      if (bases[c].size() == 0) continue;
      found[c].resize(stencils[c].size(), Vector2d::Zero());
      const VectorXd change = bases[c] * result.values.segment(at, bases[c].cols());
      for (std::size_t k = 0; k < stencils[c].size(); ++k) found[c][k][axis] = change[static_cast<Eigen::Index>(k)];
      at += bases[c].cols();
    }
  }
  return residual;
}

// With the surface vectors of its own polygon.
void add_polygon(const OutlinedBody& body, const std::array<int, 4>& cell, CellStencils& made) {
  const int count = corner_count(cell);
  double twice = 0;
  for (int k = 0; k < count; ++k) {
    const Point &before = body.points[cell[(k + count - 1) % count]], &next = body.points[cell[(k + 1) % count]];
    const Point along = next - before;
    made.point.push_back(cell[k]);
    made.gradient.push_back(0.5 * Vector2d(along.y(), -along.x()));
    if (k > 0 && k + 1 < count)
      twice += cross(body.points[cell[k]] - body.points[cell[0]], next - body.points[cell[0]]);
  }
  made.corners.push_back(count);
  made.area.push_back(0.5 * twice);
}

}  // namespace

CellStencils cell_stencils(const OutlinedBody& body) {
  const OwnBonds own(body.network.bonds);
  const bool has_factors = std::any_of(body.factors.begin(), body.factors.end(),
                                       [](double factor) { return std::abs(factor - 1) > negligible_factor; });
  std::vector<std::vector<Vector2d>> changes(body.cells.size());
  CellStencils made;
  std::optional<CorrectedCells> corrected;
  if (has_factors) {
    corrected.emplace(body);
    made.max_residual = corrected->changes(changes);
  }
  for (std::size_t c = 0; c < body.cells.size(); ++c) {
    const std::size_t first = made.point.size();
    add_polygon(body, body.cells[c], made);
    std::vector<int> bonds;
    own.add(body.cells[c], bonds);
    if (!changes[c].empty()) {
      const std::vector<int> points = corrected->points(c);
      made.point.insert(made.point.end(), points.begin() + made.corners.back(), points.end());
      made.gradient.resize(made.point.size(), Vector2d::Zero());
      for (std::size_t k = 0; k < points.size(); ++k) made.gradient[first + k] += changes[c][k];
      for (const int other : corrected->neighbours(c)) own.add(body.cells[static_cast<std::size_t>(other)], bonds);
    }
    std::sort(bonds.begin(), bonds.end());
    bonds.erase(std::unique(bonds.begin(), bonds.end()), bonds.end());
    made.bond.insert(made.bond.end(), bonds.begin(), bonds.end());
    made.start.push_back(made.point.size());
    made.bond_start.push_back(made.bond.size());
  }
  return made;
}

std::vector<StencilSquare> squares_of(const CellStencils& stencils, std::size_t cell,
                                      const PlaneElasticity& elasticity) {
  if (is_bond_based(elasticity)) return {};
  const double lambda = elasticity.c12(), mu = elasticity.shear_modulus();
  const double size = elasticity.thickness * stencils.area[cell], root = std::sqrt(2.0) / stencils.area[cell];
  std::vector<StencilSquare> squares;
  const auto add = [&](double stiffness, const auto& pull_of) {
    StencilSquare& square = squares.emplace_back(StencilSquare{{}, stiffness});
    for (const Vector2d& g : stencils.gradients(cell)) square.pull.push_back(pull_of(g));
  };
  if (lambda > mu) {
    add(size * (lambda - mu) / 2, [&](const Vector2d& g) { return Vector2d(root * g); });
  } else {
    const double m = (mu - lambda) / 2;
    add(size * m / 2, [&](const Vector2d& g) { return Vector2d(root * g.y(), root * g.x()); });
    add(size * m / 2, [&](const Vector2d& g) { return Vector2d(root * g.x(), -root * g.y()); });
  }
  return squares;
}

}  // namespace bempd::pd
