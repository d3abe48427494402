#include "regions/outlined/outlined_region.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "error.hpp"
#include "pd/outlined/surface_balance.hpp"

namespace bempd::regions {

namespace {

// Gauss rule with four points on [0, 1].
constexpr double abscissa[4] = {0.0694318442029737, 0.3300094782075719, 0.6699905217924281, 0.9305681557970263};
constexpr double weight[4] = {0.1739274225687269, 0.3260725774312731, 0.3260725774312731, 0.1739274225687269};

// Least length of a piece of the outline between two required places, in spacings.
constexpr double shortest_piece = 0.75;

// Smallest distance of a segment from lattice points, in spacings, measured along the axis that the segment is steeper
// to. `shift` is the position of the lattice.
double distance_from_points(const Segment& segment, const Point& shift) {
  const Point along = segment.direction();
  const int axis = std::abs(along.x()) >= std::abs(along.y()) ? 0 : 1;
  const double from = segment.start[axis] - shift[axis], to = segment.end[axis] - shift[axis];
  double least = 0.5;
  for (double row = std::ceil(std::min(from, to)); row <= std::max(from, to); ++row) {
    const double off = segment.at((row - from) / (to - from))[1 - axis] - shift[1 - axis];
    least = std::min(least, std::abs(off - std::round(off)));
  }
  return least;
}

double degrees(double angle) { return angle * 180 / std::numbers::pi; }

}  // namespace

OutlinedRegion::OutlinedRegion(int id, const PeridynamicDescription& described, const scene::Material& material)
    : BondedRegion(id, material, described.spacing(), described.horizon_ratio()), choice_(described.choice()) {
  origin_ = bounding_box(described.outline()).min();
}

void OutlinedRegion::mesh(const Preparation& preparation) {
  for (const Contact& contact : preparation.arrangement.contacts) {
    if (contact.region != id() - 1) continue;
    require_common_points(preparation, contact);
  }
  divide_outline(preparation);
}

std::vector<double> OutlinedRegion::stations_on(const Preparation& preparation, int number) const {
  const Edge edge = preparation.scene.region(id()).edge(number);
  const double length = edge.length() / spacing(), room = shortest_piece / length;
  std::vector<double> wanted, stations = preparation.arrangement.breakpoints[id() - 1][number - 1];
  stations.insert(stations.end(), {0.0, 1.0});
  if (edge.piece_count() > 1) stations.push_back(edge.joint());
  std::sort(stations.begin(), stations.end());
  for (const auto* conditions : {&preparation.scene.supports(), &preparation.scene.loads()}) {
    for (const scene::Condition& condition : *conditions) {
      if (condition.removed()) continue;
      const auto breaks = condition.place->breaks_on(preparation.scene, id(), number, preparation.tolerance);
      wanted.insert(wanted.end(), breaks.begin(), breaks.end());
    }
  }
  // A crack's mouth has to lie in the middle of a chord of the outline, so two places half a spacing beside it are
  // required.
  for (const scene::Crack& crack : preparation.scene.cracks()) {
    for (const Point& p : crack.given()) {
      if (distance(edge, p) > 8 * preparation.tolerance) continue;
      const double mouth = closest_fraction(edge, p);
      wanted.insert(wanted.end(), {mouth - 0.5 / length, mouth + 0.5 / length});
    }
  }
  for (const double f : wanted) {
    const auto& contacts = preparation.arrangement.contacts;
    const bool is_shared = std::any_of(contacts.begin(), contacts.end(), [&](const Contact& c) {
      return c.region == id() - 1 && c.edge == number - 1 && c.from < f && f < c.to;
    });
    if (is_shared) continue;
    const auto after = std::lower_bound(stations.begin(), stations.end(), f);
    if (after == stations.begin() || after == stations.end()) continue;
    if (f - after[-1] >= room && *after - f >= room) stations.insert(after, f);
  }
  return stations;
}

void OutlinedRegion::divide_outline(const Preparation& preparation) {
  if (!pieces_.empty()) return;
  const Outline& outline = preparation.scene.region(id()).outline();
  int number = 0;
  for (const auto& loop : outline.loops) {
    loops_.emplace_back();
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Edge edge = outline.edge(number++);
      const std::vector<double> stations = stations_on(preparation, number);
      for (std::size_t s = 0; s + 1 < stations.size(); ++s) {
        const Arc part = edge.part(stations[s], stations[s + 1]);
        const Arc arc{to_grid(part.start), to_grid(part.end), part.sweep};
        pieces_.push_back({number, stations[s], stations[s + 1], arc});
        loops_.back().push_back(arc);
      }
    }
  }
  body_.chords = pd::make_chords(loops_);
  shared_points(preparation);
  // Chords of different lengths are tried if the points that neighbours rely on leave too few chords to balance the
  // outline.
  if (pd::imbalance(body_.chords, pd::balancing_factors(body_.chords)) > 1e-13)
    body_.chords = pd::make_chords(loops_, pieces_that_may_vary(preparation));
}

