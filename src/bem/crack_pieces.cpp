#include "bem/crack_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "geometry/edge.hpp"
#include "geometry/outline.hpp"
#include "linalg/disjoint_sets.hpp"

namespace bempd::bem {

namespace {

// Step of a walk with the body on its left, as a number: step 2 l follows crack line l, step 2 l + 1 runs back along
// it, and step 2 * (number of lines) + e is boundary element e.
using WalkStep = int;

// Closed walk along the boundary and the crack lines, with a part of the body on its left.
struct Walk {
  std::vector<WalkStep> steps;
  double area = 0;
};

class Walks {
 public:
  Walks(const CrackLines& cracks, const BoundaryMesh& mesh, const std::vector<std::array<int, 2>>& mouth_of_joint)
      : cracks_(cracks), mesh_(mesh), mouths_(mouth_of_joint), around_(cracks.joints.size()) {
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
      starting_at_[mesh.elements[e].nodes[0]] = static_cast<int>(e);
    for (std::size_t j = 0; j < mouths_.size(); ++j)
      if (mouths_[j][0] >= 0) ends_at_[mouths_[j][0]] = static_cast<int>(j);
    for (int l = 0; l < lines(); ++l)
      for (int end = 0; end < 2; ++end)
        if (const int joint = cracks.lines[l].joints[end]; joint >= 0) around_[joint].push_back({l, end});
    for (std::size_t j = 0; j < around_.size(); ++j) sort_around(static_cast<int>(j));
  }

  const std::vector<std::vector<LineEnd>>& around() const { return around_; }

  std::vector<Walk> all() const {
    std::vector<char> seen(static_cast<std::size_t>(2 * lines()) + mesh_.elements.size(), 0);
    std::vector<Walk> walks;
    for (WalkStep first = 0; first < static_cast<WalkStep>(seen.size()); ++first) {
      if (seen[first]) continue;
      Walk walk;
      for (WalkStep step = first; !seen[step]; step = next(step)) {
        seen[step] = 1;
        walk.steps.push_back(step);
      }
      walk.area = signed_area(edges(walk));
      walks.push_back(std::move(walk));
    }
    return walks;
  }

  std::vector<Edge> edges(const Walk& walk) const {
    std::vector<Edge> edges;
    for (const WalkStep step : walk.steps) {
      if (step >= 2 * lines()) {
        const BoundaryElement& e = mesh_.elements[step - 2 * lines()];
        edges.emplace_back(Arc{mesh_.nodes[e.nodes[0]], mesh_.nodes[e.nodes[2]], e.sweep});
        continue;
      }
      std::vector<Point> points = cracks_.lines[step / 2].points;
      if (step % 2 == 1) std::reverse(points.begin(), points.end());
      for (std::size_t i = 0; i + 1 < points.size(); ++i) edges.emplace_back(points[i], points[i + 1]);
    }
    return edges;
  }

  int lines() const { return static_cast<int>(cracks_.lines.size()); }

 private:
  WalkStep out(const LineEnd& e) const { return 2 * e.line + e.end; }

  // Next step of a walk (closed tour with the body on its left): at a joint, the first line or boundary clockwise from
  // the line that arrives. At a tip the walk turns back along the same line.
  WalkStep next(WalkStep step) const {
    if (step >= 2 * lines()) {
      const int node = mesh_.elements[step - 2 * lines()].nodes[2];
      const auto mouth = ends_at_.find(node);
      if (mouth != ends_at_.end()) return out(around_[mouth->second].back());
      return 2 * lines() + starting_at_.at(node);
    }
    const int line = step / 2, end = step % 2 == 0 ? 1 : 0, joint = cracks_.lines[line].joints[end];
    if (joint < 0) return step ^ 1;
    const std::vector<LineEnd>& all = around_[joint];
    const auto own =
        std::find_if(all.begin(), all.end(), [&](const LineEnd& e) { return e.line == line && e.end == end; });
    if (own != all.begin()) return out(*(own - 1));
    return mouths_[joint][0] < 0 ? out(all.back()) : 2 * lines() + starting_at_.at(mouths_[joint][1]);
  }

  Point direction(const LineEnd& e) const {
    const std::vector<Point>& points = cracks_.lines[e.line].points;
    return e.end == 0 ? Point(points[1] - points[0]) : Point(points[points.size() - 2] - points.back());
  }

  // Sorts the lines at a joint by their angles. At a crack mouth, angles count from the boundary that starts at the
  // mouth. The angle of a line along this boundary may be slightly negative by rounding.
  void sort_around(int joint) {
    Point axis(1, 0);
    double back = 2 * std::numbers::pi;
    const auto angle_of = [&](const Point& d) {
      const double angle = std::atan2(cross(axis, d), axis.dot(d));
      return angle < 0 ? angle + 2 * std::numbers::pi : angle;
    };
    if (mouths_[joint][0] >= 0) {
      axis = tangent(starting_at_.at(mouths_[joint][1]), 0);
      for (std::size_t e = 0; e < mesh_.elements.size(); ++e)
        if (mesh_.elements[e].nodes[2] == mouths_[joint][0]) back = angle_of(-tangent(static_cast<int>(e), 1));
    }
    const double outside = 0.5 * (back + 2 * std::numbers::pi);
    const auto place = [&](const LineEnd& e) {
      const double angle = angle_of(direction(e));
      return angle > outside ? angle - 2 * std::numbers::pi : angle;
    };
    std::stable_sort(around_[joint].begin(), around_[joint].end(),
                     [&](const LineEnd& a, const LineEnd& b) { return place(a) < place(b); });
  }

