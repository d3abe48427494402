// A host of bempd for tests: owns a model, turns every error into an exception that carries the library's sentence,
// takes and gives vectors.
#pragma once

#include <bempd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace host {

using Vector = std::array<double, 2>;
using Outline = std::vector<Vector>;
using Field = std::function<Vector(double x, double y)>;

inline Outline rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

// Clockwise, as holes are.
inline Outline rectangular_hole(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}};
}

inline bempd_material material(double young, double poisson, int32_t plane = BEMPD_PLANE_STRESS, double thickness = 1,
                               double critical_stretch = 0) {
  bempd_material result;
  bempd_material_init(&result, sizeof result);
  result.young_modulus = young;
  result.poisson_ratio = poisson;
  result.plane = plane;
  result.thickness = thickness;
  result.critical_stretch = critical_stretch;
  return result;
}

// Poisson's ratio of bond-based peridynamics.
inline double bond_poisson(int32_t plane) { return plane == BEMPD_PLANE_STRESS ? 1.0 / 3 : 0.25; }

// Prints the line every physics test owes its reader and hands back the difference.
inline double report(const char* what, double value, double reference, const char* source) {
  std::printf("%-44s value %.9g  reference %.9g  difference %.3g  (%s)\n", what, value, reference, value - reference,
              source);
  return value - reference;
}

// Legal words of a text option, as this build of the library has them.
inline std::vector<const char*> choices_of(const std::string& option) {
  static std::vector<std::unique_ptr<std::string>> words;
  std::vector<const char*> choices;
  int64_t count = 0;
  bempd_option_count(&count);
  for (int64_t k = 0; k < count; ++k) {
    bempd_option_info info{};
    info.struct_size = sizeof info;
    if (bempd_option_describe(k, &info) != BEMPD_OK || option != info.name) continue;
    const std::string all = std::string(info.choices) + " | ";
    for (std::size_t from = 0, to; (to = all.find(" | ", from)) != std::string::npos; from = to + 3) {
      words.push_back(std::make_unique<std::string>(all.substr(from, to - from)));
      choices.push_back(words.back()->c_str());
    }
  }
  return choices;
}
inline std::vector<const char*> all_schemes() { return choices_of("scheme"); }

struct Bonds {
  std::vector<std::array<int32_t, 2>> points;
  std::vector<int32_t> states;
};

class SavedState {
 public:
  explicit SavedState(bempd_state* state) : state_(state, &bempd_state_free) {}
  const bempd_state* get() const { return state_.get(); }

 private:
  std::unique_ptr<bempd_state, void (*)(bempd_state*)> state_;
};

class Model {
 public:
  Model() {
    bempd_model* created = nullptr;
    if (bempd_model_create(&created) != BEMPD_OK) throw std::runtime_error(bempd_last_error(nullptr));
    model_.reset(created);
  }

  bempd_model* get() const { return model_.get(); }

  void check(bempd_status status) const {
    if (status != BEMPD_OK)
      throw std::runtime_error(std::string(bempd_status_name(status)) + ": " + bempd_last_error(get()));
  }

  void set_text(const char* option, const char* word) { check(bempd_set_option_text(get(), option, word)); }
  void set(const char* option, double value) { check(bempd_set_option(get(), option, value)); }

  int32_t add(const bempd_material& material) {
    int32_t id = 0;
    check(bempd_add_material(get(), &material, &id));
    return id;
  }
  int32_t bem(int32_t material, const Outline& outline, double element_length) {
    int32_t id = 0;
    check(bempd_add_bem_region(get(), material, count(outline), data(outline), element_length, &id));
    return id;
  }
  int32_t pd(int32_t material, const Outline& outline, double spacing, int horizon_ratio) {
    int32_t id = 0;
    check(bempd_add_turned_pd_region(get(), material, count(outline), data(outline), nullptr, spacing, horizon_ratio,
                                     lattice_angle, &id));
    return id;
  }
  double lattice_angle = 0;  // of regions that are added from now on
  int32_t hole(int32_t region, const Outline& outline) {
    int32_t first_edge = 0;
    check(bempd_add_hole(get(), region, count(outline), data(outline), &first_edge));
    return first_edge;
  }
  int32_t circular_hole(int32_t region, Vector centre, double radius) {
    int32_t first_edge = 0;
    check(bempd_add_circular_hole(get(), region, centre[0], centre[1], radius, &first_edge));
    return first_edge;
  }
  // A disk of four quarter circles, the first from the place with the largest x, counter-clockwise.
  int32_t disk(int32_t material, Vector centre, double radius, double element_length) {
    const double x = centre[0], y = centre[1], h = radius * std::sqrt(0.5);
    const int32_t region =
        bem(material, {{x + radius, y}, {x, y + radius}, {x - radius, y}, {x, y - radius}}, element_length);
    check(bempd_set_edge_arc(get(), region, 1, x + h, y + h));
    check(bempd_set_edge_arc(get(), region, 2, x - h, y + h));
    check(bempd_set_edge_arc(get(), region, 3, x - h, y - h));
    check(bempd_set_edge_arc(get(), region, 4, x + h, y - h));
    return region;
  }
  void crack(const Outline& points) { check(bempd_add_crack(get(), count(points), data(points), nullptr)); }
  void mesh(int32_t region, int32_t edge, double element_length, double grading) {
    check(bempd_set_edge_mesh(get(), region, edge, element_length, grading));
  }

