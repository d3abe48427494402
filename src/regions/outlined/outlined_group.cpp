#include "regions/outlined/outlined_group.hpp"

#include <algorithm>

#include "pd/cell_squares.hpp"
#include "pd/outlined/cell_patches.hpp"
#include "regions/outlined/outlined_region.hpp"

namespace bempd::regions {

namespace {

std::vector<int> ids_of(const std::vector<OutlinedRegion*>& regions) {
  std::vector<int> ids;
  for (const OutlinedRegion* region : regions) ids.push_back(region->id());
  return ids;
}

// Places at which a support or a load acts on a single point of the regions, in grid coordinates of the first region.
std::vector<Point> points_of_conditions(const std::vector<OutlinedRegion*>& regions, const Preparation& p) {
  std::vector<Point> places;
  for (const auto* conditions : {&p.scene.supports(), &p.scene.loads()}) {
    for (const scene::Condition& condition : *conditions) {
      const std::optional<Point> at = condition.removed() ? std::nullopt : condition.place->point();
      const auto has = [&](const OutlinedRegion* region) {
        return scene::contains(p.scene, region->id(), *at, p.tolerance);
      };
      if (at && std::any_of(regions.begin(), regions.end(), has)) places.push_back(regions.front()->to_grid(*at));
    }
  }
  return places;
}

// Whether each of `places` is one of `points`, up to the tolerance.
bool are_among(const std::vector<Point>& places, const std::vector<Point>& points, double tolerance) {
  return std::all_of(places.begin(), places.end(), [&](const Point& place) {
    return std::any_of(points.begin(), points.end(), [&](const Point& p) { return (p - place).norm() <= tolerance; });
  });
}

}  // namespace

bool OutlinedGroup::join(const std::shared_ptr<OutlinedGroup>& group, const Preparation& preparation) {
  Box box;
  std::vector<Point> origins;
  for (const OutlinedRegion* member : group->members_) {
    origins.push_back(member->origin());
    box.extend(bounding_box(preparation.scene.region(member->id()).outline()));
  }
  for (OutlinedRegion* member : group->members_) member->move_origin(box.min());
  const double spacing = group->members_.front()->spacing();
  if (box.volume() <= OutlinedRegion::most_places * spacing * spacing && group->build(preparation) &&
      group->divide_among_members(preparation)) {
    for (std::size_t m = 0; m < origins.size(); ++m) {
      const Part& part = group->parts_[m];
      pd::OutlinedBody own;
      own.cells = part.cells, own.factors = group->body_.factors, own.place = group->body_.place;
      for (const int point : part.points) {
        own.points.push_back(group->body_.points[point]);
        own.areas.push_back(group->body_.areas[point]);
      }
      group->members_[m]->join(group, {group->outline_, part.own_number, part.areas}, std::move(own));
    }
    return true;
  }
  for (std::size_t m = 0; m < origins.size(); ++m) group->members_[m]->move_origin(origins[m]);
  return false;
}

// Builds the body inside the common outline. Returns false if there is no network of bonds for the body, or if the body
// lacks a point at which a support or a load acts.
bool OutlinedGroup::build(const Preparation& preparation) {
  const OutlinedRegion& leader = *members_.front();
  outline_ = std::make_shared<DividedOutline>(ids_of(members_), leader);
  if (!outline_->divide(preparation) || outline_->has_impossible_corner()) return false;
  const pd::LatticePlace place = leader.place_of_lattice(preparation);
  const Eigen::Matrix2d turn(Eigen::Rotation2Dd(place.angle));
  const std::vector<Point> needed = points_of_conditions(members_, preparation);
  const double same = 10 * preparation.tolerance / leader.spacing();
  std::vector<Point> possible = outline_->chords().nodes;
  for (const Point& p : needed)
    possible.emplace_back(place.origin + turn * (turn.transpose() * (p - place.origin)).array().round().matrix());
  if (!are_among(needed, possible, same)) return false;
  body_ = pd::build_outlined_body(outline_->chords(), place, leader.horizon_ratio(), leader.elasticity(),
                                  preparation.options.whole_number("threads"));
  if (!body_.is_exact() || !are_among(needed, body_.points, same)) return false;
  if (!pd::is_bond_based(leader.elasticity())) stencils_ = pd::cell_stencils(body_);
  nodes_.assign(body_.points.size(), SharedPoints::nobody);
  return reproduce_material(stencils_);
}

// Gives each member its part of the body. Returns false if a member lacks a point of its own edges.
bool OutlinedGroup::divide_among_members(const Preparation& preparation) {
  const OutlinedRegion& leader = *members_.front();
  const auto to_grid = [&](const Arc& arc) {
    return Arc{leader.to_grid(arc.start), leader.to_grid(arc.end), arc.sweep};
  };
  std::vector<std::vector<std::vector<Arc>>> shapes;
  for (const OutlinedRegion* member : members_) {
    const Outline& outline = preparation.scene.region(member->id()).outline();
    shapes.emplace_back();
    int number = 0;
    for (const auto& loop : outline.loops) {
      shapes.back().emplace_back();
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Edge edge = outline.edge(number++);
        for (int piece = 0; piece < edge.piece_count(); ++piece)
          shapes.back().back().push_back(to_grid(edge.piece(piece)));
      }
    }
  }
  std::vector<Arc> common;
  for (const Contact& c : preparation.arrangement.contacts) {
    const auto has = [&](int region) {
      return std::any_of(members_.begin(), members_.end(), [&](const auto* m) { return m->id() == region + 1; });
    };
    if (c.region > c.other_region || !has(c.region) || !has(c.other_region)) continue;
    const Edge edge = preparation.scene.region(c.region + 1).edge(c.edge + 1);
    const double joint = edge.joint();
    if (c.from < joint) common.push_back(to_grid(edge.part(c.from, std::min(c.to, joint))));
    if (c.to > joint) common.push_back(to_grid(edge.part(std::max(c.from, joint), c.to)));
  }
  for (const std::vector<CellPart>& cells : parts_of_cells(body_.points, body_.cells, shapes, common))
    parts_.push_back(part_of(cells));
  for (const pd::Chord& chord : outline_->chords().chords) {
    const int region = outline_->piece_of(chord).region;
    const auto member =
        std::find_if(members_.begin(), members_.end(), [&](const auto* m) { return m->id() == region; });
    const std::vector<int>& own = parts_[static_cast<std::size_t>(member - members_.begin())].own_number;
    if (own[chord.first] < 0 || own[chord.second] < 0) return false;
  }
  return true;
}

