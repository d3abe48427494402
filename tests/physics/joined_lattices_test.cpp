// A plate of lattice cells gives the same answers whether the host says it in one region or in several that touch: the
// regions act as one where spacing, horizon and material are the same. Reference: the plate of one region.
#include <gtest/gtest.h>

#include <map>

#include "coupled_scene.hpp"

namespace joined_lattices_test {
namespace {

using namespace host;

constexpr double spacing = 0.05, young = 30e9, limit = 1e-3;

Outline scaled(Outline cells) {
  for (Vector& p : cells) p = {spacing * p[0], spacing * p[1]};
  return cells;
}

struct Part {
  Outline cells;
  std::vector<Outline> holes{};
};

const Outline hole_left = rectangular_hole(3, 11, 5, 13), hole_right = rectangular_hole(19, 10, 21, 12);

// 24 x 16 cells with two holes, in one, two and four parts; the first of the four is an L.
std::vector<Part> one() { return {{rectangle(0, 0, 24, 16), {hole_left, hole_right}}}; }
std::vector<Part> two() { return {{rectangle(0, 0, 11, 16), {hole_left}}, {rectangle(11, 0, 24, 16), {hole_right}}}; }
std::vector<Part> four() {
  return {{{{0, 0}, {24, 0}, {24, 5}, {9, 5}, {9, 16}, {0, 16}}, {hole_left}},
          {rectangle(9, 5, 17, 12)},
          {rectangle(17, 5, 24, 16), {hole_right}},
          {rectangle(9, 12, 17, 16)}};
}

std::vector<Piece> pieces(const std::vector<Part>& parts) {
  std::vector<Piece> result;
  for (const Part& part : parts) {
    result.push_back({Method::peridynamics, scaled(part.cells)});
    for (const Outline& hole : part.holes) result.back().holes.push_back(scaled(hole));
  }
  return result;
}

// Clamped below, pulled up above and sideways on the right; a crack runs across the shared edges. Part k is made of
// material k of `limits`, with horizon k of `horizons`; the last ones serve for all that follow.
void build(Model& model, const std::vector<Part>& parts, std::vector<double> limits = {limit},
           std::vector<int> horizons = {3}, bool cracked = true) {
  const auto all = pieces(parts);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const double stretch = limits[std::min(k, limits.size() - 1)];
    const int32_t id = model.add(material(young, 1.0 / 3, BEMPD_PLANE_STRESS, 0.01, stretch));
    add_pieces(model, {all[k]}, id, spacing, horizons[std::min(k, horizons.size() - 1)], 1);
  }
  for (const EdgePart& part : free_parts(all)) {
    const auto region = static_cast<int32_t>(part.piece) + 1;
    const double y = (part.start[1] + part.end[1]) / 2 / spacing, x = (part.start[0] + part.end[0]) / 2 / spacing;
    if (y < 1e-9) model.prescribe(region, part.edge, part.from, part.to, [](double, double) { return Vector{0, 0}; });
    if (y > 16 - 1e-9)
      model.prescribe(region, part.edge, part.from, part.to, [](double, double) { return Vector{0, 1e-4}; });
    if (x > 24 - 1e-9) model.traction(region, part.edge, part.from, part.to, BEMPD_X, 0, 1e5);
  }
  if (cracked) model.crack(scaled({{4.5, 8.5}, {19.5, 8.5}}));
}

using Place = std::array<int, 2>;
Place place_of(Vector p) {
  return {static_cast<int>(std::lround(p[0] / spacing)), static_cast<int>(std::lround(p[1] / spacing))};
}

// A field by place. Regions that share a point have to agree there up to the share `tolerance` of the largest value.
std::map<Place, std::vector<double>> by_place(Model& model, int32_t field, double tolerance) {
  std::map<Place, std::vector<double>> values;
  for (int32_t region = 1; region <= model.region_count(); ++region) {
    const auto places = model.vectors(region, BEMPD_POSITION);
    const std::vector<double> flat = model.field(region, field);
    const std::size_t n = flat.size() / places.size();
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::vector<double> entry(flat.begin() + static_cast<std::ptrdiff_t>(n * i),
                                      flat.begin() + static_cast<std::ptrdiff_t>(n * (i + 1)));
      const auto [found, is_new] = values.try_emplace(place_of(places[i]), entry);
      const double difference = is_new ? 0 : largest_difference(entry, found->second);
      EXPECT_LE(difference, tolerance * largest(flat));
    }
  }
  return values;
}

void expect_same_field(Model& model, Model& reference, int32_t field, const char* name, double tolerance) {
  const auto values = by_place(model, field, tolerance), wanted = by_place(reference, field, tolerance);
  ASSERT_EQ(values.size(), wanted.size());
  double worst = 0, scale = 0;
  for (const auto& [place, entry] : wanted) {
    ASSERT_TRUE(values.count(place));
    worst = std::max(worst, largest_difference(entry, values.at(place)));
    scale = std::max(scale, largest(entry));
  }
  EXPECT_LE(report(name, worst / scale, 0, "one region"), tolerance);
}

