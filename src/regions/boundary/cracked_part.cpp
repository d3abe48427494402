#include "regions/boundary/cracked_part.hpp"

#include <algorithm>

namespace bempd::regions {

namespace {

// Whether an operator is the one of this body with these cracks.
bool is_of(const bem::CrackedOperator& body, const BoundaryMesh& mesh, const bem::CrackMesh& cracks,
           const PlaneElasticity& elasticity) {
  const auto same_boundary = [](const BoundaryElement& a, const BoundaryElement& b) {
    return a.nodes == b.nodes && a.traction_nodes == b.traction_nodes && a.sweep == b.sweep;
  };
  const auto same_element = [](const bem::CrackElement& a, const bem::CrackElement& b) {
    return a.nodes == b.nodes && a.line == b.line && a.tip == b.tip && a.piece == b.piece;
  };
  const auto alike = [](const auto& a, const auto& b, const auto& same) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
  };
  return body.elasticity() == elasticity && body.mesh().nodes == mesh.nodes && body.cracks().nodes == cracks.nodes &&
         alike(body.mesh().elements, mesh.elements, same_boundary) &&
         alike(body.cracks().elements, cracks.elements, same_element) &&
         body.cracks().mouth_of_joint == cracks.mouth_of_joint && body.cracks().joint_of_node == cracks.joint_of_node;
}

}  // namespace

void CrackedPart::build(const BoundaryMesh& mesh, const PlaneElasticity& elasticity,
                        const bem::AssemblyOptions& assembly, bool faces_close, const CrackedPart* before) {
  if (before && is_of(*before->body, mesh, elements(), elasticity)) {
    body = before->body;
    if (faces_close) closing = before->closing;
  } else {
    body = std::make_shared<const bem::CrackedOperator>(mesh, elements(), elasticity, assembly,
                                                        before ? before->body.get() : nullptr);
  }
  if (faces_close && !closing) closing = std::make_shared<const bem::NormalOpenings>(*body);
}

bool CrackedPart::shares_crack_with(const CrackedPart& other) const {
  const std::vector<int> ids = cracks->ids();
  return std::any_of(ids.begin(), ids.end(), [&](int id) { return other.cracks->has(id); });
}

Eigen::MatrixXd CrackedPart::own(const Eigen::MatrixXd& all) const {
  if (nodes.empty()) return all;
  Eigen::MatrixXd rows(2 * static_cast<Eigen::Index>(nodes.size()), all.cols());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    rows.middleRows<2>(2 * static_cast<Eigen::Index>(i)) = all.middleRows<2>(2 * nodes[i]);
  return rows;
}

void CrackedPart::add(const Eigen::VectorXd& own, Eigen::VectorXd& all) const {
  if (nodes.empty()) {
    all += own;
    return;
  }
  for (std::size_t i = 0; i < nodes.size(); ++i)
    all.segment<2>(2 * nodes[i]) += own.segment<2>(2 * static_cast<Eigen::Index>(i));
}

}  // namespace bempd::regions