OutlinedGroup::Part OutlinedGroup::part_of(const std::vector<CellPart>& cells) const {
  Part part;
  part.own_number.assign(body_.points.size(), -1);
  for (const CellPart& one : cells)
    for (const int point : body_.cells[one.cell]) part.own_number[point] = 0;
  for (std::size_t point = 0; point < part.own_number.size(); ++point) {
    if (part.own_number[point] < 0) continue;
    part.own_number[point] = static_cast<int>(part.points.size());
    part.points.push_back(static_cast<int>(point));
  }
  part.areas.assign(part.points.size(), 0.0);
  for (const CellPart& one : cells) {
    std::array<int, 4>& cell = part.cells.emplace_back(body_.cells[one.cell]);
    const double of_corner = one.share * pd::area_of_corner(body_.points, cell);
    for (int k = 0; k < pd::corner_count(cell); ++k) part.areas[part.own_number[cell[k]]] += of_corner;
    for (int& corner : cell) corner = part.own_number[corner];
  }
  return part;
}

std::vector<int> OutlinedGroup::add_nodes(const OutlinedRegion& member, const Preparation& preparation,
                                          const Contributions& contributions) {
  const std::vector<char> is_shared = outline_->shared_nodes(preparation);
  const auto m = std::find(members_.begin(), members_.end(), &member) - members_.begin();
  std::vector<int> own;
  for (const int point : parts_[static_cast<std::size_t>(m)].points) {
    int& node = nodes_[point];
    const Point place = member.from_grid(body_.points[point]);
    const bool shared = point < outline_->chords().count() && is_shared[point];
    if (node == SharedPoints::nobody)
      node = shared ? contributions.registry.add_shared(place, member.id()) : contributions.registry.add(place);
    own.push_back(node);
  }
  return own;
}

void OutlinedGroup::add_bonds(const Preparation& preparation, const Contributions& contributions) {
  std::vector<SharedPoints::Member> members;
  for (std::size_t m = 0; m < members_.size(); ++m) members.push_back({members_[m], parts_[m].points, Point::Zero()});
  const SharedPoints points(std::move(members), body_.points);
  SharedBonds bonds(points, body_.network, preparation, contributions);
  const OutlinedRegion& leader = *members_.front();
  const std::vector<int> squares = add_squares(
      stencils_, leader.elasticity(), leader.spacing(), [&](int point) { return points.node(point); },
      [&](int bond) { return bonds.term(bond); }, contributions);
  for (std::size_t m = 0; m < members_.size(); ++m) {
    std::vector<int> own_squares;
    pd::CellStencils own = stencils_of(m, squares, bonds, own_squares);
    bonds.give(static_cast<int>(m), std::move(own_squares));
    members_[m]->set_stencils(std::move(own));
  }
}

// Gradient stencils of the patches (groups of cells) that have points of a member. `own_squares` gets the number of the
// first cell square (energy term) of each of these patches.
pd::CellStencils OutlinedGroup::stencils_of(std::size_t member, const std::vector<int>& squares, SharedBonds& bonds,
                                            std::vector<int>& own_squares) const {
  pd::CellStencils own;
  const std::vector<int>& own_number = parts_[member].own_number;
  for (std::size_t p = 0; p < stencils_.count(); ++p) {
    const std::span<const int> at = stencils_.points(p);
    if (std::none_of(at.begin(), at.end(), [&](int point) { return own_number[point] >= 0; })) continue;
    for (std::size_t k = 0; k < at.size(); ++k) {
      own.point.push_back(bonds.number(static_cast<int>(member), at[k]));
      own.gradient.push_back(stencils_.gradients(p)[k]);
      own.share.push_back(stencils_.shares(p)[k]);
    }
    own.area.push_back(stencils_.area[p]);
    own.start.push_back(own.point.size());
    own.bond_start.push_back(0);
    own_squares.push_back(squares[p]);
  }
  return own;
}

}  // namespace bempd::regions
