// Strength of a cracked plate against Griffith's, sigma = sqrt(E G0 / (pi a)), for a crack of 2a = 80 spacings between
// two rows of a lattice in a plate of boundary elements that carries the stresses of the infinite plane on its edges.
// Reference: A. A. Griffith, Phil. Trans. Roy. Soc. A 221 (1921), with G0 as the energy of a material point's bonds
// across a plane, which a lattice of finite horizon meets up to a constant.
#include <gtest/gtest.h>

#include <claims.hpp>

#include "griffith_plate.hpp"

namespace {

using namespace host;

struct Strength {
  double first, largest;  // load at the first break, and the largest one while the crack grows by four spacings
};

// How far broken bonds lie ahead of the initial tips, in spacings.
double growth(Model& model, int32_t lattice, const std::vector<Vector>& places) {
  const Bonds bonds = model.bonds(lattice);
  double farthest = half_crack;
  for (std::size_t i = 0; i < bonds.states.size(); ++i) {
    if (bonds.states[i] != BEMPD_BOND_BROKEN) continue;
    const auto [a, b] = bonds.points[i];
    const double x = (places[static_cast<std::size_t>(a)][0] + places[static_cast<std::size_t>(b)][0]) / 2;
    farthest = std::max(farthest, std::abs(x));
  }
  return (farthest - half_crack) / dx;
}

Strength strength(int horizon_ratio) {
  const double pi = 3.14159265358979323846;
  const double griffith = std::sqrt(CrackedPlane::young * toughness / (pi * half_crack));
  Model model;
  const int32_t lattice = build_griffith_plate(model, horizon_ratio);
  const auto places = model.vectors(lattice, BEMPD_POSITION);
  Strength found{0, 0};
  while (growth(model, lattice, places) < 4) {
    const double load = model.next_event(1e6).load_factor / griffith;
    if (found.first == 0) found.first = load;
    found.largest = std::max(found.largest, load);
  }
  return found;
}

void expect_claims(int horizon_ratio, const claims::Target& first, const claims::Target& largest) {
  const Strength found = strength(horizon_ratio);
  std::printf("horizon of %d spacings: ", horizon_ratio);
  EXPECT_LE(std::abs(report("first break over Griffith's load", found.first, first.claimed, "claimed")), first.margin);
  std::printf("horizon of %d spacings: ", horizon_ratio);
  EXPECT_LE(std::abs(report("largest load over Griffith's", found.largest, largest.claimed, "claimed")),
            largest.margin);
}

TEST(Griffith, share_of_the_load_with_a_horizon_of_3) {
  expect_claims(3, claims::griffith_first_3, claims::griffith_peak_3);
}

TEST(Griffith, share_of_the_load_with_a_horizon_of_4) {
  expect_claims(4, claims::griffith_first_4, claims::griffith_peak_4);
}

TEST(Griffith, share_of_the_load_with_a_horizon_of_5) {
  expect_claims(5, claims::griffith_first_5, claims::griffith_peak_5);
}

TEST(Griffith, share_of_the_load_with_a_horizon_of_6) {
  expect_claims(6, claims::griffith_first_6, claims::griffith_peak_6);
}

}  // namespace
