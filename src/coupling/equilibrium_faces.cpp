// Contact of crack faces inside a system's operators.
#include <algorithm>

#include "coupling/equilibrium_system.hpp"

namespace bempd::coupling {

// Calls visit(operator, number of its first place).
template <class Visit>
void EquilibriumSystem::for_each_with_faces(const Visit& visit) const {
  std::size_t first = 0;
  for (const OperatorSchurComplement& op : operators_) {
    if (op.face_count() > 0) visit(op, first);
    first += op.face_count();
  }
}

// Closes and opens the faces of the operators as the system knows them.
void EquilibriumSystem::close_faces() {
  std::size_t first = 0;
  for (OperatorSchurComplement& op : operators_) {
    const auto begin = closed_faces_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto count = static_cast<std::ptrdiff_t>(op.face_count());
    if (count > 0) {
      op.set_face_offsets(face_offsets_.middleRows(static_cast<Eigen::Index>(first), count));
      op.close_faces({begin, begin + count});
    }
    first += op.face_count();
  }
}

void EquilibriumSystem::set_closed_faces(const std::vector<char>& closed) {
  if (closed == closed_faces_) return;
  condense();
  closed_faces_ = closed;
  closed_face_count_ = static_cast<std::size_t>(std::count(closed.begin(), closed.end(), 1));
  close_faces();
  forget_factor();
  condensed_ = Condensed::operators;
  if (closed_face_count_ > 0) condense_load();
}

void EquilibriumSystem::switch_faces(std::span<const int> places) {
  std::vector<char> closed = closed_faces_;
  for (const int place : places) closed[static_cast<std::size_t>(place)] ^= 1;
  set_closed_faces(closed);
}

void EquilibriumSystem::exchange_face_offsets(Affine& others) noexcept {
  face_offsets_.swap(others);
  std::size_t first = 0;
  for (OperatorSchurComplement& op : operators_) {
    const auto count = static_cast<Eigen::Index>(op.face_count());
    if (count > 0) op.set_face_offsets(face_offsets_.middleRows(static_cast<Eigen::Index>(first), count));
    first += op.face_count();
  }
  if (condensed_ == Condensed::operators_and_load) condensed_ = Condensed::operators;
}

Affine EquilibriumSystem::face_gaps(const Affine& displacement) const {
  Affine gaps = Affine::Zero(static_cast<Eigen::Index>(face_count()), 2);
  for_each_with_faces([&](const OperatorSchurComplement& op, std::size_t first) {
    gaps.middleRows(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(op.face_count())) =
        op.face_gaps(displacement);
  });
  return gaps;
}

Eigen::VectorXd EquilibriumSystem::open_gaps(const Eigen::VectorXd& displacement, double load_factor) const {
  Eigen::VectorXd gaps = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(face_count()));
  for_each_with_faces([&](const OperatorSchurComplement& op, std::size_t first) {
    gaps.segment(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(op.face_count())) =
        op.open_gaps(displacement, load_factor);
  });
  return gaps;
}

Eigen::VectorXd EquilibriumSystem::face_forces(const Eigen::VectorXd& displacement, double load_factor) const {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(face_count()));
  for_each_with_faces([&](const OperatorSchurComplement& op, std::size_t first) {
    forces.segment(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(op.face_count())) =
        op.face_forces(displacement, load_factor);
  });
  return forces;
}

double EquilibriumSystem::work_at_closed_faces(const Eigen::VectorXd& displacement, double load_factor) const {
  double sum = 0;
  for_each_with_faces([&](const OperatorSchurComplement& op, std::size_t /*first*/) {
    sum += op.work_at_closed_faces(displacement, load_factor);
  });
  return sum;
}

std::vector<char> EquilibriumSystem::closed_faces_on(const std::vector<int>& nodes) const {
  std::vector<char> closed;
  for_each_with_faces([&](const OperatorSchurComplement& op, std::size_t first) {
    const auto begin = closed_faces_.begin() + static_cast<std::ptrdiff_t>(first);
    if (op.is_on(nodes)) closed.assign(begin, begin + static_cast<std::ptrdiff_t>(op.face_count()));
  });
  return closed;
}

Eigen::VectorXd EquilibriumSystem::gap_function(std::size_t place) const {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(2 * node_count_);
  for_each_with_faces([&](const OperatorSchurComplement& op, std::size_t first) {
    if (place >= first && place < first + op.face_count()) op.add_gap_function(place - first, weights);
  });
  return weights;
}

}  // namespace bempd::coupling
