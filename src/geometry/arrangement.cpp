#include "geometry/arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "geometry/edge_tree.hpp"
#include "geometry/hinges.hpp"

namespace bempd {

namespace {

using Fractions = std::vector<double>;

// Fraction of a place on an edge, made exactly 0 or 1 at the ends of the edge. Twice the tolerance is allowed, because
// two places that were each matched to a third place may be that far apart.
double snap_to_ends(const Edge& edge, double fraction, double tolerance) {
  const double reach = 2 * tolerance / edge.length();
  if (fraction <= reach) return 0;
  return fraction >= 1 - reach ? 1 : fraction;
}

double snap_to(const Fractions& candidates, double fraction) {
  if (fraction <= 0 || fraction >= 1 || candidates.empty()) return fraction;
  return *std::min_element(candidates.begin(), candidates.end(),
                           [fraction](double a, double b) { return std::abs(a - fraction) < std::abs(b - fraction); });
}

// Fractions in ascending order, without 0 and 1; places closer to each other than twice the tolerance are merged.
Fractions distinct_inner(const Edge& edge, Fractions fractions, double tolerance) {
  std::sort(fractions.begin(), fractions.end());
  const double reach = 2 * tolerance / edge.length();
  Fractions kept;
  for (double f : fractions)
    if (f > 0 && f < 1 && (kept.empty() || f - kept.back() > reach)) kept.push_back(f);
  return kept;
}

class Arranger {
 public:
  explicit Arranger(const std::vector<Outline>& regions) {
    Box all;
    for (const Outline& outline : regions) {
      bodies_.emplace_back(edges_of(outline));
      boxes_.push_back(bodies_.back().box);
      all.extend(boxes_.back());
      result_.breakpoints.emplace_back(bodies_.back().edges.size());
    }
    tolerance_ = geometric_tolerance(all);
  }

  Arrangement run() {
    const BoxTree tree(boxes_);
    for (int a = 0; a < static_cast<int>(bodies_.size()); ++a)
      for (const int b : tree.meeting(widened(boxes_[a])))
        if (b > a) compare(a, b);
    finish_breakpoints();
    finish_contacts();
    result_.hinges = find_hinges(bodies_, result_.contacts, tolerance_);
    return std::move(result_);
  }

 private:
  Box widened(const Box& box) const {
    const Point margin = Point::Constant(2 * tolerance_);
    return {box.min() - margin, box.max() + margin};
  }

  void compare(int a, int b) {
    // Edges of each body that are far from the box of the other body are left out, because they cannot lie in the other
    // body or on its boundary.
    const std::vector<int> near_a = bodies_[a].tree.meeting(widened(boxes_[b]));
    const std::vector<int> near_b = bodies_[b].tree.meeting(widened(boxes_[a]));
    std::map<int, Fractions> splits_a, splits_b;
    for (const int j : near_b) splits_b[j];
    for (const int i : near_a) {
      Fractions& on_a = splits_a[i];
      const Box box = widened(bounding_box(bodies_[a].edges[i]));
      for (const int j : bodies_[b].tree.meeting(box))
        split(bodies_[a].edges[i], bodies_[b].edges[j], on_a, splits_b[j]);
    }
    classify(a, b, splits_a, true);
    classify(b, a, splits_b, false);
  }

  void split(const Edge& a, const Edge& b, Fractions& on_a, Fractions& on_b) const {
    bool touching = false;
    const auto touch = [&](const Edge& edge, const Point& vertex, Fractions& on_edge) {
      const double fraction = closest_fraction(edge, vertex);
      if ((edge.at(fraction) - vertex).norm() > tolerance_) return;
      touching = true;
      on_edge.push_back(snap_to_ends(edge, fraction, tolerance_));
    };
    touch(a, b.start, on_a);
    touch(a, b.end, on_a);
    touch(b, a.start, on_b);
    touch(b, a.end, on_b);
    // Crossings of straight edges that touch are not computed: such a crossing would be the vertex at which they touch,
    // or a rounding error on a piece that both share.
    if (touching && a.straight() && b.straight()) return;
    for (const Crossing& c : meeting_points(a, b)) {
      // Crossings of touching edges with the same tangent at the crossing are left out, because circles that are equal
      // up to rounding seem to cross anywhere.
      constexpr double same_direction = 1e-6;
      if (touching && std::abs(cross(a.tangent(c.fraction_a), b.tangent(c.fraction_b))) < same_direction) continue;
      on_a.push_back(snap_to_ends(a, c.fraction_a, tolerance_));
      on_b.push_back(snap_to_ends(b, c.fraction_b, tolerance_));
    }
  }

