#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/terms.hpp"
#include "fracture/bonds_across.hpp"

namespace bempd::fracture {

// Load factors at which no bond exceeds its critical stretch; infinite where there is no bound.
struct LoadInterval {
  double lowest, highest;

  bool is_empty() const { return lowest > highest; }
  // The end of the interval in a direction; null if there is none.
  std::optional<double> next(bool upwards) const {
    const double end = upwards ? highest : lowest;
    return is_empty() || std::isinf(end) ? std::nullopt : std::optional(end);
  }
};

// Stretch of bonds over their critical stretch as affine functions of the load factor. From it goes what is positive of
// a second function where there is one, so that the ratio is the lesser of two functions.
struct AffineRatios {
  std::vector<double> constant, proportional;
  AffineRelief relief;  // empty: of no bond

  double at(std::size_t bond, double load_factor) const {
    const double whole = constant[bond] + load_factor * proportional[bond];
    return relief.empty() ? whole : whole - std::max(0.0, relief.at(bond, load_factor));
  }

  // Load factor of the next break on the way from `from` towards `to` (which may be infinite): `from` itself while a
  // bond exceeds its critical stretch there. Empty if no intact bond becomes critical.
  std::optional<double> next_break(const std::vector<char>& intact, double from, double to) const;

  // next_break() upwards to any load factor, where all constant parts are 0, and the ratios of broken bonds too.
  std::optional<double> next_proportional_break(double from) const;

  // The interval without critical bonds; where critical bonds lie between two, the one that a way in this direction
  // comes from.
  LoadInterval admissible(const std::vector<char>& intact, bool upwards = true) const;
  // The load factor at which a bond that has reached its critical stretch just reaches it; the given one if the bond
  // always exceeds it.
  double critical_load_factor(std::size_t bond, double load_factor) const;
  double steepest() const;  // largest ratio at the load factor 1 without the constant parts

  // Intact bonds at or beyond their critical stretch at this load factor, in bond order.
  std::vector<int> overstretched(const std::vector<char>& intact, double load_factor) const;

  // Intact bonds within the relative band of the largest ratio at this load factor, in bond order; at most
  // `limit` of them (0: all), the most stretched ones.
  std::vector<int> most_stretched(const std::vector<char>& intact, double load_factor, double band, int limit) const;
  std::vector<int> most_stretched(const std::vector<char>& intact, double load_factor, double band, int limit,
                                  double largest) const;

 private:
  // Load factors times a direction between which a bond is at or beyond its critical stretch.
  struct Span {
    double begin, end;
  };
  Span critical_span(std::size_t bond, double direction) const;
  std::optional<double> critical_from(std::size_t bond, double from, double direction) const;
};

// Share of the largest ratio from which on bonds break together with it; wider than the band by the rounding in which
// mirrored bonds differ.
double tie_limit(double band);

// The ratios of all terms of a system: elastic elongations over the critical ones of the terms' stages.
class StretchRatios : public AffineRatios {
 public:
  // All terms are in their first stage. An infinite critical stretch marks a term that cannot break.
  StretchRatios(const coupling::Terms& terms, std::vector<double> critical_stretch);

  void enter(const std::vector<std::uint8_t>& stages);  // of all terms; the ratios follow with the next update
  void update(const coupling::Affine& displacement);

  const coupling::CriticalScales& scales() const { return scales_; }
  const coupling::Terms& terms() const { return terms_; }
  const BondsAcross& across() const { return across_; }
  // The critical stretch of a term in one of its stages; infinite where it is broken.
  double critical_stretch(std::size_t term, int stage) const {
    return critical_stretch_[term] * terms_.law_of(term).critical_share(stage);
  }

 private:
  const coupling::Terms& terms_;
  std::vector<double> critical_stretch_;
  std::vector<std::uint8_t> stages_;  // empty if no critical value depends on them
  BondsAcross across_;
  std::vector<char> present_;  // per term; empty if no ratio depends on it
  coupling::CriticalScales scales_;
};

}  // namespace bempd::fracture
