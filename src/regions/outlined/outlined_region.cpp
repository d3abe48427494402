#include "regions/outlined/outlined_region.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "error.hpp"
#include "pd/cell_squares.hpp"
#include "regions/outlined/common_bodies.hpp"
#include "regions/outlined/outlined_group.hpp"

namespace bempd::regions {

namespace {

// Gauss rule with four points on [0, 1].
constexpr double abscissa[4] = {0.0694318442029737, 0.3300094782075719, 0.6699905217924281, 0.9305681557970263};
constexpr double gauss_weight[4] = {0.1739274225687269, 0.3260725774312731, 0.3260725774312731, 0.1739274225687269};

// Smallest distance of a segment from lattice points, in spacings, measured along the axis with which the segment makes
// the larger angle. `shift` is the position of the lattice.
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

}  // namespace

OutlinedRegion::OutlinedRegion(int id, const PeridynamicDescription& described, const scene::Material& material)
    : BondedRegion(id, material, described.spacing(), described.horizon_ratio()),
      choice_(described.choice()),
      part_{std::make_shared<DividedOutline>(std::vector<int>{id}, *this), {}, {}},
      squares_(elasticity(), spacing(), body_, bonds_) {
  origin_ = bounding_box(described.outline()).min();
}

void OutlinedRegion::divide(const Preparation& preparation) {
  if (outline().is_divided()) return;
  const auto group = std::make_shared<OutlinedGroup>(regions_acting_as_one(*this, preparation));
  if (group->members().size() > 1 && OutlinedGroup::join(group, preparation)) return;
  std::vector<int> ids;
  for (const OutlinedRegion* member : group->members()) ids.push_back(member->id());
  if (std::any_of(ids.begin(), ids.end(), [&](int region) { return preparation.leaves_rows(region); }))
    throw CannotLeaveRows{std::move(ids)};
  for (OutlinedRegion* member : group->members()) member->part_.outline->divide(preparation);
}

void OutlinedRegion::mesh(const Preparation& preparation) {
  divide(preparation);
  for (const Contact& contact : preparation.arrangement.contacts) {
    if (contact.region != id() - 1) continue;
    require_common_points(preparation, contact);
  }
}

bool OutlinedRegion::shares_bonds_with(const BondedRegion& other) const {
  const auto* outlined = dynamic_cast<const OutlinedRegion*>(&other);
  return outlined && part_.outline == outlined->part_.outline;
}

void OutlinedRegion::join(std::shared_ptr<OutlinedGroup> group, Part part, pd::OutlinedBody body) {
  group_ = std::move(group), part_ = std::move(part), body_ = std::move(body);
  points_ = body_.points;
}

void OutlinedRegion::set_stencils(pd::CellStencils stencils) {
  body_.points.insert(body_.points.end(), bonds_.far_points.begin(), bonds_.far_points.end());
  squares_.set_stencils(std::move(stencils));
}

// Position of the lattice inside the outline. A lattice point lies at the lower left corner of the rectangle around the
// body, unless another position keeps the lattice points farther from cracks.
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

void OutlinedRegion::build(const Preparation& preparation, Contributions& contributions) {
  if (!group_) return build_alone(preparation, contributions);
  nodes_ = group_->add_nodes(*this, preparation, contributions);
  if (group_->members().back() != this) return;
  const std::shared_ptr<OutlinedGroup> group = std::move(group_);
  group->add_bonds(preparation, contributions);
  for (OutlinedRegion* member : group->members()) member->group_.reset();
}

void OutlinedRegion::build_alone(const Preparation& preparation, Contributions& contributions) {
  outline().require_possible_corners();
  const Box box = bounding_box(preparation.scene.region(id()).outline());
  const double places = box.volume() / (spacing() * spacing());
  require(places <= most_places, "region ", id(), " lies in a rectangle of ", places, " spacings ", spacing(),
          " squared; the limit is ", most_places, ": choose a larger spacing");
  const std::vector<char> is_shared = part_.outline->shared_nodes(preparation);
  const pd::Chords& chords = outline().chords();
  const int threads = preparation.options.whole_number("threads");
  body_ = pd::build_outlined_body(chords, place_of_lattice(preparation), horizon_ratio(), elasticity(), threads);
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
    squares_.set_stencils(pd::cell_stencils(body_));
    require(reproduce_material(squares_.stencils()), "region ", id(),
            " has an outline beside which no cells were found that ", "make Poisson's ratio ",
            elasticity().poisson_ratio, "; try a smaller spacing, or ",
            elasticity().state == PlaneState::stress ? "1/3" : "1/4", ", which bonds alone make");
  }
  bonds_.network = std::make_shared<const pd::Network>(std::move(body_.network));
  add_own_bonds(preparation, contributions);
  bonds_.squares = add_squares(
      squares_.stencils(), elasticity(), spacing(), [&](int point) { return nodes_[point]; },
      [&](int bond) { return static_cast<int>(bonds_.first) + bond; }, contributions);
}

