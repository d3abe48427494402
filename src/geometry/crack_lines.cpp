#include "geometry/crack_lines.hpp"

#include <algorithm>

#include "error.hpp"
#include "geometry/outline.hpp"
#include "geometry/segment.hpp"

namespace bempd {

namespace {

// Place on a crack path where a crack line has to end; `way` is the distance of this place along the path.
struct Mark {
  double way;
  Point place;
  bool mouth;
};

struct Path {
  const CrackPath& given;
  std::vector<double> ways{0.0};  // distances of its points along the path
  std::vector<Mark> marks{};

  explicit Path(const CrackPath& path) : given(path) {
    for (int i = 0; i < segments(); ++i) ways.push_back(ways.back() + segment(i).length());
  }
  int segments() const { return static_cast<int>(given.points.size()) - 1; }
  Segment segment(int i) const { return {given.points[i], given.points[i + 1]}; }
  void mark(int i, const Point& place, bool mouth) {
    const Segment s = segment(i);
    marks.push_back({ways[i] + closest_fraction(s, place) * s.length(), place, mouth});
  }
  Point at(double way) const {
    int i = 0;
    while (i + 1 < segments() && way > ways[i + 1]) ++i;
    return segment(i).at((way - ways[i]) / (ways[i + 1] - ways[i]));
  }
};

// Places where two segments cross or touch: none, one, or the two ends of a piece that they have in common.
std::vector<Point> common_places(const Segment& a, const Segment& b, double tolerance) {
  if (const auto crossing = proper_crossing(a, b)) return {a.at(crossing->fraction_a)};
  std::vector<Point> places;
  const auto add = [&](const Segment& segment, const Point& end) {
    if (distance(segment, end) > tolerance) return;
    const auto near = [&](const Point& p) { return (p - end).norm() <= 4 * tolerance; };
    if (std::none_of(places.begin(), places.end(), near)) places.push_back(end);
  };
  for (const Point& end : {b.start, b.end}) add(a, end);
  for (const Point& end : {a.start, a.end}) add(b, end);
  return places;
}

void mark_meetings(Path& a, int i, Path& b, int j, double tolerance) {
  // Segments of one path are not compared if one follows the other, or if the path between them is too short to hold
  // two different places.
  const bool follows = &a == &b && (j == i + 1 || a.ways[j] - a.ways[i + 1] <= 4 * tolerance);
  const std::vector<Point> places = common_places(a.segment(i), b.segment(j), tolerance);
  require(places.size() <= 1, "crack ", a.given.id, " runs along ",
          &a == &b ? text("itself") : text("crack ", b.given.id), " from (", places.empty() ? 0 : places[0].x(), ", ",
          places.empty() ? 0 : places[0].y(), "); give that piece once");
  if (follows || places.empty()) return;
  a.mark(i, places[0], false);
  b.mark(j, places[0], false);
}

void mark_mouths(Path& path, const std::vector<Edge>& boundary, double tolerance) {
  for (int i = 0; i < path.segments(); ++i) {
    const Segment segment = path.segment(i);
    for (const Edge& edge : boundary) {
      if (least_distance(edge, segment.at(0.5)) > 0.5 * segment.length() + 2 * tolerance) continue;
      std::vector<Point> places;
      for (const Crossing& c : meeting_points(Edge(segment.start, segment.end), edge))
        places.push_back(segment.at(c.fraction_a));
      for (const Point& end : {segment.start, segment.end})
        if (distance(edge, end) <= tolerance) places.push_back(end);
      for (const Point& end : {edge.start, edge.end})
        if (distance(segment, end) <= tolerance) places.push_back(end);
      for (const Point& place : places) path.mark(i, place, true);
    }
  }
}

// Merges marks (places where crack lines end) at the same place. The merged mark is a crack mouth if any of the marks
// is one.
void merge_marks(Path& path, double tolerance) {
  std::sort(path.marks.begin(), path.marks.end(), [](const Mark& a, const Mark& b) { return a.way < b.way; });
  std::vector<Mark> merged;
  for (const Mark& mark : path.marks) {
    if (!merged.empty() && mark.way - merged.back().way <= 4 * tolerance) {
      if (mark.mouth && !merged.back().mouth) merged.back() = mark;
    } else {
      merged.push_back(mark);
    }
  }
  path.marks = merged;
}

int joint_at(const Mark& mark, double tolerance, std::vector<CrackJoint>& joints) {
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if ((joints[j].place - mark.place).norm() > 8 * tolerance) continue;
    joints[j].mouth = joints[j].mouth || mark.mouth;
    return static_cast<int>(j);
  }
  joints.push_back({mark.place, mark.mouth});
  return static_cast<int>(joints.size()) - 1;
}

void require_inside(const Path& path, double from, double to, const std::vector<Edge>& boundary, double tolerance) {
  const Point middle = path.at(0.5 * (from + to));
  require(locate(boundary, middle, tolerance) == Location::inside, "crack ", path.given.id, " passes (", middle.x(),
          ", ", middle.y(), "), which is not inside the body; end the crack where it meets the boundary");
}

CrackLine line_between(const Path& path, int crack, const Mark& from, const Mark& to, std::array<int, 2> joints,
                       double tolerance) {
  CrackLine line{crack, {from.place}, from.way, joints, {}, path.given.given_elsewhere};
  double reached = from.way;
  const auto add = [&](const Point& place, double way) {
    int segment = 0;
    while (segment + 1 < path.segments() && 0.5 * (reached + way) > path.ways[segment + 1]) ++segment;
    line.points.push_back(place);
    line.grown.push_back(path.given.grown(segment));
    reached = way;
  };
  for (std::size_t i = 0; i < path.ways.size(); ++i)
    if (path.ways[i] > reached + 4 * tolerance && path.ways[i] < to.way - 4 * tolerance)
      add(path.given.points[i], path.ways[i]);
  add(to.place, to.way);
  return line;
}

void add_lines(Path& path, int crack, const std::vector<Edge>& boundary, double tolerance, CrackLines& result) {
  merge_marks(path, tolerance);
  std::vector<Mark> stations = path.marks;
  std::vector<int> joints;
  joints.reserve(stations.size() + 2);
  for (const Mark& mark : stations) joints.push_back(joint_at(mark, tolerance, result.joints));
  if (stations.empty() || stations.front().way > 4 * tolerance) {
    stations.insert(stations.begin(), {0, path.given.points.front(), false});
    joints.insert(joints.begin(), -1);
  }
  if (stations.size() == 1 || stations.back().way < path.ways.back() - 4 * tolerance) {
    stations.push_back({path.ways.back(), path.given.points.back(), false});
    joints.push_back(-1);
  }
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    require_inside(path, stations[i].way, stations[i + 1].way, boundary, tolerance);
    result.lines.push_back(
        line_between(path, crack, stations[i], stations[i + 1], {joints[i], joints[i + 1]}, tolerance));
  }
}

}  // namespace

double CrackLine::length() const {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) sum += (points[i + 1] - points[i]).norm();
  return sum;
}

CrackLines crack_lines(const std::vector<CrackPath>& given, const std::vector<Edge>& boundary, double tolerance) {
  std::vector<Path> paths(given.begin(), given.end());
  for (const Path& path : paths)
    require(path.ways.back() > 6 * tolerance, "crack ", path.given.id, " is ", path.ways.back(),
            " long, and places count as one up to ", tolerance, " here; leave it out, or choose a smaller body");
  for (std::size_t a = 0; a < paths.size(); ++a)
    for (std::size_t b = a; b < paths.size(); ++b)
      for (int i = 0; i < paths[a].segments(); ++i)
        for (int j = a == b ? i + 1 : 0; j < paths[b].segments(); ++j)
          mark_meetings(paths[a], i, paths[b], j, tolerance);
  CrackLines result;
  for (std::size_t c = 0; c < paths.size(); ++c) {
    mark_mouths(paths[c], boundary, tolerance);
    add_lines(paths[c], static_cast<int>(c), boundary, tolerance, result);
  }
  return result;
}

}  // namespace bempd
