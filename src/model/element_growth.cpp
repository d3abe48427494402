#include "model/element_growth.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/turning.hpp"
#include "model/extension_end.hpp"
#include "model/growth_options.hpp"

namespace bempd::model {

namespace {

// Largest lengths of extensions that the library chooses: step_over_crack times the crack's length, and
// step_over_clearance times the distance to the nearest edge, hole or other crack, where the latter limit is at least
// least_step_over_crack times the crack's length. Stress intensity factors then change by about a tenth in a step, and
// a ligament shorter than the last extension breaks with that extension.
constexpr double step_over_crack = 0.1, step_over_clearance = 0.12, least_step_over_crack = 0.01;

Kink kink_at(const regions::TipValues& tip, double load_factor, const scene::Options& options) {
  return law_of(tip, options).kink(factors_of(tip), load_factor);
}

// Load factor at which a tip that is overloaded at `load_factor` just reaches its toughness; `load_factor` itself if
// the tip is not overloaded there, or is overloaded at every load factor.
double critical_load_factor(const regions::TipValues& tip, double load_factor, const scene::Options& options) {
  const crack::GrowthRange range = law_of(tip, options).range(factors_of(tip));
  if (range.is_empty() || range.holds(load_factor)) return load_factor;
  return load_factor >= range.highest ? range.highest : range.lowest;
}

}  // namespace

crack::AffineFactors factors_of(const regions::TipValues& tip) {
  return {tip.constant_factors, tip.proportional_factors};
}

crack::GrowthLaw law_of(const regions::TipValues& tip, const scene::Options& options) {
  return {tip.toughness,  tip.plane_modulus,         growth_criterion(options),
          tip.directions, heading_of(tip.direction), tip.asking};
}

crack::Tip tip_for_carrier(const regions::TipValues& tip, const scene::Options& options) {
  crack::Tip one{tip.id(), tip.place, tip.direction, factors_of(tip), law_of(tip, options), {}};
  one.range = one.law.range(one.factors);
  one.kink_angle = one.law.kink(tip.factors).angle;
  if (std::isfinite(one.range.highest)) one.critical_kink_angle = one.law.kink(one.factors, one.range.highest).angle;
  return one;
}

Growing growing_with(const std::vector<regions::TipValues>& tips, std::size_t first, double load_factor,
                     const scene::Options& options) {
  const auto ratio_of = [&](const regions::TipValues& tip) {
    return law_of(tip, options).ratio(factors_of(tip), load_factor);
  };
  Growing growing;
  growing.load_factor = load_factor;
  growing.ratio = ratio_of(tips[first]);
  growing.critical_load_factor = load_factor;
  if (growing.is_in_equilibrium()) {
    growing.ratio = 1;  // up to rounding
  } else {
    growing.critical_load_factor = critical_load_factor(tips[first], load_factor, options);
  }
  const double share = options.number("crack.tie_share");
  for (std::size_t t = 0; t < tips.size(); ++t) {
    if (t != first && !(share > 0 && ratio_of(tips[t]) >= growing.ratio / (1 + share))) continue;
    const regions::TipValues& tip = tips[t];
    const crack::GrowthLaw law = law_of(tip, options).with_host_toughness(factors_of(tip), load_factor);
    const Kink kink = law.kink(factors_of(tip), load_factor);
    crack::Extension extension = crack::begin_extension(tip.id(), tip.place, kink.angle, load_factor, factors_of(tip),
                                                        law.resistance(kink.angle));
    extension.rate_before = law.rate(kink);
    growing.tips.push_back(tip);
    growing.extensions.push_back(extension);
  }
  return growing;
}

void set_lengths(Growing& growing, double length, const scene::Options& options) {
  const double exponent = options.number("crack.exponent");
  growing.lengths.clear();
  for (const regions::TipValues& tip : growing.tips) {
    const double factor = kink_at(tip, growing.load_factor, options).equivalent_factor;
    growing.lengths.push_back(length * std::pow(factor / tip.toughness, 2 * exponent));
  }
}

double chosen_length(const scene::Scene& scene, const Growing& growing, const scene::Options& options) {
  if (const double said = options.number("crack.step"); said > 0) return said;
  double least = std::numeric_limits<double>::infinity();
  for (const regions::TipValues& tip : growing.tips) {
    const double length = length_of(scene.crack(tip.crack));
    const double clearance = clearance_of_tip(scene, scene.cracks(), tip.crack, tip.end);
    least = std::min(
        {least, step_over_crack * length, std::max(step_over_clearance * clearance, least_step_over_crack * length)});
  }
  return least;
}

// Extends cracks one after another, so that two cracks that grow into each other meet.
std::vector<scene::Crack> extended(const scene::Scene& scene, std::vector<scene::Crack> cracks, double tolerance,
                                   Growing& growing) {
  for (std::size_t k = 0; k < growing.tips.size(); ++k) {
    fracture::CrackExtension& e = growing.extensions[k];
    const Point& from = growing.tips[k].place;
    const ExtensionEnd way = end_of_extension(scene, cracks, e.crack, e.end, turned(growing.tips[k].direction, e.angle),
                                              growing.lengths[k], tolerance);
    scene::Crack& crack = cracks[static_cast<std::size_t>(e.crack) - 1];
    extend(crack, e.end, way.to);
    crack::arrive(e, way.to, (way.to - from).norm(), way.state);
    e.crack_length = length_of(crack);
  }
  return cracks;
}

double largest_turn(const Growing& growing, const std::vector<regions::TipValues>& after,
                    const scene::Options& options) {
  double largest = 0;
  for (const fracture::CrackExtension& e : growing.extensions) {
    const regions::TipValues* tip = crack::tip_in(after, e.tip());
    if (!e.has_ended() && tip && !tip->directions)
      largest = std::max(largest, std::abs(kink_at(*tip, e.load_factor, options).angle));
  }
  return largest;
}

void turn_to_chords(Growing& growing, const std::vector<regions::TipValues>& after, const scene::Options& options) {
  for (fracture::CrackExtension& e : growing.extensions) {
    const regions::TipValues* tip = crack::tip_in(after, e.tip());
    if (!e.has_ended() && tip && !tip->directions) e.angle += 0.5 * kink_at(*tip, e.load_factor, options).angle;
  }
}

std::optional<double> end_of_path(const Growing& growing, const std::vector<regions::TipValues>& after,
                                  const scene::Options& options) {
  if (!growing.is_in_equilibrium()) return std::nullopt;
  crack::GrowthRange before, common;
  const auto narrow = [&](crack::GrowthRange& range, const regions::TipValues& tip) {
    const crack::GrowthRange own = law_of(tip, options).range(factors_of(tip));
    range = {std::max(range.lowest, own.lowest), std::min(range.highest, own.highest)};
  };
  for (std::size_t k = 0; k < growing.tips.size(); ++k) {
    const regions::TipValues* tip = crack::tip_in(after, growing.extensions[k].tip());
    if (!tip) return std::nullopt;
    narrow(before, growing.tips[k]);
    narrow(common, *tip);
  }
  const bool upwards = std::abs(growing.load_factor - before.highest) <= std::abs(growing.load_factor - before.lowest);
  const double end = upwards ? common.highest : common.lowest;
  return common.is_empty() || !std::isfinite(end) ? std::nullopt : std::optional(end);
}

namespace {

// Fracture energy per area for growth straight ahead of a tip [J/m^2].
double resistance_ahead_of(const regions::TipValues& tip) {
  const double share = tip.directions ? tip.directions->share(heading_of(tip.direction)) : 1;
  return tip.toughness * tip.toughness / tip.plane_modulus * share;
}

}  // namespace

// Enters the energies of a growth in its extensions. An extension releases the integral of its energy release rate
// (trapezoidal rule); on the equilibrium path the rate equals the fracture energy all along. Tips that have ended have
// no rate at the end of the extension: they share the rest of `released` in proportion to the lengths of their
// extensions.
fracture::Growth with_energies(Growing growing, const std::vector<regions::TipValues>& after,
                               const std::vector<double>& thickness, double released,
                               std::optional<double> beyond_path) {
  fracture::Growth growth{growing.ratio,           growing.critical_load_factor,  0,
                          beyond_path.value_or(0), std::move(growing.extensions), growing.ties};
  double left = released, ended_length = 0;
  for (std::size_t k = 0; k < growth.extensions.size(); ++k) {
    fracture::CrackExtension& e = growth.extensions[k];
    const double area = e.length * thickness[k];
    const regions::TipValues* tip = crack::tip_in(after, e.tip());
    const double at_end = tip ? resistance_ahead_of(*tip) : e.resistance;
    const double mean = at_end == e.resistance ? 1 : 0.5 * (1 + at_end / e.resistance);
    e.surface_energy = mean * e.resistance * area;
    growth.surface_energy += e.surface_energy;
    if (tip) {
      e.rate_after = tip->energy_release_rate;
      e.released_energy = (beyond_path ? mean * e.rate_before : 0.5 * (e.rate_before + e.rate_after)) * area;
      left -= e.released_energy;
    } else {
      ended_length += e.length;
    }
  }
  for (fracture::CrackExtension& e : growth.extensions)
    if (!crack::tip_in(after, e.tip())) e.released_energy = left * e.length / ended_length;
  return growth;
}

GrowthResult result_of(const fracture::Growth& growth) {
  GrowthResult result{static_cast<int>(growth.extensions.size()), 0, growth.extensions.front().load_factor, 0, 0};
  for (const fracture::CrackExtension& e : growth.extensions) {
    result.length += e.length;
    result.ended += e.has_ended() ? 1 : 0;
  }
  return result;
}

bool has_stopped(const crack::TipId& tip, const fracture::EvolutionState& state) {
  if (std::find(state.stopped.begin(), state.stopped.end(), tip) != state.stopped.end()) return true;
  const auto last = std::find_if(state.extensions.rbegin(), state.extensions.rend(),
                                 [&](const crack::Extension& e) { return e.tip() == tip; });
  return last != state.extensions.rend() && last->state == crack::TipState::at_interface;
}

}  // namespace bempd::model
