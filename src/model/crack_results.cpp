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

// Copies the load factors at which a tip grows, and its kink angles, from crack::Tip to the tip's results.
void copy_growth(regions::TipValues& values, const crack::Tip& tip) {
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

// Takes the stress intensity factors that the run has fitted to the stress ahead of a tip around which no contour
// (ring) fits.
void take_stress_ahead(regions::TipValues& values, const crack::Tip& tip, double load_factor) {
  if (!tip.factors.at(load_factor).allFinite()) return;
  values.method = regions::TipMethod::stress_ahead;
  values.constant_factors = tip.factors.constant, values.proportional_factors = tip.factors.proportional;
  values.factors = tip.factors.at(load_factor);
  values.toughness = tip.law.toughness, values.plane_modulus = tip.law.plane_modulus;
  values.energy_release_rate = in_range(values.factors.squaredNorm() / tip.law.plane_modulus);
}

bool has_extensions(const crack::TipId& tip, std::span<const fracture::CrackExtension> extensions) {
  return std::any_of(extensions.begin(), extensions.end(),
                     [&](const fracture::CrackExtension& e) { return e.tip() == tip; });
}

// Length by which an end of a crack has grown in lattices [m]. Extensions that the scene's crack `described` already
// contains do not count.
double grown_among_bonds(int crack, int end, const scene::Crack& described,
                         std::span<const fracture::CrackExtension> extensions) {
  double sum = 0;
  for (const fracture::CrackExtension& e : extensions.subspan(known_extensions(described, {crack, end}, extensions)))
    if (e.tip() == crack::TipId{crack, end}) sum += e.length;
  return sum;
}

}  // namespace

void complete(regions::TipValues& tip, const scene::Options& options) {
  if (!tip.factors.allFinite() || !tip.constant_factors.allFinite() || !tip.proportional_factors.allFinite()) return;
  tip.toughness = law_of(tip, options).with_host_toughness(tip.factors, tip.stress_along).toughness;
  copy_growth(tip, tip_for_carrier(tip, options));
  if (std::isfinite(tip.critical_kink_angle)) tip.load_error = tip.error / tip.factors.norm();
  const crack::GrowthLaw law = law_of(tip, options);
  tip.straight_load_factor =
      straight_load_factor(tip.constant_factors, tip.proportional_factors,
                           law.directions ? tip.toughness * std::sqrt(law.share_in(0)) : tip.toughness);
}

std::vector<regions::TipValues> CrackResults::tips_of(const PreparedScene& prepared, regions::TipDetail detail) const {
  std::vector<regions::TipValues> tips;
  for (const auto& region : prepared.discretization.regions) {
    if (!region->crack_elements()) continue;
    const std::vector<regions::TipValues> found = region->crack_elements()->tips(solution_of(prepared), detail);
    tips.insert(tips.end(), found.begin(), found.end());
  }
  model_.accuracy().raise_errors(tips);
  for (regions::TipValues& tip : tips) complete(tip, model_.options());
  // Tips are sorted by crack id; of a crack, the tip at the first point comes before the tip at the last point.
  std::stable_sort(tips.begin(), tips.end(), [](const regions::TipValues& a, const regions::TipValues& b) {
    return std::pair(a.crack, a.end) < std::pair(b.crack, b.end);
  });
  return tips;
}

std::vector<regions::TipValues> CrackResults::present_tips() const {
  std::vector<regions::TipValues> all = tips_of(model_.prepared(), regions::TipDetail::everything);
  for (regions::TipValues& tip : all)
    if (has_stopped(tip.id(), model_.prepared().evolution->progress())) never_grows(tip);
  const std::vector<regions::TipValues> in_lattices =
      model_.prepared().evolution->lines() ? tips_of_lines() : tips_in_lattices();
  all.insert(all.end(), in_lattices.begin(), in_lattices.end());
  std::vector<std::vector<Point>> paths;
  for (int crack = 1; crack <= count(); ++crack) paths.push_back(points_of_path(path(crack)));
  for (regions::TipValues& tip : all)
    tip.valid_radius =
        clear_radius(model_.scene(), model_.prepared().discretization, paths, {tip.id(), tip.place, tip.direction});
  return all;
}

