#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "bem/crack_tips.hpp"
#include "bem/cracked_operator.hpp"
#include "bem/normal_openings.hpp"
#include "regions/boundary/meshed_cracks.hpp"

namespace bempd::regions {

// Part of a boundary element region with cracks that has an operator of its own: the whole region, or a subdomain.
struct CrackedPart {
  std::unique_ptr<const MeshedCracks> cracks;
  std::size_t subdomain = 0;
  std::vector<int> nodes;  // of each of its nodes: the number among the region's places; empty for the whole region
  std::shared_ptr<const bem::CrackedOperator> body;
  std::shared_ptr<const bem::NormalOpenings> closing;  // null unless cracks close

  // Builds the operator, and what closes the faces if `faces_close`. What it has in common with `before` (null: none),
  // the part with shorter cracks, is taken from there.
  void build(const BoundaryMesh& mesh, const PlaneElasticity& elasticity, const bem::AssemblyOptions& assembly,
             bool faces_close, const CrackedPart* before);
  // Whether a crack has elements in both parts.
  bool shares_crack_with(const CrackedPart& other) const;

  const bem::CrackMesh& elements() const { return cracks->elements(); }
  Eigen::Index openings() const { return 2 * static_cast<Eigen::Index>(elements().nodes.size()); }
  std::size_t constraints() const { return closing ? closing->size() : 0; }
  // Rows of its nodes, of values at all places of the region.
  Eigen::MatrixXd own(const Eigen::MatrixXd& all) const;
  // Adds values at its nodes to those at all places.
  void add(const Eigen::VectorXd& own, Eigen::VectorXd& all) const;
};

}  // namespace bempd::regions
