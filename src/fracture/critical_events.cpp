#include "fracture/critical_events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bempd::fracture {

namespace {

// Difference of a stretch ratio (stretch over critical stretch) from 1 below which a bond counts as just critical.
constexpr double excess_tolerance = 1e-12;

// Least slope of a stretch ratio over the load factor that counts. With a smaller slope, the load factor at which the
// ratio reaches 1 would exceed the range of numbers.
constexpr double least_slope = 1e-280;

// Rounding by which the least stretch ratio of bonds that break together is lowered, so that mirrored bonds, whose
// ratios are equal up to rounding, break together.
constexpr double tie_rounding = 1e-9;

}  // namespace

double tie_limit(double band) { return (1 - band) * (1 - tie_rounding); }

StretchRatios::StretchRatios(const coupling::Terms& terms, std::vector<double> critical_stretch)
    : AffineRatios{std::vector<double>(terms.size(), 0.0), std::vector<double>(terms.size(), 0.0), {}},
      terms_(terms),
      critical_stretch_(std::move(critical_stretch)),
      across_(terms),
      scales_(terms.critical_scales(critical_stretch_)) {
  if (!across_.empty()) present_.assign(terms.size(), 1);
  const coupling::TermLaw& brittle = coupling::TermLaw::brittle();
  if (std::all_of(terms.laws.begin(), terms.laws.end(), [&](const auto& law) { return law == brittle; })) return;
  stages_.assign(terms.size(), 0);
  for (std::size_t t = 0; t < terms.size(); ++t) scales_.set(t, terms_, t, this->critical_stretch(t, 0));
}

void StretchRatios::enter(const std::vector<std::uint8_t>& stages) {
  for (std::size_t t = 0; t < present_.size(); ++t) present_[t] = terms_.is_broken(t, stages[t]) ? 0 : 1;
  for (std::size_t t = 0; t < stages_.size(); ++t) {
    if (stages_[t] == stages[t]) continue;
    stages_[t] = stages[t];
    scales_.set(t, terms_, t, critical_stretch(t, stages[t]));
  }
}

void StretchRatios::update(const coupling::Affine& displacement) {
  terms_.critical_shares(displacement, scales_, constant, proportional);
  if (!across_.empty()) across_.relieve(constant, proportional, scales_.per_elongation, present_, relief);
}

namespace {

// Range of (load factor times direction) in which the function constant + proportional * load factor is at least 1. The
// range is empty (first > second) or infinite if the function is constant.
std::pair<double, double> at_least_one(double constant, double proportional, double direction) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double slope = proportional * direction;
  if (std::abs(slope) < least_slope)
    return constant >= 1 ? std::pair(-infinity, infinity) : std::pair(infinity, -infinity);
  const double place = (1 - constant) / slope;
  return slope > 0 ? std::pair(place, infinity) : std::pair(-infinity, place);
}

}  // namespace

AffineRatios::Span AffineRatios::critical_span(std::size_t b, double direction) const {
  const auto [begin, end] = at_least_one(constant[b], proportional[b], direction);
  const auto [relieved_begin, relieved_end] =
      at_least_one(constant[b] - relief.constant[b], proportional[b] - relief.proportional[b], direction);
  return {std::max(begin, relieved_begin), std::min(end, relieved_end)};
}

std::optional<double> AffineRatios::critical_from(std::size_t b, double from, double direction) const {
  if (relief.empty()) {
    const double slope = proportional[b];
    if (!(slope * direction > least_slope)) return std::nullopt;
    return (1 - constant[b]) / slope;
  }
  const Span span = critical_span(b, direction);
  if (!(span.begin <= span.end) || span.end < from * direction) return std::nullopt;
  return span.begin * direction;
}

std::optional<double> AffineRatios::next_break(const std::vector<char>& intact, double from, double to) const {
  const double direction = to >= from ? 1 : -1;
  std::optional<double> next;
  for (std::size_t b = 0; b < intact.size(); ++b) {
    if (!intact[b]) continue;
    const double ratio = at(b, from);
    if (ratio > 1 + excess_tolerance) return from;
    const std::optional<double> critical = critical_from(b, from, direction);
    if (!critical) continue;
    double load_factor = *critical;
    if ((load_factor - from) * direction < 0) load_factor = from;  // reached already, up to rounding
    if (!next || (load_factor - *next) * direction < 0) next = load_factor;
  }
  if (next && (to - *next) * direction < 0) next.reset();
  return next;
}

LoadInterval AffineRatios::admissible(const std::vector<char>& intact, bool upwards) const {
  const double infinity = std::numeric_limits<double>::infinity();
  LoadInterval result{-infinity, infinity};
  for (std::size_t b = 0; b < intact.size(); ++b) {
    if (!intact[b]) continue;
    if (!relief.empty()) {
      const Span span = critical_span(b, 1);
      if (!(span.begin <= span.end)) continue;
      if (std::isinf(span.begin) && std::isinf(span.end)) return {infinity, -infinity};
      // If the range in which a bond is critical has two ends, the bond is not critical on either side of it; only the
      // side from which the load path comes counts.
      if (std::isinf(span.begin) || (!upwards && !std::isinf(span.end))) {
        result.lowest = std::max(result.lowest, span.end);
      } else {
        result.highest = std::min(result.highest, span.begin);
      }
      continue;
    }
    const double slope = proportional[b], room = 1 - constant[b];
    if (slope > least_slope) {
      result.highest = std::min(result.highest, room / slope);
    } else if (slope < -least_slope) {
      result.lowest = std::max(result.lowest, room / slope);
    } else if (room < -excess_tolerance) {
      return {infinity, -infinity};
    }
  }
  return result;
}

double AffineRatios::critical_load_factor(std::size_t bond, double load_factor) const {
  const bool relieved = !relief.empty() && relief.at(bond, load_factor) > 0;
  const double slope = proportional[bond] - (relieved ? relief.proportional[bond] : 0);
  if (std::abs(slope) < least_slope) return load_factor;
  const double critical = (1 - constant[bond] + (relieved ? relief.constant[bond] : 0)) / slope;
  return std::isfinite(critical) ? critical : load_factor;
}

double AffineRatios::steepest() const {
  if (!relief.empty()) {
    double largest = 0;
    for (std::size_t b = 0; b < proportional.size(); ++b)
      largest = std::max(largest, proportional[b] - std::max(0.0, relief.proportional[b]));
    return largest;
  }
  const auto count = static_cast<Eigen::Index>(proportional.size());
  return count > 0 ? Eigen::Map<const Eigen::ArrayXd>(proportional.data(), count).maxCoeff() : 0;
}

std::optional<double> AffineRatios::next_proportional_break(double from) const {
  const double largest = steepest();
  if (!(largest > least_slope)) return std::nullopt;
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
