// A host in C++17, or C++20 with std::span: a scene through bempd.hpp, then what it must refuse.
#include <bempd.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace {

void expect(bool holds, const char* what) {
  if (holds) return;
  std::printf("not so: %s\n", what);
  std::exit(1);
}

bempd_material glass() {
  auto material = bempd::make<bempd_material>();
  material.young_modulus = 70e9;
  material.poisson_ratio = 0.2;
  material.fracture_energy = 8;
  return material;
}

// A plate of boundary elements with a crack in its middle, pulled at both ends.
bempd::Model plate() {
  bempd::Model model;
  const auto material = model.add_material(glass());
  const std::vector<std::array<double, 2>> corners{{-1, -3}, {1, -3}, {1, 3}, {-1, 3}};
  const auto region = model.add_bem_region(material, corners, 0.5);
  const double points[] = {-0.5, 0, 0.5, 0};
  model.add_crack({points, 2});
  model.fix_point(-1, -3);
  model.fix_point(1, -3, BEMPD_Y);
  model.add_traction(region, 1, BEMPD_Y, -1e6);
  model.add_traction(region, 3, BEMPD_Y, 1e6);
  return model;
}

// A body with a hole: its elements are the library's.
void hole_attracts_stress() {
  bempd::Model model;
  const auto body = model.add_body(model.add_material(glass()), {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  expect(model.add_circular_hole(body, 2, 2, 0.5) == 5, "the edges of a hole follow those of the outline");
  model.fix_edge(body, 4);
  model.add_traction(body, 2, BEMPD_X, 1e6);
  model.step(1);
  expect(model.field(body, BEMPD_DISPLACEMENT).values.size() > 0, "a body has fields");
}

template <class Function>
bempd_status refused(Function function, const char* words) {
  try {
    function();
  } catch (const bempd::Error& error) {
    expect(std::strstr(error.what(), words) != nullptr, error.what());
    return error.status();
  }
  expect(false, words);
  return BEMPD_OK;
}

void run() {
  hole_attracts_stress();
  bempd::Model model = plate();
  int lines = 0;
  model.on_log([&](std::int32_t, const char*) { ++lines; });
  model.call(bempd_set_tip_frozen, 1, std::int32_t{BEMPD_CRACK_START}, 1);
  model.call(bempd_set_tip_frozen, 1, std::int32_t{BEMPD_CRACK_END}, 1);
  const bempd_step_report report = model.step(1);
  expect(lines > 0 && report.load_factor == 1 && model.load_factor() == 1, "the step is told");
  const auto tips = model.tips();
  expect(tips.size() == 2 && std::abs(tips[0].stress_intensity_1 / 1.487e6 - 1) < 0.01, "K_I of a crack in a plate");
  expect(std::abs(model.ask(bempd_crack_length, 1) - 1) < 1e-12, "ask() returns a number");
  expect(model.ask(bempd_get_statistics).boundary_elements > 0, "ask() returns a struct");
  const bempd::Field moved = model.field(1, BEMPD_DISPLACEMENT);
  expect(moved.components == 2 && moved.values.size() % 2 == 0 && moved.values[1] == 0, "a field is looked at");
  const bempd::State before = model.save();
  model.step(2);
  model.restore(before);
  expect(model.load_factor() == 1, "a state is restored");
}

void refuse() {
  bempd::Model model;
  const auto material = model.add_material(glass());
  expect(refused(
             [&] {
               model.add_bem_region(material, {{0, 0}, {1, 0}}, 0.1);
             },
             "bempd_add_bem_region: ") == BEMPD_ERROR_ARGUMENT,
         "two vertices");
  expect(refused([&] { model.set_option("no.such", 1); }, "no.such") == BEMPD_ERROR_ARGUMENT, "an unknown option");
  expect(refused([&] { model.step(1); }, "bempd_step: ") == BEMPD_ERROR_ORDER, "a scene without a region");
  bool odd = false;
  try {
    model.add_crack(std::vector<double>{0, 0, 1});
  } catch (const std::invalid_argument&) {
    odd = true;
  }
  expect(odd, "an odd number of coordinates");
  const bempd::Model taken = std::move(model);
  expect(taken.get() != nullptr && refused(
                                       [&] {
                                         model.add_crack({{0, 0}, {1, 0}});
                                       },
                                       "model") == BEMPD_ERROR_ARGUMENT,
         "a moved model");
}

// An exception of the host passes through the library, which has come back to the start of the step.
void cancel() {
  bempd::Model model = plate();
  model.on_progress([](double, std::int64_t, std::int64_t) { throw std::out_of_range("enough"); });
  bool came = false;
  try {
    model.run_to_separation(1e3);
  } catch (const std::out_of_range& error) {
    came = std::strcmp(error.what(), "enough") == 0;
  }
  expect(came && model.load_factor() == 0, "an exception of a progress function");
  model.on_progress(nullptr);
  expect(model.step_to_next_event(1e3).events == 1, "the model goes on without it");
}

#if defined(__cpp_lib_span)
void spans() {
  bempd::Model model;
  const double corners[] = {0, 0, 2, 0, 2, 1, 0, 1};
  model.add_bem_region(model.add_material(glass()), std::span<const double>(corners), 0.5);
  expect(model.ask(bempd_edge_count, 1) == 4, "a span of coordinates");
  static_assert(std::is_same_v<bempd::View, std::span<const double>>);
}
#else
void spans() { static_assert(__cplusplus < 202002L, "std::span is missing"); }
#endif

}  // namespace

int main() {
  run();
  refuse();
  cancel();
  spans();
  std::printf("bempd %s\n", bempd_version_string());
}
