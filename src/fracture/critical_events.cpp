#include "fracture/critical_events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bempd::fracture {

namespace {

// A ratio that differs from 1 by less than this belongs to a bond that is just reaching its critical stretch.
constexpr double excess_tolerance = 1e-12;

// Widens the tie band so that mirrored bonds, equal up to rounding, fall on the same side of its limit.
constexpr double tie_rounding = 1e-9;

}  // namespace

double tie_limit(double band) { return (1 - band) * (1 - tie_rounding); }

StretchRatios::StretchRatios(const coupling::Terms& terms, std::vector<double> critical_stretch)
    : AffineRatios{std::vector<double>(terms.size(), 0.0), std::vector<double>(terms.size(), 0.0)},
      terms_(terms),
      critical_stretch_(std::move(critical_stretch)),
      scales_(terms.critical_scales(critical_stretch_)) {
  const coupling::TermLaw& brittle = coupling::TermLaw::brittle();
  if (std::all_of(terms.laws.begin(), terms.laws.end(), [&](const auto& law) { return law == brittle; })) return;
  stages_.assign(terms.size(), 0);
  for (std::size_t t = 0; t < terms.size(); ++t) scales_.set(t, terms_, t, this->critical_stretch(t, 0));
}

void StretchRatios::enter(const std::vector<std::uint8_t>& stages) {
  for (std::size_t t = 0; t < stages_.size(); ++t) {
    if (stages_[t] == stages[t]) continue;
    stages_[t] = stages[t];
    scales_.set(t, terms_, t, critical_stretch(t, stages[t]));
  }
}

void StretchRatios::update(const coupling::Affine& displacement) {
  terms_.critical_shares(displacement, scales_, constant, proportional);
}

std::optional<double> AffineRatios::next_break(const std::vector<char>& intact, double from, double to) const {
  const double direction = to >= from ? 1 : -1;
  std::optional<double> next;
  for (std::size_t b = 0; b < intact.size(); ++b) {
    if (!intact[b]) continue;
    const double ratio = at(b, from);
    if (ratio > 1 + excess_tolerance) return from;
    const double slope = proportional[b];
    if (!(slope * direction > 0)) continue;
    double load_factor = (1 - constant[b]) / slope;
    if ((load_factor - from) * direction < 0) load_factor = from;  // reached already, up to rounding
    if (!next || (load_factor - *next) * direction < 0) next = load_factor;
  }
  if (next && (to - *next) * direction < 0) next.reset();
  return next;
}

LoadInterval AffineRatios::admissible(const std::vector<char>& intact) const {
  const double infinity = std::numeric_limits<double>::infinity();
  LoadInterval result{-infinity, infinity};
  for (std::size_t b = 0; b < intact.size(); ++b) {
    if (!intact[b]) continue;
    const double slope = proportional[b], room = 1 - constant[b];
    if (slope > 0) {
      result.highest = std::min(result.highest, room / slope);
    } else if (slope < 0) {
      result.lowest = std::max(result.lowest, room / slope);
    } else if (room < -excess_tolerance) {
      return {infinity, -infinity};
    }
  }
  return result;
}

double AffineRatios::critical_load_factor(std::size_t bond, double load_factor) const {
  const double critical = (1 - constant[bond]) / proportional[bond];
  return std::isfinite(critical) ? critical : load_factor;
}

double AffineRatios::steepest() const {
  const auto count = static_cast<Eigen::Index>(proportional.size());
  return count > 0 ? Eigen::Map<const Eigen::ArrayXd>(proportional.data(), count).maxCoeff() : 0;
}

std::optional<double> AffineRatios::next_proportional_break(double from) const {
  const double largest = steepest();
  if (!(largest > 0)) return std::nullopt;
  return from * largest > 1 + excess_tolerance ? from : std::max(from, 1 / largest);
}

std::vector<int> AffineRatios::overstretched(const std::vector<char>& intact, double load_factor) const {
  std::vector<int> chosen;
  for (std::size_t b = 0; b < intact.size(); ++b) {
    if (intact[b] && at(b, load_factor) > 1 - excess_tolerance) chosen.push_back(static_cast<int>(b));
  }
  return chosen;
}

std::vector<int> AffineRatios::most_stretched(const std::vector<char>& intact, double load_factor, double band,
                                              int limit) const {
  double largest = 0;
  for (std::size_t b = 0; b < intact.size(); ++b) {
    if (intact[b]) largest = std::max(largest, at(b, load_factor));
  }
  return most_stretched(intact, load_factor, band, limit, largest);
}

std::vector<int> AffineRatios::most_stretched(const std::vector<char>& intact, double load_factor, double band,
                                              int limit, double largest) const {
  const double threshold = tie_limit(band) * largest;
  std::vector<int> chosen;
  for (std::size_t b = 0; b < intact.size(); ++b) {
    if (at(b, load_factor) >= threshold && intact[b]) chosen.push_back(static_cast<int>(b));
  }
  if (limit > 0 && static_cast<int>(chosen.size()) > limit) {
    std::stable_sort(chosen.begin(), chosen.end(),
                     [&](int a, int b) { return at(a, load_factor) > at(b, load_factor); });
    chosen.resize(limit);
    std::sort(chosen.begin(), chosen.end());
  }
  return chosen;
}

}  // namespace bempd::fracture