  // Classifies the pieces of body `a`'s edges between their splits as inside, outside or on the boundary of body `b`.
  // The middle of a piece decides for the whole piece. Shared pieces are found from one body only (`enter_contacts`)
  // and listed for both bodies, so that their lists agree.
  void classify(int a, int b, const std::map<int, Fractions>& splits, bool enter_contacts) {
    for (const auto& [k, fractions] : splits) {
      const Edge& edge = bodies_[a].edges[k];
      Fractions stations = distinct_inner(edge, fractions, tolerance_);
      auto& breakpoints = result_.breakpoints[a][k];
      breakpoints.insert(breakpoints.end(), stations.begin(), stations.end());
      stations.insert(stations.begin(), 0.0);
      stations.push_back(1.0);
      for (std::size_t s = 0; s + 1 < stations.size(); ++s)
        classify_piece(a, k, stations[s], stations[s + 1], b, enter_contacts);
    }
  }

  void classify_piece(int a, int edge, double from, double to, int b, bool enter_contacts) {
    const Edge& whole = bodies_[a].edges[edge];
    const Point middle = whole.at(0.5 * (from + to));
    const Location location = bodies_[b].locate(middle, tolerance_);
    if (location == Location::outside) return;
    if (location == Location::inside) return note_overlap(a, b, middle);
    const Segment piece{whole.at(from), whole.at(to)};
    const Point direction = whole.tangent(0.5 * (from + to));
    const int partner = coincident_edge(piece, middle, direction, bodies_[b]);
    if (partner < 0) return;
    const Edge& other = bodies_[b].edges[partner];
    if (direction.dot(other.tangent(closest_fraction(other, middle))) > 0) return note_overlap(a, b, middle);
    if (!enter_contacts) return;
    const double other_from = snap_to_ends(other, closest_fraction(other, piece.start), tolerance_);
    const double other_to = snap_to_ends(other, closest_fraction(other, piece.end), tolerance_);
    if (other_from > other_to) result_.contacts.push_back({a, edge, from, to, b, partner, other_from, other_to});
  }

  // Number of the edge of `body` on which the piece lies, or -1; next to a corner, the edge that is more parallel to
  // the piece.
  int coincident_edge(const Segment& piece, const Point& middle, const Point& direction, const EdgeTree& body) const {
    int best = -1;
    double best_alignment = 0;
    for (const int j : body.tree.meeting(widened(Box(middle)))) {
      const Edge& edge = body.edges[j];
      if (distance(edge, middle) > tolerance_) continue;
      if (distance(edge, piece.start) > 3 * tolerance_ || distance(edge, piece.end) > 3 * tolerance_) continue;
      const double alignment = std::abs(direction.dot(edge.tangent(closest_fraction(edge, middle))));
      if (alignment > best_alignment) {
        best = j;
        best_alignment = alignment;
      }
    }
    return best;
  }

  void note_overlap(int a, int b, const Point& where) {
    if (!result_.overlap) result_.overlap = Overlap{std::min(a, b), std::max(a, b), where};
  }

  void finish_breakpoints() {
    for (std::size_t r = 0; r < bodies_.size(); ++r)
      for (std::size_t k = 0; k < bodies_[r].edges.size(); ++k) {
        auto& fractions = result_.breakpoints[r][k];
        fractions = distinct_inner(bodies_[r].edges[k], std::move(fractions), tolerance_);
      }
  }

  void finish_contacts() {
    std::vector<Contact> both;
    for (Contact c : result_.contacts) {
      const Fractions& own = result_.breakpoints[c.region][c.edge];
      const Fractions& others = result_.breakpoints[c.other_region][c.other_edge];
      c.from = snap_to(own, c.from);
      c.to = snap_to(own, c.to);
      c.other_from = snap_to(others, c.other_from);
      c.other_to = snap_to(others, c.other_to);
      if (!(c.from < c.to && c.other_to < c.other_from)) continue;
      both.push_back(c);
      both.push_back({c.other_region, c.other_edge, c.other_to, c.other_from, c.region, c.edge, c.to, c.from});
    }
    std::sort(both.begin(), both.end(), [](const Contact& a, const Contact& b) {
      return std::tie(a.region, a.edge, a.from) < std::tie(b.region, b.edge, b.from);
    });
    result_.contacts = std::move(both);
  }

  std::vector<EdgeTree> bodies_;
  std::vector<Box> boxes_;
  double tolerance_ = 0;
  Arrangement result_;
};

}  // namespace

Arrangement arrange(const std::vector<Outline>& regions) { return Arranger(regions).run(); }

}  // namespace bempd
