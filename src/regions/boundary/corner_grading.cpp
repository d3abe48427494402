#include "regions/boundary/corner_grading.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bempd::regions {

namespace {

// Division of an element at a singular end: the distance of each new element end from the singular end over that of the
// previous one. With `usual_grading` divisions the error of displacements drops to 2e-3 of its value or less, because
// it falls at least like the size of the last element (crack tips).
constexpr double ratio = 0.3;

// Largest angle of a corner [rad] without a stress singularity, for the conditions on its two sides. A support that
// holds one component counts as a plane of symmetry.
double largest_regular_angle(Held a, Held b) {
  constexpr double pi = std::numbers::pi;
  if (a == b && a != Held::one_component) return pi;
  if (a == Held::one_component || b == Held::one_component) return 0.5 * pi;
  return pi / 3;
}

bool is_singular(const BoundaryPiece& before, const BoundaryPiece& after) {
  if (before.held == Held::interface || after.held == Held::interface) return false;
  const Point along = before.arc.tangent(1), on = after.arc.tangent(0);
  const double turn = std::atan2(cross(along, on), along.dot(on));
  constexpr double slack = 0.02;  // about a degree: corners that are weaker than that do not matter
  if (before.held == after.held && std::abs(turn) < slack) return false;
  return std::numbers::pi - turn > largest_regular_angle(before.held, after.held) + slack;
}

}  // namespace

std::vector<SingularEnds> singular_ends(const std::vector<BoundaryPiece>& loop) {
  std::vector<SingularEnds> ends(loop.size());
  for (std::size_t p = 0; p < loop.size(); ++p) {
    const std::size_t next = (p + 1) % loop.size();
    if (is_singular(loop[p], loop[next])) ends[p].end = ends[next].start = true;
  }
  return ends;
}

int grading_for(double wanted) {
  constexpr double share = 0.25;  // of the error wanted
  return std::max(1, static_cast<int>(std::ceil(std::log(share * wanted) / std::log(ratio))));
}

std::vector<double> refined_towards(const SingularEnds& singular, const std::vector<double>& stations, int levels) {
  std::vector<double> all = stations;
  // A single element with two singular ends is halved first, so that each half is divided towards one end.
  if (singular.start && singular.end && all.size() == 2) all = {0, 0.5, 1};
  const double first = all[1], last = 1 - all[all.size() - 2];
  std::vector<double> refined;
  for (std::size_t i = 0; i < all.size(); ++i) {
    refined.push_back(all[i]);
    if (i == 0 && singular.start)
      for (int k = levels; k > 0; --k) refined.push_back(first * std::pow(ratio, k));
    if (i + 2 == all.size() && singular.end)
      for (int k = 1; k <= levels; ++k) refined.push_back(1 - last * std::pow(ratio, k));
  }
  return refined;
}

}  // namespace bempd::regions
