// Saved states with edits that follow from bytes, their checksum repaired: they are refused, or the model goes on from
// them. The first byte chooses a state of one of two runs, bond by bond and as a line; then each edit is 11 bytes: what
// to do, where, and a number. Inputs stay of use when the format of states changes.
#include <bempd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fuzz {

namespace {

// A torn block: a piece that an initial crack cut off is held by springs, the other one has lost bonds.
bempd_model* torn_block(const char* crack_rule) {
  bempd_model* model = nullptr;
  bempd_material material;
  good("bempd_model_create", nullptr, bempd_model_create(&model));
  good("bempd_material_init", nullptr, bempd_material_init(&material, sizeof material));
  material.young_modulus = 1000, material.poisson_ratio = 1 / 3.0, material.critical_stretch = 1e-3;
  const std::array vertices = {0.0, 0.0, 5.0, 0.0, 5.0, 4.0, 0.0, 4.0};
  const std::array cut = {3.5, 0.0, 3.5, 4.0}, notch = {1.5, 0.0, 1.5, 1.5};
  const double pull = 1;
  const bool built = FUZZ_CALL(bempd_set_option, model, "threads", 1.0) &&
                     FUZZ_CALL(bempd_set_option_text, model, "crack.rule", crack_rule) &&
                     FUZZ_CALL(bempd_set_option, model, "stepping.max_events", 100.0) &&
                     FUZZ_CALL(bempd_add_material, model, &material, nullptr) &&
                     FUZZ_CALL(bempd_add_pd_region, model, 1, 4, vertices.data(), 1, 2, nullptr) &&
                     FUZZ_CALL(bempd_add_crack, model, 2, cut.data(), nullptr) &&
                     FUZZ_CALL(bempd_add_crack, model, 2, notch.data(), nullptr) &&
                     FUZZ_CALL(bempd_fix_edge, model, 1, 4, BEMPD_BOTH, nullptr) &&
                     FUZZ_CALL(bempd_prescribe_edge, model, 1, 1, 0.4, 0.6, BEMPD_X, 1, nullptr, &pull, nullptr) &&
                     FUZZ_CALL(bempd_step_to_next_event, model, 100, nullptr);
  require_true(built, "torn_block", "the fixed scene fails");
  return model;
}

// FNV-1a, 64 bits, over all but the last eight bytes.
void repair_checksum(std::vector<std::uint8_t>& bytes) {
  if (bytes.size() < 8) return;
  std::uint64_t sum = 14695981039346656037ULL;
  for (std::size_t k = 0; k + 8 < bytes.size(); ++k) sum = (sum ^ bytes[k]) * 1099511628211ULL;
  std::memcpy(bytes.data() + bytes.size() - 8, &sum, 8);
}

void read_all(bempd_model* model) {
  double load_factor = 0;
  if (FUZZ_CALL(bempd_load_factor, model, &load_factor)) require_finite("bempd_load_factor", &load_factor, 1);
  for (std::int32_t field = BEMPD_POSITION; field <= BEMPD_ELEMENT_STRESS; ++field) {
    std::int64_t count = 0;
    std::int32_t components = 0;
    if (!FUZZ_CALL(bempd_field_size, model, 1, field, &count, &components)) continue;
    std::vector<double> values(static_cast<std::size_t>(count * components));
    if (FUZZ_CALL(bempd_copy_field, model, 1, field, count * components, values.data()))
      require_finite("bempd_copy_field", values.data(), values.size());
  }
  for (std::int32_t support = 1; support <= 2; ++support) {
    std::array<double, 2> force;
    if (FUZZ_CALL(bempd_reaction, model, support, force.data())) require_finite("bempd_reaction", force.data(), 2);
  }
}

void advance(bempd_model* model) {
  bempd_step_report r;
  good("bempd_step_report_init", nullptr, bempd_step_report_init(&r, sizeof r));
  if (!FUZZ_CALL(bempd_step_to_next_event, model, 100, &r)) return;
  // Energies of loads near the end of the range of numbers are beyond it; the log says so.
  const std::array numbers = {r.load_factor, r.residual};
  require_finite("bempd_step_to_next_event", numbers.data(), numbers.size());
}

using Bytes = std::vector<std::uint8_t>;

Bytes saved_bytes(bempd_model* model) {
  bempd_state* state = nullptr;
  std::int64_t size = 0;
  require_true(FUZZ_CALL(bempd_state_save, model, &state), "bempd_state_save", "fails");
  require_true(bempd_state_to_bytes(state, 0, nullptr, &size) == BEMPD_OK, "bempd_state_to_bytes", "fails");
  Bytes bytes(static_cast<std::size_t>(size));
  require_true(bempd_state_to_bytes(state, size, bytes.data(), nullptr) == BEMPD_OK, "bempd_state_to_bytes", "fails");
  bempd_state_free(state);
  return bytes;
}

// States after the first event, after the second, and when the body is torn.
std::array<Bytes, 3> states_of(bempd_model* model) {
  std::array<Bytes, 3> states;
  states[0] = saved_bytes(model);
  advance(model);
  states[1] = saved_bytes(model);
  require_true(FUZZ_CALL(bempd_run_to_separation, model, 1e6, nullptr), "bempd_run_to_separation", "fails");
  states[2] = saved_bytes(model);
  return states;
}

constexpr std::size_t edit_size = 11;

void edit(Bytes& bytes, const std::uint8_t* edit) {
  constexpr double largest = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();
  constexpr std::array special = {0.0,      -1.0,   1e300,   -largest,
                                  infinity, 1e-310, largest, std::numeric_limits<double>::quiet_NaN()};
  const std::size_t at = (edit[1] | static_cast<std::size_t>(edit[2]) << 8) % (bytes.size() + 1);
  const std::size_t room = bytes.size() - at;
  const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
  const auto put = [&](const void* value, std::size_t size) {
    std::memcpy(bytes.data() + at, value, std::min(size, room));
  };
  std::int64_t count = 0;
  switch (edit[0] % 7) {
    case 0:
      return put(edit + 3, 8);
    case 1:
      return put(edit + 3, 1);
    case 2:
      return put(&special[edit[3] % special.size()], 8);
    case 3:
      bytes.insert(place, edit + 3, edit + 3 + 8);
      return;
    case 4:
      bytes.erase(place, place + static_cast<std::ptrdiff_t>(std::min<std::size_t>(edit[3], room)));
      return;
    case 5:
      bytes.resize(at);
      return;
    default:  // a count that is off by a little
      if (room < 8) return;
      std::memcpy(&count, bytes.data() + at, 8);
      count += static_cast<std::int8_t>(edit[3]);
      return put(&count, 8);
  }
}

struct Torn {
  explicit Torn(const char* crack_rule) : model(torn_block(crack_rule)), states(states_of(model)) {}
  bempd_model* model;
  std::array<Bytes, 3> states;
};

void check(const std::uint8_t* data, std::size_t size) {
  static const std::array torn = {Torn("bond"), Torn("line")};
  if (size == 0) return;
  const Torn& from = torn[data[0] / 3 % torn.size()];
  bempd_model* const model = from.model;
  const Bytes& said = from.states[data[0] % from.states.size()];
  Bytes bytes = said;
  for (std::size_t at = 1; at + edit_size <= size; at += edit_size) edit(bytes, data + at);
  repair_checksum(bytes);
  const bool unchanged = bytes == said;
  bempd_state* state = nullptr;
  const bool is_read = good("bempd_state_from_bytes", nullptr,
                            bempd_state_from_bytes(static_cast<std::int64_t>(bytes.size()), bytes.data(), &state));
  if (is_read && FUZZ_CALL(bempd_state_restore, model, state)) {
    require_true(!unchanged || saved_bytes(model) == bytes, "bempd_state_save", "a restored state is another one");
    read_all(model);
    advance(model);
    read_all(model);
  } else {
    require_true(!unchanged, "bempd_state_restore", "the model's own state is refused");
  }
  bempd_state_free(state);
}

}  // namespace

}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::check(data, size);
  return 0;
}
