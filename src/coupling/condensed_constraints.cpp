// Exact unilateral constraints of all dense operators together (a part of CondensedOperators).
#include <limits>

#include "coupling/condensed_operators.hpp"
#include "geometry/box_tree.hpp"

namespace bempd::coupling {

namespace {

// Calls visit(operator, number of the operator's first constraint, count of its constraints) for all operators with
// constraints.
template <class Operators, class Visit>
void for_each_constrained(Operators& operators, const Visit& visit) {
  Eigen::Index first = 0;
  for (auto& op : operators) {
    const auto count = static_cast<Eigen::Index>(op.constraint_count());
    if (count > 0) visit(op, first, count);
    first += count;
  }
}

}  // namespace

std::vector<char> CondensedOperators::closed_as_in(const CondensedOperators& before,
                                                   const std::vector<char>& closed) const {
  std::vector<char> found(static_cast<std::size_t>(constraint_count()), 0);
  std::vector<Point> places;
  std::vector<Box> boxes;
  for_each_constrained(before.list_, [&](const OperatorSchurComplement& op, Eigen::Index, Eigen::Index) {
    for (const Point& place : op.constraints()->places) places.push_back(place), boxes.emplace_back(place, place);
  });
  const BoxTree tree(boxes);
  for_each_constrained(list_, [&](const OperatorSchurComplement& op, Eigen::Index first, Eigen::Index count) {
    for (Eigen::Index k = 0; k < count && !places.empty(); ++k) {
      const Point& place = op.constraints()->places[static_cast<std::size_t>(k)];
      double least = std::numeric_limits<double>::infinity();
      std::size_t nearest = 0;
      const auto is_nearer = [&](const Box& box) { return box.squaredExteriorDistance(place) < least; };
      tree.any(is_nearer, [&](int i) {
        nearest = static_cast<std::size_t>(i);
        least = (places[nearest] - place).squaredNorm();
        return false;
      });
      found[static_cast<std::size_t>(first + k)] = op.can_switch(k) && closed[nearest] ? 1 : 0;
    }
  });
  return found;
}

void CondensedOperators::set_closed(const std::vector<char>& closed) {
  for_each_constrained(list_, [&](OperatorSchurComplement& op, Eigen::Index first, Eigen::Index count) {
    op.set_gap_offsets(gap_offsets_.middleRows(first, count));
    op.set_closed({closed.begin() + first, closed.begin() + first + count});
  });
  forget_load();
}

void CondensedOperators::exchange_gap_offsets(Affine& others) noexcept {
  gap_offsets_.swap(others);
  for_each_constrained(list_, [&](OperatorSchurComplement& op, Eigen::Index first, Eigen::Index count) {
    op.set_gap_offsets(gap_offsets_.middleRows(first, count));
  });
  forget_load();
}

Affine CondensedOperators::gaps(const Affine& displacement) const {
  Affine gaps = Affine::Zero(constraint_count(), 2);
  for_each_constrained(list_, [&](const OperatorSchurComplement& op, Eigen::Index first, Eigen::Index count) {
    gaps.middleRows(first, count) = op.gaps(displacement);
  });
  return gaps;
}

Eigen::VectorXd CondensedOperators::gaps_without_multipliers(const Eigen::VectorXd& displacement,
                                                             double load_factor) const {
  Eigen::VectorXd gaps = Eigen::VectorXd::Zero(constraint_count());
  for_each_constrained(list_, [&](const OperatorSchurComplement& op, Eigen::Index first, Eigen::Index count) {
    gaps.segment(first, count) = op.gaps_without_multipliers(displacement, load_factor);
  });
  return gaps;
}

Eigen::VectorXd CondensedOperators::multipliers(const Eigen::VectorXd& displacement, double load_factor) const {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(constraint_count());
  for_each_constrained(list_, [&](const OperatorSchurComplement& op, Eigen::Index first, Eigen::Index count) {
    forces.segment(first, count) = op.multipliers(displacement, load_factor);
  });
  return forces;
}

double CondensedOperators::work_due_to_multipliers(const Eigen::VectorXd& displacement, double load_factor) const {
  double sum = 0;
  for (const OperatorSchurComplement& op : list_) sum += op.work_due_to_multipliers(displacement, load_factor);
  return sum;
}

void CondensedOperators::add_gap_function(Eigen::Index constraint, Eigen::VectorXd& weights) const {
  for_each_constrained(list_, [&](const OperatorSchurComplement& op, Eigen::Index first, Eigen::Index count) {
    if (constraint >= first && constraint < first + count) op.add_gap_function(constraint - first, weights);
  });
}

}  // namespace bempd::coupling
