#include "regions/boundary/cracked_part.hpp"

#include <algorithm>
#include <utility>

#include "bem/crack_forces.hpp"

namespace bempd::regions {

namespace {

// Ratio of two nodes' distances above which one node counts as farther than the other, so that rounding does not
// decide. Of nodes at nearly equal distances the first is taken.
constexpr double clearly_farther = 1 + 1e-6;

// Whether an operator belongs to the body with this mesh, these cracks and this elasticity.
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

Point traction_of(const LinearBodyForce& particular, const Point& x, const Point& normal) {
  const Eigen::Vector3d s = particular.stress(x);
  return {s[0] * normal.x() + s[2] * normal.y(), s[2] * normal.x() + s[1] * normal.y()};
}

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

std::vector<coupling::BodyPiece> CrackedPart::pieces(const std::function<int(int)>& node_at) const {
  const bem::CrackMesh& mesh_of_cracks = elements();
  if (mesh_of_cracks.pieces.count == 1) return {};
  const BoundaryMesh& mesh = body->mesh();
  const auto node_of = [&](std::size_t i) { return node_at(nodes.empty() ? static_cast<int>(i) : nodes[i]); };
  std::vector<int> piece_of(mesh.nodes.size(), 0);
  std::vector<char> on_face(mesh.nodes.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (const int node : mesh.elements[e].nodes) {
      piece_of[node] = mesh_of_cracks.pieces.of_element[e];
      if (mesh.elements[e].panel >= mesh_of_cracks.first_face_panel) on_face[node] = 1;
    }
  std::vector<coupling::BodyPiece> pieces(static_cast<std::size_t>(mesh_of_cracks.pieces.count));
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    // Nodes away from crack faces are preferred for springs that hold a piece, because contact depends on the
    // displacements of the faces.
    std::vector<std::size_t> those, beside_faces;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
      if (node_of(i) < 0 || piece_of[i] != static_cast<int>(p)) continue;
      pieces[p].nodes.push_back(node_of(i));
      those.push_back(i);
      if (!on_face[i]) beside_faces.push_back(i);
    }
    if (beside_faces.size() > 1) those.swap(beside_faces);
    const auto farthest_from = [&](std::size_t from) {
      std::size_t best = those.front();
      const auto way = [&](std::size_t i) { return (mesh.nodes[i] - mesh.nodes[from]).norm(); };
      for (const std::size_t i : those)
        if (way(i) > clearly_farther * way(best)) best = i;
      return best;
    };
    const std::size_t one = farthest_from(those.front()), other = farthest_from(one);
    pieces[p].holdable = {node_of(one), node_of(other)};
  }
  return pieces;
}

Eigen::VectorXd CrackedPart::forces_of(const bem::FaceTraction& traction) const {
  if (!traction) return Eigen::VectorXd::Zero(openings());
  return bem::crack_forces(elements(), traction, body->elasticity().thickness);
}

Eigen::VectorXd CrackedPart::forces_of(const LinearBodyForce& particular) const {
  const auto traction = [&](int, const Point& x, const Point& normal) { return traction_of(particular, x, normal); };
  return bem::crack_forces(elements(), traction, body->elasticity().thickness);
}

Eigen::MatrixX2d CrackedPart::forces_of(const std::vector<CrackLoad>& loads) const {
  Eigen::MatrixX2d forces(openings(), 2);
  forces << forces_of(cracks->traction(loads, 1, 0)), forces_of(cracks->traction(loads, 0, 1));
  return forces;
}

Eigen::VectorXd CrackedPart::on_boundary(const bem::FaceTraction& traction) const {
  Eigen::VectorXd forces = body->forces_on_boundary(forces_of(traction));
  bem::add_forces_on_cuts(body->mesh(), elements(), traction, body->elasticity().thickness, forces);
  return forces;
}

coupling::Affine CrackedPart::gaps(const Eigen::MatrixX2d& displacements, const Eigen::MatrixX2d& forces) const {
  coupling::Affine gaps = coupling::Affine::Zero(static_cast<Eigen::Index>(constraints()), 2);
  if (forces.isZero(0) && displacements.isZero(0)) return gaps;
  const Eigen::MatrixXd open = body->openings(displacements, forces);
  for (int column = 0; column < 2; ++column) gaps.col(column) = closing->gaps(open.col(column));
  return gaps;
}

std::shared_ptr<const coupling::ExactConstraints> CrackedPart::constraints_for(
    const Eigen::SparseMatrix<double>& trace) const {
  if (!closing) return nullptr;
  return std::make_shared<const coupling::ExactConstraints>(
      coupling::ExactConstraints{closing->of_displacements() * trace, closing->of_forces(), closing->places(*body)});
}

bem::CrackedState CrackedPart::state(const Eigen::VectorXd& displacements, bem::FaceTraction traction,
                                     const std::vector<char>& closed) const {
  bem::CrackedState state;
  state.displacements = own(displacements);
  state.openings = body->openings(state.displacements, forces_of(traction));
  state.face_traction = std::move(traction);
  if (closing) {
    state.closed = closing->closed_nodes(closed);
    if (!closed.empty()) state.openings = closing->held_shut(state.openings, closed);
  }
  state.tractions = body->tractions(state.displacements, state.openings);
  return state;
}

Eigen::Matrix2d CrackedPart::work_of(const Eigen::MatrixX2d& forces, const Particulars& particular) const {
  Eigen::Matrix2d work = Eigen::Matrix2d::Zero();
  if (!forces.isZero(0)) {
    const Eigen::MatrixXd held = Eigen::MatrixXd::Zero(2 * static_cast<Eigen::Index>(body->mesh().nodes.size()), 2);
    work = forces.transpose() * body->openings(held, forces);
  }
  if (particular.displacements.isZero(0) && particular.face_forces.isZero(0)) return work;
  const Eigen::MatrixXd open = body->openings(particular.displacements, particular.face_forces);
  const Eigen::Matrix2d mixed = forces.transpose() * open;
  return work + open.transpose() * particular.face_forces - mixed - mixed.transpose();
}

}  // namespace bempd::regions