std::optional<LatticeGrid> OutlinedRegion::lattice_grid() const {
  return LatticeGrid{from_grid(body_.place.origin), spacing(), horizon_ratio() * spacing(), choice_.angle};
}

// Adds the bonds that a crack cuts. An end of the crack that lies on a node of the outline (at a corner, or between two
// pieces of a round edge) is moved outwards and to its right, looking into the body. An end elsewhere on a round edge
// is moved outwards, because bonds between neighbouring points of a round hole run outside the body and would not be
// cut.
void OutlinedRegion::cut(const scene::Crack& crack, int number, std::vector<int>& bonds,
                         std::vector<std::string>& warnings) const {
  constexpr double on_point = 1e-8, on_arc = 1e-6, aside = 1e-3, beyond_arc = 0.5;  // in spacings
  scene::Crack beside = crack;
  const auto pass_by = [&](Point& end, const Point& next) {
    const Point inward = (next - end).normalized(), place = to_grid(end);
    for (int i = 0; i < outline().chords().count(); ++i) {
      if ((outline().chords().nodes[i] - place).norm() > on_point) continue;
      end += aside * spacing() * (Point(inward.y(), -inward.x()) - inward);
      return;
    }
    for (const DividedOutline::Piece& piece : outline().pieces())
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

std::vector<PlacedNode> OutlinedRegion::nodes_on(const EdgeSpan& span, double tolerance) const {
  const double slack = 10 * tolerance / span.geometry.length();
  std::vector<PlacedNode> found;
  const auto add = [&](int node, double at) {
    if (at < span.from - slack || at > span.to + slack) return;
    found.push_back({nodes_[point_at_node(node)], std::clamp((at - span.from) / (span.to - span.from), 0.0, 1.0)});
  };
  for (const pd::Chord& chord : outline().chords_on(id(), span.edge)) {
    if (found.empty()) add(chord.first, outline().fraction(chord, 0));
    add(chord.second, outline().fraction(chord, 1));
  }
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
  for (const pd::Chord& chord : outline().chords_on(id(), span.edge)) {
    const double begin = outline().fraction(chord, 0), end = outline().fraction(chord, 1);
    const double from = std::max(span.from, begin), to = std::min(span.to, end);
    if (from >= to) continue;
    const bool halves = !outline().piece_of(chord).arc.straight() && from == begin && to == end;
    for (int g = 0; g < 4; ++g) {
      const double at = from + abscissa[g] * (to - from), part = halves ? 0.5 : (at - begin) / (end - begin);
      const Point f = gauss_weight[g] * (to - from) * length * traction(span.geometry.at(at));
      nodal.segment<2>(2 * point_at_node(chord.first)) += (1 - part) * body_.factors[chord.first] * f;
      nodal.segment<2>(2 * point_at_node(chord.second)) += part * body_.factors[chord.second] * f;
    }
  }
  scatter(elasticity().thickness * nodal, force);
}

}  // namespace bempd::regions
