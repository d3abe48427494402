#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "geometry/segment.hpp"
#include "model/run_errors.hpp"

// Results of runs and their differences.
namespace bempd::model {

namespace {

// Path of one tip from the place where its growth began, with the length of the path up to each vertex.
struct TipPath {
  std::vector<Point> places;
  std::vector<double> lengths;

  double length() const { return lengths.back(); }
  double last_step() const { return lengths.size() < 2 ? 0 : lengths.back() - lengths[lengths.size() - 2]; }
  Point at(double length) const {
    const auto end = std::lower_bound(lengths.begin(), lengths.end(), length) - lengths.begin();
    if (end == 0) return places.front();
    if (end == static_cast<std::ptrdiff_t>(lengths.size())) return places.back();
    const auto k = static_cast<std::size_t>(end);
    const double share = (length - lengths[k - 1]) / (lengths[k] - lengths[k - 1]);
    return places[k - 1] + share * (places[k] - places[k - 1]);
  }
  double distance_to(const Point& place) const {
    double least = (places.front() - place).norm();
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
      least = std::min(least, distance(Segment{places[i], places[i + 1]}, place));
    return least;
  }
};

std::map<crack::TipId, TipPath> paths_of(const std::vector<crack::Extension>& extensions) {
  std::map<crack::TipId, TipPath> paths;
  for (const crack::Extension& e : extensions) {
    TipPath& path = paths[e.tip()];
    if (path.places.empty()) path.places.emplace_back(e.from_x, e.from_y), path.lengths.push_back(0);
    path.places.emplace_back(e.x, e.y);
    path.lengths.push_back(path.lengths.back() + e.length);
  }
  return paths;
}

// Difference between two paths of a tip [m]: the largest distance of a vertex of `path` from `other`, up to the length
// that both paths have. If the lengths of the paths differ by more than their last steps together, the difference is at
// least that excess.
double between(const TipPath& path, const TipPath& other) {
  const double common = std::min(path.length(), other.length());
  double most = other.distance_to(path.at(common));
  for (std::size_t i = 1; i < path.places.size(); ++i)
    if (path.lengths[i] <= common) most = std::max(most, other.distance_to(path.places[i]));
  const double apart = std::abs(path.length() - other.length());
  return std::max(most, apart - path.last_step() - other.last_step());
}

// Largest resistance of the body at events up to the growth `grown`, and the growth at which it occurs. Between events
// the resistance is interpolated.
RunAnswers::Place peak_until(const std::vector<RunAnswers::Place>& places, double grown) {
  RunAnswers::Place best{0, 0};
  const auto consider = [&](const RunAnswers::Place& place) {
    if (place.resistance > best.resistance) best = place;
  };
  for (std::size_t i = 0; i < places.size(); ++i) {
    const RunAnswers::Place& place = places[i];
    if (place.grown <= grown * (1 + 1e-9)) {
      consider(place);
    } else if (i > 0 && places[i - 1].grown < grown) {
      const RunAnswers::Place& before = places[i - 1];
      const double share = (grown - before.grown) / (place.grown - before.grown);
      consider({grown, before.resistance + share * (place.resistance - before.resistance)});
    }
  }
  return best;
}

double over(double difference, double scale) { return difference == 0 ? 0 : std::abs(difference / scale); }

}  // namespace

RunAnswers run_answers(const fracture::EvolutionState& state) {
  RunAnswers answers{{}, state.extensions};
  double grown = 0;
  auto next = state.extensions.begin();
  for (const fracture::HistoryEntry& line : state.history) {
    if (line.event == 0) continue;
    answers.places.push_back({grown, line.resistance_before});
    for (; next != state.extensions.end() && next->event <= line.event; ++next) grown += next->length;
  }
  return answers;
}

double rise_above_peak(const RunAnswers& run, const RunAnswers& other) {
  if (run.places.empty() || other.places.empty()) return 0;
  const double peak = peak_until(run.places, run.places.back().grown).resistance;
  const double highest = peak_until(other.places, other.places.back().grown).resistance;
  return peak > 0 ? std::max(0.0, highest / peak - 1) : 0;
}

double largest_turn_of(const RunAnswers& run) {
  double largest = 0;
  std::set<crack::TipId> grown;
  for (const crack::Extension& e : run.extensions)
    if (!grown.insert(e.tip()).second) largest = std::max(largest, std::abs(e.angle));
  return largest;
}

// The differences of the loads of first growth and of the peaks are 1 if cracks have grown in one of the runs only: the
// other load and the other peak are unknown.
RunDifference difference(const RunAnswers& run, const RunAnswers& other) {
  RunDifference found;
  if (run.places.empty() != other.places.empty()) {
    found.peak = 1, found.is_at_start = false;
  } else if (!run.places.empty()) {
    const double end = run.places.back().grown;
    const RunAnswers::Place peak = peak_until(run.places, end), other_peak = peak_until(other.places, end);
    found.peak = over(peak.resistance - other_peak.resistance, peak.resistance);
    found.is_at_start = peak.grown == 0 && other_peak.grown == 0;
  }
  if (run.extensions.empty() || other.extensions.empty()) {
    found.first_growth = run.extensions.empty() && other.extensions.empty() ? 0 : 1;
  } else {
    const double first = run.extensions.front().load_factor;
    found.first_growth = over(first - other.extensions.front().load_factor, first);
  }
  const std::map<crack::TipId, TipPath> paths = paths_of(run.extensions), others = paths_of(other.extensions);
  const auto consider = [&](const crack::TipId& tip, double apart) {
    if (apart > found.path) found.path = apart, found.crack = tip.crack;
  };
  for (const auto& [tip, path] : paths) {
    const auto same = others.find(tip);
    consider(tip, same == others.end() ? path.length() - path.last_step() : between(same->second, path));
  }
  for (const auto& [tip, path] : others)
    if (!paths.contains(tip)) consider(tip, path.length() - path.last_step());
  return found;
}

}  // namespace bempd::model
