#pragma once

#include <vector>

#include "bem/galerkin_assembly.hpp"
#include "bem/pair_integrals.hpp"

namespace bempd::bem {

// Blocks of the Galerkin matrices that two elements give, x on the outer one and y on the inner one, by the nodes a of
// the outer and b of the inner one.
class PairBlocks {
 public:
  PairBlocks(const std::vector<GalerkinElement>& elements, double nu, double quadrature_tolerance);

  PairMoments moments(int outer, int inner, PairPart part) const;

  // Half of the blocks of an element with itself: they come back with the transpose.
  Eigen::Matrix2d single_layer(int outer, int inner, const PairMoments& moments, int a, int b) const;
  Eigen::Matrix2d hypersingular(int outer, int inner, const PairMoments& moments, int a, int b) const;
  // Transposed; b as in PairMoments::double_layer.
  Eigen::Matrix2d double_layer(const PairMoments& moments, int a, int b) const;

 private:
  const std::vector<GalerkinElement>& elements_;
  double nu_;
  PairIntegrator integrator_;
  std::vector<std::array<double, 3>> node_lengths_;
};

}  // namespace bempd::bem
