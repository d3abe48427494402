#include "crack/path.hpp"

#include <deque>

namespace bempd::crack {

std::vector<PathVertex> path_of(int crack, std::span<const Point> described, std::span<const Extension> extensions) {
  std::deque<PathVertex> path;
  for (const Point& place : described) path.push_back({.place = place});
  for (const Extension& e : extensions) {
    if (e.crack != crack) continue;
    if (path.empty()) {
      path.push_back({.place = {e.from_x, e.from_y}, .event = e.event, .end = -1, .load_factor = e.load_factor});
    }
    const PathVertex vertex{{e.x, e.y},    e.event,     e.end, e.load_factor, {e.factor_1, e.factor_2},
                            e.rate_before, e.resistance};
    if (e.end == 0) {
      path.push_front(vertex);
    } else {
      path.push_back(vertex);
    }
  }
  return {path.begin(), path.end()};
}

std::vector<Point> points_of_path(const std::vector<PathVertex>& path) {
  std::vector<Point> places;
  places.reserve(path.size());
  for (const PathVertex& vertex : path) places.push_back(vertex.place);
  return places;
}

double length_of(const std::vector<PathVertex>& path) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < path.size(); ++k) sum += (path[k + 1].place - path[k].place).norm();
  return sum;
}

}  // namespace bempd::crack
