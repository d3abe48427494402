#include <algorithm>
#include <cmath>
#include <limits>

#include "elasticity/griffith.hpp"
#include "error.hpp"
#include "geometry/segment.hpp"
#include "model/clear_radius.hpp"
#include "model/element_carrier.hpp"
#include "model/element_growth.hpp"
#include "model/line_factors.hpp"
#include "model/model.hpp"
#include "number_range.hpp"
#include "regions/tips/lattice_openings.hpp"
#include "regions/tips/lattice_pictures.hpp"
#include "regions/tips/lattice_tips.hpp"

namespace bempd::model {

namespace {

// Copies the load factors and kink angles of growth from a carrier's tip to the results.
void tell_growth(regions::TipValues& values, const crack::Tip& tip) {
  values.kink_angle = tip.kink_angle, values.critical_kink_angle = tip.critical_kink_angle;
  values.critical_load_factor = in_range(tip.range.highest);
  values.critical_load_factor_down = in_range(tip.range.lowest);
  values.load_rule = tip.load_rule, values.load_error = tip.load_error;
}

void never_grows(regions::TipValues& tip) {
  tip.critical_load_factor = std::numeric_limits<double>::max();
  tip.critical_load_factor_down = -tip.critical_load_factor;
  tip.critical_kink_angle = tip.load_error = regions::TipValues::unknown;
}

// Takes the stress intensity factors that the run has fitted to the stress ahead of the tip. They are used for tips
// that have no room for a ring (contour) around them.
void take_stress_ahead(regions::TipValues& values, const crack::Tip& tip, double load_factor) {
  if (!tip.factors.at(load_factor).allFinite()) return;
  values.method = regions::TipMethod::stress_ahead;
  values.constant_factors = tip.factors.constant, values.proportional_factors = tip.factors.proportional;
  values.factors = tip.factors.at(load_factor);
  values.toughness = tip.law.toughness, values.plane_modulus = tip.law.plane_modulus;
  values.energy_release_rate = in_range(values.factors.squaredNorm() / tip.law.plane_modulus);
}

bool has_extensions(const crack::TipId& tip, std::span<const fracture::CrackExtension> extensions) {
  return std::any_of(extensions.begin(), extensions.end(), [&](const fracture::CrackExtension& e) {
    return crack::TipId{e.crack, e.end} == tip;
  });
}

// Length by which an end of a crack has grown in lattices, without extensions that the scene's crack contains.
double grown_among_bonds(int crack, int end, const scene::Crack& described,
                         std::span<const fracture::CrackExtension> extensions) {
  double sum = 0;
  for (const fracture::CrackExtension& e : extensions) {
    const bool is_known =
        std::find(described.points.begin(), described.points.end(), Point(e.x, e.y)) != described.points.end();
    if (e.crack == crack && e.end == end && !is_known) sum += e.length;
  }
  return sum;
}

}  // namespace

void complete(regions::TipValues& tip, const scene::Options& options) {
  if (!tip.factors.allFinite() || !tip.constant_factors.allFinite() || !tip.proportional_factors.allFinite()) return;
  tip.toughness = law_of(tip, options).met(tip.factors, tip.stress_along).toughness;
  tell_growth(tip, carried(tip, options));
  if (std::isfinite(tip.critical_kink_angle)) tip.load_error = tip.error / tip.factors.norm();
  const crack::GrowthLaw law = law_of(tip, options);
  tip.straight_load_factor =
      straight_load_factor(tip.constant_factors, tip.proportional_factors,
                           law.directions ? tip.toughness * std::sqrt(law.share_in(0)) : tip.toughness);
}

std::vector<regions::TipValues> Model::tips_of(const PreparedScene& prepared, regions::TipDetail detail) const {
  std::vector<regions::TipValues> tips;
  for (const auto& region : prepared.discretization.regions) {
    const std::vector<regions::TipValues> found = region->tips(solution_of(prepared), detail);
    tips.insert(tips.end(), found.begin(), found.end());
  }
  double largest = 0;
  for (const regions::TipValues& tip : tips) largest = std::max(largest, tip.factors.norm());
  for (regions::TipValues& tip : tips) {
    tip.error = std::max(tip.error, accuracy_.intensity_error() * largest);
    complete(tip, options_);
  }
  // Tips are sorted by crack id; the tip at the first point comes before that at the last point.
  std::stable_sort(tips.begin(), tips.end(), [](const regions::TipValues& a, const regions::TipValues& b) {
    return std::pair(a.crack, a.end) < std::pair(b.crack, b.end);
  });
  return tips;
}

std::vector<regions::TipValues> Model::compute_tips() const {
  std::vector<regions::TipValues> all = tips_of(*prepared_, regions::TipDetail::everything);
  for (regions::TipValues& tip : all)
    if (has_stopped({tip.crack, tip.end}, prepared_->evolution->progress())) never_grows(tip);
  const std::vector<regions::TipValues> in_lattices =
      prepared_->evolution->lines() ? tips_of_lines() : tips_in_lattices();
  all.insert(all.end(), in_lattices.begin(), in_lattices.end());
  std::vector<std::vector<Point>> paths;
  for (int crack = 1; crack <= crack_count(); ++crack) paths.push_back(places_of(crack_path(crack)));
  for (regions::TipValues& tip : all)
    tip.valid_radius =
        clear_radius(scene_, prepared_->discretization, paths, {{tip.crack, tip.end}, tip.place, tip.direction});
  return all;
}

// Tips found among the broken bonds of the lattices, in growth bond by bond.
std::vector<regions::TipValues> Model::tips_in_lattices() const {
  const regions::BondedBody body = bonded_body(scene_, *prepared_);
  std::vector<regions::TipValues> tips =
      regions::lattice_tips(body, regions::find_lattice_tips(body), solution(), options_);
  for (regions::TipValues& tip : tips) complete(tip, options_);
  return tips;
}

// Tips of crack lines: place, direction and load factors as in the run, stress intensity factors by rings.
std::vector<regions::TipValues> Model::tips_of_lines() const {
  const std::vector<crack::Tip> carried = prepared_->evolution->lines()->tips();
  std::vector<regions::KnownTip> known;
  for (const crack::Tip& tip : carried) {
    std::vector<Point> path = places_of(crack_path(tip.id.crack));
    if (tip.id.end == 0) std::reverse(path.begin(), path.end());
    known.push_back({tip.id.crack, tip.id.end, tip.direction, std::move(path), has_extensions(tip.id, extensions())});
  }
  const regions::BondedBody body = bonded_body(scene_, *prepared_);
  std::vector<regions::TipValues> tips =
      regions::lattice_tips(body, regions::lattice_tips_at(body, known), solution(), options_);
  for (std::size_t k = 0; k < tips.size(); ++k) {
    const crack::Tip& tip = carried[k];
    regions::TipValues& values = tips[k];
    if (values.contours == 0) take_stress_ahead(values, tip, load_factor());
    values.directions = tip.law.directions, values.asking = tip.law.asking;
    if (values.toughness > 0) values.toughness = tip.law.toughness;
    complete(values, options_);
    tell_growth(values, tip);
    values.closed = values.closed || tip.closed;
  }
  return tips;
}

const std::vector<regions::TipValues>& Model::tips() {
  ensure_equilibrium();
  if (tips_generation_ == generation_) return tips_;
  tips_ = compute_tips();
  look_past_switches(tips_);
  tips_generation_ = generation_;
  return tips_;
}

std::vector<regions::CrackPicture> Model::crack_pictures() const {
  std::vector<regions::CrackPicture> cracks;
  for (const auto& region : prepared_->discretization.regions) {
    const auto pictures = region->crack_pictures(solution());
    cracks.insert(cracks.end(), pictures.begin(), pictures.end());
  }
  const std::vector<std::vector<Point>> paths = paths_in_lattices();
  const auto in_lattices =
      regions::lattice_crack_pictures(bonded_body(scene_, *prepared_), solution().displacement,
                                      [&](const Point& place) { return crack_nearest(place, paths); });
  cracks.insert(cracks.end(), in_lattices.begin(), in_lattices.end());
  return cracks;
}

std::vector<Point> Model::crack_openings(int crack, const std::vector<double>& fractions) {
  crack_path(crack);  // throws for a crack that there is not
  for (const double fraction : fractions)
    require(fraction >= 0 && fraction <= 1, "a fraction of the crack's length is ", fraction,
            "; it must lie between 0 and 1");
  prepare();
  ensure_equilibrium();
  std::vector<Point> openings = ElementCarrier(*this, nullptr, false).openings(crack, fractions);
  std::vector<std::size_t> left;
  std::vector<double> left_fractions;
  for (std::size_t k = 0; k < openings.size(); ++k)
    if (openings[k].hasNaN()) left.push_back(k), left_fractions.push_back(fractions[k]);
  if (left.empty()) return openings;
  fracture::LineCarrier* lines = prepared_->evolution->lines();
  const std::vector<Point> in_lattices =
      lines ? lines->openings(crack, left_fractions) : openings_in_lattices(crack, left_fractions);
  for (std::size_t k = 0; k < left.size(); ++k) openings[left[k]] = in_lattices[k];
  return openings;
}

std::vector<Point> ElementCarrier::openings(int crack, const std::vector<double>& fractions) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<Point> openings(fractions.size(), Point(unknown, unknown));
  const std::vector<regions::PartedCrack>& cracks = model_.prepared_->discretization.cracks;
  const auto number = static_cast<std::size_t>(crack) - 1;
  if (number >= cracks.size() || !cracks[number].has_elements()) return openings;
  const auto within = [&](int region, const std::vector<double>& parts) {
    return model_.results_.region(region).crack_openings(crack, parts, model_.solution());
  };
  if (cracks[number].parts.size() == 1) return within(cracks[number].region_at(0), fractions);
  const bool is_whole = !cracks[number].cuts_bonds();
  const double length = length_of(model_.crack_path(crack)), own = polyline_length(cracks[number].crack.points);
  const double before = grown_among_bonds(crack, 0, model_.scene_.cracks()[number], model_.extensions());
  for (std::size_t k = 0; k < fractions.size(); ++k) {
    double part = is_whole ? fractions[k] : (fractions[k] * length - before) / own;
    // The crack may lie a little beside its points in a lattice, which changes its length.
    if (cracks[number].region_at(0) > 0) part = std::max(part, 0.0);
    if (cracks[number].region_at(1) > 0) part = std::min(part, 1.0);
    const int region = part < 0 || part > 1 ? 0 : cracks[number].part_at(part).region;
    if (region > 0) openings[k] = within(region, {part}).front();
  }
  return openings;
}