void expect_same_run(const std::vector<Part>& parts) {
  Model reference, model;
  build(reference, one());
  build(model, parts);
  reference.step(0.1);
  model.step(0.1);
  EXPECT_EQ(model.statistics().bonds, reference.statistics().bonds);
  EXPECT_EQ(model.statistics().cut_bonds, reference.statistics().cut_bonds);
  for (const auto& [field, name] : {std::pair<int32_t, const char*>{BEMPD_DISPLACEMENT, "displacement"},
                                    {BEMPD_STRESS, "stress"},
                                    {BEMPD_DAMAGE, "damage"}})
    expect_same_field(model, reference, field, name, 1e-9);
  reference.run(1e4);
  model.run(1e4);
  const auto lines = model.history(), wanted = reference.history();
  ASSERT_EQ(lines.size(), wanted.size());
  ASSERT_GT(lines.size(), 5u);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].total_broken_bonds, wanted[i].total_broken_bonds) << i;
    EXPECT_NEAR(lines[i].load_factor, wanted[i].load_factor, 1e-9 * std::abs(wanted[i].load_factor)) << i;
    // The last event frees what hangs on a few bonds, and their elongations carry the rounding of its solution.
    const double slack = i + 2 < lines.size() ? 1e-9 : 1e-5;
    EXPECT_NEAR(lines[i].released_energy, wanted[i].released_energy, slack * std::abs(wanted[i].work)) << i;
  }
  expect_same_field(model, reference, BEMPD_DAMAGE, "damage at the end", 1e-12);
}

TEST(JoinedLattices, two_regions_run_as_one) { expect_same_run(two()); }

TEST(JoinedLattices, four_regions_with_an_L_run_as_one) { expect_same_run(four()); }

// How many bonds regions list, each between two of its own points and none twice.
std::int64_t listed(Model& model) {
  std::set<std::array<Place, 2>> seen;
  std::int64_t count = 0;
  for (int32_t region = 1; region <= model.region_count(); ++region) {
    const auto places = model.vectors(region, BEMPD_POSITION);
    const Bonds bonds = model.bonds(region);
    EXPECT_EQ(model.field(region, BEMPD_BOND_STRETCH).size(), bonds.points.size());
    count += static_cast<std::int64_t>(bonds.points.size());
    for (const auto& [a, b] : bonds.points)
      seen.insert({place_of(places.at(static_cast<std::size_t>(a))), place_of(places.at(static_cast<std::size_t>(b)))});
  }
  EXPECT_EQ(static_cast<std::int64_t>(seen.size()), count);
  return count;
}

TEST(JoinedLattices, bonds_across_count_in_damage_and_statistics_and_are_listed_by_none) {
  for (const auto& parts : {two(), four()}) {
    Model model;
    build(model, parts);
    model.prepare();
    const std::int64_t count = listed(model);
    EXPECT_LT(count, model.statistics().bonds);
    std::int64_t cut = 0;
    for (int32_t region = 1; region <= model.region_count(); ++region) {
      for (int32_t state : model.bonds(region).states) cut += state == BEMPD_BOND_CUT;
    }
    EXPECT_LT(cut, model.statistics().cut_bonds);
  }
}

std::int64_t bonds_of(const std::vector<Part>& parts, const std::vector<double>& limits,
                      const std::vector<int>& horizons) {
  Model model;
  build(model, parts, limits, horizons, false);
  model.prepare();
  return model.statistics().bonds;
}

TEST(JoinedLattices, other_materials_and_horizons_stay_coupled_by_shared_points) {
  const auto halves = two();
  const auto alone = [&](std::size_t half, int horizon) { return bonds_of({halves[half]}, {limit}, {horizon}); };
  EXPECT_EQ(bonds_of(halves, {limit, 2 * limit}, {3}), alone(0, 3) + alone(1, 3));
  EXPECT_EQ(bonds_of(halves, {limit}, {3, 4}), alone(0, 3) + alone(1, 4));
  EXPECT_NE(bonds_of(halves, {limit}, {3}), alone(0, 3) + alone(1, 3));
}

// A strip with another critical stretch runs between two equal parts: all three differ from their neighbours.
TEST(JoinedLattices, a_strip_of_another_material_keeps_its_neighbours_apart) {
  const std::vector<Part> thirds{{rectangle(0, 0, 8, 16)}, {rectangle(8, 0, 16, 16)}, {rectangle(16, 0, 24, 16)}};
  const std::int64_t strip = bonds_of({thirds[0]}, {limit}, {3});
  EXPECT_EQ(bonds_of(thirds, {limit, 2 * limit, limit}, {3}), 3 * strip);
}

}  // namespace
}  // namespace joined_lattices_test
