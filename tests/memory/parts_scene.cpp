// Calls that make a scene.
#include "parts.hpp"

namespace memory_test {

namespace {

int64_t half(const std::vector<double>& values) { return static_cast<int64_t>(values.size() / 2); }

int32_t widening(double x, double, double* constant, double* proportional, void*) {
  constant[0] = constant[1] = proportional[1] = 0;
  proportional[0] = 0.01 + 1e-3 * x;
  return 0;
}

}  // namespace

void add(Program& program, std::initializer_list<Call> calls) {
  program.calls.insert(program.calls.end(), calls.begin(), calls.end());
}

Call create() {
  return {"model_create", [](Host& h) { return bempd_model_create(&h.model); }, {}};
}

Call free_model() {
  return {"model_free",
          [](Host& h) {
            bempd_model_free(h.model);
            h.model = nullptr;
            return BEMPD_OK;
          },
          {}};
}

Call text_option(const char* name, const char* word) {
  return {"set_option_text", [=](Host& h) { return bempd_set_option_text(h.model, name, word); }, {}};
}

Call number_option(const char* name, double value) {
  return {"set_option", [=](Host& h) { return bempd_set_option(h.model, name, value); }, {}};
}

bempd_material with_fracture_energy(double value) {
  bempd_material material;
  bempd_material_init(&material, sizeof material);
  material.young_modulus = 1;
  material.poisson_ratio = 0.3;
  material.fracture_energy = value;
  return material;
}

Call add_material(const bempd_material& values) {
  bempd_material material = values;
  if (material.young_modulus == 0) {
    bempd_material_init(&material, sizeof material);
    material.young_modulus = 1000;
    material.poisson_ratio = 1.0 / 3;
    material.critical_stretch = 1e-3;
  }
  return {"add_material", [material](Host& h) { return bempd_add_material(h.model, &material, &h.material); }, {}};
}

Call bem(int place, std::vector<double> vertices, double element_length) {
  return {"add_bem_region",
          [=](Host& h) {
            return bempd_add_bem_region(h.model, h.material, half(vertices), vertices.data(), element_length,
                                        &h.region[place]);
          },
          {}};
}

Call pd(int place, std::vector<double> vertices, double spacing, int horizon_ratio) {
  return {"add_pd_region",
          [=](Host& h) {
            return bempd_add_pd_region(h.model, h.material, half(vertices), vertices.data(), spacing, horizon_ratio,
                                       &h.region[place]);
          },
          {}};
}

Call body(int place, std::vector<double> vertices) {
  return {
      "add_body",
      [=](Host& h) { return bempd_add_body(h.model, h.material, half(vertices), vertices.data(), &h.region[place]); },
      {}};
}

Call lattice_patch(int body, double spacing) {
  return {"set_body_lattice, set_crack_treatment",
          [=](Host& h) {
            const bempd_status status = bempd_set_body_lattice(h.model, h.region[body], spacing, 3);
            return status == BEMPD_OK ? bempd_set_crack_treatment(h.model, 1, BEMPD_TREATMENT_LATTICE) : status;
          },
          {}};
}

Call hole(int place, std::vector<double> vertices) {
  return {"add_hole",
          [=](Host& h) { return bempd_add_hole(h.model, h.region[place], half(vertices), vertices.data(), nullptr); },
          {}};
}

Call crack(std::vector<double> points) {
  return {"add_crack", [=](Host& h) { return bempd_add_crack(h.model, half(points), points.data(), nullptr); }, {}};
}

Call fix(int place, int region, int32_t edge) {
  return {"fix_edge",
          [=](Host& h) { return bempd_fix_edge(h.model, h.region[region], edge, BEMPD_BOTH, &h.support[place]); },
          {}};
}

Call pin(int place, double x, double y) {
  return {"fix_point", [=](Host& h) { return bempd_fix_point(h.model, x, y, BEMPD_Y, &h.support[place]); }, {}};
}

Call prescribe(int place, int region, int32_t edge, std::vector<double> proportional) {
  return {"prescribe_edge",
          [=](Host& h) {
            return bempd_prescribe_edge(h.model, h.region[region], edge, 0, 1, BEMPD_X,
                                        static_cast<int64_t>(proportional.size()), nullptr, proportional.data(),
                                        &h.support[place]);
          },
          {}};
}

Call prescribe_by_function(int place, int region, int32_t edge) {
  return {"prescribe_edge_function",
          [=](Host& h) {
            return bempd_prescribe_edge_function(h.model, h.region[region], edge, 0, 1, BEMPD_X, &widening, nullptr,
                                                 &h.support[place]);
          },
          {}};
}

Call traction(int place, int region, int32_t edge) {
  return {"add_traction",
          [=](Host& h) {
            const double one = 1;
            return bempd_add_traction(h.model, h.region[region], edge, 0, 1, BEMPD_Y, 1, nullptr, &one, &h.load[place]);
          },
          {}};
}

Call traction_by_function(int region, int32_t edge) {
  return {"add_traction_function",
          [=](Host& h) {
            return bempd_add_traction_function(h.model, h.region[region], edge, 0, 1, &widening, nullptr, nullptr);
          },
          {}};
}

Call pressure(int place, int region) {
  return {"add_pressure",
          [=](Host& h) {
            const double small = 0.01;
            return bempd_add_pressure(h.model, h.region[region], 1, 0, 1, 1, nullptr, &small, &h.load[place]);
          },
          {}};
}

Call point_force(int place, double x, double y) {
  return {"add_point_force",
          [=](Host& h) { return bempd_add_point_force(h.model, x, y, BEMPD_Y, 0, 0.01, &h.load[place]); },
          {}};
}

Call crack_traction(int place) {
  return {"add_crack_traction",
          [=](Host& h) {
            const double small = 0.1;
            return bempd_add_crack_traction(h.model, 1, BEMPD_PRESSURE, 1, nullptr, &small, &h.load[place]);
          },
          {}};
}

Call new_load_values(int place) {
  return {"set_load_values",
          [=](Host& h) {
            const double value = 0.05;
            return bempd_set_load_values(h.model, h.load[place], 1, nullptr, &value);
          },
          {}};
}

Call new_support_values(int place) {
  return {"set_support_values",
          [=](Host& h) {
            const double values[] = {-0.001, -0.021};
            return bempd_set_support_values(h.model, h.support[place], 2, nullptr, values);
          },
          {}};
}

}  // namespace memory_test
