#include "fracture/line/line_load.hpp"

#include <cmath>

#include "crack/growth_law.hpp"
#include "error.hpp"
#include "fracture/event_source.hpp"

namespace bempd::fracture {

namespace {

constexpr int rounds_for_kink = 8;

// Largest quotient that counts as a load factor: stress intensity factors times this quotient can still be squared
// within the range of numbers.
constexpr double largest_ratio_of_loads = 1e150;

// Kink of a tip with the stress intensity factors `of` at a load factor: by the growth law if its fracture energy
// depends on the direction, else in the direction of maximum hoop stress.
Kink kink_at(const AffineIntensity& of, double load_factor, const crack::GrowthLaw& law) {
  const Eigen::Vector2d at(1, load_factor);
  const Point factors(of.one.dot(at), of.two.dot(at));
  return law.directions ? law.kink(factors) : kink_of(factors);
}

bool are_proportional(const AffineIntensity& intensity, const AffineIntensity& turn_factors) {
  return turn_factors.one[0] == 0 && turn_factors.two[0] == 0 && intensity.one[0] == 0 && intensity.two[0] == 0;
}

// Load factor beyond the one at which a tip reaches its toughness, as the start of an iteration; 0 if larger loads do
// not increase the tip's equivalent stress intensity factor.
double beyond_toughness(const AffineIntensity& intensity, const crack::GrowthLaw& law) {
  const Point slopes(intensity.one[1], intensity.two[1]);
  const double slope = (law.directions ? law.kink(slopes) : kink_of(slopes)).equivalent_factor;
  const double size = law.toughness + std::hypot(intensity.one[0], intensity.two[0]);
  return slope > 0 ? load_ratio(4 * size, slope).value_or(0) : 0;
}

// Search for the load factor at which a tip grows, by the criterion of maximum hoop stress. Without constant loads the
// kink does not depend on the load factor. Otherwise the equivalent factor is a convex function of the load factor,
// with one tangent for each kink: rising tangents lead to the larger one of the two load factors at which the
// equivalent factor equals the toughness (Newton's method).
class ByHoopStress {
 public:
  ByHoopStress(const AffineIntensity& intensity, const AffineIntensity& turn_factors, const LineCriterion& criterion)
      : intensity_(intensity),
        turn_factors_(turn_factors),
        criterion_(criterion),
        proportional_(are_proportional(intensity, turn_factors)) {}

  std::optional<LineLoad> load() {
    const double present = criterion_.present;
    bool grows = aim(proportional_ || present <= 0 ? 1 : present) ||
                 (!proportional_ && aim(beyond_toughness(intensity_, criterion_.law)));
    for (int round = 1; grows && !proportional_ && round < rounds_for_kink; ++round) grows = aim(found_.load_factor);
    if (is_due(grows)) {
      aim(present);
      found_.load_factor = present;
      return found_;
    }
    return grows ? std::optional(found_) : std::nullopt;
  }

 private:
  bool aim(double load_factor) {
    const double kink = kink_at(intensity_, load_factor, criterion_.law).angle;
    const double toughness =
        criterion_.law.toughness * (criterion_.law.directions ? std::sqrt(criterion_.law.share_in(kink)) : 1);
    const auto share = [&](int part) {
      return hoop_factor({intensity_.one[part], intensity_.two[part]}, kink) * criterion_.correction / toughness;
    };
    found_.constant = share(0), found_.growing = share(1),
    found_.angle = kink_at(turn_factors_, load_factor, criterion_.law).angle;
    if (!(found_.growing > 0)) return false;
    const std::optional<double> root = load_ratio(1 - found_.constant, found_.growing);
    found_.load_factor = root.value_or(0);
    return root.has_value();
  }

  // Whether a tip that is overloaded at the start of the load path grows at once, although the search has found no load
  // factor or only a farther one. This happens if the load factor has changed its direction, or if the path starts
  // below the smaller of the two load factors at which the equivalent factor equals the toughness.
  bool is_due(bool grows) const {
    const double present = criterion_.present, least = proportional_ ? 1 + ratio_rounding : 1;
    return (!proportional_ || present < 0) && criterion_.control == Control::load &&
           (!grows || found_.load_factor > present) &&
           kink_at(intensity_, present, criterion_.law).equivalent_factor * criterion_.correction >=
               least * criterion_.law.toughness;
  }

