#include "results/inside_picture.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "cancellation.hpp"
#include "error.hpp"
#include "geometry/body_mesh.hpp"
#include "geometry/outline.hpp"
#include "linalg/disjoint_sets.hpp"
#include "results/picture_arrays.hpp"

namespace bempd::results {

namespace {

using PointPair = std::array<int, 2>;

PointPair ordered(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

// Triangles of a body, disconnected along cracks: each point on a crack has a copy for each side of the crack.
class OpenedMesh {
 public:
  explicit OpenedMesh(BodyMesh mesh) : mesh_(std::move(mesh)) {
    for (const PointPair& side : mesh_.crack_sides) {
      cracks_.insert(ordered(side[0], side[1]));
      triangles_at_.try_emplace(side[0]);
      triangles_at_.try_emplace(side[1]);
    }
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (const int point : mesh_.triangles[t])
        if (const auto found = triangles_at_.find(point); found != triangles_at_.end())
          found->second.push_back(static_cast<int>(t));
    const std::vector<std::array<int, 3>> whole = mesh_.triangles;
    for (const auto& [point, around] : triangles_at_) open_at(point, around, whole);
  }

  const std::vector<std::array<int, 3>>& triangles() const { return mesh_.triangles; }

  // Places at which values are computed and then averaged, for each point: the point itself or, on a crack, where
  // values jump, places just inside each of its triangles.
  std::vector<std::vector<Point>> places() const {
    std::vector<std::vector<Point>> all;
    for (const Point& point : mesh_.points) all.push_back({point});
    for (const int point : on_cracks_) all[static_cast<std::size_t>(point)].clear();
    constexpr double inwards = 0.05;
    for (const std::array<int, 3>& triangle : mesh_.triangles) {
      const Point centre = (at(triangle[0]) + at(triangle[1]) + at(triangle[2])) / 3;
      for (const int point : triangle)
        if (on_cracks_.contains(point))
          all[static_cast<std::size_t>(point)].emplace_back(at(point) + inwards * (centre - at(point)));
    }
    return all;
  }
  const std::vector<Point>& points() const { return mesh_.points; }

 private:
  const Point& at(int point) const { return mesh_.points[static_cast<std::size_t>(point)]; }

  // Makes copies of a point on a crack. Triangles around the point get the same copy if they are connected by sides off
  // the crack.
  void open_at(int point, const std::vector<int>& around, const std::vector<std::array<int, 3>>& whole) {
    linalg::DisjointSets joined(static_cast<int>(around.size()));
    std::map<int, int> with_side;  // triangle by the other end of a side
    for (std::size_t i = 0; i < around.size(); ++i)
      for (const int other : whole[static_cast<std::size_t>(around[i])]) {
        if (other == point || cracks_.contains(ordered(point, other))) continue;
        const auto [found, is_new] = with_side.try_emplace(other, static_cast<int>(i));
        if (!is_new) joined.join(found->second, static_cast<int>(i));
      }
    std::map<int, int> copies;
    for (std::size_t i = 0; i < around.size(); ++i) {
      const int group = joined.find(static_cast<int>(i));
      const auto [copy, is_new] =
          copies.try_emplace(group, copies.empty() ? point : static_cast<int>(mesh_.points.size()));
      if (is_new && copy->second != point) mesh_.points.emplace_back(at(point));
      on_cracks_.insert(copy->second);
      std::array<int, 3>& triangle = mesh_.triangles[static_cast<std::size_t>(around[i])];
      std::replace(triangle.begin(), triangle.end(), point, copy->second);
    }
  }

  BodyMesh mesh_;
  std::set<PointPair> cracks_;
  std::map<int, std::vector<int>> triangles_at_;  // for each point on a crack
  std::set<int> on_cracks_;
};

}  // namespace

void add_inside(output::VtuGrid& grid, const regions::Region& region, const scene::Region& described, double size,
                const regions::Solution& solution, const regions::FieldsOfRegion& fields) {
  const CrackLines* cracks = region.crack_elements() ? region.crack_elements()->lines() : nullptr;
  const OpenedMesh mesh(mesh_body(edges_of(described.outline()), cracks ? *cracks : CrackLines(), size));
  const std::unique_ptr<regions::Evaluator> evaluator = region.results().evaluator(solution, fields, true);
  std::vector<double> displacements, stresses;
  for (const std::vector<Point>& places : mesh.places()) {
    check_cancelled();
    regions::PointValue sum;
    for (const Point& place : places) {
      const regions::PointValue value = evaluator->at(place);
      sum.displacement += value.displacement / static_cast<double>(places.size());
      sum.stress += value.stress / static_cast<double>(places.size());
    }
    if (!sum.displacement.allFinite() || !sum.stress.allFinite())
      fail(Failure::unsolvable, "a displacement or stress inside region ", region.id(),
           " is beyond the range of numbers; choose other units, or smaller loads");
    displacements.insert(displacements.end(), {sum.displacement.x(), sum.displacement.y()});
    stresses.insert(stresses.end(), {sum.stress[0], sum.stress[1], sum.stress[2]});
  }
  append(grid.point_data, "displacement", 2, displacements);
  append_stress(grid.point_data, region.elasticity(), stresses);
  const auto first = static_cast<std::int64_t>(grid.points.size());
  grid.points.insert(grid.points.end(), mesh.points().begin(), mesh.points().end());
  for (const std::array<int, 3>& t : mesh.triangles()) {
    grid.add_cell(output::VtuCell::triangle, {first + t[0], first + t[1], first + t[2]});
    std::get<std::vector<std::int32_t>>(grid.cell_data[0].values).push_back(region.id());
  }
}

}  // namespace bempd::results
