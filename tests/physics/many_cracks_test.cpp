// Plates that random initial cracks cut into parts: parts on hinges and pieces cut off are held and told, and the run
// goes on in balance (bempd.h: 1e-6 of forces and work).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <span>

#include "host.hpp"
#include "thorough.hpp"

namespace many_cracks_test {
namespace {

using namespace host;

struct Torn {
  int64_t events = 0;
  double residual = 0, balance = 0;
};

Torn tear(unsigned seed, int cracks) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) { return low + (high - low) * random() / 4294967296.0; };
  Model model;
  const int32_t plate =
      model.pd(model.add(material(1, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 1e-3)), rectangle(0, 0, 40, 30), 1, 3);
  for (int k = 0; k < cracks; ++k) {
    const double x = between(2, 38), y = between(2, 28), angle = between(0, 6.283), length = between(2, 8);
    const auto inside = [](double value, double end) { return std::min(std::max(value, 1.03), end - 1.03); };
    model.crack({{x, y}, {inside(x + length * std::cos(angle), 40), inside(y + length * std::sin(angle), 30)}});
  }
  model.fix(plate, 4, BEMPD_BOTH);
  model.prescribe(plate, 2, BEMPD_X, 0, 1e-2);
  Torn run;
  for (int k = 0; k < 6; ++k) {
    const bempd_step_report report = model.next_event(1e9);
    run.residual = std::max(run.residual, report.residual);
    run.balance = std::max(run.balance, report.energy_balance_error);
    if (report.stop_reason != BEMPD_STOP_EVENT) break;
    ++run.events;
  }
  return run;
}

TEST(ManyCracks, leave_parts_on_hinges_that_are_held) {
  constexpr std::array counts{40, 60, 100};
  for (const int cracks : std::span(counts).first(static_cast<std::size_t>(bempd_tests::cases(1, 3)))) {
    for (unsigned seed = 1; seed <= static_cast<unsigned>(bempd_tests::cases(1, 3)); ++seed) {
      const Torn run = tear(seed, cracks);
      std::printf("%d cracks, seed %u: %lld events, residual %.1e, balance %.1e\n", cracks, seed,
                  static_cast<long long>(run.events), run.residual, run.balance);
      EXPECT_LE(run.residual, 1e-8);
      EXPECT_LE(run.balance, 1e-8);
    }
  }
}

}  // namespace
}  // namespace many_cracks_test