  const AffineIntensity &intensity_, &turn_factors_;
  const LineCriterion& criterion_;
  bool proportional_;
  LineLoad found_;
};

std::optional<LineLoad> load_by_energy(const AffineIntensity& intensity, const AffineIntensity& turn_factors,
                                       const LineCriterion& criterion) {
  const crack::AffineFactors factors{{intensity.one[0], intensity.two[0]}, {intensity.one[1], intensity.two[1]}};
  crack::GrowthLaw law = criterion.law;
  law.toughness /= criterion.correction;
  const double present = criterion.present;
  const crack::GrowthRange range = law.range(factors);
  const auto ratio_at = [&](double load_factor) { return law.ratio(factors, load_factor); };
  const bool holds_load = criterion.control == Control::load;
  if (range.is_empty() && !holds_load) return std::nullopt;
  LineLoad found;
  if (holds_load && (range.is_empty() || range.lowest - present > ratio_rounding * std::abs(present))) {
    found.load_factor = present, found.constant = ratio_at(present);
  } else if (std::abs(range.highest) < largest_ratio_of_loads) {
    found.load_factor = range.highest;
    // The ratio of equivalent factor to toughness is given as constant + load factor * growing. For a tip that is
    // overloaded at the present load factor, this line joins the ratio 1 at range.highest and the present ratio; for
    // any other tip the line is the constant 1.
    const double ratio = holds_load && present > range.highest ? ratio_at(present) : 1;
    found.growing = ratio > 1 ? (ratio - 1) / (present - range.highest) : 0;
    found.constant = 1 - range.highest * found.growing;
  } else {
    return std::nullopt;
  }
  found.angle = kink_at(turn_factors, found.load_factor, law).angle;
  return found;
}

}  // namespace

std::optional<double> load_ratio(double dividend, double divisor) {
  const double size = std::abs(divisor);
  if (!(size > 0) || (size < 1 && std::abs(dividend) >= largest_ratio_of_loads * size)) return std::nullopt;
  return dividend / divisor;
}

namespace {

std::optional<LineLoad> load_by_numbers(const AffineIntensity& intensity, const AffineIntensity& turn_factors,
                                        const LineCriterion& criterion) {
  if (!(criterion.law.toughness > 0) || std::isinf(criterion.law.toughness)) return std::nullopt;
  if (criterion.law.criterion == KinkCriterion::energy_release_rate)
    return load_by_energy(intensity, turn_factors, criterion);
  return ByHoopStress(intensity, turn_factors, criterion).load();
}

}  // namespace

// A fracture energy from a function of the host depends on the stress intensity factors of the tip, and so on the load
// factor of growth. Fracture energy and load factor are found together, by repeated substitution.
std::optional<LineLoad> load_of_growth(const AffineIntensity& intensity, const AffineIntensity& turn_factors,
                                       LineCriterion& criterion) {
  if (!criterion.law.asking.function) return load_by_numbers(intensity, turn_factors, criterion);
  constexpr int most_rounds = 50;
  constexpr double same = 1e-10;
  const crack::GrowthLaw asking = criterion.law;
  const crack::AffineFactors factors{{intensity.one[0], intensity.two[0]}, {intensity.one[1], intensity.two[1]}};
  criterion.law.asking.function = nullptr;
  std::optional<LineLoad> load = load_by_numbers(intensity, turn_factors, criterion);
  for (int round = 0; load && round < most_rounds; ++round) {
    const double before = load->load_factor;
    criterion.law = asking.with_host_toughness(factors, before);
    load = load_by_numbers(intensity, turn_factors, criterion);
    if (!load || std::abs(load->load_factor - before) <= same * std::abs(before)) return load;
  }
  if (!load) return load;
  fail(Failure::argument, "no load factor was found at which crack ", asking.asking.id.crack,
       " grows: the fracture energy that the resistance function gives changes too fast with the factors of the tip; "
       "let it change more slowly than they do");
}

}  // namespace bempd::fracture
