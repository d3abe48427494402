#pragma once

#include <optional>
#include <span>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/operators.hpp"

namespace bempd::regions {

// Nodes of a dense operator, and their displacements in the free, swollen state (`rest`), without rows if the region
// does not swell.
struct OperatorNodes {
  std::vector<int> nodes;
  coupling::Affine rest;
};

struct KnownOperator {
  const class RegionOperators* owner;
  coupling::DenseOperator dense;
};

// Dense operators of a region: stiffness matrices on its nodes.
class RegionOperators {
 public:
  virtual ~RegionOperators() = default;

  // Makes the dense operators of the region. If an operator in `before` is equal, both use its matrix, which is stored
  // once.
  virtual std::vector<coupling::DenseOperator> dense_operators(std::span<const KnownOperator> before) const = 0;
  virtual std::size_t count() const = 0;  // number of dense operators
  // Nodes of each dense operator and their rest displacements, in the order of dense_operators().
  virtual std::vector<OperatorNodes> nodes_of_operators() const = 0;
  // Volume that flows out of an incompressible region per displacement of each degree of freedom; empty if the region's
  // volume can change.
  virtual std::optional<Eigen::VectorXd> outflow(Eigen::Index dof_count) const = 0;
  // Estimated memory [B] that preparing the region takes with `times` as many elements.
  virtual double memory_of_preparing(double times) const = 0;
};

}  // namespace bempd::regions