std::vector<Point> Model::openings_in_lattices(int crack, const std::vector<double>& fractions) const {
  const std::vector<std::vector<Point>> paths = paths_in_lattices();
  const auto number = static_cast<std::size_t>(crack) - 1;
  require(paths[number].size() > 1, "crack ", crack, " was removed; ask for the openings of one that there is");
  return regions::lattice_openings(bonded_body(scene_, *prepared_), paths, number, fractions, solution().displacement);
}

int Model::crack_count() const {
  int count = static_cast<int>(scene_.cracks().size());
  for (const fracture::CrackExtension& e : extensions()) count = std::max(count, e.crack);
  return count;
}

std::vector<crack::PathVertex> Model::crack_path(int crack) const {
  const auto described = static_cast<int>(scene_.cracks().size());
  if (crack < 1 || crack > crack_count()) scene_.crack(crack);  // throws
  const auto number = static_cast<std::size_t>(crack) - 1;
  if (crack > described || scene_.cracks()[number].has_begun) return path_of(crack, {}, extensions());
  if (prepared_ && prepared_->discretization.cracks[number].cuts_bonds()) return path_in(scene_, *prepared_, crack);
  const scene::Crack& found = scene_.cracks()[number];
  if (found.points.empty()) return {};
  return path_of(crack, found.given(), extensions());
}

