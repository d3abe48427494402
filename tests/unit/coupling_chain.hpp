#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "dense.hpp"

// A small coupled system with its dense solution.
namespace bempd::test {

using namespace coupling;

// Nodes 0 1 2 carry a dense operator, nodes 2 3 4 bonds; node 2 is shared.
struct Chain {
  static constexpr int nodes = 5;
  DenseOperator op{{0, 1, 2}, {}};
  Terms bonds;
  std::vector<char> prescribed = std::vector<char>(2 * nodes, 0);

  Chain() {
    const Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(6, 6, [](Eigen::Index i, Eigen::Index j) {
      return std::sin(static_cast<double>(3 * i * j + i * i + 7 * j + 1));
    });
    op.stiffness = std::make_shared<const Eigen::MatrixXd>(a * a.transpose() + Eigen::MatrixXd::Identity(6, 6));
    bond(2, 3, 1, 0, 3.0);
    bond(2, 3, 0.6, 0.8, 2.0);
    bond(3, 4, 1, 0, 5.0);
    bond(3, 4, 0, 1, 4.0);
    bond(2, 4, 0.8, -0.6, 1.5);
    prescribed[0] = prescribed[9] = 1;
  }
  void bond(int i, int j, double c, double s, double k) {
    bonds.first.push_back(i);
    bonds.second.push_back(j);
    bonds.cosine.push_back(c);
    bonds.sine.push_back(s);
    bonds.length.push_back(1);
    bonds.stiffness.push_back(k);
  }
  Eigen::MatrixXd full(const std::vector<char>& intact) const {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(10, 10);
    matrix.topLeftCorner(6, 6) = *op.stiffness;
    for (std::size_t b = 0; b < bonds.size(); ++b) {
      if (!intact[b]) continue;
      Eigen::VectorXd d = Eigen::VectorXd::Zero(10);
      d.segment<2>(2 * bonds.first[b]) = Eigen::Vector2d(-bonds.cosine[b], -bonds.sine[b]);
      d.segment<2>(2 * bonds.second[b]) = Eigen::Vector2d(bonds.cosine[b], bonds.sine[b]);
      matrix += bonds.stiffness[b] * d * d.transpose();
    }
    return matrix;
  }
};

inline Affine expected_solution(const Chain& chain, const std::vector<char>& intact, const Affine& force,
                                const Affine& given) {
  const Eigen::MatrixXd k = chain.full(intact);
  std::vector<int> free;
  for (int dof = 0; dof < 10; ++dof) {
    if (!chain.prescribed[dof]) free.push_back(dof);
  }
  Affine u = given;
  const Affine rhs = force - k * given;
  const Affine solved = dense::solve(k(free, free), rhs(free, Eigen::all));
  for (std::size_t i = 0; i < free.size(); ++i) u.row(free[i]) = solved.row(static_cast<Eigen::Index>(i));
  return u;
}

}  // namespace bempd::test
