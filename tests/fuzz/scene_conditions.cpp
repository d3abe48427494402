// Supports and loads, and their values.
#include <array>

#include "checks.hpp"
#include "scene.hpp"

namespace fuzz {

namespace {

// Numbers that a callback hands to the library.
struct Given {
  double constant, proportional;
  std::int32_t answer;
};

std::int32_t give(double x, double y, double* constant, double* proportional, void* user) {
  const auto* given = static_cast<const Given*>(user);
  require_finite("bempd_boundary_function", &x, 1);
  require_finite("bempd_boundary_function", &y, 1);
  constant[0] = constant[1] = given->constant;
  proportional[0] = proportional[1] = given->proportional;
  return given->answer;
}

// Keeps what a function of the host returns as long as models live.
Given* keep(double constant, double proportional, std::int32_t answer) {
  static std::array<Given, 64> all;
  static std::size_t next = 0;
  Given& given = all[next++ % all.size()];
  given = {constant, proportional, answer};
  return &given;
}

struct Part {
  double from, to;
};
constexpr std::array parts = {Part{0, 1}, Part{0, 1}, Part{0.25, 0.5}, Part{0, 0.1}, Part{0.5, 0.5}, Part{0.7, 0.2}};

}  // namespace

void Scene::add_support() {
  const int way = bytes_.pick(5);
  const std::int32_t of = region(), number = edge(), along = component(way < 2 || way == 4 ? 3 : 2);
  const Place at = place_on_body();
  const Part part = bytes_.of(parts);
  const std::int64_t count = 1 + bytes_.pick(3);
  const std::array constant = {bytes_.number(), 0.0, 1e-3};
  const std::array proportional = {bytes_.number(), 1e-3, 0.0};
  bool added = false;
  if (way == 0) added = FUZZ_CALL(bempd_fix_edge, model_, of, number, along, nullptr);
  if (way == 1) added = FUZZ_CALL(bempd_fix_point, model_, at.x, at.y, along, nullptr);
  if (way == 2)
    added = FUZZ_CALL(bempd_prescribe_edge, model_, of, number, part.from, part.to, along, count, constant.data(),
                      proportional.data(), nullptr);
  if (way == 3)
    added = FUZZ_CALL(bempd_prescribe_point, model_, at.x, at.y, along, constant[0], proportional[0], nullptr);
  if (way == 4)
    added = FUZZ_CALL(bempd_prescribe_edge_function, model_, of, number, part.from, part.to, along, give,
                      keep(constant[0], proportional[0], bytes_.pick(16) == 1), nullptr);
  if (!added) return;
  ++supports_;
  support_values_.push_back(way == 2 ? count : 1);
}

void Scene::add_load() {
  const int way = bytes_.pick(3);
  const std::int32_t of = bytes_.pick(2) == 0 ? regions_ : region(), number = bytes_.pick(2) == 0 ? 2 : edge();
  const std::int32_t along = component(2);
  const Place at = place_on_body();
  const Part part = bytes_.of(parts);
  const std::int64_t count = 1 + bytes_.pick(3);
  const std::array constant = {bytes_.number(), 0.0, 1e-3};
  const std::array proportional = {bytes_.number(), 1e-3, 0.0};
  bool added = false;
  if (way == 0)
    added = FUZZ_CALL(bempd_add_traction, model_, of, number, part.from, part.to, along, count, constant.data(),
                      proportional.data(), nullptr);
  if (way == 1)
    added = FUZZ_CALL(bempd_add_point_force, model_, at.x, at.y, along, constant[0], proportional[0], nullptr);
  if (way == 2)
    added = FUZZ_CALL(bempd_add_traction_function, model_, of, number, part.from, part.to, give,
                      keep(constant[0], proportional[0], bytes_.pick(16) == 1), nullptr);
  if (!added) return;
  ++loads_;
  load_values_.push_back(way == 0 ? count : 1);
}

// Weight, heat and pressure.
void Scene::add_whole_load() {
  const std::int32_t of = region();
  const double constant = bytes_.number(), proportional = bytes_.number();
  bool added = false;
  switch (bytes_.pick(3)) {
    case 0:
      added = FUZZ_CALL(bempd_add_body_force, model_, of, component(2), constant, proportional, nullptr);
      break;
    case 1:
      added = FUZZ_CALL(bempd_add_temperature, model_, of, constant, proportional, nullptr);
      break;
    default:
      added = FUZZ_CALL(bempd_add_pressure, model_, of, edge(), 0.0, 1.0, 1, &constant, &proportional, nullptr);
  }
  if (!added) return;
  ++loads_;
  load_values_.push_back(1);
}

void Scene::change_values() {
  const bool of_support = bytes_.pick(2) == 0;
  const auto& counts = of_support ? support_values_ : load_values_;
  const int choice = counts.empty() ? 0 : bytes_.pick(static_cast<int>(counts.size()));
  const std::int64_t count = counts.empty() || bytes_.pick(16) == 1 ? 2 : counts[static_cast<std::size_t>(choice)];
  const std::array constant = {bytes_.number(), bytes_.number(), 0.0};
  const std::array proportional = {bytes_.number(), bytes_.number(), 1e-3};
  const Marks before = marks();
  if (of_support) {
    FUZZ_CALL(bempd_set_support_values, model_, choice + 1, count, constant.data(), proportional.data());
  } else {
    FUZZ_CALL(bempd_set_load_values, model_, choice + 1, count, constant.data(), proportional.data());
  }
  require_true(before.load_factor == marks().load_factor, "set values", "the load factor moved");
}

}  // namespace fuzz
