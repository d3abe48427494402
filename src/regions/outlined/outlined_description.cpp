#include "regions/outlined/outlined_description.hpp"

#include <algorithm>
#include <cmath>

#include "error.hpp"
#include "regions/scheme.hpp"
#include "scene/outline_rules.hpp"

namespace bempd::regions {

namespace {

bool is_rectilinear(const Outline& outline) {
  if (!outline.curved.empty()) return false;
  const double tolerance = geometric_tolerance(bounding_box(outline));
  const std::vector<Edge> edges = edges_of(outline);
  return std::all_of(edges.begin(), edges.end(),
                     [&](const Edge& edge) { return edge.direction().cwiseAbs().minCoeff() <= tolerance; });
}

// Throws Error (argument) for a horizon of less than three spacings: points on an outline need more bonds than those to
// their nearest neighbours.
void require_horizon(int horizon_ratio) {
  require(horizon_ratio >= 3, "horizon_ratio is ", horizon_ratio,
          "; a peridynamic region with slanted or round edges needs at least 3");
}

}  // namespace

OutlinedDescription::OutlinedDescription(int material_id, const scene::Material& material, const Outline& outline,
                                         double spacing, int horizon_ratio, const PointChoice& choice)
    : LatticeDescription(material_id, material, outline, spacing, horizon_ratio,
                         choice.is_plain() && is_rectilinear(outline)),
      choice_(choice),
      on_rows_(is_on_rows(this->outline())) {
  if (!on_rows_) require_horizon(horizon_ratio);
}

bool OutlinedDescription::is_on_rows(const Outline& outline) const {
  return choice_.is_plain() && is_rectilinear(outline);
}

void OutlinedDescription::set_outline(Outline changed) {
  const bool on_rows = is_on_rows(changed);
  if (on_rows) {
    LatticeDescription::set_outline(std::move(changed));
  } else {
    require_horizon(horizon_ratio());
    take_outline(std::move(changed));
  }
  on_rows_ = on_rows;
}

std::optional<scene::NodeGrid> OutlinedDescription::node_grid() const {
  return on_rows_ ? LatticeDescription::node_grid() : std::nullopt;
}

void OutlinedDescription::identify(Hash& hash) const {
  LatticeDescription::identify(hash);
  if (choice_.balance != pd::OutlineBalance::constant_stress && !on_rows_) hash.add(2);
  if (choice_.is_plain()) return;
  hash.add(choice_.on_outline ? 1 : 0);
  hash.add(choice_.angle);
}

std::unique_ptr<regions::Region> OutlinedDescription::build(int id, const Preparation& preparation) const {
  if (on_rows_) return LatticeDescription::build(id, preparation);
  return preparation.scheme.outlined_region(id, *this, preparation.scene.material(material()));
}

int add_peridynamic_region(scene::Scene& scene, int material, const std::vector<Point>& vertices, double spacing,
                           int horizon_ratio, const PointChoice& choice, const std::vector<double>& bulges) {
  Outline outline;
  scene::append_loop(outline, vertices, bulges);
  return scene.add_region(std::make_unique<OutlinedDescription>(material, scene.material(material), outline, spacing,
                                                                horizon_ratio, choice));
}

}  // namespace bempd::regions
