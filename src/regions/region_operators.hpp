#pragma once

#include <optional>
#include <span>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/operators.hpp"

namespace bempd::regions {

// Nodes of a dense operator, and their rest displacements; without rows if the region does not swell.
struct OperatorNodes {
  std::vector<int> nodes;
  coupling::Affine rest;
};

struct KnownOperator {
  const class RegionOperators* owner;
  coupling::DenseOperator dense;
};

// Dense operators of a region: its stiffness on its nodes.
class RegionOperators {
 public:
  virtual ~RegionOperators() = default;

  // Dense operators with the region's stiffness on its nodes. A region equal to one in `before` takes its matrix, which
  // is then stored once.
  virtual std::vector<coupling::DenseOperator> dense_operators(std::span<const KnownOperator> before) const = 0;
  virtual std::size_t count() const = 0;  // of dense operators
  // Nodes of each dense operator and their displacements in the stress-free, swollen state, in the same order.
  virtual std::vector<OperatorNodes> nodes_of_operators() const = 0;
  // Volume that flows out of an incompressible region per displacement of each degree of freedom; empty otherwise.
  virtual std::optional<Eigen::VectorXd> outflow(Eigen::Index dof_count) const = 0;
  // Estimated memory [B] that preparing takes with `times` as many elements.
  virtual double memory_of_preparing(double times) const = 0;
};

}  // namespace bempd::regions
