// Cracks that lie across an interface of boundary elements and a lattice: stress intensity factors of both tips,
// openings and energies beside those of the same crack among elements alone, which closed forms vouch for
// (crack_factors_test), and in a lattice alone.
#include <gtest/gtest.h>

#include <algorithm>

#include "host.hpp"
#include "thorough.hpp"

namespace mixed_cracks_test {
namespace {

using namespace host;

constexpr double width = 80, height = 64, middle = 40;

// A strip of the plate from one place to another, of boundary elements or with a lattice.
struct Strip {
  bool lattice;
  double from, to;
};
const std::vector<Strip> all_elements{{false, 0, width}}, all_lattice{{true, 0, width}};
const std::vector<Strip> both{{false, 0, middle}, {true, middle, width}};

struct Answer {
  std::vector<bempd_crack_tip> tips;  // the crack's start first
  double energy;
};

struct Plate {
  double poisson = 1.0 / 3, slant = 0;  // half the way that the border in `both` goes sideways
  double pull = 1, pressure = 0;
  std::vector<std::string>* log = nullptr;

  static void hear(int32_t level, const char* message, void* user) {
    if (level <= 1) static_cast<std::vector<std::string>*>(user)->emplace_back(message);
  }

  void describe(Model& model, const std::vector<Strip>& strips, const Outline& crack) const {
    if (log) model.check(bempd_set_log(model.get(), &hear, log));
    const int32_t id = model.add(material(1, poisson, BEMPD_PLANE_STRESS));
    for (const Strip& strip : strips) {
      const double s = slant;
      const Outline outline{{strip.from > 0 ? strip.from - s : 0, 0},
                            {strip.to < width ? strip.to - s : width, 0},
                            {strip.to < width ? strip.to + s : width, height},
                            {strip.from > 0 ? strip.from + s : 0, height}};
      const int32_t region = strip.lattice ? model.pd(id, outline, 1, 4) : model.bem(id, outline, 4);
      model.fix(region, 1, BEMPD_Y);
      model.prescribe(region, 3, BEMPD_Y, 0, pull);
    }
    model.fix_point({0, 0}, BEMPD_X);
    model.crack(crack);
    if (pressure != 0) {
      int32_t load = 0;
      model.check(bempd_add_crack_pressure(model.get(), 1, 0, pressure, &load));
    }
  }

  static Answer ask(Model& model) {
    Answer answer{{}, model.step(1).stored_energy};
    int64_t count = 0;
    model.check(bempd_tip_count(model.get(), &count));
    answer.tips.resize(static_cast<std::size_t>(count));
    for (int64_t k = 0; k < count; ++k) {
      bempd_crack_tip_init(&answer.tips[static_cast<std::size_t>(k)], sizeof(bempd_crack_tip));
      model.check(bempd_tip(model.get(), k, &answer.tips[static_cast<std::size_t>(k)]));
    }
    std::sort(answer.tips.begin(), answer.tips.end(), [](const auto& a, const auto& b) { return a.end < b.end; });
    return answer;
  }

