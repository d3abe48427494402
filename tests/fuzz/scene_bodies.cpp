// Options, materials, regions and cracks.
#include <array>

#include "checks.hpp"
#include "scene.hpp"

namespace fuzz {

void Scene::set_option() {
  struct Word {
    const char *name, *value;
  };
  static constexpr std::array words = {Word{"scheme", "paper"},
                                       Word{"scheme", "symmetric"},
                                       Word{"test.solver", "plain"},
                                       Word{"test.solver", "window"},
                                       Word{"paper.mode", "paper"},
                                       Word{"paper.mode", "event"},
                                       Word{"critical_stretch", "printed"},
                                       Word{"critical_stretch", "running"},
                                       Word{"paper.lattice", "nodal"},
                                       Word{"paper.interface", "traction"},
                                       Word{"paper.corner_tractions", "one"},
                                       Word{"bem.grading", "none"},
                                       Word{"crack.criterion", "energy"},
                                       Word{"contact", "none"},
                                       Word{"stepping.control", "path"},
                                       Word{"crack.rule", "bond"},
                                       Word{"test.outline_points", "always"},
                                       Word{"scheme", "nothing"},
                                       Word{"", ""}};
  static constexpr std::array<const char*, 10> names = {
      "bem.quadrature_tolerance",  "paper.increment", "test.window_length", "no option",   "scheme", "tips.record",
      "stepping.separation_share", "crack.tie_share", "crack.exponent",     "memory.limit"};
  if (bytes_.pick(2) == 0) {
    const Word word = bytes_.of(words);
    FUZZ_CALL(bempd_set_option_text, model_, word.name, word.value);
    return;
  }
  const char* name = bytes_.of(names);
  const double value = bytes_.number();
  double stored = 0;
  if (FUZZ_CALL(bempd_set_option, model_, name, value)) {
    require_true(FUZZ_CALL(bempd_get_option, model_, name, &stored) && stored == value, name, "not what was set");
    limit_memory();
  }
}

void Scene::add_material(bool sound) {
  static constexpr std::array ratios = {1 / 3.0, 1 / 3.0, 1 / 3.0,   1 / 3.0, 1 / 3.0, 0.25,
                                        0.3,     0.5,     0.4999999, -0.9,    0.0};
  bempd_material material;
  good("bempd_material_init", nullptr, bempd_material_init(&material, sizeof material));
  material.young_modulus = 1, material.poisson_ratio = 1 / 3.0, material.critical_stretch = 1e-3;
  if (!sound) {
    material.young_modulus = bytes_.mostly(1);
    material.poisson_ratio = bytes_.mostly(bytes_.of(ratios));
    material.thickness = bytes_.mostly(1);
    material.critical_stretch = bytes_.mostly(bytes_.pick(4) == 0 ? 0 : 1e-3);
    material.fracture_energy = bytes_.mostly(0);
    material.thermal_expansion = bytes_.mostly(bytes_.pick(2) == 0 ? 0 : 1e-4);
    material.plane = bytes_.byte() < 240 ? 1 + (material.poisson_ratio == 0.25) : bytes_.pick(5);
  }
  if (FUZZ_CALL(bempd_add_material, model_, &material, nullptr)) ++materials_;
}

void Scene::add_box(bool of_lattice) {
  const double left = front_ * scale_, right = (front_ + 2 + bytes_.pick(6)) * scale_;
  const double top = (bytes_.pick(8) == 0 ? 1 + bytes_.pick(10) : height_) * scale_;
  const std::array vertices = {left, 0.0, right, 0.0, right, bytes_.mostly(top), left, top};
  const std::int32_t material =
      bytes_.byte() < 250 && materials_ > 0 ? 1 + bytes_.pick(materials_) : bytes_.pick(9) - 2;
  static constexpr std::array lengths = {1.0, 1.0, 1.0, 2.0, 1.0, 1.0, 1.3, 0.5};
  const double length = bytes_.of(lengths) * scale_;
  const std::int32_t horizon = bytes_.byte() < 240 ? 2 + bytes_.pick(3) : bytes_.pick(12) - 2;
  const bool added =
      of_lattice ? FUZZ_CALL(bempd_add_pd_region, model_, material, 4, vertices.data(), length, horizon, nullptr)
                 : FUZZ_CALL(bempd_add_bem_region, model_, material, 4, vertices.data(), length, nullptr);
  if (!added) return;
  ++regions_;
  if (of_lattice) lattice_origins_.push_back({left, 0});
  corners_.insert(corners_.end(), {{left, 0}, {right, 0}, {right, top}, {left, top}});
  front_ = front_ > 20 ? 0 : right / scale_;
}

void Scene::add_polygon() {
  std::vector<double> vertices;
  const int count = 3 + bytes_.pick(5);
  for (int k = 0; k < count; ++k) {
    const Place vertex = place();
    vertices.push_back(vertex.x), vertices.push_back(vertex.y);
  }
  const double length = (1 + bytes_.pick(3)) * scale_;
  const bool of_lattice = bytes_.pick(2) == 0;
  if (of_lattice ? FUZZ_CALL(bempd_add_pd_region, model_, 1, count, vertices.data(), length, 0, nullptr)
                 : FUZZ_CALL(bempd_add_bem_region, model_, 1, count, vertices.data(), length, nullptr))
    ++regions_;
}

void Scene::add_hole() {
  const Place at = place();
  const double size = bytes_.mostly((1 + bytes_.pick(3)) * 0.5 * scale_);
  const std::int32_t of = region();
  if (bytes_.pick(2) == 0) {
    FUZZ_CALL(bempd_add_circular_hole, model_, of, at.x, at.y, size, nullptr);
    return;
  }
  const std::array vertices = {at.x, at.y, at.x, at.y + size, at.x + size, at.y + size, at.x + size, at.y};
  FUZZ_CALL(bempd_add_hole, model_, of, 4, vertices.data(), nullptr);
}

void Scene::bend_edge() {
  const Place at = place();
  const std::int32_t of = region(), first = edge();
  if (bytes_.pick(3) == 0) {
    FUZZ_CALL(bempd_set_edges_smooth, model_, of, first, edge());
  } else {
    const double bulge = bytes_.pick(9) * 0.05 * scale_;
    FUZZ_CALL(bempd_set_edge_arc, model_, of, first, at.x + bulge, at.y - bulge);
    FUZZ_CALL(bempd_set_edge_arc_about, model_, of, first, at.x, at.y, bulge, 1 + first % 2);
  }
}

void Scene::mesh_edge() {
  static constexpr std::array lengths = {1.0, 1.3, 0.5, 2.0, 1e3, 0.0, -1.0};
  static constexpr std::array gradings = {1.0, 1.0, 1.5, 4.0, 0.5, 1e300};
  const std::int32_t of = region(), number = edge();
  const double length = bytes_.of(lengths) * scale_;
  FUZZ_CALL(bempd_set_edge_mesh, model_, of, number, length, bytes_.of(gradings));
}

// Places on one line, or three that are not.
void Scene::vary_toughness() {
  static constexpr std::array energies = {1.0, 2.0, 0.1, 1e3, 1e-12, 0.0, -1.0};
  const Place at = place();
  const std::array places = {at.x, at.y, at.x + scale_, at.y, at.x, at.y + bytes_.pick(2) * scale_};
  const double first = bytes_.of(energies), second = bytes_.of(energies);
  const std::array values = {first, second, first};
  FUZZ_CALL(bempd_set_toughness_at, model_, region(), 2 + bytes_.pick(2), places.data(), values.data());
  const std::array rows = {0.0, bytes_.mostly(0.5), 1.0};
  if (bytes_.pick(2) == 1) FUZZ_CALL(bempd_set_resistance_curve, model_, 1, 3, rows.data(), values.data());
  if (bytes_.pick(2) == 1) FUZZ_CALL(bempd_set_resistance_directions, model_, 1, 3, rows.data(), values.data());
  const auto resistance = [](std::int32_t, std::int32_t, double, double, double, double, double, double length, double,
                             double, void*) { return 1 + length; };
  if (bytes_.pick(4) == 1) FUZZ_CALL(bempd_set_resistance_function, model_, 1, resistance, nullptr);
}

void Scene::add_crack(bool in_lattice) {
  std::vector<double> points;
  const int count = 2 + bytes_.pick(2);
  const bool placed = in_lattice && !lattice_origins_.empty();
  const Place first = placed ? lattice_origins_.back() : place();
  double x = first.x + (0.5 + (placed ? bytes_.pick(3) : 0)) * scale_, y = first.y;
  for (int k = 0; k < count; ++k) {
    points.push_back(x), points.push_back(y);
    x += (bytes_.pick(5) - 2) * (placed ? 0.03 : 0.31) * scale_;
    y += (placed ? 0.5 + bytes_.pick(3) : (bytes_.pick(7) - 2) * 0.5) * scale_;
  }
  FUZZ_CALL(bempd_add_crack, model_, count, points.data(), nullptr);
}

}  // namespace fuzz