// Position of the lattice inside the outline. A lattice point lies at the lower left corner, unless another position
// keeps the points farther from cracks.
pd::LatticePlace OutlinedRegion::place_of_lattice(const Preparation& preparation) const {
  constexpr int steps = 8;
  const Eigen::Matrix2d turn(Eigen::Rotation2Dd(choice_.angle));
  std::vector<Segment> segments;  // in coordinates of the lattice
  for (const scene::Crack& crack : preparation.scene.cracks()) {
    const std::span<const Point> points = crack.given();
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      segments.push_back({turn.transpose() * to_grid(points[k]), turn.transpose() * to_grid(points[k + 1])});
  }
  double best = -1;
  Point best_shift = Point::Zero();
  for (int k = 0; k < steps * steps; ++k) {
    const Point shift = Point(k % steps, k / steps) / steps;
    double least = 0.5;
    for (const Segment& s : segments) least = std::min(least, distance_from_points(s, shift));
    if (least > best + 1e-9) best = least, best_shift = shift;
  }
  return {turn * best_shift, choice_.angle, !segments.empty()};
}

void OutlinedRegion::require_possible_corners() const {
  const auto corner = pd::find_impossible_corner(body_.chords);
  if (!corner) return;
  const Point where = from_grid(body_.chords.nodes[corner->node]);
  const int edge = pieces_[body_.chords.chords[corner->node].piece].edge;
  require(degrees(corner->angle) > 60 + 1e-9, "region ", id(), " has a corner of ", degrees(corner->angle),
          " degrees at (", where.x(), ", ", where.y(), "), where edge ", edge,
          " begins; bonds that pull only cannot carry a corner below 60 degrees: cut it off over two spacings (",
          2 * spacing(), "), or round it");
  require(false, "region ", id(), " has a corner of ", degrees(corner->angle), " degrees at (", where.x(), ", ",
          where.y(), "), where edge ", edge, " begins, between points ", corner->before * spacing(), " and ",
          corner->behind * spacing(),
          " from it; there the two lengths have to be more alike: choose a spacing that "
          "divides the edges of the corner, or longer edges");
}

void OutlinedRegion::build(const Preparation& preparation, Contributions& contributions) {
  require_possible_corners();
  const Box box = bounding_box(preparation.scene.region(id()).outline());
  constexpr double most_places = 1e8;
  const double places = box.volume() / (spacing() * spacing());
  require(places <= most_places, "region ", id(), " lies in a rectangle of ", places, " spacings ", spacing(),
          " squared; the limit is ", most_places, ": choose a larger spacing");
  const std::vector<char> is_shared = shared_points(preparation);
  const pd::Chords chords = body_.chords;
  const int threads = preparation.options.whole_number("threads");
  body_ = pd::build_outlined_body(chords, place_of_lattice(preparation), horizon_ratio(), elasticity(), threads,
                                  choice_.balance);
  require(body_.is_exact(), "region ", id(), " has a shape for which no network of positive bonds with horizon ratio ",
          horizon_ratio(), " and spacing ", spacing(),
          " was found: corners below 65 degrees, parts less than three spacings wide and edges shorter than a spacing "
          "may have none; try a smaller spacing or the horizon ratio 4, and cracks that begin half a spacing "
          "farther along the outline. Edges in common with others need chords of like lengths");
  points_ = body_.points;
  nodes_.clear();
  for (int i = 0; i < point_count(); ++i) {
    const bool shared = i < chords.count() && is_shared[i];
    nodes_.push_back(shared ? contributions.registry.add_shared(position(i), id())
                            : contributions.registry.add(position(i)));
  }
  if (!pd::is_bond_based(elasticity())) {
    stencils_ = pd::cell_stencils(body_);
    require(stencils_.max_residual < 1e-11, "region ", id(), " has an outline beside which no cells were found that ",
            "make Poisson's ratio ", elasticity().poisson_ratio, "; try a smaller spacing, or ",
            elasticity().state == PlaneState::stress ? "1/3" : "1/4", ", which bonds alone make");
  }
  bonds_.network = std::make_shared<const pd::Network>(std::move(body_.network));
  add_own_bonds(preparation, contributions);
  add_squares(contributions);
}

