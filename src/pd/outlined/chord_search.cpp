#include "pd/outlined/chord_search.hpp"

#include <algorithm>
#include <cmath>

namespace bempd::pd {

namespace {

constexpr double sight_tolerance = 1e-9;

Box box_around(const Point& a, const Point& b, double margin) {
  const Point pad = Point::Constant(margin);
  return {a.cwiseMin(b) - pad, a.cwiseMax(b) + pad};
}

bool is_straight(const Chords& chords, std::size_t piece) {
  const int first = chords.piece_start[piece], end = chords.piece_start[piece + 1];
  const Point whole = chords.nodes[chords.chords[end - 1].second] - chords.nodes[chords.chords[first].first];
  for (int c = first; c < end; ++c) {
    const Point off = chords.nodes[chords.chords[c].second] - chords.nodes[chords.chords[first].first];
    if (std::abs(cross(whole, off)) > sight_tolerance * whole.norm()) return false;
  }
  return true;
}

}  // namespace

Buckets::Buckets(const Box& box, double side) : origin_(box.min()), side_(side) {
  columns_ = 1 + static_cast<int>(box.sizes().x() / side);
  rows_ = 1 + static_cast<int>(box.sizes().y() / side);
  items_.resize(static_cast<std::size_t>(columns_) * rows_);
}

Eigen::Array2i Buckets::square_of(const Point& p) const {
  const Eigen::Array2d at = ((p - origin_) / side_).array().floor();
  const Eigen::Array2d most(columns_ - 1, rows_ - 1);
  return at.max(Eigen::Array2d::Zero()).min(most).cast<int>();
}

void Buckets::add(const Box& box, int item) {
  const Eigen::Array2i low = square_of(box.min()), high = square_of(box.max());
  for (int y = low.y(); y <= high.y(); ++y)
    for (int x = low.x(); x <= high.x(); ++x) items_[static_cast<std::size_t>(y) * columns_ + x].push_back(item);
}

ChordSearch::ChordSearch(const Chords& chords) : chords_(chords) {
  Box all;
  for (const Point& node : chords.nodes) all.extend(node);
  buckets_ = Buckets(all, 2);
  low_ = all.min().y();
  rows_.resize(1 + static_cast<std::size_t>(all.sizes().y()));
  for (std::size_t c = 0; c < chords.chords.size(); ++c) {
    const Point &a = chords.nodes[chords.chords[c].first], &b = chords.nodes[chords.chords[c].second];
    buckets_.add(box_around(a, b, sight_tolerance), static_cast<int>(c));
    const auto first = static_cast<std::size_t>(std::min(a.y(), b.y()) - low_);
    const auto last = static_cast<std::size_t>(std::max(a.y(), b.y()) - low_);
    for (std::size_t row = first; row <= last; ++row) rows_[row].push_back(static_cast<int>(c));
  }
  for (std::size_t p = 0; p + 1 < chords.piece_start.size(); ++p) straight_.push_back(is_straight(chords, p));
}

bool ChordSearch::on_chord(const Point& p) const {
  return buckets_.any_near(box_around(p, p, sight_tolerance), [&](int c) {
    return distance(Segment{chords_.nodes[chords_.chords[c].first], chords_.nodes[chords_.chords[c].second]}, p) <=
           sight_tolerance;
  });
}

bool ChordSearch::inside(const Point& p) const {
  if (on_chord(p)) return true;
  const double row = std::floor(p.y() - low_);
  if (row < 0 || row >= static_cast<double>(rows_.size())) return false;
  bool within = false;
  for (const int c : rows_[static_cast<std::size_t>(row)]) {
    const Point &a = chords_.nodes[chords_.chords[c].first], &b = chords_.nodes[chords_.chords[c].second];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) within = !within;
  }
  return within;
}

// Fractions, between the ends of the segment from `from` to `to`, at which it meets chords; sorted.
std::vector<double> ChordSearch::meetings(const Point& from, const Point& to) const {
  const Point d = to - from;
  const double length = d.norm(), slack = sight_tolerance / length;
  std::vector<double> found;
  const auto add = [&](double t) {
    if (t > slack && t < 1 - slack) found.push_back(t);
  };
  buckets_.any_near(box_around(from, to, sight_tolerance), [&](int c) {
    const Point& a = chords_.nodes[chords_.chords[c].first];
    const Point e = chords_.along(c);
    const double slope = cross(d, e), reach = e.norm();
    if (std::abs(slope) > 1e-12 * length * reach) {
      const double s = cross(a - from, d) / slope;
      if (s >= -sight_tolerance / reach && s <= 1 + sight_tolerance / reach) add(cross(a - from, e) / slope);
    } else if (std::abs(cross(a - from, d)) <= sight_tolerance * length) {
      add((a - from).dot(d) / (length * length));
      add((a + e - from).dot(d) / (length * length));
    }
    return false;
  });
  std::sort(found.begin(), found.end());
  return found;
}

// Whether the segment stays inside. Between two neighbouring meetings with chords the segment is either inside or
// outside, so the middle of each such stretch decides.
bool ChordSearch::in_sight(const Point& from, const Point& to) const {
  std::vector<double> stations = meetings(from, to);
  stations.insert(stations.begin(), 0.0);
  stations.push_back(1.0);
  const double slack = sight_tolerance / (to - from).norm();
  for (std::size_t k = 0; k + 1 < stations.size(); ++k) {
    if (stations[k + 1] - stations[k] <= slack) continue;
    if (!inside(from + 0.5 * (stations[k] + stations[k + 1]) * (to - from))) return false;
  }
  return true;
}

ChordSearch::View::View(const ChordSearch& search, const Point& from, double reach) : search_(search), from_(from) {
  const Chords& chords = search.chords_;
  std::array<int, most_pieces> found{};
  search.buckets_.any_near(box_around(from, from, reach), [&](int c) {
    const int piece = chords.chords[c].piece;
    if (std::find(found.begin(), found.begin() + count_, piece) != found.begin() + count_) return false;
    const Point &a = chords.nodes[chords.chords[c].first], &b = chords.nodes[chords.chords[c].second];
    if (distance(Segment{a, b}, from) > reach) return false;
    if (count_ == most_pieces || !search.straight_[piece]) {
      count_ = most_pieces + 1;
      return true;
    }
    found[count_] = piece;
    pieces_[count_++] = {a, b};
    return false;
  });
}

bool ChordSearch::View::sees(const Point& to) const {
  const auto behind = [&](const Segment& piece) {
    const Point along = piece.end - piece.start;
    const double slack = -sight_tolerance * along.norm();
    return cross(along, from_ - piece.start) < slack || cross(along, to - piece.start) < slack;
  };
  const bool simple = count_ <= most_pieces && std::none_of(pieces_.begin(), pieces_.begin() + count_, behind);
  return simple || search_.in_sight(from_, to);
}

}  // namespace bempd::pd
