#include "model/fingerprint.hpp"

#include <algorithm>
#include <cmath>

#include "hash.hpp"

namespace bempd::model {

namespace {

void add(Hash& hash, const Point& p) {
  hash.add(p.x());
  hash.add(p.y());
}

void add(Hash& hash, const std::vector<double>& values) {
  hash.add(values.size());
  for (double value : values) hash.add(value);
}

// Arcs are computed from places that the host gave, so the last digits of angles and fractions are not its own.
void add_computed(Hash& hash, double value) { hash.add(std::llround(value * 1e8)); }

void add(Hash& hash, const Outline& outline) {
  hash.add(outline.loops.size());
  for (const std::vector<Point>& loop : outline.loops) {
    hash.add(loop.size());
    for (const Point& vertex : loop) add(hash, vertex);
  }
  hash.add(outline.curved.size());
  for (const auto& [number, edge] : outline.curved) {
    hash.add(number);
    add_computed(hash, edge.joint());
    for (int k = 0; k < edge.piece_count(); ++k) add_computed(hash, edge.piece(k).sweep);
  }
}

void add(Hash& hash, const Material& material) {
  hash.add(material.elasticity.young_modulus);
  hash.add(material.elasticity.poisson_ratio);
  hash.add(material.elasticity.state);
  hash.add(material.elasticity.thickness);
  hash.add(material.critical_stretch);
  hash.add(material.fracture_energy);
}

void add(Hash& hash, const Region& region) {
  hash.add(region.kind);
  add(hash, region.outline);
  hash.add(region.element_length);
  hash.add(region.edge_mesh.size());
  for (const auto& [edge, mesh] : region.edge_mesh) {
    hash.add(edge);
    hash.add(mesh.element_length);
    hash.add(mesh.grading);
  }
  hash.add(region.horizon_ratio);
  hash.add(region.lattice.spacing);
}

void add_place(Hash& hash, const Condition& condition) {
  hash.add(condition.place.index());
  if (const auto* part = std::get_if<EdgePart>(&condition.place)) {
    hash.add(part->region);
    hash.add(part->edge);
    hash.add(part->from);
    hash.add(part->to);
  } else if (const auto* point = std::get_if<Point>(&condition.place)) {
    add(hash, *point);
  }
  hash.add(condition.components);
}

// Whether the values are numbers of the host's, which they are unless it gave a function.
bool add_values(Hash& hash, const Condition& condition) {
  const auto* samples = std::get_if<SampledValues>(&condition.values);
  if (!samples) return false;
  add(hash, samples->constant);
  add(hash, samples->proportional);
  return true;
}

}  // namespace

SceneFingerprint fingerprint(const Scene& scene, const Options& options) {
  Hash body;
  body.add(scene.regions().size());
  for (const Region& region : scene.regions()) {
    add(body, scene.material(region.material));
    add(body, region);
  }
  std::uint64_t cracks = 0;  // their order does not matter
  for (const Crack& crack : scene.cracks()) {
    Hash hash;
    for (const Point& p : crack.points) add(hash, p);
    cracks += hash.value();
  }
  body.add(cracks);
  for (const char* name :
       {"scheme", "critical_stretch", "paper.lattice", "paper.interface", "paper.corner_tractions", "bem.grading"}) {
    body.add(std::string_view(options.text_value(name)));
  }
  body.add(options.number("bem.quadrature_tolerance"));
  Hash supports;
  for (const Condition& support : scene.supports()) add_place(supports, support);
  return {body.value(), supports.value()};
}

std::uint64_t load_fingerprint(const Scene& scene, const DofConditions& values) {
  Hash hash;
  bool said = true;
  for (const Condition& support : scene.supports()) said = add_values(hash, support) && said;
  hash.add(scene.loads().size());
  for (const Condition& load : scene.loads()) {
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