std::optional<LatticeGrid> OutlinedRegion::lattice_grid() const {
  return LatticeGrid{from_grid(body_.place.origin), spacing(), horizon_ratio() * spacing(), choice_.angle};
}

// Adds the bonds that a crack cuts. If the crack begins at a material point (at a corner, or between two pieces of a
// round edge), it is moved to the right of it. If it ends on a round hole it is lengthened, because bonds between
// neighbouring points on the hole run outside the body and would not be cut.
void OutlinedRegion::cut(const scene::Crack& crack, int number, std::vector<int>& bonds,
                         std::vector<std::string>& warnings) const {
  constexpr double on_point = 1e-8, on_arc = 1e-6, aside = 1e-3, beyond_arc = 0.5;  // in spacings
  scene::Crack beside = crack;
  const auto pass_by = [&](Point& end, const Point& next) {
    const Point inward = (next - end).normalized(), place = to_grid(end);
    for (int i = 0; i < body_.chords.count(); ++i) {
      if ((body_.points[i] - place).norm() > on_point) continue;
      end += aside * spacing() * (Point(inward.y(), -inward.x()) - inward);
      return;
    }
    for (const Piece& piece : pieces_)
      if (!piece.arc.straight() && distance(Edge(piece.arc), place) <= on_arc) {
        end -= beyond_arc * spacing() * inward;
        return;
      }
  };
  if (crack.points.size() > 1) {
    pass_by(beside.points.front(), crack.points[1]);
    pass_by(beside.points.back(), crack.points[crack.points.size() - 2]);
  }
  BondedRegion::cut(beside, number, bonds, warnings);
}

double OutlinedRegion::fraction(const pd::Chord& chord, double part) const {
  const Piece& piece = pieces_[chord.piece];
  return piece.from + (chord.from + part * (chord.to - chord.from)) * (piece.to - piece.from);
}

template <class Visit>
void OutlinedRegion::for_chords_on(const EdgeSpan& span, const Visit& visit) const {
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    if (pieces_[p].edge != span.edge) continue;
    for (int c = body_.chords.piece_start[p]; c < body_.chords.piece_start[p + 1]; ++c) visit(body_.chords.chords[c]);
  }
}

std::vector<PlacedNode> OutlinedRegion::nodes_on(const EdgeSpan& span, double tolerance) const {
  const double slack = 10 * tolerance / span.geometry.length();
  std::vector<PlacedNode> found;
  const auto add = [&](int node, double at) {
    if (at < span.from - slack || at > span.to + slack) return;
    found.push_back({nodes_[node], std::clamp((at - span.from) / (span.to - span.from), 0.0, 1.0)});
  };
  for_chords_on(span, [&](const pd::Chord& chord) {
    if (found.empty()) add(chord.first, fraction(chord, 0));
    add(chord.second, fraction(chord, 1));
  });
  return found;
}

// Nodal forces of a traction t: f_i = (1 + a_i) integral of phi_i t ds, where the factors 1 + a_i balance the chords of
// the outline. Along straight edges phi_i is the linear hat function.
// Along a round edge a constant stress has a traction that turns with the normal; its integral over an arc equals that
// over the chord. Therefore each end of a whole chord takes half, which is exact for a constant stress and of second
// order otherwise.
void OutlinedRegion::add_traction(const EdgeSpan& span, const std::function<Point(const Point&)>& traction,
                                  Eigen::Ref<Eigen::VectorXd> force) const {
  Eigen::VectorXd nodal = Eigen::VectorXd::Zero(2 * point_count());
  const double length = span.geometry.length();
  for_chords_on(span, [&](const pd::Chord& chord) {
    const double begin = fraction(chord, 0), end = fraction(chord, 1);
    const double from = std::max(span.from, begin), to = std::min(span.to, end);
    if (from >= to) return;
    const bool halves = !pieces_[chord.piece].arc.straight() && from == begin && to == end;
    for (int g = 0; g < 4; ++g) {
      const double at = from + abscissa[g] * (to - from), part = halves ? 0.5 : (at - begin) / (end - begin);
      const Point f = weight[g] * (to - from) * length * traction(span.geometry.at(at));
      nodal.segment<2>(2 * chord.first) += (1 - part) * body_.factors[chord.first] * f;
      nodal.segment<2>(2 * chord.second) += part * body_.factors[chord.second] * f;
    }
  });
  scatter(elasticity().thickness * nodal, force);
}

}  // namespace bempd::regions
