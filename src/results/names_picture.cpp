#include "results/names_picture.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "scene/scene.hpp"

namespace bempd::results {

namespace {

using scene::Names;
using Kind = Names::Kind;

constexpr int number_of_edges = 102;   // number of the part, behind those of all other parts
constexpr int pieces_of_a_curve = 64;  // straight pieces that stand for a curved edge

// Cells of the part "edges" of a snapshot, with their texts and numbers.
class EdgePart {
 public:
  EdgePart(const scene::Scene& scene, const Names& names) : scene_(scene), names_(names) {}

  PicturePart picture_part() {
    for (const int id : scene_.region_ids())
      for (int edge = 1; edge <= scene_.region(id).edge_count(); ++edge) add_edge(id, edge);
    for (std::size_t c = 0; c < scene_.cracks().size(); ++c) add_crack(static_cast<int>(c) + 1, scene_.cracks()[c]);
    add_points(scene_.supports());
    add_points(scene_.loads());
    grid_.cell_data = {{"region", 1, std::move(regions_)},
                       {"edge", 1, std::move(edges_)},
                       {"crack", 1, std::move(cracks_)},
                       {"name", 1, std::move(edge_names_)},
                       {"region name", 1, std::move(region_names_)},
                       {"supports and loads", 1, std::move(conditions_)}};
    return {number_of_edges, "edges", std::move(grid_)};
  }

 private:
  void add_edge(int region, int number) {
    const Edge edge = scene_.region(region).edge(number);
    const int pieces = edge.straight() ? 1 : pieces_of_a_curve;
    std::vector<Point> way;
    for (int k = 0; k <= pieces; ++k) way.push_back(edge.at(static_cast<double>(k) / pieces));
    add(way, region, number, 0, [&](const scene::Place& place) {
      return place.edge() ? *place.edge() == std::pair(region, number) : !place.point() && place.needs(region);
    });
  }

  void add_crack(int number, const scene::Crack& crack) {
    const std::span<const Point> given = crack.given();
    if (given.empty()) return;
    add({given.begin(), given.end()}, 0, 0, number,
        [&](const scene::Place& place) { return place.needs_crack(number); });
  }

  void add_points(const std::vector<scene::Condition>& conditions) {
    for (const scene::Condition& condition : conditions) {
      const std::optional<Point> point = condition.removed() ? std::nullopt : condition.place->point();
      if (!point || std::find(points_.begin(), points_.end(), *point) != points_.end()) continue;
      points_.push_back(*point);
      add({*point}, 0, 0, 0, [&](const scene::Place& place) { return place.point() == point; });
    }
  }

  template <class IsThere>
  void add(const std::vector<Point>& way, int region, int edge, int crack, const IsThere& is_there) {
    std::vector<std::int64_t> points;
    for (const Point& place : way) {
      points.push_back(static_cast<std::int64_t>(grid_.points.size()));
      grid_.points.push_back(place);
    }
    grid_.add_cell(way.size() > 1 ? output::VtuCell::polyline : output::VtuCell::vertex, points);
    regions_.push_back(region), edges_.push_back(edge), cracks_.push_back(crack);
    edge_names_.push_back(names_.of_edge(region, edge));
    region_names_.push_back(names_.of(Kind::region, region));
    std::string there;
    const auto tell = [&](Kind kind, const std::vector<scene::Condition>& conditions) {
      for (std::size_t k = 0; k < conditions.size(); ++k)
        if (!conditions[k].removed() && is_there(*conditions[k].place))
          there += (there.empty() ? "" : ", ") + names_.called(kind, static_cast<int>(k) + 1);
    };
    tell(Kind::support, scene_.supports());
    tell(Kind::load, scene_.loads());
    conditions_.push_back(std::move(there));
  }

  const scene::Scene& scene_;
  const Names& names_;
  output::VtuGrid grid_;
  std::vector<std::int32_t> regions_, edges_, cracks_;
  std::vector<std::string> edge_names_, region_names_, conditions_;
  std::vector<Point> points_;
};

// Arrays, one for each named region, support and load, that store its number under its name.
std::vector<output::VtuArray> numbers(const scene::Scene& scene, const Names& names) {
  std::vector<output::VtuArray> found;
  const auto add = [&](Kind kind, std::size_t count) {
    for (int k = 1; k <= static_cast<int>(count); ++k)
      if (!names.of(kind, k).empty()) found.push_back({names.called(kind, k), 1, std::vector<std::int32_t>{k}});
  };
  add(Kind::region, static_cast<std::size_t>(scene.region_count()));
  add(Kind::support, scene.supports().size());
  add(Kind::load, scene.loads().size());
  return found;
}

}  // namespace

void add_names(std::vector<PicturePart>& parts, const scene::Scene& scene, const Names& names) {
  if (names.empty()) return;
  parts.push_back(EdgePart(scene, names).picture_part());
  const std::vector<output::VtuArray> all = numbers(scene, names);
  for (PicturePart& part : parts) part.grid.field_data = all;
}

}  // namespace bempd::results
