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

// Range of load factors in which no bond exceeds its critical stretch; infinite where there is no bound.
struct LoadInterval {
  double lowest, highest;

  bool is_empty() const { return lowest > highest; }
  // End of the range in a direction; empty if it is infinite or the range is empty.
  std::optional<double> next(bool upwards) const {
    const double end = upwards ? highest : lowest;
    return is_empty() || std::isinf(end) ? std::nullopt : std::optional(end);
  }
};

// Ratios of stretch to critical stretch of bonds, as affine functions of the load factor. If there is a relief (a
// second function), its positive values are subtracted, so that the ratio is the smaller of two affine functions.
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

  // next_break() with rising load factor and no bound, for the case that all constant parts are 0, and the ratios of
  // broken bonds too.
  std::optional<double> next_proportional_break(double from) const;

  // Range of load factors without critical bonds. If critical bonds lie between two such ranges, the one that a path in
  // this direction comes from.
  LoadInterval admissible(const std::vector<char>& intact, bool upwards = true) const;
  // Load factor at which a bond that exceeds its critical stretch just reaches it; `load_factor` itself if the bond
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
  // Range of (load factor times direction) in which a bond is at or beyond its critical stretch.
  struct Span {
    double begin, end;
  };
  Span critical_span(std::size_t bond, double direction) const;
  std::optional<double> critical_from(std::size_t bond, double from, double direction) const;
};

// Ratio over the largest ratio from which on bonds break together with the most stretched one: 1 - band, less the
// rounding by which mirrored bonds differ.
double tie_limit(double band);

// Ratios of all terms of a system: elastic elongation over the critical one of the term's stage.
class StretchRatios : public AffineRatios {
 public:
  // Puts all terms in their first stage. An infinite critical stretch marks a term that cannot break.
  StretchRatios(const coupling::Terms& terms, std::vector<double> critical_stretch);

  void enter(const std::vector<std::uint8_t>& stages);  // of all terms; the ratios follow with the next update
  void update(const coupling::Affine& displacement);

  const coupling::CriticalScales& scales() const { return scales_; }
  const coupling::Terms& terms() const { return terms_; }
  const BondsAcross& across() const { return across_; }
  // Critical stretch of a term in one of its stages; infinite where the term is broken.
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
