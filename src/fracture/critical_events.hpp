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

// Stretch ratios (stretch over critical stretch) of bonds, as affine functions of the load factor. If bonds have a
// relief (stretch by Poisson's effect, bonds_across.hpp), it is subtracted where it is positive, so that the ratio is
// the smaller of two affine functions.
struct AffineRatios {
  std::vector<double> constant, proportional;
  AffineRelief relief;  // empty: no bond has a relief

  double at(std::size_t bond, double load_factor) const {
    const double whole = constant[bond] + load_factor * proportional[bond];
    return relief.empty() ? whole : whole - std::max(0.0, relief.at(bond, load_factor));
  }

  // Load factor of the next break on the way from `from` towards `to` (which may be infinite). The result is `from` if
  // some bond exceeds its critical stretch already there; empty if no intact bond becomes critical on the way.
  std::optional<double> next_break(const std::vector<char>& intact, double from, double to) const;

  // next_break() from `from` to infinity, for stretch ratios whose constant parts are all 0, and which are 0 for broken
  // bonds.
  std::optional<double> next_proportional_break(double from) const;

  // Range of load factors in which no intact bond is critical. If critical load factors lie between two such ranges,
  // the result is the range in which a load path in the direction of `upwards` begins.
  LoadInterval admissible(const std::vector<char>& intact, bool upwards = true) const;
  // Load factor at which a bond that exceeds its critical stretch just reaches it; `load_factor` itself if the bond
  // always exceeds it.
  double critical_load_factor(std::size_t bond, double load_factor) const;
  double steepest() const;  // largest ratio at the load factor 1, without the constant parts

  // Intact bonds at or beyond their critical stretch at this load factor, in bond order.
  std::vector<int> overstretched(const std::vector<char>& intact, double load_factor) const;

  // Intact bonds whose stretch ratio lies within the relative `band` below the largest ratio at a load factor, in bond
  // order; at most `limit` of them (0: all), the most stretched ones. `largest` is the largest ratio, if the caller
  // knows it.
  std::vector<int> most_stretched(const std::vector<char>& intact, double load_factor, double band, int limit) const;
  std::vector<int> most_stretched(const std::vector<char>& intact, double load_factor, double band, int limit,
                                  double largest) const;

 private:
  // Range of (load factor times direction) in which a bond is at or beyond its critical stretch; empty if begin > end.
  struct Span {
    double begin, end;
  };
  Span critical_span(std::size_t bond, double direction) const;
  std::optional<double> critical_from(std::size_t bond, double from, double direction) const;
};

// Share of the largest stretch ratio from which on bonds break together with the most stretched bond: 1 - band, less
// the rounding by which mirrored bonds differ.
double tie_limit(double band);

// Stretch ratios of all terms (bonds and cell squares) of a system: elastic elongation over the critical elongation in
// the term's damage stage.
class StretchRatios : public AffineRatios {
 public:
  // Begins with all terms in their first damage stage. An infinite critical stretch marks a term that cannot break.
  StretchRatios(const coupling::Terms& terms, std::vector<double> critical_stretch);

  void enter(const std::vector<std::uint8_t>& stages);  // stages of all terms; the ratios change with the next update()
  void update(const coupling::Affine& displacement);

  const coupling::CriticalScales& scales() const { return scales_; }
  const coupling::Terms& terms() const { return terms_; }
  const BondsAcross& across() const { return across_; }
  // Critical stretch of a term in one of its damage stages; infinite in the stage in which the term is broken.
  double critical_stretch(std::size_t term, int stage) const {
    return critical_stretch_[term] * terms_.law_of(term).critical_share(stage);
  }

 private:
  const coupling::Terms& terms_;
  std::vector<double> critical_stretch_;
  std::vector<std::uint8_t> stages_;  // empty if no critical value depends on them
  BondsAcross across_;
  std::vector<char> present_;  // flags of terms that are not broken; empty if no ratio depends on them
  coupling::CriticalScales scales_;
};

}  // namespace bempd::fracture
