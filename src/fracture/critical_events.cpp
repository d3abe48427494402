#include "fracture/critical_events.hpp"

#include <algorithm>
#include <cmath>

namespace bempd::fracture {

namespace {

// A ratio that differs from 1 by less than this belongs to a bond that is just reaching its critical stretch.
constexpr double excess_tolerance = 1e-12;

// Widens the tie band so that mirrored bonds, equal up to rounding, fall on the same side of its limit.
constexpr double tie_rounding = 1e-9;

}  // namespace

StretchRatios::StretchRatios(const coupling::BondSet& bonds, std::vector<double> critical_stretch)
    : bonds_(bonds),
      critical_stretch_(std::move(critical_stretch)),
      constant_(bonds.size(), 0.0),
      proportional_(bonds.size(), 0.0) {}

void StretchRatios::update(const coupling::Affine& displacement) {
  const double* constant = displacement.col(0).data();
  const double* proportional = displacement.col(1).data();
  for (std::size_t b = 0; b < bonds_.size(); ++b) {
    const double scale = 1 / (bonds_.length[b] * critical_stretch_[b]);
    constant_[b] = bonds_.elongation(b, constant) * scale;
    proportional_[b] = bonds_.elongation(b, proportional) * scale;
  }
}

double StretchRatios::stretch(std::size_t bond, double load_factor) const {
  return at(bond, load_factor) * critical_stretch_[bond];
}

std::optional<double> StretchRatios::next_break(const std::vector<char>& intact, double from, double to) const {
  const double direction = to >= from ? 1 : -1;
  std::optional<double> next;
  for (std::size_t b = 0; b < intact.size(); ++b) {
    if (!intact[b]) continue;
    const double ratio = at(b, from);
    if (ratio > 1 + excess_tolerance) return from;
    const double slope = proportional_[b];
    if (!(slope * direction > 0)) continue;
    double load_factor = (1 - constant_[b]) / slope;
    if ((load_factor - from) * direction < 0) load_factor = from;  // reached already, up to rounding
    if (!next || (load_factor - *next) * direction < 0) next = load_factor;
  }
  if (next && (to - *next) * direction < 0) next.reset();
  return next;
}

std::vector<int> StretchRatios::overstretched(const std::vector<char>& intact, double load_factor) const {
  std::vector<int> chosen;
  for (std::size_t b = 0; b < intact.size(); ++b) {
    if (intact[b] && at(b, load_factor) > 1 - excess_tolerance) chosen.push_back(static_cast<int>(b));
  }
  return chosen;
}

std::vector<int> StretchRatios::most_stretched(const std::vector<char>& intact, double load_factor, double band,
                                               int limit) const {
  double largest = 0;
  for (std::size_t b = 0; b < intact.size(); ++b) {
    if (intact[b]) largest = std::max(largest, at(b, load_factor));
  }
  const double threshold = (1 - band) * (1 - tie_rounding) * largest;
  std::vector<int> chosen;
  for (std::size_t b = 0; b < intact.size(); ++b) {
    if (intact[b] && at(b, load_factor) >= threshold) chosen.push_back(static_cast<int>(b));
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