  int32_t fix(int32_t region, int32_t edge, int32_t component) {
    int32_t id = 0;
    check(bempd_fix_edge(get(), region, edge, component, &id));
    return id;
  }
  int32_t fix_point(Vector at, int32_t component) {
    int32_t id = 0;
    check(bempd_fix_point(get(), at[0], at[1], component, &id));
    return id;
  }
  int32_t prescribe_point(Vector at, int32_t component, double proportional) {
    int32_t id = 0;
    check(bempd_prescribe_point(get(), at[0], at[1], component, 0, proportional, &id));
    return id;
  }
  int32_t prescribe(int32_t region, int32_t edge, int32_t component, double constant, double proportional) {
    int32_t id = 0;
    check(bempd_prescribe_edge(get(), region, edge, 0, 1, component, 1, &constant, &proportional, &id));
    return id;
  }
  int32_t prescribe(int32_t region, int32_t edge, double from, double to, Field proportional) {
    int32_t id = 0;
    check(bempd_prescribe_edge_function(get(), region, edge, from, to, BEMPD_BOTH, &call, keep(std::move(proportional)),
                                        &id));
    return id;
  }
  int32_t traction(int32_t region, int32_t edge, double from, double to, int32_t component, double constant,
                   double proportional) {
    int32_t id = 0;
    check(bempd_add_traction(get(), region, edge, from, to, component, 1, &constant, &proportional, &id));
    return id;
  }
  int32_t traction(int32_t region, int32_t edge, Field proportional) {
    int32_t id = 0;
    check(bempd_add_traction_function(get(), region, edge, 0, 1, &call, keep(std::move(proportional)), &id));
    return id;
  }
  int32_t point_force(Vector at, int32_t component, double constant, double proportional) {
    int32_t id = 0;
    check(bempd_add_point_force(get(), at[0], at[1], component, constant, proportional, &id));
    return id;
  }

  bempd_step_report step(double load_factor) {
    bempd_step_report report = empty_report();
    check(bempd_step(get(), load_factor, &report));
    return report;
  }
  bempd_step_report next_event(double limit) {
    bempd_step_report report = empty_report();
    check(bempd_step_to_next_event(get(), limit, &report));
    return report;
  }
  bempd_step_report run(double limit) {
    bempd_step_report report = empty_report();
    check(bempd_run_to_separation(get(), limit, &report));
    return report;
  }
  void prepare() { check(bempd_prepare(get())); }

