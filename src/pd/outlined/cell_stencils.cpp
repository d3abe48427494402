#include "pd/outlined/cell_stencils.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "linalg/least_change.hpp"
#include "pd/cell_squares.hpp"
#include "pd/outlined/cell_patches.hpp"

namespace bempd::pd {

namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double negligible_factor = 1e-15;

bool has_factors(const OutlinedBody& body) {
  return std::any_of(body.factors.begin(), body.factors.end(),
                     [](double factor) { return std::abs(factor - 1) > negligible_factor; });
}

// Points of some patches, each once; those of the patch `first` come first.
std::vector<int> points_of(const OutlinedBody& body, const CellPatches& patches, int first,
                           const std::vector<int>& others = {}) {
  std::vector<int> all;
  const auto add = [&](int patch) {
    for (const int cell : patches.cells[patch])
      for (const int p : body.cells[cell])
        if (std::find(all.begin(), all.end(), p) == all.end()) all.push_back(p);
  };
  add(first);
  for (const int other : others) add(other);
  return all;
}

// Appends the existing bonds between any two of `points` to `found`, sorted and each once; `bonds` are sorted by their
// ends.
void add_bonds_among(const std::vector<Bond>& bonds, const std::vector<int>& points, std::vector<int>& found) {
  const auto before = [](const Bond& bond, const std::pair<int, int>& ends) {
    return std::pair(bond.first, bond.second) < ends;
  };
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = a + 1; b < points.size(); ++b) {
      const std::pair ends = std::minmax({points[a], points[b]});
      const auto at = std::lower_bound(bonds.begin(), bonds.end(), ends, before);
      if (at != bonds.end() && std::pair(at->first, at->second) == ends)
        found.push_back(static_cast<int>(at - bonds.begin()));
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

// Orthonormal basis of all linear combinations of the values at some points that are zero for every linear function.
MatrixXd null_space_of_linear(const OutlinedBody& body, const std::vector<int>& points) {
  MatrixXd linear(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Point from_first = body.points[points[k]] - body.points[points[0]];
    linear.row(static_cast<Eigen::Index>(k)) << 1, from_first.x(), from_first.y();
  }
  const MatrixXd q = Eigen::HouseholderQR<MatrixXd>(linear).householderQ();
  return q.rightCols(q.cols() - 3);
}

// Correction of the stencils at the outline, each of which has one gradient vector G for each of its points
// (cell_stencils.hpp). The correction changes these vectors as little as possible so that, at each point, the vectors
// of all stencils add up to the point's surface vector times its balancing factor (surface_balance.hpp). The gradients
// of linear displacements stay exact.
class Correction {
 public:
  Correction(const OutlinedBody& body, const CellPatches& patches) : body_(body) {
    std::vector<int> row(body.points.size(), -1);
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::Index column = 0;
    for (std::size_t p = 0; p < patches.cells.size(); ++p) {
      if (patches.behind_an_edge[p].empty()) continue;
      Part part{p, points_of(body, patches, static_cast<int>(p), patches.behind_an_edge[p]), {}};
      if (part.points.size() < 4) continue;
      part.basis = null_space_of_linear(body, part.points);
      for (std::size_t k = 0; k < part.points.size(); ++k) {
        int& r = row[part.points[k]];
        if (r < 0) r = static_cast<int>(points_of_rows_.size()), points_of_rows_.push_back(part.points[k]);
        for (Eigen::Index b = 0; b < part.basis.cols(); ++b)
          entries.emplace_back(r, static_cast<int>(column + b), part.basis(static_cast<Eigen::Index>(k), b));
      }
      column += part.basis.cols();
      parts_.push_back(std::move(part));
    }
    problem_.constraints.resize(static_cast<Eigen::Index>(points_of_rows_.size()), column);
    problem_.constraints.setFromTriplets(entries.begin(), entries.end());
    problem_.start = VectorXd::Zero(column);
    problem_.scale = VectorXd::Ones(column);
    problem_.lower = -std::numeric_limits<double>::infinity();
  }

  // Calls visit(patch, points, changes of G) for every patch at the outline; returns the largest difference that is
  // left between a point's sum of vectors G and its surface vector with the factor.
  template <class Visit>
  double solve(const Visit& visit) {
    const auto [x, left_of_x] = component(0);
    const auto [y, left_of_y] = component(1);
    Eigen::Index at = 0;
    for (const Part& part : parts_) {
      const Eigen::Index count = part.basis.cols();
      MatrixXd changes(part.basis.rows(), 2);
      changes << part.basis * x.segment(at, count), part.basis * y.segment(at, count);
      visit(part.patch, part.points, changes);
      at += count;
    }
    return std::max(left_of_x, left_of_y);
  }

 private:
  struct Part {
    std::size_t patch;
    std::vector<int> points;
    MatrixXd basis;
  };

  std::pair<VectorXd, double> component(int axis) {
    problem_.target = VectorXd::Zero(static_cast<Eigen::Index>(points_of_rows_.size()));
    for (std::size_t r = 0; r < points_of_rows_.size(); ++r) {
      const int p = points_of_rows_[r];
      if (p >= body_.chords.count()) continue;
      problem_.target[static_cast<Eigen::Index>(r)] = (body_.factors[p] - 1) * body_.chords.surface_vector(p)[axis];
    }
    linalg::LeastChangeResult found = linalg::solve_long_least_change(problem_);
    return {std::move(found.values), found.residual};
  }

  const OutlinedBody& body_;
  std::vector<Part> parts_;
  std::vector<int> points_of_rows_;
  linalg::LeastChange problem_;
};

// Stencil of a patch while it is made.
struct Stencil {
  std::vector<int> points, bonds;
  std::vector<Vector2d> gradient;
  std::vector<double> share;
  double area = 0;
};

Stencil stencil_of(const OutlinedBody& body, const CellPatches& patches, int patch) {
  Stencil made{points_of(body, patches, patch), {}, {}, {}, 0};
  made.gradient.assign(made.points.size(), Vector2d::Zero());
  made.share.assign(made.points.size(), 0.0);
  for (const int number : patches.cells[patch]) {
    const std::array<int, 4>& cell = body.cells[number];
    const int count = corner_count(cell);
    const auto corner = [&](int k) { return body.points[cell[k % count]]; };
    double area = 0.5 * cross(corner(1) - corner(0), corner(2) - corner(0));
    if (count == 4) area += 0.5 * cross(corner(2) - corner(0), corner(3) - corner(0));
    for (int k = 0; k < count; ++k) {
      const Point along = corner(k + 1) - corner(k + count - 1);
      const auto at = std::find(made.points.begin(), made.points.end(), cell[k]) - made.points.begin();
      made.gradient[at] += 0.5 * Vector2d(along.y(), -along.x());
      made.share[at] += area / count;
    }
    made.area += area;
  }
  return made;
}

void append(const Stencil& stencil, CellStencils& all) {
  all.point.insert(all.point.end(), stencil.points.begin(), stencil.points.end());
  all.gradient.insert(all.gradient.end(), stencil.gradient.begin(), stencil.gradient.end());
  all.share.insert(all.share.end(), stencil.share.begin(), stencil.share.end());
  all.bond.insert(all.bond.end(), stencil.bonds.begin(), stencil.bonds.end());
  all.area.push_back(stencil.area);
  all.start.push_back(all.point.size());
  all.bond_start.push_back(all.bond.size());
}

}  // namespace

CellStencils cell_stencils(const OutlinedBody& body) {
  const CellPatches patches = make_patches(body.points, body.cells, body.chords.count());
  std::vector<Stencil> corrected(has_factors(body) ? patches.cells.size() : 0);
  CellStencils all;
  if (!corrected.empty()) {
    all.max_residual =
        Correction(body, patches).solve([&](std::size_t p, const std::vector<int>& points, const MatrixXd& changes) {
          Stencil made = stencil_of(body, patches, static_cast<int>(p));
          made.points = points;
          made.gradient.resize(points.size(), Vector2d::Zero());
          made.share.resize(points.size(), 0.0);
          for (std::size_t k = 0; k < points.size(); ++k)
            made.gradient[k] += changes.row(static_cast<Eigen::Index>(k)).transpose();
          corrected[p] = std::move(made);
        });
  }
  for (std::size_t p = 0; p < patches.cells.size(); ++p) {
    const bool is_corrected = !corrected.empty() && !corrected[p].points.empty();
    Stencil made = is_corrected ? std::move(corrected[p]) : stencil_of(body, patches, static_cast<int>(p));
    add_bonds_among(body.network.bonds, points_of(body, patches, static_cast<int>(p)), made.bonds);
    if (is_corrected)
      for (const int other : patches.behind_an_edge[p])
        add_bonds_among(body.network.bonds, points_of(body, patches, other), made.bonds);
    append(made, all);
  }
  return all;
}

std::vector<StencilSquare> squares_of(const CellStencils& stencils, std::size_t patch,
                                      const PlaneElasticity& elasticity) {
  if (is_bond_based(elasticity)) return {};
  const double lambda = elasticity.c12(), mu = elasticity.shear_modulus();
  const double size = elasticity.thickness * stencils.area[patch], root = std::sqrt(2.0) / stencils.area[patch];
  std::vector<StencilSquare> squares;
  const auto add = [&](double stiffness, const auto& pull_of) {
    StencilSquare& square = squares.emplace_back(StencilSquare{{}, stiffness});
    for (const Vector2d& g : stencils.gradients(patch)) square.pull.push_back(pull_of(g));
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
