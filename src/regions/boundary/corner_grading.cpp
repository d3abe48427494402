#include "regions/boundary/corner_grading.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "elasticity/wedge_exponent.hpp"

namespace bempd::regions {

namespace {

// Ratio in which the element next to a singular place is divided, again and again: each new element end has this
// fraction of the distance from the place that the element end before it has.
constexpr double ratio = 0.3;

// Usual number of divisions. At a crack tip the divisions reduce the error of displacements far away to 2e-3 of its
// value, because this error is proportional to the size of the last element. At corners and ends of supports the error
// falls faster.
constexpr int usual_count = 5;

// Largest angle of a corner [rad] without a stress singularity, for the supports `a` and `b` on its two sides. A
// support that holds one displacement component counts as a plane of symmetry.
double largest_regular_angle(HeldComponents a, HeldComponents b) {
  constexpr double pi = std::numbers::pi;
  if (a == b && a != HeldComponents::one) return pi;
  if (a == HeldComponents::one || b == HeldComponents::one) return 0.5 * pi;
  return pi / 3;
}

bool is_singular(const BoundaryPiece& before, const BoundaryPiece& after) {
  if (before.held == HeldComponents::interface || after.held == HeldComponents::interface) return false;
  const Point along = before.arc.tangent(1), on = after.arc.tangent(0);
  const double turn = std::atan2(cross(along, on), along.dot(on));
  constexpr double slack = 0.02;  // about a degree: flatter corners do not matter
  if (before.held == after.held && std::abs(turn) < slack) return false;
  return std::numbers::pi - turn > largest_regular_angle(before.held, after.held) + slack;
}

// Exponent of the displacements near a singular place: they are proportional to the distance from the place, raised to
// the power of the exponent.
double exponent_at(const BoundaryPiece& before, const BoundaryPiece& after, const PlaneElasticity& elasticity) {
  constexpr double of_crack_tip = 0.5;
  const Point along = before.arc.tangent(1), on = after.arc.tangent(0);
  const double opening = std::numbers::pi - std::atan2(cross(along, on), along.dot(on));
  const Wedge wedge{std::atan2(on.y(), on.x()), {{opening, elasticity}}, {after.components, before.components}, false};
  const auto exponent = elasticity.poisson_ratio < 0.5 ? singular_exponent(wedge) : std::nullopt;
  return exponent ? exponent->real() : of_crack_tip;
}

// Whether tractions may jump where two pieces meet, so that stress depends on the direction there.
bool has_jump(const BoundaryPiece& before, const BoundaryPiece& after) {
  constexpr double straight_on = 0.02;
  if (before.held == HeldComponents::interface || after.held == HeldComponents::interface) return false;
  if (before.loads != after.loads) return true;
  const Point along = before.arc.tangent(1), on = after.arc.tangent(0);
  return !before.loads.empty() && std::abs(std::atan2(cross(along, on), along.dot(on))) > straight_on;
}

}  // namespace

int usual_divisions(const BoundaryPiece& before, const BoundaryPiece& after) {
  return is_singular(before, after) ? usual_count : 0;
}

DivisionRule divisions_for(double wanted, const PlaneElasticity& elasticity) {
  return [wanted, elasticity](const BoundaryPiece& before, const BoundaryPiece& after) {
    const bool singular = is_singular(before, after);
    if (!singular && !has_jump(before, after)) return 0;
    const double exponent = singular ? exponent_at(before, after, elasticity) : 1;
    constexpr int most = 30;
    return std::clamp(static_cast<int>(std::ceil(std::log(wanted) / (exponent * std::log(ratio)))), 1, most);
  };
}

std::vector<EndDivisions> end_divisions(const std::vector<BoundaryPiece>& loop, const DivisionRule& rule) {
  std::vector<EndDivisions> ends(loop.size());
  for (std::size_t p = 0; p < loop.size(); ++p) {
    const std::size_t next = (p + 1) % loop.size();
    ends[p].end = ends[next].start = rule(loop[p], loop[next]);
  }
  return ends;
}

std::vector<double> graded_stations(const EndDivisions& wanted, const std::vector<double>& stations, double least) {
  std::vector<double> all = stations;
  // A single element that is divided towards both of its ends is halved first, so that each half is divided towards one
  // end.
  if (wanted.start > 0 && wanted.end > 0 && all.size() == 2) all = {0, 0.5, 1};
  const double first = all[1], last = 1 - all[all.size() - 2];
  const auto possible = [&](int count, double length) {
    while (count > 0 && length * std::pow(ratio, count) < least) --count;
    return count;
  };
  const EndDivisions divisions{possible(wanted.start, first), possible(wanted.end, last)};
  std::vector<double> refined;
  for (std::size_t i = 0; i < all.size(); ++i) {
    refined.push_back(all[i]);
    if (i == 0)
      for (int k = divisions.start; k > 0; --k) refined.push_back(first * std::pow(ratio, k));
    if (i + 2 == all.size())
      for (int k = 1; k <= divisions.end; ++k) refined.push_back(1 - last * std::pow(ratio, k));
  }
  return refined;
}

}  // namespace bempd::regions