  double load_factor() const {
    double value = 0;
    check(bempd_load_factor(get(), &value));
    return value;
  }
  int32_t region_count() const {
    int32_t value = 0;
    check(bempd_region_count(get(), &value));
    return value;
  }
  std::vector<double> field(int32_t region, int32_t which) {
    int64_t entries = 0;
    int32_t components = 0;
    check(bempd_field_size(get(), region, which, &entries, &components));
    std::vector<double> values(static_cast<std::size_t>(entries * components));
    check(bempd_copy_field(get(), region, which, static_cast<int64_t>(values.size()), values.data()));
    return values;
  }
  std::vector<Vector> vectors(int32_t region, int32_t which) {
    const std::vector<double> flat = field(region, which);
    std::vector<Vector> values(flat.size() / 2);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = {flat[2 * i], flat[2 * i + 1]};
    return values;
  }
  // Displacements of all regions, one after the other.
  std::vector<double> displacements() {
    std::vector<double> all;
    for (int32_t region = 1; region <= region_count(); ++region) {
      const std::vector<double> one = field(region, BEMPD_DISPLACEMENT);
      all.insert(all.end(), one.begin(), one.end());
    }
    return all;
  }
  std::vector<std::array<int32_t, 3>> elements(int32_t region) {
    int64_t entries = 0;
    check(bempd_element_count(get(), region, &entries));
    std::vector<std::array<int32_t, 3>> nodes(static_cast<std::size_t>(entries));
    check(bempd_copy_elements(get(), region, 3 * entries, nodes.data()->data()));
    return nodes;
  }
  Bonds bonds(int32_t region) {
    int64_t entries = 0;
    check(bempd_bond_count(get(), region, &entries));
    Bonds all{std::vector<std::array<int32_t, 2>>(static_cast<std::size_t>(entries)),
              std::vector<int32_t>(static_cast<std::size_t>(entries))};
    check(bempd_copy_bonds(get(), region, entries, all.points.data()->data(), all.states.data()));
    return all;
  }
  Vector reaction(int32_t support) {
    Vector force{};
    check(bempd_reaction(get(), support, force.data()));
    return force;
  }
  struct Values {
    Vector displacement;
    std::array<double, 3> stress;
    int32_t region;
  };
  Values evaluate(Vector at) {
    Values values{};
    check(bempd_evaluate(get(), 1, at.data(), values.displacement.data(), values.stress.data(), &values.region));
    return values;
  }
  bempd_statistics statistics() const {
    bempd_statistics result;
    bempd_statistics_init(&result, sizeof result);
    check(bempd_get_statistics(get(), &result));
    return result;
  }
  std::vector<bempd_history_entry> history() const {
    int64_t entries = 0;
    check(bempd_history_count(get(), &entries));
    std::vector<bempd_history_entry> lines(static_cast<std::size_t>(entries));
    for (int64_t i = 0; i < entries; ++i) {
      bempd_history_entry_init(&lines[static_cast<std::size_t>(i)], sizeof(bempd_history_entry));
      check(bempd_get_history_entry(get(), i, &lines[static_cast<std::size_t>(i)]));
    }
    return lines;
  }
  SavedState save() {
    bempd_state* state = nullptr;
    check(bempd_state_save(get(), &state));
    return SavedState(state);
  }
  void restore(const SavedState& state) { check(bempd_state_restore(get(), state.get())); }

 private:
  static int64_t count(const Outline& outline) { return static_cast<int64_t>(outline.size()); }
  static const double* data(const Outline& outline) { return outline.data()->data(); }
  static bempd_step_report empty_report() {
    bempd_step_report report;
    bempd_step_report_init(&report, sizeof report);
    return report;
  }
  static int32_t call(double x, double y, double*, double* proportional, void* user) {
    const Vector value = (*static_cast<const Field*>(user))(x, y);
    proportional[0] = value[0];
    proportional[1] = value[1];
    return 0;
  }
  // The library calls a boundary function again when it prepares the model, so it has to live as long as the model.
  Field* keep(Field function) {
    functions_.push_back(std::make_unique<Field>(std::move(function)));
    return functions_.back().get();
  }

  std::vector<std::unique_ptr<Field>> functions_;
  std::unique_ptr<bempd_model, void (*)(bempd_model*)> model_{nullptr, &bempd_model_free};
};

// Model whose cracks grow bond by bond.
class BondModel : public Model {
 public:
  BondModel() { set_text("crack.rule", "bond"); }
};

// State after the next event, to which a model has returned from a run to a load factor; with the displacements of when
// it was saved.
struct ReturnedTo {
  SavedState state;
  std::vector<double> displacements;
};

inline ReturnedTo return_from_run(Model& model, double load_factor) {
  model.next_event(load_factor);
  ReturnedTo saved{model.save(), model.displacements()};
  model.run(load_factor);
  model.restore(saved.state);
  return saved;
}

inline double largest(const std::vector<double>& values) {
  double result = 0;
  for (double v : values) result = std::isnan(v) ? v : (std::isnan(result) ? result : std::max(result, std::abs(v)));
  return result;
}

inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b, double factor = 1) {
  if (a.size() != b.size()) throw std::runtime_error("fields of different size");
  std::vector<double> difference(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) difference[i] = a[i] - factor * b[i];
  return largest(difference);
}

}  // namespace host
