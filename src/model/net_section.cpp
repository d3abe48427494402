#include "model/net_section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/outline.hpp"

namespace bempd::model {

namespace {

// Number of places at which the stress on each piece of the section is evaluated. The places are chosen so that the
// integral is exact for stresses with a square root's singularity at either end of the piece.
constexpr int places_on_piece = 16;

// Share of the section's length: parts of cracks that are nearer to the section's line than this count as lying on the
// line.
constexpr double along = 0.05;

double angle_of(int k) { return (k + 0.5) * std::numbers::pi / places_on_piece; }

// Positions along the section's line, measured from the tip, at which the line meets edges or their ends; ascending.
// `half` is half of the line's length.
std::vector<double> crossings_of(const Edge& line, double half, const std::vector<Edge>& edges, double tolerance) {
  std::vector<double> found;
  for (const Edge& edge : edges) {
    for (const Crossing& crossing : meeting_points(line, edge)) found.push_back((2 * crossing.fraction_a - 1) * half);
    if (distance(line, edge.start) <= tolerance) found.push_back((2 * closest_fraction(line, edge.start) - 1) * half);
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Largest value of a function that has one maximum between two places, by golden section search.
template <class Value>
double largest_between(double low, double high, const Value& value) {
  constexpr double golden = 0.6180339887498949;
  double best = 0;
  for (int round = 0; round < 40; ++round) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    const double at_a = value(a), at_b = value(b);
    best = std::max({best, at_a, at_b});
    (at_a > at_b ? high : low) = at_a > at_b ? b : a;
  }
  return best;
}

}  // namespace

NetSection::NetSection(const Outline& outline, const std::vector<scene::Crack>& cracks, int crack, const Point& place,
                       const Point& direction, const std::vector<SpreadTip>& spread)
    : place_(place), direction_(direction) {
  const Box box = bounding_box(outline);
  const double half = 2 * box.diagonal().norm(), tolerance = geometric_tolerance(box);
  const Edge line(place - half * direction, place + half * direction);
  const std::vector<Edge> all = edges_of(outline);
  const std::vector<Edge> outer(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(outline.loops[0].size()));
  // First and last position, along the line, of that part of the line around the tip which lies within the outer loop.
  double lowest = -half, highest = half;
  for (const double at : crossings_of(line, half, outer, tolerance)) {
    if (at < -tolerance) lowest = at;
    if (at > tolerance && highest == half) highest = at;
  }
  std::vector<double> cuts{lowest};
  for (const double at : crossings_of(line, half, all, tolerance))
    if (at > lowest && at < highest) cuts.push_back(at);
  cuts.push_back(highest);
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    if (cuts[k + 1] - cuts[k] <= tolerance) continue;
    const Point middle = place + 0.5 * (cuts[k] + cuts[k + 1]) * direction;
    if (locate(all, middle, tolerance) == Location::inside) pieces_.push_back({cuts[k], cuts[k + 1]});
  }
  for (std::size_t c = 0; c < cracks.size(); ++c)
    take_out(cracks[c], static_cast<int>(c) + 1 == crack ? 2 * half : along * (highest - lowest));
  std::erase_if(pieces_, [&](const Piece& piece) { return piece.to - piece.from <= 1e3 * tolerance; });
  find_spread_ends(spread);
}

void NetSection::find_spread_ends(const std::vector<SpreadTip>& spread) {
  constexpr double largest_share = 0.4, near = 0.25;
  for (Piece& piece : pieces_)
    for (std::size_t t = 0; t < spread.size(); ++t)
      for (const int end : {0, 1}) {
        const Point place = place_ + (end == 0 ? piece.from : piece.to) * direction_;
        if ((place - spread[t].place).norm() > near * spread[t].radius) continue;
        piece.ends[static_cast<std::size_t>(end)] = {
            t, std::min(spread[t].radius, largest_share * (piece.to - piece.from))};
      }
}

void NetSection::take_out(const scene::Crack& crack, double half_width) {
  const Point across(-direction_.y(), direction_.x());
  for (std::size_t k = 0; k + 1 < crack.points.size(); ++k) {
    const Point from = crack.points[k] - place_, way = crack.points[k + 1] - crack.points[k];
    const double beside = across.dot(from), turn = across.dot(way);
    // First and last fraction of the crack's segment, between which the segment is near the section's line.
    double first = 0, last = 1;
    if (std::abs(turn) > 1e-12 * way.norm()) {
      const double a = (-half_width - beside) / turn, b = (half_width - beside) / turn;
      first = std::max(first, std::min(a, b)), last = std::min(last, std::max(a, b));
    } else if (std::abs(beside) > half_width) {
      continue;
    }
    if (first >= last) continue;
    const double a = direction_.dot(from + first * way), b = direction_.dot(from + last * way);
    take_out(Piece{std::min(a, b), std::max(a, b)});
  }
}

void NetSection::take_out(const Piece& part) {
  std::vector<Piece> left;
  for (const Piece& piece : pieces_) {
    if (part.to <= piece.from || part.from >= piece.to) {
      left.push_back(piece);
      continue;
    }
    if (part.from > piece.from) left.push_back({piece.from, part.from});
    if (part.to < piece.to) left.push_back({part.to, piece.to});
  }
  pieces_ = std::move(left);
}

std::vector<Point> NetSection::places() const {
  std::vector<Point> all;
  for (const Piece& piece : pieces_) {
    const double middle = 0.5 * (piece.first() + piece.last()), half = 0.5 * (piece.last() - piece.first());
    for (int k = 0; k < places_on_piece; ++k)
      all.emplace_back(place_ + (middle - half * std::cos(angle_of(k))) * direction_);
    for (const int end : {0, 1})
      if (piece.ends[static_cast<std::size_t>(end)].radius > 0)
        all.emplace_back(place_ + (end == 0 ? piece.first() : piece.last()) * direction_);
  }
  return all;
}

// Integrates the tensile stress over the section; `pulls` are its values at places(). At a spread tip (tip of a crack
// line in a lattice) the stress is K / sqrt(2 pi r), where r is the distance from the tip, plus a part in proportion to
// sqrt(r), which is fitted to the stress at the tip's radius.
NetSection::Resultant NetSection::resultant(const std::vector<double>& pulls,
                                            const std::vector<double>& factors) const {
  Resultant sum;
  std::size_t next = 0;
  for (const Piece& piece : pieces_) {
    const double middle = 0.5 * (piece.first() + piece.last()), half = 0.5 * (piece.last() - piece.first());
    for (int k = 0; k < places_on_piece; ++k, ++next) {
      const double weight = half * std::sin(angle_of(k)) * std::numbers::pi / places_on_piece * pulls[next];
      sum.force += weight, sum.moment += weight * (middle - half * std::cos(angle_of(k)));
    }
    for (const int end : {0, 1}) {
      const auto [tip, radius] = piece.ends[static_cast<std::size_t>(end)];
      if (!(radius > 0)) continue;
      const double pull = pulls[next++];
      const double of_tip = std::max(0.0, factors[tip]) / std::sqrt(2 * std::numbers::pi * radius),
                   rest = pull - of_tip;
      const double force = (2 * of_tip + 2 * rest / 3) * radius;
      const double about_end = (2 * of_tip / 3 + 2 * rest / 5) * radius * radius;
      sum.force += force;
      sum.moment += end == 0 ? piece.from * force + about_end : piece.to * force - about_end;
    }
  }
  return sum;
}

double NetSection::opening_about(double centre) const {
  double sum = 0;
  for (const Piece& piece : pieces_) {
    const double a = piece.from - centre, b = piece.to - centre;
    sum += 0.5 * (b * std::abs(b) - a * std::abs(a));
  }
  return sum;
}

double NetSection::share(const std::vector<regions::PointValue>& stresses, double flow_stress,
                         const std::vector<double>& factors) const {
  const Point normal(-direction_.y(), direction_.x());
  std::vector<double> pulls;
  for (const regions::PointValue& value : stresses)
    pulls.push_back(normal.x() * normal.x() * value.stress[0] + normal.y() * normal.y() * value.stress[1] +
                    2 * normal.x() * normal.y() * value.stress[2]);
  const auto [force, moment] = resultant(pulls, factors);
  double length = 0;
  for (const Piece& piece : pieces_) length += piece.to - piece.from;
  if (!(length > 0)) return 0;
  const double size = std::max(pieces_.back().to, -pieces_.front().from);
  // Ratio of the work of the stresses to the plastic work, for a rotation about the place at size * tan(angle) from the
  // tip. The sense in which the rotation opens the tip depends on whether the place lies behind the tip (angle < 0) or
  // ahead of it.
  const auto ratio = [&, force = force, moment = moment](double angle) {
    const double centre = size * std::tan(angle);
    const double work = (angle < 0 ? 1 : -1) * (moment - centre * force);
    return work > 0 ? work / (flow_stress * opening_about(centre)) : work;
  };
  constexpr double quarter = std::numbers::pi / 2 - 1e-3;
  double largest = std::max(0.0, force / (flow_stress * length));
  largest = std::max(largest, largest_between(-quarter, -1e-9, ratio));
  return std::max(largest, largest_between(1e-9, quarter, ratio));
}

}  // namespace bempd::model
