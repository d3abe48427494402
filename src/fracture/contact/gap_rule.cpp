#include "fracture/contact/gap_rule.hpp"

#include <algorithm>
#include <cmath>

namespace bempd::fracture {

using coupling::Affine;
using coupling::Constraint;
using coupling::Constraints;

namespace {

// Rounding errors of gaps and of their rates, as shares of the largest displacement, also for iterated solutions:
// smaller values count as zero. Exact constraints, which lie inside dense operators (boundary element regions), have
// larger errors than constraints with a penalty.
constexpr double rounding_of_penalties = 1e-12, rounding_of_exact = 1e-10;

// Tolerance for gaps that have passed zero. While a constraint is closed its gap is zero up to rounding. When the
// constraint opens, that rounding is magnified by the ratio of the penalty to the remaining stiffness, which is
// unknown. So a gap that has passed zero by less than this share of the largest displacement, but is returning, still
// counts as zero. The energy error is the square of the share. Contact forces of exact constraints may change faster
// than any displacement; for such constraints the tolerance is this share of the change of the load factor.
constexpr double rounding_of_passed_gaps = 1e-8;

double rounding_of(const Constraint& constraint) {
  return constraint.is_exact() ? rounding_of_exact : rounding_of_penalties;
}

// Distance by which a gap has passed zero to the wrong side: an opening at a closed constraint, or an overlap at an
// open one. Negative if the gap is on the right side.
double passed_zero(bool closed, double gap) { return closed ? gap : -gap; }

// Gap of a constraint at a load factor, and its rate (change with the load factor); `rounding` is the share of the
// largest displacement below which a gap counts as zero, and of the largest rate of a displacement below which a rate
// does.
struct GapLine {
  double gap, rate;
  double largest_displacement, largest_rate;
  double rounding;

  // Change of the gap if the load factor moves in a direction: negative while the gap closes, zero within rounding.
  double rate_in(double direction) const { return std::abs(rate) <= rounding * largest_rate ? 0 : direction * rate; }
  double faster() const { return std::max(1.0, std::abs(rate) / largest_rate); }
  bool is_wrong(bool closed, double direction) const {
    const double passed = passed_zero(closed, gap), passes = passed_zero(closed, rate_in(direction));
    if (std::abs(gap) <= rounding * largest_displacement) return passes > 0;
    return passed > (passes < 0 ? rounding_of_passed_gaps * largest_displacement * faster() : 0);
  }
};

// Distance from the present load factor, in a direction, at which the constraint opens or closes; empty if it does
// neither.
std::optional<double> distance_to_switch(const GapLine& line, bool closed, double direction) {
  if (line.is_wrong(closed, direction)) return 0;
  const double rate = line.rate_in(direction);
  if (closed ? rate <= 0 : rate >= 0) return std::nullopt;
  return std::max(0.0, -line.gap / rate);
}

// Calls visit(number, line) for every constraint; `line` is its gap as a linear function of the load factor.
template <class Visit>
void for_each_line(const Constraints& constraints, const Affine& gaps, const Affine& u, double load_factor,
                   const Visit& visit) {
  if (constraints.size() == 0) return;
  const double largest[2] = {u.col(0).lpNorm<Eigen::Infinity>(), u.col(1).lpNorm<Eigen::Infinity>()};
  const double largest_displacement = largest[0] + std::abs(load_factor) * largest[1];
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const Eigen::RowVector2d gap = gaps.row(static_cast<Eigen::Index>(i));
    visit(i, GapLine{gap[0] + load_factor * gap[1], gap[1], largest_displacement, largest[1],
                     rounding_of(constraints[i])});
  }
}

}  // namespace

bool is_wrong(const Constraint& constraint, bool closed, double gap, double largest_displacement) {
  return passed_zero(closed, gap) > rounding_of(constraint) * largest_displacement;
}

std::vector<int> wrong_constraints(const Constraints& constraints, const Affine& gaps, const Affine& displacement,
                                   double load_factor, double direction) {
  std::vector<int> wrong;
  for_each_line(constraints, gaps, displacement, load_factor, [&](std::size_t i, const GapLine& line) {
    const bool closed = constraints.is_closed(i);
    const double its_direction = constraints[i].is_exact() && direction == 0 ? 1 : direction;
    if (constraints.is_barred(i) ? closed : line.is_wrong(closed, its_direction)) wrong.push_back(static_cast<int>(i));
  });
  return wrong;
}

std::optional<double> next_switch(const Constraints& constraints, const Affine& gaps, const Affine& displacement,
                                  double from, double to) {
  if (from == to) return std::nullopt;
  const double direction = to > from ? 1 : -1, farthest = (to - from) * direction;
  std::optional<double> least;
  for_each_line(constraints, gaps, displacement, from, [&](std::size_t i, const GapLine& line) {
    if (constraints.is_barred(i)) return;
    const std::optional<double> distance = distance_to_switch(line, constraints.is_closed(i), direction);
    if (distance && *distance <= farthest && (!least || *distance < *least)) least = distance;
  });
  return least ? std::optional(from + direction * *least) : std::nullopt;
}

}  // namespace bempd::fracture