// Tips in lattices in which cracks grow bond by bond, found from the broken bonds.
std::vector<regions::TipValues> CrackResults::tips_in_lattices() const {
  const regions::BondedBody body = bonded_body(model_.scene(), model_.prepared());
  std::vector<regions::TipValues> tips =
      regions::lattice_tips(body, regions::find_lattice_tips(body), solution_of(model_.prepared()), model_.options());
  for (regions::TipValues& tip : tips) complete(tip, model_.options());
  return tips;
}

// Tips of crack lines, with stress intensity factors from contours (rings) around them or, where no contour fits, from
// the stress ahead of them.
std::vector<regions::TipValues> CrackResults::tips_of_lines(bool with_loads) const {
  fracture::LineCarrier& lines = *model_.prepared().evolution->lines();
  const std::vector<crack::Tip> carried = with_loads ? lines.tips() : lines.tips_without_loads();
  std::vector<regions::KnownTip> known;
  for (const crack::Tip& tip : carried) {
    std::vector<Point> path = points_of_path(this->path(tip.id.crack));
    if (tip.id.end == 0) std::reverse(path.begin(), path.end());
    known.push_back({tip.id.crack, tip.id.end, tip.direction, std::move(path), has_extensions(tip.id, extensions())});
  }
  const regions::BondedBody body = bonded_body(model_.scene(), model_.prepared());
  std::vector<regions::TipValues> tips = regions::lattice_tips(body, regions::lattice_tips_at(body, known),
                                                               solution_of(model_.prepared()), model_.options());
  for (std::size_t k = 0; k < tips.size(); ++k) {
    const crack::Tip& tip = carried[k];
    regions::TipValues& values = tips[k];
    if (values.contours == 0) take_stress_ahead(values, tip, model_.load_factor());
    values.directions = tip.law.directions, values.asking = tip.law.asking;
    if (values.toughness > 0) values.toughness = tip.law.toughness;
    complete(values, model_.options());
    if (with_loads) copy_growth(values, tip);
    values.closed = values.closed || tip.closed;
  }
  return tips;
}

const std::vector<regions::TipValues>& CrackResults::tips() {
  model_.in_equilibrium();
  if (tips_generation_ == model_.generation()) return tips_;
  tips_ = present_tips();
  take_growth_past_face_changes(tips_);
  tips_generation_ = model_.generation();
  return tips_;
}

std::vector<regions::CrackPicture> CrackResults::pictures() const {
  std::vector<regions::CrackPicture> cracks;
  for (const auto& region : model_.prepared().discretization.regions) {
    if (!region->crack_elements()) continue;
    const auto pictures = region->crack_elements()->pictures(solution_of(model_.prepared()));
    cracks.insert(cracks.end(), pictures.begin(), pictures.end());
  }
  const std::vector<std::vector<Point>> paths = paths_in_lattices();
  const auto in_lattices = regions::lattice_crack_pictures(
      bonded_body(model_.scene(), model_.prepared()), solution_of(model_.prepared()).displacement,
      [&](const Point& place) { return scene::crack_nearest(paths, place); });
  cracks.insert(cracks.end(), in_lattices.begin(), in_lattices.end());
  return cracks;
}

std::vector<Point> CrackResults::openings(int crack, const std::vector<double>& fractions) {
  path(crack);  // throws for a crack that there is not
  for (const double fraction : fractions)
    require(fraction >= 0 && fraction <= 1, "a fraction of the crack's length is ", fraction,
            "; it must lie between 0 and 1");
  model_.in_equilibrium();
  std::vector<Point> openings = ElementCarrier(model_, nullptr, false).openings(crack, fractions);
  std::vector<std::size_t> left;
  std::vector<double> left_fractions;
  for (std::size_t k = 0; k < openings.size(); ++k)
    if (openings[k].hasNaN()) left.push_back(k), left_fractions.push_back(fractions[k]);
  if (left.empty()) return openings;
  fracture::LineCarrier* lines = model_.prepared().evolution->lines();
  const std::vector<Point> in_lattices =
      lines ? lines->openings(crack, left_fractions) : openings_in_lattices(crack, left_fractions);
  for (std::size_t k = 0; k < left.size(); ++k) openings[left[k]] = in_lattices[k];
  return openings;
}

