#include "bem/normal_openings.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "geometry/turning.hpp"

namespace bempd::bem {

namespace {

// Elements that turn by less at a node have one normal there, that of a smooth face: cosine of some 26 degrees.
constexpr double smooth_turn = 0.9;

// One less the cosine of gaps that are the same.
constexpr double same_direction = 1e-10;

}  // namespace

// One for every node and element; elements that hardly turn at a node share it.
void NormalOpenings::add_places(const CrackMesh& cracks) {
  std::vector<std::vector<Point>> normals(cracks.nodes.size());
  for (const CrackElement& e : cracks.elements) {
    const Point normal = left_of((cracks.nodes[e.nodes[2]] - cracks.nodes[e.nodes[0]]).normalized());
    for (const int node : e.nodes) {
      std::vector<Point>& known = normals[node];
      if (known.empty() || known.back().dot(normal) < smooth_turn) {
        known.push_back(normal);
      } else {
        known.back() = (known.back() + normal).normalized();
      }
    }
  }
  // Tips do not open.
  std::vector<char> opens(cracks.nodes.size(), 0);
  for (Eigen::Index column = 0; column < cracks.constraint.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator i(cracks.constraint, column); i; ++i) opens[i.row() / 2] = 1;
  for (std::size_t node = 0; node < normals.size(); ++node)
    for (const Point& normal : normals[node])
      if (opens[node]) places_.push_back({static_cast<int>(node), normal});
}

Eigen::MatrixXd NormalOpenings::normals() const {
  Eigen::MatrixXd normals = Eigen::MatrixXd::Zero(components_, static_cast<Eigen::Index>(places_.size()));
  for (std::size_t i = 0; i < places_.size(); ++i)
    normals.col(static_cast<Eigen::Index>(i)).segment<2>(2 * places_[i].node) = places_[i].normal;
  return normals;
}

void NormalOpenings::drop_doubles(const CrackMesh& cracks) {
  std::vector<Eigen::VectorXd> at_joints;
  std::vector<Place> kept;
  for (const Place& place : places_) {
    if (cracks.joint_of_node[place.node] >= 0) {
      Eigen::VectorXd own = Eigen::VectorXd::Zero(components_);
      own.segment<2>(2 * place.node) = place.normal;
      const Eigen::VectorXd gap = cracks.constraint.transpose() * own;
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
  drop_doubles(body.cracks());
  const auto count = static_cast<Eigen::Index>(places_.size());
  const Eigen::Index u = body.stiffness().rows(), w = body.full_stiffness().rows() - u;
  const Eigen::MatrixXd normals = this->normals();
  const Eigen::MatrixXd of_unknowns = body.cracks().constraint.transpose() * normals;  // C^T
  Eigen::MatrixXd unknowns = Eigen::MatrixXd::Zero(u + w, count);
  unknowns.bottomRows(w) = body.opening_response(of_unknowns.bottomRows(w));
  response_ = body.cracks().constraint * unknowns;
  of_forces_ = normals.transpose() * response_;
  of_displacements_ = of_unknowns.topRows(u).transpose() -
                      unknowns.bottomRows(w).transpose() * body.full_stiffness().bottomLeftCorner(w, u);
}

Eigen::VectorXd NormalOpenings::gaps(const Eigen::VectorXd& openings) const {
  Eigen::VectorXd gaps(static_cast<Eigen::Index>(places_.size()));
  for (std::size_t i = 0; i < places_.size(); ++i)
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
  // What is left is rounding.
  for (std::size_t i = 0; i < closed.size(); ++i) {
    if (!closed[i]) continue;
    const Place& place = places_[i];
    result.segment<2>(2 * place.node) -= place.normal.dot(result.segment<2>(2 * place.node)) * place.normal;
  }
  return result;
}

std::vector<char> NormalOpenings::closed_nodes(const std::vector<char>& closed) const {
  std::vector<char> nodes(static_cast<std::size_t>(components_ / 2), 0);
  for (std::size_t i = 0; i < closed.size(); ++i)
    if (closed[i]) nodes[places_[i].node] = 1;
  return nodes;
}

}  // namespace bempd::bem
