#include <algorithm>
#include <cmath>
#include <limits>

#include "error.hpp"
#include "geometry/segment.hpp"
#include "model/model.hpp"

namespace bempd::model {

namespace {

// Tips whose load factors differ by less grow together, so that what is symmetric stays so.
constexpr double tie = 0.01;

// An end that would stop this part of the step before an edge or a crack goes on to it: a shorter ligament breaks.
constexpr double reach = 1.25;

// The first place at which the way from a tip meets an edge or another crack, as a part of the way; beyond 1 if none.
double first_meeting(const scene::Scene& scene, const Segment& way, double tolerance) {
  double first = 2;
  const double behind_tip = 10 * tolerance / way.length();
  const auto consider = [&](double fraction) {
    if (fraction > behind_tip) first = std::min(first, fraction);
  };
  for (const int region : scene.region_ids())
    for (const Edge& edge : edges_of(scene.region(region).outline()))
      for (const Crossing& meeting : meeting_points(Edge(way.start, way.end), edge)) consider(meeting.fraction_a);
  for (const scene::Crack& crack : scene.cracks())
    for (std::size_t i = 0; i + 1 < crack.points.size(); ++i)
      if (const auto crossing = proper_crossing(way, {crack.points[i], crack.points[i + 1]}))
        consider(crossing->fraction_a);
  return first;
}

struct Extension {
  int crack, end;
  Point to;
  bool ends;  // at an edge or a crack
};

Extension extension_of(const scene::Scene& scene, const regions::TipValues& tip, double length, double tolerance) {
  const double c = std::cos(tip.growth_angle), s = std::sin(tip.growth_angle);
  const Point direction(c * tip.direction.x() - s * tip.direction.y(), s * tip.direction.x() + c * tip.direction.y());
  const Segment way{tip.place, tip.place + reach * length * direction};
  const double meeting = first_meeting(scene, way, tolerance);
  if (meeting <= 1) return {tip.crack, tip.end, way.at(meeting), true};
  return {tip.crack, tip.end, tip.place + length * direction, false};
}

}  // namespace

GrowthResult Model::grow_cracks(double length) {
  require(std::isfinite(length) && length > 0, "length is ", length, "; it must be > 0");
  const std::vector<regions::TipValues> tips = this->tips();
  require(!tips.empty(),
          "no crack in a BEM region has a tip; add one, or let cracks in peridynamic regions grow by steps");
  require(prepared_->system->terms().size() == 0,
          "the scene has peridynamic regions, whose cracks grow by steps; cracks grow by lengths where all regions are "
          "BEM regions");
  GrowthResult result;
  result.load_factor = std::numeric_limits<double>::infinity();
  for (const regions::TipValues& tip : tips) result.load_factor = std::min(result.load_factor, tip.growth_load_factor);
  if (!std::isfinite(result.load_factor))
    fail(Failure::unsolvable,
         "no crack grows however large the load factor is; give their materials a fracture_energy, "
         "and loads that open them");
  std::vector<scene::Crack> grown = scene_.cracks();
  for (const regions::TipValues& tip : tips) {
    if (tip.growth_load_factor > (1 + tie) * result.load_factor) continue;
    const Extension extension = extension_of(scene_, tip, length, prepared_->discretization.tolerance);
    std::vector<Point>& points = grown[static_cast<std::size_t>(extension.crack) - 1].points;
    points.insert(extension.end == 0 ? points.begin() : points.end(), extension.to);
    ++result.tips;
    result.ended += extension.ends;
  }
  const std::vector<scene::Crack> before = scene_.cracks();
  rebuild_with(grown, result.load_factor, before);
  return result;
}

// The old scene and its state come back if the new one cannot be.
void Model::rebuild_with(std::vector<scene::Crack> cracks, double load_factor, std::vector<scene::Crack> before) {
  std::unique_ptr<PreparedScene> old = std::move(prepared_);
  scene_.set_cracks(std::move(cracks));
  try {
    advance(load_factor, fracture::Goal::load_factor);
  } catch (...) {
    scene_.set_cracks(std::move(before));
    prepared_ = std::move(old);
    ++generation_;
    throw;
  }
}

}  // namespace bempd::model
