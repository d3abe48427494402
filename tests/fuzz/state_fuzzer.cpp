// Saved states that follow from bytes, with their checksum repaired: they are refused, or the model goes on from them.
#include <bempd.h>

#include <array>
#include <cstdint>
#include <vector>

#include "checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fuzz {

namespace {

// A torn block: a piece that an initial crack cut off is held by springs, the other one has lost bonds.
bempd_model* torn_block() {
  bempd_model* model = nullptr;
  bempd_material material;
  good("bempd_model_create", nullptr, bempd_model_create(&model));
  good("bempd_material_init", nullptr, bempd_material_init(&material, sizeof material));
  material.young_modulus = 1000, material.poisson_ratio = 1 / 3.0, material.critical_stretch = 1e-3;
  const std::array vertices = {0.0, 0.0, 5.0, 0.0, 5.0, 4.0, 0.0, 4.0};
  const std::array cut = {3.5, 0.0, 3.5, 4.0}, notch = {1.5, 0.0, 1.5, 1.5};
  const double pull = 1;
  const bool built = FUZZ_CALL(bempd_set_option, model, "threads", 1.0) &&
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

void check(std::vector<std::uint8_t> bytes) {
  static bempd_model* const model = torn_block();
  static bempd_state* first = nullptr;
  if (first == nullptr) require_true(FUZZ_CALL(bempd_state_save, model, &first), "bempd_state_save", "fails");
  repair_checksum(bytes);
  bempd_state* state = nullptr;
  const auto size = static_cast<std::int64_t>(bytes.size());
  if (!good("bempd_state_from_bytes", nullptr, bempd_state_from_bytes(size, bytes.data(), &state))) return;
  if (FUZZ_CALL(bempd_state_restore, model, state)) {
    read_all(model);
    advance(model);
    read_all(model);
  }
  bempd_state_free(state);
  require_true(FUZZ_CALL(bempd_state_restore, model, first), "bempd_state_restore", "the model's own state is refused");
}

}  // namespace

}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::check(std::vector<std::uint8_t>(data, data + size));
  return 0;
}
