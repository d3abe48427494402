#pragma once

#include <Eigen/Core>
#include <array>
#include <numbers>
#include <vector>

#include "bem/galerkin_assembly.hpp"
#include "bem/pair_integrals.hpp"

namespace bempd::bem {

// Blocks of the Galerkin matrices from a pair of elements: the outer one with points x and nodes a, the inner one with
// points y and nodes b. The functions are in the header for inlining, because calls would cost as much as the sums.
class PairBlocks {
 public:
  PairBlocks(const std::vector<GalerkinElement>& elements, double nu, double quadrature_tolerance);

  PairMoments moments(int outer, int inner, PairPart part) const;

  // Block of the single layer. For an element paired with itself it is half the block, because the transpose is added
  // later.
  Eigen::Matrix2d single_layer(int outer, int inner, const PairMoments& m, int a, int b) const {
    const double single = (outer == inner ? 0.5 : 1.0) * single_;
    // The trace part 1/2 of e e^T, where e = r / |r|, gives a product of integrals. In the hypersingular block this
    // part vanishes in the sum over closed loops.
    const double trace = 0.5 * node_lengths_[outer][a] * node_lengths_[inner][b];
    return single * symmetric_block(trace - (3 - 4 * nu_) * m.mass[0][b][a], m.mass[1][b][a], m.mass[2][b][a]);
  }

  Eigen::Matrix2d hypersingular(int outer, int inner, const PairMoments& m, int a, int b) const {
    const double hyper = (outer == inner ? 0.5 : 1.0) * hyper_;
    return hyper * symmetric_block(-m.derivative[0][b][a], m.derivative[1][b][a], m.derivative[2][b][a]);
  }

  // Transposed block of the double layer; `b` numbers the nodes of the inner and then of the outer element, as in
  // PairMoments::double_layer.
  Eigen::Matrix2d double_layer(const PairMoments& m, int a, int b) const {
    const auto& moment = m.double_layer;
    const double rotation = (1 - 2 * nu_) * moment[1][b][a];
    Eigen::Matrix2d transposed =
        symmetric_block((2 - 2 * nu_) * moment[0][b][a], 2 * moment[2][b][a], 2 * moment[3][b][a]);
    transposed(1, 0) += rotation;
    transposed(0, 1) -= rotation;
    return double_ * transposed;
  }

 private:
  // Matrix isotropic * I + (cosine, sine; sine, -cosine).
  static Eigen::Matrix2d symmetric_block(double isotropic, double cosine, double sine) {
    Eigen::Matrix2d block;
    block << isotropic + cosine, sine, sine, isotropic - cosine;
    return block;
  }

  const std::vector<GalerkinElement>& elements_;
  double nu_;
  double single_ = 1 / (8 * std::numbers::pi * (1 - nu_));
  double hyper_ = 1 / (2 * std::numbers::pi * (1 - nu_));
  double double_ = -1 / (4 * std::numbers::pi * (1 - nu_));
  PairIntegrator integrator_;
  std::vector<std::array<double, 3>> node_lengths_;
};

}  // namespace bempd::bem
