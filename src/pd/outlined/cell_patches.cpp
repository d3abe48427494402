#include "pd/outlined/cell_patches.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace bempd::pd {

namespace {

using CellsByEdge = std::map<std::pair<int, int>, int>;  // directed

// Edge that two triangles share, with the numbers of the two triangles.
struct Joint {
  double length;
  int one, other;
};

std::vector<Joint> joints_of_triangles(const std::vector<Point>& points, const FillingCells& cells) {
  CellsByEdge by_edge;
  std::vector<Joint> joints;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (!is_triangle(cells[c])) continue;
    for_each_edge(cells[c], [&](int a, int b) {
      by_edge[{a, b}] = static_cast<int>(c);
      const auto found = by_edge.find({b, a});
      if (found != by_edge.end())
        joints.push_back({(points[b] - points[a]).norm(), found->second, static_cast<int>(c)});
    });
  }
  std::stable_sort(joints.begin(), joints.end(), [](const Joint& a, const Joint& b) { return a.length > b.length; });
  return joints;
}

}  // namespace

CellPatches make_patches(const std::vector<Point>& points, const FillingCells& cells, int outline_count) {
  CellPatches made;
  std::vector<int> patch_of(cells.size(), -1);
  const auto put = [&](int cell, int patch) {
    patch_of[cell] = patch;
    made.cells[patch].push_back(cell);
  };
  const auto put_alone = [&](int cell) {
    made.cells.emplace_back();
    put(cell, static_cast<int>(made.cells.size()) - 1);
  };
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (!is_triangle(cells[c])) put_alone(static_cast<int>(c));
  const std::vector<Joint> joints = joints_of_triangles(points, cells);
  for (const Joint& joint : joints) {
    if (patch_of[joint.one] >= 0 || patch_of[joint.other] >= 0) continue;
    put_alone(joint.one);
    put(joint.other, patch_of[joint.one]);
  }
  for (const Joint& joint : joints) {
    for (const auto& [one, other] : {std::pair(joint.one, joint.other), std::pair(joint.other, joint.one)})
      if (patch_of[one] < 0 && patch_of[other] >= 0 && made.cells[patch_of[other]].size() == 2)
        put(one, patch_of[other]);
  }
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (patch_of[c] < 0) put_alone(static_cast<int>(c));

  // The edges of cells near the outline are collected, so that the patches beside each patch at the outline can be
  // found.
  std::vector<char> at_outline(made.cells.size(), 0), near(points.size(), 0);
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (*std::min_element(cells[c].begin(), cells[c].end()) < outline_count) at_outline[patch_of[c]] = 1;
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const int p : cells[c]) near[p] = near[p] || at_outline[patch_of[c]];
  CellsByEdge by_edge;
  for (std::size_t c = 0; c < cells.size(); ++c)
    for_each_edge(cells[c], [&](int a, int b) {
      if (near[a] && near[b]) by_edge[{a, b}] = patch_of[c];
    });
  made.behind_an_edge.resize(made.cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (!at_outline[patch_of[c]]) continue;
    for_each_edge(cells[c], [&](int a, int b) {
      const auto found = by_edge.find({b, a});
      if (found != by_edge.end() && found->second != patch_of[c])
        made.behind_an_edge[patch_of[c]].push_back(found->second);
    });
  }
  return made;
}

}  // namespace bempd::pd
