#include "bem/normal_openings.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "geometry/turning.hpp"

namespace bempd::bem {

namespace {

// Cosine of the angle between the normals of two elements at a node (some 26 degrees) from which the face counts as
// smooth: the node then has one mean normal.
constexpr double smooth_turn = 0.9;

// Limit on 1 - cosine of the angle between the weight vectors of two gaps at joints (gap_function()); below the limit
// the gaps count as the same.
constexpr double same_direction = 1e-10;

}  // namespace

namespace {

// Adds the normal of an element to the list `known` of the normals of its node. If the normal hardly turns from the
// last known normal, their mean replaces the last one instead.
void add_normal(const Point& normal, std::vector<Point>& known) {
  if (known.empty() || known.back().dot(normal) < smooth_turn) {
    known.push_back(normal);
  } else {
    known.back() = (known.back() + normal).normalized();
  }
}

}  // namespace

void NormalOpenings::add_places(const CrackMesh& cracks) {
  std::vector<std::vector<Point>> normals(cracks.nodes.size());
  for (const CrackElement& e : cracks.elements) {
    const Point normal = left_of((cracks.nodes[e.nodes[2]] - cracks.nodes[e.nodes[0]]).normalized());
    for (const int node : e.nodes) add_normal(normal, normals[node]);
  }
  // Tips have no gap, because their openings are zero.
  std::vector<char> opens(cracks.nodes.size(), 0);
  for (Eigen::Index column = 0; column < cracks.constraint.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator i(cracks.constraint, column); i; ++i) opens[i.row() / 2] = 1;
  for (std::size_t node = 0; node < normals.size(); ++node)
    for (const Point& normal : normals[node])
      if (opens[node]) places_.push_back({static_cast<int>(node), normal, -1, -1, cracks.joint_of_node[node] >= 0});
}

void NormalOpenings::add_places_on_cuts(const BoundaryMesh& mesh, const CrackMesh& cracks) {
  for (std::size_t first = 0, next = 0; first < cracks.cuts.size(); first = next) {
    while (next < cracks.cuts.size() && cracks.cuts[next].line == cracks.cuts[first].line) ++next;
    std::vector<std::vector<Point>> normals(2 * (next - first) + 1);
    for (std::size_t e = first; e < next; ++e) {
      const CutElement& cut = cracks.cuts[e];
      const Point normal = left_of((mesh.nodes[cut.left[2]] - mesh.nodes[cut.left[0]]).normalized());
      for (std::size_t k = 0; k < 3; ++k) add_normal(normal, normals[2 * (e - first) + k]);
    }
    for (std::size_t n = 0; n < normals.size(); ++n) {
      const CutElement& cut = cracks.cuts[std::min(first + n / 2, next - 1)];
      const std::size_t k = n + 1 == normals.size() ? 2 : n % 2;
      const bool at_joint = n == 0 || n + 1 == normals.size();
      for (const Point& normal : normals[n]) places_.push_back({-1, normal, cut.left[k], cut.right[k], at_joint});
    }
  }
}

Eigen::VectorXd NormalOpenings::gap_function(const CrackMesh& cracks, const Place& place) const {
  if (place.node >= 0) {
    Eigen::VectorXd own = Eigen::VectorXd::Zero(components_);
    own.segment<2>(2 * place.node) = place.normal;
    return cracks.constraint.transpose() * own;
  }
  Eigen::VectorXd gap = Eigen::VectorXd::Zero(cracks.constraint.cols());
  gap.segment<2>(2 * place.left) = place.normal;
  gap.segment<2>(2 * place.right) = -place.normal;
  return gap;
}

Eigen::MatrixXd NormalOpenings::normals() const {
  Eigen::MatrixXd normals = Eigen::MatrixXd::Zero(components_, static_cast<Eigen::Index>(places_.size()));
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (places_[i].node >= 0)
      normals.col(static_cast<Eigen::Index>(i)).segment<2>(2 * places_[i].node) = places_[i].normal;
  return normals;
}

void NormalOpenings::drop_doubles(const CrackMesh& cracks) {
  std::vector<Eigen::VectorXd> at_joints;
  std::vector<Place> kept;
  for (const Place& place : places_) {
    if (place.at_joint) {
      const Eigen::VectorXd gap = gap_function(cracks, place);
      const auto same = [&](const Eigen::VectorXd& other) {
        return gap.dot(other) > (1 - same_direction) * gap.norm() * other.norm();
      };
      if (std::any_of(at_joints.begin(), at_joints.end(), same)) continue;
      at_joints.push_back(gap);
    }
    kept.push_back(place);
  }
  places_.swap(kept);
}

NormalOpenings::NormalOpenings(const CrackedOperator& body)
    : components_(2 * static_cast<Eigen::Index>(body.cracks().nodes.size())) {
  add_places(body.cracks());
  add_places_on_cuts(body.mesh(), body.cracks());
  drop_doubles(body.cracks());
  const auto count = static_cast<Eigen::Index>(places_.size());
  const Eigen::Index u = body.stiffness().rows(), w = body.full_stiffness().rows() - u;
  const Eigen::MatrixXd normals = this->normals();
  Eigen::MatrixXd of_unknowns = body.cracks().constraint.transpose() * normals;  // C^T
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (places_[i].node < 0) of_unknowns.col(static_cast<Eigen::Index>(i)) = gap_function(body.cracks(), places_[i]);
  Eigen::MatrixXd unknowns = Eigen::MatrixXd::Zero(u + w, count);
  unknowns.bottomRows(w) = body.opening_response(of_unknowns.bottomRows(w));
  response_ = body.cracks().constraint * unknowns;
  of_forces_ = normals.transpose() * response_;
  of_displacements_ = of_unknowns.topRows(u).transpose() -
                      unknowns.bottomRows(w).transpose() * body.full_stiffness().bottomLeftCorner(w, u);
}

std::vector<Point> NormalOpenings::places(const CrackedOperator& body) const {
  std::vector<Point> places;
  for (const Place& place : places_)
    places.push_back(place.node >= 0 ? body.cracks().nodes[place.node] : body.mesh().nodes[place.left]);
  return places;
}

Eigen::VectorXd NormalOpenings::gaps(const Eigen::VectorXd& openings) const {
  Eigen::VectorXd gaps = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(places_.size()));
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (places_[i].node >= 0)
      gaps[static_cast<Eigen::Index>(i)] = places_[i].normal.dot(openings.segment<2>(2 * places_[i].node));
  return gaps;
}