  Point tangent(int element, double fraction) const {
    const BoundaryElement& e = mesh_.elements[element];
    return Arc{mesh_.nodes[e.nodes[0]], mesh_.nodes[e.nodes[2]], e.sweep}.tangent(fraction);
  }

  const CrackLines& cracks_;
  const BoundaryMesh& mesh_;
  const std::vector<std::array<int, 2>>& mouths_;
  std::vector<std::vector<LineEnd>> around_;
  std::map<int, int> starting_at_;  // boundary element that starts at a node
  std::map<int, int> ends_at_;      // joint of the mouth before which a node lies
};

// Number of the connected part of the boundary and the cracks along which each walk (closed tour with the body on its
// left) runs. Boundary loops and crack lines that are connected are one part.
std::vector<int> parts_of(const std::vector<Walk>& walks, int lines) {
  linalg::DisjointSets joined(static_cast<int>(walks.size()));
  std::vector<int> walk_of(static_cast<std::size_t>(2 * lines), -1);
  for (std::size_t w = 0; w < walks.size(); ++w)
    for (const WalkStep step : walks[w].steps)
      if (step < 2 * lines) walk_of[step] = static_cast<int>(w);
  for (int l = 0; l < lines; ++l) joined.join(walk_of[2 * l], walk_of[2 * l + 1]);
  std::vector<int> part;
  for (std::size_t w = 0; w < walks.size(); ++w) part.push_back(joined.find(static_cast<int>(w)));
  return part;
}

// Flags the walks (closed tours with the body on their left) that go around the outside of a connected part, such as a
// hole with its cracks, or a crack inside the body. Every part but the outermost has one walk of this kind. All other
// walks go around a piece of the body.
std::vector<char> go_around_outside(const std::vector<Walk>& walks, const std::vector<int>& part, int lines) {
  std::vector<int> least(walks.size(), -1);
  int outermost = -1;
  for (std::size_t w = 0; w < walks.size(); ++w) {
    int& best = least[part[w]];
    if (best < 0 || walks[w].area < walks[best].area) best = static_cast<int>(w);
    const auto& steps = walks[w].steps;
    if (std::find(steps.begin(), steps.end(), 2 * lines) != steps.end()) outermost = part[w];
  }
  std::vector<char> outside(walks.size(), 0);
  for (std::size_t p = 0; p < least.size(); ++p)
    if (least[p] >= 0 && static_cast<int>(p) != outermost) outside[least[p]] = 1;
  return outside;
}

// Step of a walk (closed tour with the body on its left) that runs along the boundary element with the smallest number;
// a number larger than all steps if the walk has no boundary element.
WalkStep first_on_boundary(const Walk& walk, int lines) {
  WalkStep first = std::numeric_limits<WalkStep>::max();
  for (const WalkStep step : walk.steps)
    if (step >= 2 * lines) first = std::min(first, step);
  return first;
}

// Piece of the body on the left of every walk (closed tour along boundary and cracks). `around_pieces` are the walks
// around a piece; any other walk belongs to the smallest piece in which it lies.
std::vector<int> pieces_of(const Walks& finder, const std::vector<Walk>& walks, const std::vector<int>& part,
                           const std::vector<int>& around_pieces) {
  std::vector<int> piece(walks.size(), -1);
  for (std::size_t k = 0; k < around_pieces.size(); ++k) piece[around_pieces[k]] = static_cast<int>(k);
  for (std::size_t w = 0; w < walks.size(); ++w) {
    if (piece[w] >= 0) continue;
    const Point place = finder.edges(walks[w]).front().start;
    double least = std::numeric_limits<double>::infinity();
    for (const int other : around_pieces) {
      if (part[other] == part[w] || walks[other].area >= least) continue;
      if (locate(finder.edges(walks[other]), place, 0) == Location::outside) continue;
      least = walks[other].area;
      piece[w] = piece[other];
    }
  }
  return piece;
}

}  // namespace

BoundaryMesh elements_of_piece(const BoundaryMesh& mesh, const CrackPieces& pieces, int piece) {
  if (pieces.count == 1) return mesh;
  BoundaryMesh own = mesh;
  own.elements.clear();
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (pieces.of_element[e] == piece) own.elements.push_back(mesh.elements[e]);
  return own;
}

CrackPieces find_pieces(const CrackLines& cracks, const BoundaryMesh& mesh,
                        const std::vector<std::array<int, 2>>& mouth_of_joint) {
  const Walks finder(cracks, mesh, mouth_of_joint);
  const std::vector<Walk> walks = finder.all();
  const int lines = finder.lines();
  const std::vector<int> part = parts_of(walks, lines);
  const std::vector<char> outside = go_around_outside(walks, part, lines);
  std::vector<int> around_pieces;
  for (std::size_t w = 0; w < walks.size(); ++w)
    if (!outside[w]) around_pieces.push_back(static_cast<int>(w));
  CrackPieces pieces;
  pieces.around = finder.around();
  pieces.count = static_cast<int>(around_pieces.size());
  if (pieces.count == 1) return pieces;
  std::stable_sort(around_pieces.begin(), around_pieces.end(), [&](int a, int b) {
    return first_on_boundary(walks[a], lines) < first_on_boundary(walks[b], lines);
  });
  const std::vector<int> piece = pieces_of(finder, walks, part, around_pieces);
  pieces.of_element.assign(mesh.elements.size(), 0);
  pieces.of_line.assign(static_cast<std::size_t>(lines), {0, 0});
  for (std::size_t w = 0; w < walks.size(); ++w)
    for (const WalkStep step : walks[w].steps) {
      if (step < 2 * lines) {
        pieces.of_line[step / 2][step % 2] = piece[w];
      } else {
        pieces.of_element[step - 2 * lines] = piece[w];
      }
    }
  return pieces;
}

}  // namespace bempd::bem