std::vector<Point> ElementCarrier::openings(int crack, const std::vector<double>& fractions) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<Point> openings(fractions.size(), Point(unknown, unknown));
  const std::vector<regions::PartedCrack>& cracks = model_.prepared().discretization.cracks;
  const auto number = static_cast<std::size_t>(crack) - 1;
  if (number >= cracks.size() || !cracks[number].has_elements()) return openings;
  const auto within = [&](int region, const std::vector<double>& parts) {
    const regions::CrackElements* elements = model_.results().region(region).crack_elements();
    return elements->openings(crack, parts, solution_of(model_.prepared()));
  };
  if (cracks[number].parts.size() == 1) return within(cracks[number].region_at(0), fractions);
  const bool is_whole = !cracks[number].cuts_bonds();
  const double length = length_of(model_.cracks().path(crack)), own = polyline_length(cracks[number].crack.points);
  const double before = grown_among_bonds(crack, 0, model_.scene().cracks()[number], model_.cracks().extensions());
  for (std::size_t k = 0; k < fractions.size(); ++k) {
    double part = is_whole ? fractions[k] : (fractions[k] * length - before) / own;
    // The path of a crack in a lattice differs a little from the described points, and so does its length. A place near
    // an end of the crack that has elements may therefore lie slightly beyond that end.
    if (cracks[number].region_at(0) > 0) part = std::max(part, 0.0);
    if (cracks[number].region_at(1) > 0) part = std::min(part, 1.0);
    const int region = part < 0 || part > 1 ? 0 : cracks[number].part_at(part).region;
    if (region > 0) openings[k] = within(region, {part}).front();
  }
  return openings;
}

std::vector<Point> CrackResults::openings_in_lattices(int crack, const std::vector<double>& fractions) const {
  const std::vector<std::vector<Point>> paths = paths_in_lattices();
  const auto number = static_cast<std::size_t>(crack) - 1;
  require(paths[number].size() > 1, "crack ", crack, " was removed; ask for the openings of one that there is");
  return regions::lattice_openings(bonded_body(model_.scene(), model_.prepared()), paths, number, fractions,
                                   solution_of(model_.prepared()).displacement);
}

int CrackResults::count() const {
  int count = static_cast<int>(model_.scene().cracks().size());
  for (const fracture::CrackExtension& e : extensions()) count = std::max(count, e.crack);
  return count;
}

std::vector<crack::PathVertex> CrackResults::path(int crack) const {
  const auto described = static_cast<int>(model_.scene().cracks().size());
  if (crack < 1 || crack > count()) model_.scene().crack(crack);  // throws
  const auto number = static_cast<std::size_t>(crack) - 1;
  if (crack > described || model_.scene().cracks()[number].has_begun) return path_of(crack, {}, extensions());
  if (model_.prepared_or_null() && model_.prepared().discretization.cracks[number].cuts_bonds())
    return path_in(model_.scene(), model_.prepared(), crack);
  const scene::Crack& found = model_.scene().cracks()[number];
  if (found.points.empty()) return {};
  return path_of(crack, found.given(), extensions());
}

double CrackResults::length(int crack) const {
  if (crack != 0) return length_of(path(crack));
  double sum = 0;
  for (int id = 1; id <= count(); ++id) sum += length_of(path(id));
  return sum;
}

std::vector<std::vector<Point>> CrackResults::paths_in_lattices() const {
  const std::vector<regions::PartedCrack>& cracks = model_.prepared().discretization.cracks;
  std::vector<std::vector<Point>> paths(static_cast<std::size_t>(count()));
  for (std::size_t c = 0; c < paths.size(); ++c)
    if (c >= cracks.size() || cracks[c].parts.empty() || cracks[c].cuts_bonds())
      paths[c] = points_of_path(path(static_cast<int>(c) + 1));
  return paths;
}

bool CrackResults::have_elements() const {
  const std::vector<regions::PartedCrack>& cracks = model_.prepared().discretization.cracks;
  return std::any_of(cracks.begin(), cracks.end(), [](const auto& crack) { return crack.has_elements(); });
}

std::span<const fracture::CrackExtension> CrackResults::extensions() const {
  const PreparedScene* const prepared = model_.prepared_or_null();
  if (!prepared) return {};
  return prepared->evolution->progress().extensions;
}

bool CrackResults::are_recorded() const { return model_.options().whole_number("tips.record") > 0; }

void CrackResults::record() {
  const fracture::HistoryEntry& line = model_.prepared().evolution->state().history.back();
  for (const regions::TipValues& tip : present_tips())
    history_.push_back({line.event, line.total_broken_bonds, line.load_factor, tip});
}

}  // namespace bempd::model
