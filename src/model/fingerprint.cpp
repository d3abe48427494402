#include "model/fingerprint.hpp"

#include <array>

#include "hash.hpp"
#include "model/state_members.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/scheme.hpp"

namespace bempd::model {

namespace {

void add(Hash& hash, const std::vector<double>& values) {
  hash.add(values.size());
  for (double value : values) hash.add(value);
}

void add(Hash& hash, const scene::Material& material) {
  hash.add(material.elasticity.young_modulus);
  hash.add(material.elasticity.poisson_ratio);
  hash.add(material.elasticity.state);
  hash.add(material.elasticity.thickness);
  hash.add(material.critical_stretch);
  hash.add(material.fracture_energy);
  if (material.thermal_expansion != 0) hash.add(material.thermal_expansion);
  hash.add(material.bond_law.stages().size());
  for (const auto& stage : material.bond_law.stages()) {
    hash.add(stage.stiffness_share);
    hash.add(stage.critical_share);
  }
  const auto add_table = [&](const char* kind, const std::vector<double>& at, const std::vector<double>& shares) {
    hash.add(std::string_view(kind));
    add(hash, at), add(hash, shares);
  };
  if (const crack::ResistanceCurve* curve = material.resistance.curve.get())
    add_table("resistance by growth", curve->extensions(), curve->shares());
  if (const crack::ResistanceDirections* table = material.resistance.directions.get())
    add_table("resistance by direction", table->angles(), table->shares());
  if (material.resistance.function) hash.add(std::string_view("resistance by a function"));
}

void add_place(Hash& hash, const scene::Condition& condition) {
  if (condition.removed()) return hash.add(std::string_view("removed"));
  condition.place->identify(hash);
  hash.add(condition.components);
}

// Adds the values of a support or load to a hash; returns false if the host gave a function, whose values cannot be
// hashed here.
bool add_values(Hash& hash, const scene::Condition& condition) {
  const auto add_list = [&](const std::vector<double>& values) { add(hash, values); };
  const auto* samples = std::get_if<scene::SampledValues>(&condition.values);
  const auto* placed = std::get_if<scene::PlacedValues>(&condition.values);
  if (samples) visit_members(*samples, add_list);
  if (placed) visit_members(*placed, add_list);
  return samples || placed;
}

void add_option(Hash& hash, const scene::OptionDescription& option, const scene::Options& options) {
  hash.add(std::string_view(option.name));
  if (option.is_text) {
    hash.add(std::string_view(options.text_in_effect(option.name)));
  } else {
    hash.add(options.number(option.name));
  }
}

// Adds an option to a hash unless the value in effect is the default, so that saved states stay readable when the
// library gets or loses options. A changed default value needs a new format of states.
void add_changed_option(Hash& hash, const scene::OptionDescription& option, const scene::Options& options) {
  const scene::Options defaults;
  const bool is_default = option.is_text ? options.text_in_effect(option.name) == defaults.text_in_effect(option.name)
                                         : options.number(option.name) == defaults.number(option.name);
  if (!is_default) add_option(hash, option, options);
}

// Options in the fingerprint of state format 14, in their order; that fingerprint also contained options with default
// values.
constexpr std::array options_of_format_14 = {
    "scheme",  "critical_stretch",         "pd.crack_tip", "pd.criterion", "crack.rule",
    "contact", "bem.quadrature_tolerance", "bem.grading"};

// Adds the options by which the library chooses the boundary elements of bodies: wanted error, time and memory allowed.
void hash_wish(Hash& hash, const scene::Options& options) {
  for (const char* name : {"error.wanted", "budget.seconds", "memory.limit"}) hash.add(options.number(name));
}

void add_options_of_format_14(Hash& hash, const scene::Options& options) {
  for (const std::string_view name : options_of_format_14) {
    if (name == "pd.crack_tip") {
      hash.add(name), hash.add(std::string_view("ahead"));
    } else {
      add_option(hash, scene::option_description(name), options);
    }
  }
  for (const scene::OptionDescription& option : regions::scheme_options(options)) add_option(hash, option, options);
}

}  // namespace

SceneFingerprint fingerprint(const scene::Scene& scene, const scene::Options& options) {
  Hash body;
  const std::vector<int> ids = scene.region_ids();
  body.add(ids.size());
  for (int id : ids) {
    add(body, scene.material_of(id));
    scene.region(id).identify(body);
  }
  if (regions::has_bodies(scene)) hash_wish(body, options);
  for (const scene::Condition& load : scene.loads()) {
    if (load.removed() || !load.place->is_built_in()) continue;
    add_place(body, load);
    add_values(body, load);
  }
  std::uint64_t cracks = 0;  // a sum, so that the order of the cracks does not matter
  for (const scene::Crack& crack : scene.cracks()) {
    if (crack.points.empty() || crack.has_begun) continue;
    Hash hash;
    for (const Point& p : crack.given()) hash.add(p.x()), hash.add(p.y());
    cracks += hash.value();
  }
  body.add(cracks);
  Hash body_of_format_14 = body;
  add_options_of_format_14(body_of_format_14, options);
  for (const scene::OptionDescription& option : scene::option_descriptions()) {
    if (option.shapes_operators) add_changed_option(body, option, options);
  }
  // Options of schemes other than the chosen scheme have no effect and are left out.
  for (const scene::OptionDescription& option : regions::scheme_options(options))
    add_changed_option(body, option, options);
  Hash supports;
  for (const scene::Condition& support : scene.supports()) add_place(supports, support);
  Hash loads;
  for (const scene::Condition& load : scene.loads()) add_place(loads, load);
  return {body.value(), supports.value(), loads.value(), body_of_format_14.value()};
}

std::uint64_t load_fingerprint(const scene::Scene& scene, const regions::DofConditions& values) {
  Hash hash;
  bool said = true;
  for (const scene::Condition& support : scene.supports()) said = add_values(hash, support) && said;
  hash.add(scene.loads().size());
  for (const scene::Condition& load : scene.loads()) {
    add_place(hash, load);
    said = add_values(hash, load) && said;
  }
  if (!said) {
    for (double value : values.displacement.reshaped()) hash.add(value);
    for (double value : values.force.reshaped()) hash.add(value);
  }
  return hash.value();
}

}  // namespace bempd::model
