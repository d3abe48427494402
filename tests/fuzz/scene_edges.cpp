// Edges as hosts that couple see them, loads that follow cracks and places, callbacks, options, and states in files.
#include <unistd.h>

#include <array>
#include <filesystem>
#include <string>

#include "checks.hpp"
#include "scene.hpp"

namespace fuzz {

namespace {

// Calls until a callback asks to stop; never where it is negative.
std::int32_t count_down(void* user) {
  auto* left = static_cast<std::int32_t*>(user);
  if (*left < 0) return 0;
  return (*left)-- == 0 ? 1 : 0;
}

std::int32_t hear_progress(double load_factor, std::int64_t events, std::int64_t broken, void* user) {
  require_finite("bempd_progress_function", &load_factor, 1);
  require_true(events >= 0 && broken >= 0, "bempd_progress_function", "a negative count");
  return count_down(user);
}

std::int32_t hear_phase(const char* phase, double share, double seconds, double expected, void* user) {
  const std::array numbers = {share, seconds, expected};
  require_finite("bempd_phase_function", numbers.data(), numbers.size());
  require_true(phase[0] != '\0' && share >= 0 && share <= 1, "bempd_phase_function", "no phase, or a share of none");
  return count_down(user);
}

void hear_log(std::int32_t level, const char* message, void*) {
  require_true(level >= 1 && level <= 3 && message[0] != '\0', "bempd_log_function", "no line of a log");
}

std::int32_t heat_linearly(double x, double, double* constant, double* proportional, void* user) {
  *constant = 0, *proportional = x * *static_cast<double*>(user);
  return 0;
}

}  // namespace

void Scene::add_other_load() {
  static double slope = 0;
  const std::int32_t of = region();
  const double constant = bytes_.number(), proportional = bytes_.number();
  const Place at = place();
  bool added = false;
  switch (bytes_.pick(4)) {
    case 0:
      added = FUZZ_CALL(bempd_add_rotation, model_, of, at.x, at.y, constant, proportional, nullptr);
      break;
    case 1:
      added = FUZZ_CALL(bempd_add_crack_pressure, model_, 1 + bytes_.pick(3), constant, proportional, nullptr);
      break;
    case 2:
      slope = proportional;
      added = FUZZ_CALL(bempd_add_temperature_function, model_, of, heat_linearly, &slope, nullptr);
      break;
    default:
      added = FUZZ_CALL(bempd_add_edge_forces, model_, of, edge(), 0.0, 1.0, nullptr);
  }
  if (!added) return;
  ++loads_;
  load_values_.push_back(1);
}

// Values by the struct that has them of any kind.
void Scene::give_edge_values() {
  bempd_edge_values values;
  good("bempd_edge_values_init", nullptr, bempd_edge_values_init(&values, sizeof values));
  const std::array fractions = {0.0, 0.5, 1.0};
  const std::array numbers = {bytes_.mostly(1e-3), 1e-3, 0.0, 1e-3, bytes_.mostly(2e-3), 0.0};
  values.kind = bytes_.pick(7), values.components = 1 + bytes_.pick(2), values.count = 3;
  values.fractions = fractions.data(), values.constant = bytes_.pick(2) == 0 ? nullptr : numbers.data();
  values.proportional = numbers.data();
  if (values.kind == BEMPD_FUNCTION) values.kind = BEMPD_TABLE;
  const int component = 1 + bytes_.pick(3);
  switch (bytes_.pick(4)) {
    case 0:
      if (FUZZ_CALL(bempd_prescribe_edge_values, model_, region(), edge(), 0.0, 1.0, component, &values, nullptr))
        ++supports_, support_values_.push_back(3);
      break;
    case 1:
      if (FUZZ_CALL(bempd_add_traction_values, model_, region(), edge(), 0.0, 1.0, component, &values, nullptr))
        ++loads_, load_values_.push_back(3);
      break;
    case 2:
      FUZZ_CALL(bempd_set_support_edge_values, model_, 1 + bytes_.pick(4), &values);
      break;
    default:
      FUZZ_CALL(bempd_set_load_edge_values, model_, 1 + bytes_.pick(4), &values);
  }
}

// Names of what is there and what is not.
void Scene::name_things(std::int32_t of, std::int32_t number) {
  std::int32_t found = 0;
  FUZZ_CALL(bempd_name_region, model_, of, "region 1");
  FUZZ_CALL(bempd_name_support, model_, number, "support \"1\"");
  FUZZ_CALL(bempd_name_load, model_, number, "");
  if (FUZZ_CALL(bempd_name_edge, model_, of, number, "edge 2") &&
      FUZZ_CALL(bempd_edge_named, model_, of, "edge 2", &found))
    require_true(found == number, "bempd_edge_named", "another edge");
}

void Scene::read_edge() {
  const std::int32_t of = region(), number = edge();
  std::int32_t edges = 0;
  std::int64_t nodes = 0, elements = 0;
  if (FUZZ_CALL(bempd_edge_count, model_, of, &edges))
    require_true(edges >= 3 || edges == 1, "bempd_edge_count", "no outline");
  name_things(of, number);
  const Place at = place();
  const std::array point = {at.x, at.y};
  std::array<double, 2> answer;
  if (FUZZ_CALL(bempd_fractions_on_edge, model_, of, number, 1, point.data(), &answer[0], &answer[1]))
    require_true(answer[0] >= 0 && answer[0] <= 1 && answer[1] >= 0, "bempd_fractions_on_edge", "no fraction");
  if (!FUZZ_CALL(bempd_edge_size, model_, of, number, &nodes, &elements)) return;
  const auto size = static_cast<std::size_t>(nodes);
  std::vector<std::int32_t> ids(size), sides(static_cast<std::size_t>(elements));
  std::vector<double> fractions(size), weights(size), forces(2 * size);
  if (FUZZ_CALL(bempd_copy_edge_nodes, model_, of, number, nodes, ids.data(), fractions.data(), weights.data())) {
    require_finite("bempd_copy_edge_nodes", fractions.data(), size);
    require_finite("bempd_copy_edge_nodes", weights.data(), size);
  }
  FUZZ_CALL(bempd_copy_edge_elements, model_, of, number, elements, sides.data());
  if (FUZZ_CALL(bempd_copy_edge_forces, model_, of, number, nodes, forces.data()))
    require_finite("bempd_copy_edge_forces", forces.data(), forces.size());
}

void Scene::read_bounds() {
  double moment = 0, lowest = 0, highest = 0;
  std::int64_t generation = 0, again = 0;
  const Place at = place();
  if (FUZZ_CALL(bempd_reaction_moment, model_, 1 + bytes_.pick(3), at.x, at.y, &moment))
    require_finite("bempd_reaction_moment", &moment, 1);
  if (FUZZ_CALL(bempd_admissible_load_factors, model_, &lowest, &highest)) {
    require_finite("bempd_admissible_load_factors", &lowest, 1);
    require_finite("bempd_admissible_load_factors", &highest, 1);
  }
  bempd_explanation next;
  good("bempd_explanation_init", nullptr, bempd_explanation_init(&next, sizeof next));
  std::array<char, 64> words{};
  std::int64_t needed = 0;
  FUZZ_CALL(bempd_explain, model_, bytes_.pick(3), &next, words.data(), static_cast<std::int64_t>(words.size()),
            &needed);
  const bool known = FUZZ_CALL(bempd_generation, model_, &generation) && FUZZ_CALL(bempd_generation, model_, &again);
  require_true(known && generation == again, "bempd_generation", "asking for it changes it");
  bempd_history_entry line;
  good("bempd_history_entry_init", nullptr, bempd_history_entry_init(&line, sizeof line));
  FUZZ_CALL(bempd_history, model_, 0, &line);
}

void Scene::change_values_along() {
  const bool of_support = bytes_.pick(2) == 0, of_nodes = bytes_.pick(2) == 0;
  const std::int32_t id = 1 + bytes_.pick(1 + (of_support ? supports_ : loads_));
  std::int64_t count = 1 + bytes_.pick(3), elements = 0;
  if (of_nodes && bytes_.pick(4) != 3) FUZZ_CALL(bempd_edge_size, model_, region(), edge(), &count, &elements);
  const auto size = static_cast<std::size_t>(count);
  std::vector<double> fractions(size), constant(2 * size), proportional(2 * size);
  for (std::size_t k = 0; k < size; ++k) fractions[k] = bytes_.mostly(static_cast<double>(k + 1) / (size + 1.0));
  constant[0] = bytes_.number(), proportional[0] = bytes_.number();
  const Marks before = marks();
  if (of_nodes && of_support)
    FUZZ_CALL(bempd_set_support_nodal_values, model_, id, count, constant.data(), proportional.data());
  if (of_nodes && !of_support)
    FUZZ_CALL(bempd_set_load_nodal_values, model_, id, count, constant.data(), proportional.data());
  if (!of_nodes && of_support)
    FUZZ_CALL(bempd_set_support_values_at, model_, id, count, fractions.data(), constant.data(), proportional.data());
  if (!of_nodes && !of_support)
    FUZZ_CALL(bempd_set_load_values_at, model_, id, count, fractions.data(), constant.data(), proportional.data());
  require_true(before.load_factor == marks().load_factor, "set values along", "the load factor moved");
}

void Scene::listen() {
  static std::array<std::int32_t, 2> left;
  left = {bytes_.pick(4) == 0 ? bytes_.pick(5) : -1, bytes_.pick(4) == 0 ? bytes_.pick(5) : -1};
  FUZZ_CALL(bempd_set_progress, model_, bytes_.pick(4) == 0 ? nullptr : hear_progress, &left[0]);
  FUZZ_CALL(bempd_set_phase_progress, model_, bytes_.pick(4) == 0 ? nullptr : hear_phase, &left[1]);
  FUZZ_CALL(bempd_set_log, model_, bytes_.pick(4) == 0 ? nullptr : hear_log, nullptr);
}

void Scene::read_options() {
  std::int64_t count = 0, needed = 0;
  require_true(bempd_option_count(&count) == BEMPD_OK && count > 0, "bempd_option_count", "no options");
  require_true(bempd_version_string()[0] != '\0' && bempd_build_info()[0] != '\0', "bempd_build_info", "nothing");
  bempd_option_info info;
  good("bempd_option_info_init", nullptr, bempd_option_info_init(&info, sizeof info));
  const std::int64_t index = bytes_.byte() < 250 ? bytes_.byte() % count : count;
  if (!good("bempd_option_describe", nullptr, bempd_option_describe(index, &info))) return;
  std::array<char, 64> text;
  if (!FUZZ_CALL(bempd_get_option_text, model_, info.name, nullptr, 0, &needed)) return;
  require_true(needed >= 1, "bempd_get_option_text", "no room for its zero");
  FUZZ_CALL(bempd_get_option_text, model_, info.name, text.data(), bytes_.pick(static_cast<int>(text.size())), &needed);
}

void Scene::keep_file() {
  static const std::string path =
      (std::filesystem::temp_directory_path() / ("bempd_fuzz_" + std::to_string(getpid()) + ".state")).string();
  bempd_state* state = nullptr;
  if (!FUZZ_CALL(bempd_state_save_with, model_, bytes_.byte() < 250 ? 1 + bytes_.pick(2) : 3, &state)) return;
  const bool written = good("bempd_state_write", nullptr, bempd_state_write(state, path.c_str()));
  bempd_state_free(state);
  bempd_state* read = nullptr;
  if (!written || !good("bempd_state_read", nullptr, bempd_state_read(path.c_str(), &read))) return;
  const Marks before = marks();
  if (!FUZZ_CALL(bempd_state_restore, model_, read)) require_same("bempd_state_restore", before, marks());
  require_true(before.load_factor == marks().load_factor && before.lines == marks().lines, "bempd_state_restore",
               "the present state is another one");
  bempd_state_free(read);
  std::filesystem::remove(path);
}

}  // namespace fuzz