Eigen::VectorXd NormalOpenings::held_shut(const Eigen::VectorXd& openings, const std::vector<char>& closed) const {
  std::vector<Eigen::Index> held;
  for (std::size_t i = 0; i < closed.size(); ++i) {
    const auto place = static_cast<Eigen::Index>(i);
    if (closed[i] && of_forces_(place, place) > 0) held.push_back(place);
  }
  Eigen::VectorXd result = openings;
  if (!held.empty()) {
    const Eigen::VectorXd own = gaps(openings)(held);
    const Eigen::VectorXd forces = of_forces_(held, held).ldlt().solve(-own);
    result += response_(Eigen::all, held) * forces;
  }
  // The normal opening that is left at closed places is a rounding error, and is removed.
  for (std::size_t i = 0; i < closed.size(); ++i) {
    if (!closed[i] || places_[i].node < 0) continue;
    const Place& place = places_[i];
    result.segment<2>(2 * place.node) -= place.normal.dot(result.segment<2>(2 * place.node)) * place.normal;
  }
  return result;
}

std::vector<char> NormalOpenings::closed_nodes(const std::vector<char>& closed) const {
  std::vector<char> nodes(static_cast<std::size_t>(components_ / 2), 0);
  for (std::size_t i = 0; i < closed.size(); ++i)
    if (closed[i] && places_[i].node >= 0) nodes[places_[i].node] = 1;
  return nodes;
}

}  // namespace bempd::bem
