// Position of the effective tip of an initial crack: the half length of the slit in an infinite plane that opens as the
// crack in the lattice does, against the stated one. Reference: H. M. Westergaard, J. Appl. Mech. 6 (1939).
#include <gtest/gtest.h>

#include <algorithm>
#include <claims.hpp>

#include "griffith_plate.hpp"

namespace fracture_tip_test {
namespace {

using namespace host;

constexpr int stations = 20;  // points behind the tip whose opening is compared

// Opening between the rows of points at both sides, at points `first` .. `first + stations - 1` spacings behind the
// middle of the last gap between columns.
std::vector<double> openings(Model& model, int32_t lattice, int first) {
  const auto places = model.vectors(lattice, BEMPD_POSITION), moved = model.vectors(lattice, BEMPD_DISPLACEMENT);
  std::vector<double> opening(stations, 0.0);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double behind = (half_crack - places[i][0]) / dx - 0.5 - first;
    const int k = static_cast<int>(std::lround(behind));
    if (k < 0 || k >= stations || std::abs(std::abs(places[i][1]) - dx / 2) > 0.1 * dx) continue;
    opening[static_cast<std::size_t>(k)] += (places[i][1] > 0 ? 1 : -1) * moved[i][1] / model.load_factor();
  }
  return opening;
}

double slit_opening(double half_length, double x) { return 2 * CrackedPlane{half_length}.displacement(x, dx / 2)[1]; }

// Least squares by bisection: the sum of openings grows with the length.
double felt_half_length(const std::vector<double>& opening, int first) {
  double low = half_crack - 3 * dx, high = half_crack + 3 * dx;
  while (high - low > 1e-6 * dx) {
    const double middle = (low + high) / 2;
    double excess = 0;
    for (int k = 0; k < stations; ++k)
      excess += slit_opening(middle, half_crack - (first + k + 0.5) * dx) - opening[static_cast<std::size_t>(k)];
    (excess > 0 ? high : low) = middle;
  }
  return (low + high) / 2;
}

struct Tip {
  double felt;   // ahead of the stated tip, in spacings
  double first;  // load at the first break over Griffith's for the stated length
};

Tip tip_of(const char* rule, int horizon_ratio, double shift) {
  Model model;
  model.set_text("crack.rule", rule);
  const int32_t lattice = build_griffith_plate(model, horizon_ratio, shift);
  constexpr double load = 0.01;  // nothing breaks yet
  model.step(load);
  const int first = 2 * horizon_ratio;
  const double stated = half_crack + shift * dx;
  const double felt = (felt_half_length(openings(model, lattice, first), first) - stated) / dx;
  const double griffith = std::sqrt(CrackedPlane::young * toughness / (3.14159265358979323846 * stated));
  return {felt, model.next_event(1e6).load_factor / griffith};
}

struct Range {
  double least = 1, most = 0;
};

Range felt_ahead(const char* rule, const std::vector<int>& horizon_ratios) {
  Range range;
  for (const int m : horizon_ratios) {
    for (const double shift : {-0.5, -0.25, 0.0, 0.25}) {
      const Tip tip = tip_of(rule, m, shift);
      std::printf("%s, horizon of %d spacings, tip %+.2f from midway: felt %+.3f ahead, first load %.4f of Griffith\n",
                  rule, m, shift, tip.felt, tip.first);
      range = {std::min(range.least, tip.felt), std::max(range.most, tip.felt)};
    }
  }
  return range;
}

TEST(CrackTip, is_felt_half_a_spacing_ahead_of_the_stated_place_bond_by_bond) {
  const auto [least, most] = felt_ahead("bond", {3, 4, 5});
  EXPECT_GE(least, claims::slit_shortest.claimed);
  EXPECT_LE(most, claims::slit_longest.claimed);
  EXPECT_TRUE(claims::slit_shortest.holds(least)) << least;
  EXPECT_TRUE(claims::slit_longest.holds(most)) << most;
}

TEST(CrackTip, is_felt_at_the_stated_place_as_a_line) {
  const auto [least, most] = felt_ahead("line", {4});
  EXPECT_LE(std::max(-least, most), 0.15);
}

}  // namespace
}  // namespace fracture_tip_test
