#include "fracture/line/tip_sight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fracture/line/on_limits.hpp"

namespace bempd::fracture {

namespace {

// Half length of the straight segments that make up a crack face, in spacings. Each segment runs across the middle of a
// broken bond between neighbours and overlaps the next segment slightly.
constexpr double half_length_of_piece = 0.55;

// Limits in spacings for the middle of a bond that the tip's own crack has broken: at most `ahead_of_own` ahead of the
// tip, if it lies at most `beside_own` to a side, or else at most `ahead_of_kink` ahead. Bonds that a crack breaks
// between neighbours have their middles within half a spacing of the crack, and the crack runs back from the tip at an
// angle of at least 110 degrees to the tip's direction.
constexpr double ahead_of_own = 0.75, beside_own = 1.5, ahead_of_kink = 0.25;

bool lie_apart(const Point& from, const Point& to, const Point& a, const Point& b) {
  return is_left(from, to, a) != is_left(from, to, b);
}

}  // namespace

TipSight::TipSight(const Point& place, const Point& direction, double spacing)
    : place_(place), direction_(direction), spacing_(spacing), nearest_face_(std::numeric_limits<double>::infinity()) {}

void TipSight::add_broken_bond(const Point& middle, const Point& along) {
  const Point step = middle - place_;
  const double ahead = step.dot(direction_), aside = std::abs(cross(direction_, step));
  const double rounding = rounding_of_places * spacing_;
  if (ahead <= (aside <= beside_own * spacing_ + rounding ? ahead_of_own : ahead_of_kink) * spacing_ + rounding) return;
  nearest_face_ = std::min(nearest_face_, step.norm());
  const Point half = half_length_of_piece * spacing_ * Point(-along.y(), along.x());
  faces_.push_back({middle - half, middle + half});
}

bool TipSight::sees(const Point& point) const {
  return std::none_of(faces_.begin(), faces_.end(), [&](const Piece& face) {
    return lie_apart(place_, point, face.from, face.to) && lie_apart(face.from, face.to, place_, point);
  });
}

}  // namespace bempd::fracture
