#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "model/host_requests.hpp"
#include "phase.hpp"

using namespace bempd;

// Calls report to functions of the host.
namespace {

// Tells of a phase that is long enough for a line of the log.
void begin_long_phase() { const Phase phase("factorization", 1, 10); }

TEST(HostRequests, long_phases_write_no_line_while_the_log_is_exchanged_for_none) {
  model::HostRequests host;
  std::vector<std::string> lines;
  host.set_log([&](int, const std::string& line) { lines.push_back(line); });
  const ListeningScope scope(host.phase_listener());
  begin_long_phase();
  EXPECT_EQ(lines.size(), 1U);
  model::HostRequests::Listeners own = host.exchange({});
  begin_long_phase();
  EXPECT_EQ(lines.size(), 1U);
  host.exchange(std::move(own));
  begin_long_phase();
  EXPECT_EQ(lines.size(), 2U);
}

TEST(HostRequests, phases_can_still_be_cancelled_while_the_log_is_exchanged_for_none) {
  model::HostRequests host;
  host.set_phase_progress([](const char*, double, double, double) { return false; });
  const ListeningScope scope(host.phase_listener());
  host.exchange({});
  EXPECT_THROW(begin_long_phase(), Error);
}

}  // namespace