double Model::crack_length(int crack) const {
  if (crack != 0) return length_of(crack_path(crack));
  double sum = 0;
  for (int id = 1; id <= crack_count(); ++id) sum += length_of(crack_path(id));
  return sum;
}

std::vector<std::vector<Point>> Model::paths_in_lattices() const {
  const std::vector<regions::PartedCrack>& cracks = prepared_->discretization.cracks;
  std::vector<std::vector<Point>> paths(static_cast<std::size_t>(crack_count()));
  for (std::size_t c = 0; c < paths.size(); ++c)
    if (c >= cracks.size() || cracks[c].parts.empty() || cracks[c].cuts_bonds())
      paths[c] = places_of(crack_path(static_cast<int>(c) + 1));
  return paths;
}

// Id of the crack in a lattice that is nearest to a place; among all described cracks if none lies in a lattice.
int Model::crack_nearest(const Point& place, const std::vector<std::vector<Point>>& paths) const {
  int nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < paths.size(); ++c) {
    for (std::size_t i = 0; i + 1 < paths[c].size(); ++i) {
      const double away = distance(Segment{paths[c][i], paths[c][i + 1]}, place);
      if (away < least) least = away, nearest = static_cast<int>(c) + 1;
    }
  }
  return nearest;
}

bool Model::has_crack_elements() const {
  const std::vector<regions::PartedCrack>& cracks = prepared_->discretization.cracks;
  return std::any_of(cracks.begin(), cracks.end(), [](const auto& crack) { return crack.has_elements(); });
}

void Model::warn_of_overlap() {
  if (warned_of_overlap_ || !log_ || !has_crack_elements()) return;
  for (const auto& region : prepared_->discretization.regions) {
    const auto overlap = region->overlap(solution());
    if (!overlap) continue;
    warned_of_overlap_ = true;
    log(1, text("the faces of crack ", overlap->crack, " overlap by ", overlap->depth, " at (", overlap->place.x(),
                ", ", overlap->place.y(), "): they do not know contact; what closes a crack makes its results wrong"));
  }
}

}  // namespace bempd::model
