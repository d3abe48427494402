// Cracks that lie across an interface of boundary elements and a lattice: stress intensity factors of both tips, openings
// and energies beside those of the same crack among elements alone, which closed forms vouch for (crack_factors_test),
// and in a lattice alone.
#include <gtest/gtest.h>

#include <algorithm>

#include "host.hpp"

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
  std::vector<double> openings;  // normal ones at tenths of the length
};

struct Plate {
  double poisson = 1.0 / 3, slant = 0;  // half the way that the border in `both` goes sideways
  double pull = 1, pressure = 0;
  std::vector<std::string>* log = nullptr;

  static void hear(int32_t level, const char* message, void* user) {
    if (level <= 1) static_cast<std::vector<std::string>*>(user)->emplace_back(message);
  }

  void describe(Model& model, const std::vector<Strip>& strips, const Outline& crack) const {
    model.set_text("pd.crack_tip", "stated");
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
    Answer answer{{}, model.step(1).stored_energy, {}};
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
  for (const double slant : {0.0, 5.0}) {
    for (const double degrees : {0.0, 20.0, 45.0, 63.0}) {
      for (const double y : {32.0, 32.2, 32.5}) {
        const Outline crack = inclined(degrees, 16, {middle, y});
        const Answer elements = Plate{}(all_elements, crack), mixed = Plate{1.0 / 3, slant}(both, crack);
        ASSERT_EQ(mixed.tips.size(), 2u);
        EXPECT_EQ(mixed.tips[0].method, BEMPD_TIP_ELEMENTS);
        EXPECT_EQ(mixed.tips[1].method, BEMPD_TIP_CONTOURS);
        const double one = difference(mixed.tips[0], elements.tips[0]);
        const double other = difference(mixed.tips[1], elements.tips[1]);
        std::printf("%2.0f degrees, border %+.0f, height %.1f: tip of elements %.4f, of bonds %.4f, energy %+.4f\n", degrees,
                    slant, y, one, other, mixed.energy / elements.energy - 1);
        EXPECT_LT(one, 0.02);
        EXPECT_LT(other, 0.02);
        EXPECT_LT(std::abs(mixed.energy / elements.energy - 1), 0.01);
      }
    }
  }
}

}  // namespace
}  // namespace mixed_cracks_test
