#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "linalg/sparse_factorization.hpp"

namespace bempd::test {

using SparseMatrix = Eigen::SparseMatrix<double>;

struct Spring {
  std::array<int, 2> node;
  Eigen::Vector2d direction;  // unit vector times the square root of the stiffness
};

// Two-dimensional network of springs between the points of an n x n lattice that are closer than `horizon` spacings;
// every point also hangs on a weak spring of stiffness `ground` in both directions.
class SpringLattice {
 public:
  SpringLattice(int n, int horizon, double ground) : n_(n), ground_(ground) {
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        for (int b = 0; b <= horizon; ++b)
          for (int a = b == 0 ? 1 : -horizon; a <= horizon; ++a) {
            if (a * a + b * b >= horizon * horizon || x + a < 0 || x + a >= n || y + b >= n) continue;
            const double length = std::hypot(a, b);
            springs.push_back(
                {{y * n + x, (y + b) * n + x + a}, Eigen::Vector2d(a, b) / length * std::sqrt(1 / length)});
          }
  }

  int dof_count() const { return 2 * n_ * n_; }

  // One column a spring, so that the stiffness is C C^T plus the ground springs.
  SparseMatrix columns(const std::vector<int>& which) const {
    std::vector<Eigen::Triplet<double>> entries;
    for (int k = 0; k < static_cast<int>(which.size()); ++k) {
      const Spring& spring = springs[which[k]];
      for (int axis = 0; axis < 2; ++axis) {
        entries.emplace_back(2 * spring.node[0] + axis, k, spring.direction[axis]);
        entries.emplace_back(2 * spring.node[1] + axis, k, -spring.direction[axis]);
      }
    }
    SparseMatrix out(dof_count(), static_cast<int>(which.size()));
    out.setFromTriplets(entries.begin(), entries.end());
    return out;
  }

  // Full matrix of the springs that are not broken; broken ones stay in the pattern as zeros.
  SparseMatrix stiffness(const std::vector<char>& broken) const {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < dof_count(); ++i) entries.emplace_back(i, i, ground_);
    for (std::size_t s = 0; s < springs.size(); ++s) {
      const Spring& spring = springs[s];
      const Eigen::Matrix2d block = (broken[s] ? 0.0 : 1.0) * spring.direction * spring.direction.transpose();
      for (int p = 0; p < 2; ++p)
        for (int q = 0; q < 2; ++q)
          for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j)
              entries.emplace_back(2 * spring.node[p] + i, 2 * spring.node[q] + j, (p == q ? 1 : -1) * block(i, j));
    }
    SparseMatrix out(dof_count(), dof_count());
    out.setFromTriplets(entries.begin(), entries.end());
    return out;
  }

  std::vector<char> intact() const { return std::vector<char>(springs.size(), 0); }

  std::vector<Spring> springs;

 private:
  int n_;
  double ground_;
};

inline SparseMatrix lower_triangle(const SparseMatrix& matrix) { return matrix.triangularView<Eigen::Lower>(); }

// Numbers 0..count-1 in an order that depends on the seed only.
inline std::vector<int> shuffled(int count, unsigned seed) {
  std::vector<int> out(count);
  std::mt19937 random(seed);
  for (int i = 0; i < count; ++i) {
    out[i] = i;
    std::swap(out[i], out[random() % (static_cast<unsigned>(i) + 1)]);
  }
  return out;
}

inline Eigen::VectorXd waves(int count) {
  return Eigen::VectorXd::NullaryExpr(count, [](Eigen::Index i) { return std::sin(1.0 + 0.7 * double(i)); });
}

inline double relative_difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

inline Eigen::VectorXd solve(const linalg::SparseFactorization& factor, Eigen::VectorXd rhs) {
  factor.solve_in_place(rhs);
  return rhs;
}

// Spring lattice whose last `block` unknowns also meet in a dense unsymmetric block, and whose rows have been
// multiplied by wildly different units: what boundary elements in terms of tractions and bonds give together.
inline SparseMatrix unsymmetric_lattice(const SpringLattice& lattice, const std::vector<char>& broken, int block) {
  const int n = lattice.dof_count();
  std::mt19937 random(17);
  std::uniform_real_distribution<double> value(-1, 1);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = n - block; i < n; ++i)
    for (int j = n - block; j < n; ++j) entries.emplace_back(i, j, (i == j ? 2.0 : 0.0) + value(random) / block);
  SparseMatrix dense(n, n);
  dense.setFromTriplets(entries.begin(), entries.end());
  SparseMatrix sum = lattice.stiffness(broken) + dense;
  const auto unit = [n, block](int row) { return row < n - block ? 1.0 : 1e-9; };
  for (int j = 0; j < n; ++j)
    for (SparseMatrix::InnerIterator it(sum, j); it; ++it) it.valueRef() *= unit(static_cast<int>(it.row()));
  return sum;
}

}  // namespace bempd::test