  Answer operator()(const std::vector<Strip>& strips, const Outline& crack) const {
    Model model;
    describe(model, strips, crack);
    return ask(model);
  }
};

Outline inclined(double degrees, double half_length, Vector centre) {
  const double angle = degrees * 3.14159265358979323846 / 180, c = std::cos(angle), s = std::sin(angle);
  return {{centre[0] - half_length * c, centre[1] - half_length * s},
          {centre[0] + half_length * c, centre[1] + half_length * s}};
}

double size(const bempd_crack_tip& tip) { return std::hypot(tip.stress_intensity_1, tip.stress_intensity_2); }

// Largest difference of both factors over their size.
double difference(const bempd_crack_tip& tip, const bempd_crack_tip& reference) {
  return std::hypot(tip.stress_intensity_1 - reference.stress_intensity_1,
                    tip.stress_intensity_2 - reference.stress_intensity_2) /
         size(reference);
}

TEST(MixedCracks, have_the_factors_of_elements_at_all_angles_and_borders) {
  int combination = 0;
  for (const double slant : {0.0, 5.0}) {
    for (const double degrees : {0.0, 20.0, 45.0, 63.0}) {
      combination += 2;  // another height at every angle
      for (const double y : {32.0, 32.2, 32.5}) {
        if (!bempd_tests::is_thorough() && combination++ % 3 != 0) continue;
        const Outline crack = inclined(degrees, 16, {middle, y});
        const Answer elements = Plate{}(all_elements, crack), mixed = Plate{1.0 / 3, slant}(both, crack);
        ASSERT_EQ(mixed.tips.size(), 2u);
        EXPECT_EQ(mixed.tips[0].method, BEMPD_TIP_ELEMENTS);
        EXPECT_EQ(mixed.tips[1].method, BEMPD_TIP_CONTOURS);
        const double one = difference(mixed.tips[0], elements.tips[0]);
        const double other = difference(mixed.tips[1], elements.tips[1]);
        std::printf("%2.0f degrees, border %+.0f, height %.1f: tip of elements %.4f, of bonds %.4f, energy %+.4f\n",
                    degrees, slant, y, one, other, mixed.energy / elements.energy - 1);
        EXPECT_LT(one, 0.02);
        EXPECT_LT(other, 0.02);
        EXPECT_LT(std::abs(mixed.energy / elements.energy - 1), 0.01);
      }
    }
  }
}

// The crack crosses borders in both orders, and also a body with elements on one side only.
TEST(MixedCracks, pass_through_strips) {
  const Outline crack{{24, 30.2}, {56, 35.1}};
  const std::vector<std::vector<Strip>> bodies{{{false, 0, 34}, {true, 34, 46}, {false, 46, width}},
                                               {{true, 0, 34}, {false, 34, 46}, {true, 46, width}},
                                               {{true, 0, middle}, {false, middle, width}}};
  const Answer elements = Plate{}(all_elements, crack);
  for (const auto& strips : bodies) {
    const Answer mixed = Plate{}(strips, crack);
    ASSERT_EQ(mixed.tips.size(), 2u);
    for (int k = 0; k < 2; ++k) {
      EXPECT_EQ(mixed.tips[k].method,
                strips[k == 0 ? 0 : strips.size() - 1].lattice ? BEMPD_TIP_CONTOURS : BEMPD_TIP_ELEMENTS);
      const double off = difference(mixed.tips[k], elements.tips[k]);
      std::printf("%zu strips, tip %d: off by %.4f\n", strips.size(), k, off);
      EXPECT_LT(off, 0.02);
    }
  }
}

// The crack starts at the free edge of one part and runs into the other: the first part is cut, and the second one
// connects its pieces.
TEST(MixedCracks, begin_at_free_edges) {
  const Outline crack{{0, 32.5}, {46, 32.5}};
  const Answer elements = Plate{}(all_elements, crack);
  for (const bool lattice : {false, true}) {
    const Answer mixed = Plate{}({{lattice, 0, 34}, {!lattice, 34, width}}, crack);
    ASSERT_EQ(mixed.tips.size(), 1u);
    report("K_I", mixed.tips[0].stress_intensity_1, elements.tips[0].stress_intensity_1, "boundary elements");
    EXPECT_LT(difference(mixed.tips[0], elements.tips[0]), 2e-3);
    EXPECT_NEAR(mixed.energy / elements.energy, 1, 3e-3);
  }
}

std::vector<double> openings(Model& model, const std::vector<double>& fractions) {
  std::vector<double> normal(fractions.size()), along(fractions.size());
  model.check(bempd_crack_opening(model.get(), 1, static_cast<int64_t>(fractions.size()), fractions.data(),
                                  normal.data(), along.data()));
  return normal;
}

// Elements of the crack meet the rows of the lattice at its mouth.
TEST(MixedCracks, open_as_far_as_among_elements_alone) {
  const Outline crack{{24, 32.5}, {56, 32.5}};
  Model alone, mixed;
  Plate{}.describe(alone, all_elements, crack);
  Plate{}.describe(mixed, both, crack);
  alone.step(1), mixed.step(1);
  const std::vector<double> fractions{0.05, 0.2, 0.35, 0.45, 0.49};
  const std::vector<double> expected = openings(alone, fractions), found = openings(mixed, fractions);
  for (std::size_t k = 0; k < fractions.size(); ++k) {
    report("opening", found[k], expected[k], "boundary elements");
    EXPECT_NEAR(found[k] / expected[k], 1, 3e-3);
  }
}

// A pressure acts on both parts: the resultant of a cut through the whole body is the pressure times its length.
TEST(MixedCracks, are_pressed_open_on_both_sides) {
  const double pressure = 0.01;
  Plate plate;
  plate.pull = 0, plate.pressure = pressure;
  const Outline crack{{24, 32.5}, {56, 32.5}};
  const Answer elements = plate(all_elements, crack), mixed = plate(both, crack);
  for (int k = 0; k < 2; ++k) {
    report("K_I", mixed.tips[k].stress_intensity_1, elements.tips[k].stress_intensity_1, "elements alone");
    EXPECT_LT(difference(mixed.tips[k], elements.tips[k]), 0.01);
  }
  for (const double rise : {0.0, 7.0}) {
    Model model;
    const int32_t id = model.add(material(1, 1.0 / 3));
    const int32_t left = model.bem(id, rectangle(0, 0, middle, height), 4);
    const int32_t right = model.pd(id, rectangle(middle, 0, width, height), 1, 4);
    const int32_t held[] = {model.fix(left, 1, BEMPD_BOTH), model.fix(right, 1, BEMPD_BOTH)};
    model.fix(left, 3, BEMPD_BOTH), model.fix(right, 3, BEMPD_BOTH);
    model.crack({{0, 32.2 - rise / 2}, {width, 32.2 + rise / 2}});
    int32_t load = 0;
    model.check(bempd_add_crack_pressure(model.get(), 1, 0, pressure, &load));
    model.step(1);
    Vector sum{0, 0};
    for (const int32_t support : held)
      for (int c = 0; c < 2; ++c) sum[c] += model.reaction(support)[c];
    report("force on the lower half", sum[1], pressure * width, "pressure times length");
    EXPECT_NEAR(sum[1], pressure * width, 1e-3 * pressure * width);
    EXPECT_NEAR(sum[0], -pressure * rise, 5e-3 * pressure * width);
  }
}

TEST(MixedCracks, with_elements_of_the_hosts_choice_on_the_interface) {
  const Outline crack = inclined(20, 16, {middle, 32.2});
  const Answer elements = Plate{}(all_elements, crack);
  for (const double length : {1.0, 2.0, 4.0}) {
    Model model;
    Plate{}.describe(model, both, crack);
    model.mesh(1, 2, length, 1);
    const Answer mixed = Plate::ask(model);
    ASSERT_EQ(mixed.tips.size(), 2u);
    const double one = difference(mixed.tips[0], elements.tips[0]), other = difference(mixed.tips[1], elements.tips[1]);
    std::printf("elements of %.0f spacings: tip of elements off by %.4f, of bonds %.4f\n", length, one, other);
    EXPECT_LT(one, 0.02);
    EXPECT_LT(other, 0.02);
  }
}

TEST(MixedCracks, are_bent_to_between_two_rows_and_say_so) {
  std::vector<std::string> log;
  Plate plate;
  plate.log = &log;
  const auto told = [&](const char* words) {
    return std::any_of(log.begin(), log.end(), [&](const auto& line) { return line.find(words) != std::string::npos; });
  };
  plate(both, {{24, 32.5}, {56, 32.5}});
  EXPECT_FALSE(told("bent"));
  plate(both, {{24, 32.3}, {56, 32.3}});
  EXPECT_TRUE(told("crosses the interface of the regions 1 and 2 at (40, 32.3), 0.2 spacings beside the middle"));
}

TEST(MixedCracks, do_not_share_a_gap_between_two_points) {
  Model model;
  Plate{}.describe(model, both, {{24, 32.5}, {56, 32.5}});
  model.crack({{24, 36.8}, {56, 28.2}});
  try {
    model.prepare();
    FAIL() << "two cracks cross the interface at one place";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("between the same two material points"), std::string::npos)
        << error.what();
  }
}

TEST(MixedCracks, are_there_again_in_a_restored_state) {
  Model model;
  Plate{}.describe(model, both, {{24, 30.2}, {56, 35.1}});
  model.step(0.5);
  const SavedState state = model.save();
  const Answer first = Plate::ask(model);
  model.restore(state);
  EXPECT_EQ(model.load_factor(), 0.5);
  const Answer again = Plate::ask(model);
  for (int k = 0; k < 2; ++k) EXPECT_EQ(first.tips[k].stress_intensity_1, again.tips[k].stress_intensity_1);
  EXPECT_EQ(first.energy, again.energy);
}

// The crack goes on at the mouth, so that stress is bounded there; at both tips in elements it is not.
TEST(MixedCracks, have_no_singularity_at_the_mouth) {
  Model model;
  Plate{}.describe(model, both, {{24, 32.5}, {56, 32.5}});
  int64_t count = 0;
  model.check(bempd_singularity_count(model.get(), &count));
  bool at_tip = false;
  for (int64_t k = 0; k < count; ++k) {
    bempd_singularity place;
    bempd_singularity_init(&place, sizeof place);
    model.check(bempd_get_singularity(model.get(), k, &place));
    EXPECT_GT(std::hypot(place.x - middle, place.y - 32.5), 1);
    at_tip = at_tip || std::hypot(place.x - 24, place.y - 32.5) < 1e-6;
  }
  EXPECT_TRUE(at_tip);
}

}  // namespace
}  // namespace mixed_cracks_test
