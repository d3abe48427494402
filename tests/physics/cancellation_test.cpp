// A request to stop is heard in the midst of long work, and leaves the model as it was.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <claims.hpp>
#include <ctime>
#include <thread>
#include <vector>

#include "host.hpp"

namespace cancellation_test {
namespace {

// Processor time of this process, so that other programs on the machine do not count.
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

constexpr double asked_after = 0.1;

class Cancellation : public testing::Test {
 protected:
  Cancellation() { renew(); }
  ~Cancellation() override { bempd_model_free(model); }

  void renew() {
    bempd_model_free(model);
    bempd_model_create(&model);
    const bempd_material steel = host::material(1000, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 1e-3);
    bempd_add_material(model, &steel, &material);
    bempd_set_option(model, "threads", 1);
  }

  template <class Call>
  void expect_heard(const Call& call) {
    EXPECT_EQ(status_when_asked_to_stop(call, asked_after), BEMPD_ERROR_CANCELLED) << bempd_last_error(model);
  }

  // Runs the call and asks it to stop after a while of processor time.
  template <class Call>
  bempd_status status_when_asked_to_stop(const Call& call, double after) {
    const double start = processor_time();
    std::atomic<bool> returned{false};
    std::atomic<double> asked{0};
    std::thread other([&] {
      while (!returned && processor_time() - start < after) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      asked = processor_time();
      while (!returned) {  // a request that comes before the call is forgotten
        bempd_request_cancel(model);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    });
    const bempd_status status = call();
    const double end = processor_time();
    returned = true;
    other.join();
    std::printf("heard after %.3f s of processor time\n", end - asked);
    EXPECT_LE(end - asked, claims::cancellation) << "asked after " << asked - start << " s";
    return status;
  }

  // Asks to cancel at many moments in the course of a call. A first run takes longer than later ones, by what it loads
  // and by pages it touches first. So a request that came after the end of its call is made anew, by the time that the
  // call took.
  template <class Call>
  void expect_heard_throughout(const Call& call) {
    double whole = 0;
    const auto run = [&](double part) {
      const double start = processor_time();
      const bempd_status status = part > 0 ? status_when_asked_to_stop(call, part * whole) : call();
      if (status == BEMPD_OK) whole = processor_time() - start;
      return status;
    };
    ASSERT_EQ(run(0), BEMPD_OK) << bempd_last_error(model);
    for (const double part : {0.25, 0.45, 0.65}) {
      bempd_status status = BEMPD_OK;
      for (int attempt = 0; status == BEMPD_OK && attempt < 10; ++attempt) {
        renew();
        status = run(part);
      }
      EXPECT_EQ(status, BEMPD_ERROR_CANCELLED) << "asked after " << part << " of " << whole << " s";
    }
  }

  int32_t add_boundary(double width, double element_length) {
    const double vertices[] = {0, 0, width, 0, width, 1, 0, 1};
    int32_t region = 0;
    EXPECT_EQ(bempd_add_bem_region(model, material, 4, vertices, element_length, &region), BEMPD_OK);
    return region;
  }

  void expect_usable(int32_t region) {
    int32_t held = 0;
    double force[2] = {0, 0};
    const double pull = 2;
    ASSERT_EQ(bempd_fix_edge(model, region, 4, BEMPD_BOTH, &held), BEMPD_OK) << bempd_last_error(model);
    ASSERT_EQ(bempd_add_traction(model, region, 2, 0, 1, BEMPD_X, 1, nullptr, &pull, nullptr), BEMPD_OK);
    ASSERT_EQ(bempd_step(model, 1e-4, nullptr), BEMPD_OK) << bempd_last_error(model);
    ASSERT_EQ(bempd_reaction(model, held, force), BEMPD_OK);
    EXPECT_NEAR(force[0], -2e-4, 1e-12);
  }

  bempd_model* model = nullptr;
  int32_t material = 0;
};

TEST_F(Cancellation, is_heard_while_boundary_operators_are_built) {
  const int32_t large = add_boundary(4, 10.0 / 4000);
  expect_heard([&] { return bempd_prepare(model); });
  ASSERT_EQ(bempd_remove_region(model, large), BEMPD_OK) << bempd_last_error(model);
  expect_usable(add_boundary(4, 0.5));
}

TEST_F(Cancellation, is_heard_while_lattices_are_built) {
  const double vertices[] = {0, 0, 600, 0, 600, 600, 0, 600};
  int32_t large = 0;
  ASSERT_EQ(bempd_add_pd_region(model, material, 4, vertices, 1, 8, &large), BEMPD_OK);
  expect_heard([&] { return bempd_prepare(model); });
  ASSERT_EQ(bempd_remove_region(model, large), BEMPD_OK) << bempd_last_error(model);
  expect_usable(add_boundary(4, 0.5));
}

// Dense matrices of 2800 x 2800.
TEST_F(Cancellation, is_heard_throughout_a_step_of_a_large_boundary) {
  expect_heard_throughout([&] {
    const int32_t region = add_boundary(4, 10.0 / 700);
    bempd_fix_edge(model, region, 4, BEMPD_BOTH, nullptr);
    return bempd_step(model, 1e-4, nullptr);
  });
}

// A sparse matrix of 40,000 unknowns.
TEST_F(Cancellation, is_heard_throughout_a_step_of_a_large_lattice) {
  expect_heard_throughout([&] {
    const double vertices[] = {0, 0, 140, 0, 140, 140, 0, 140}, pull = 1;
    int32_t region = 0;
    bempd_add_pd_region(model, material, 4, vertices, 1, 4, &region);
    bempd_fix_edge(model, region, 4, BEMPD_BOTH, nullptr);
    bempd_prescribe_edge(model, region, 2, 0, 1, BEMPD_X, 1, nullptr, &pull, nullptr);
    return bempd_step(model, 1e-4, nullptr);
  });
}

// Cracks that grow as lines: steps that are computed ahead in windows, and bonds that are looked at in each of them.
TEST_F(Cancellation, is_heard_throughout_a_run_of_lines) {
  expect_heard_throughout([&] {
    const double vertices[] = {0, 0, 70, 0, 70, 70, 0, 70}, crack[] = {28, 35.5, 42, 35.5}, pull = 1;
    int32_t region = 0;
    bempd_set_option_text(model, "crack.rule", "line");
    bempd_add_pd_region(model, material, 4, vertices, 1, 4, &region);
    bempd_add_crack(model, 2, crack, nullptr);
    bempd_fix_edge(model, region, 1, BEMPD_BOTH, nullptr);
    bempd_prescribe_edge(model, region, 3, 0, 1, BEMPD_Y, 1, nullptr, &pull, nullptr);
    return bempd_run_to_separation(model, 1000, nullptr);
  });
}

TEST_F(Cancellation, is_heard_while_values_inside_are_computed) {
  expect_usable(add_boundary(4, 0.05));
  const std::vector<double> places(1000000, 0.4);
  std::vector<double> stress(1500000);
  expect_heard([&] { return bempd_evaluate(model, 500000, places.data(), nullptr, stress.data(), nullptr); });
  EXPECT_EQ(bempd_evaluate(model, 1, places.data(), nullptr, stress.data(), nullptr), BEMPD_OK);
}

class CancellationOfRuns : public Cancellation, public testing::WithParamInterface<const char*> {};

// Requests that come again and again while events are computed ahead.
TEST_P(CancellationOfRuns, takes_nothing_away) {
  const double vertices[] = {0, 0, 40, 0, 40, 24, 0, 24}, crack[] = {20.5, 0, 20.5, 8.5}, pull = 1;
  bempd_model* undisturbed = nullptr;
  bempd_model_create(&undisturbed);
  bempd_step_report reports[2];
  for (bempd_model* each : {undisturbed, model}) {
    const bempd_material steel = host::material(1000, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 1e-3);
    int32_t id = material, region = 0;
    if (each == undisturbed) bempd_add_material(each, &steel, &id);
    ASSERT_EQ(bempd_set_option_text(each, "crack.rule", GetParam()), BEMPD_OK);
    ASSERT_EQ(bempd_add_pd_region(each, id, 4, vertices, 1, 3, &region), BEMPD_OK);
    bempd_add_crack(each, 2, crack, nullptr);
    bempd_fix_edge(each, region, 4, BEMPD_BOTH, nullptr);
    bempd_prescribe_edge(each, region, 2, 0, 1, BEMPD_X, 1, nullptr, &pull, nullptr);
    bempd_step_report& report = reports[each == model];
    bempd_step_report_init(&report, sizeof report);
    int cancelled = 0;
    for (int milliseconds = 1; each == model && milliseconds < 40; milliseconds += 3) {
      // A request that comes before the call is forgotten, so they go on until it returns. The call waits for the
      // thread that makes them, which a busy machine may start late.
      std::atomic<bool> asks{false}, returned{false};
      std::thread other([&] {
        asks = true;
        do {
          std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
          bempd_request_cancel(each);
        } while (!returned);
      });
      while (!asks) std::this_thread::yield();
      const bempd_status status = bempd_step_to_next_event(each, 10, nullptr);
      returned = true;
      other.join();
      if (status == BEMPD_OK) break;
      ASSERT_EQ(status, BEMPD_ERROR_CANCELLED) << bempd_last_error(each);
      ++cancelled;
    }
    EXPECT_EQ(cancelled > 0, each == model);
    ASSERT_EQ(bempd_run_to_separation(each, 10, &report), BEMPD_OK) << bempd_last_error(each);
  }
  EXPECT_EQ(reports[0].total_broken_bonds, reports[1].total_broken_bonds);
  EXPECT_NEAR(reports[0].load_factor, reports[1].load_factor, 1e-12 * reports[0].load_factor);
  EXPECT_NEAR(reports[0].work, reports[1].work, 1e-10 * reports[0].work);
  bempd_model_free(undisturbed);
}

INSTANTIATE_TEST_SUITE_P(Rules, CancellationOfRuns, testing::Values("bond", "line"));

}  // namespace
}  // namespace cancellation_test
