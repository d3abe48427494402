#include "regions/boundary_conditions.hpp"

#include <algorithm>

#include "error.hpp"

namespace bempd::regions {

namespace {

using coupling::Affine;

class SupportTable {
 public:
  SupportTable(const Discretization& d, DofConditions& conditions)
      : d_(d), c_(conditions), owner_(d.positions.size() * 2, -1) {}

  void prescribe(int support, int node, int component, const scene::BoundaryValue& value) {
    const int dof = 2 * node + component;
    const Eigen::RowVector2d wanted(value.constant[component], value.proportional[component]);
    require(wanted.allFinite(), "support ", support + 1, " prescribes a displacement that is not a finite number at (",
            d_.positions[node].x(), ", ", d_.positions[node].y(), ")");
    require(d_.ties.tie_of(node) < 0, "support ", support + 1, " holds the material point at (", d_.positions[node].x(),
            ", ", d_.positions[node].y(),
            "), which follows the boundary elements of its interface; hold the boundary element region's edge instead");
    c_.held_dofs[support].push_back(dof);
    if (owner_[dof] < 0) {
      owner_[dof] = support;
      c_.prescribed[dof] = 1;
      c_.displacement.row(dof) = wanted;
      c_.reaction_dofs[support].push_back(dof);
      return;
    }
    const Eigen::RowVector2d present = c_.displacement.row(dof);
    const double scale = std::max(wanted.cwiseAbs().maxCoeff(), present.cwiseAbs().maxCoeff());
    require((wanted - present).cwiseAbs().maxCoeff() <= 1e-9 * scale, "supports ", owner_[dof] + 1, " and ",
            support + 1, " prescribe different displacements in ", component == 0 ? "x" : "y", " at (",
            d_.positions[node].x(), ", ", d_.positions[node].y(), "): ", present[0], " + ", present[1],
            " * load factor and ", wanted[0], " + ", wanted[1],
            " * load factor; let them agree, or end one of them before that place");
  }

 private:
  const Discretization& d_;
  DofConditions& c_;
  std::vector<int> owner_;
};

void apply_support(const scene::Scene& scene, const Discretization& d, int support, SupportTable& table) {
  const scene::Condition& condition = scene.supports()[support];
  if (condition.removed()) return;
  for (const PlacedNode& n : condition.place->held_nodes(scene, d, support)) {
    const scene::BoundaryValue value = condition.value(d.positions[n.node], n.fraction);
    for (int component = 0; component < 2; ++component) {
      if (condition.acts_on(component)) table.prescribe(support, n.node, component, value);
    }
  }
}

}  // namespace

std::vector<BodyForce> DofConditions::body_forces(double load_factor) const {
  std::vector<BodyForce> per_region;
  for (Eigen::Index id = 1; 3 * id <= body_force.rows(); ++id)
    per_region.push_back(body_force_of(body_force, static_cast<int>(id), {1, load_factor}));
  return per_region;
}

BodyForce body_force_of(const coupling::Affine& all, int region, const Eigen::Vector2d& parts) {
  const Eigen::Vector3d values =
      all.col(0).segment<3>(3 * (region - 1)) * parts[0] + all.col(1).segment<3>(3 * (region - 1)) * parts[1];
  return {values.head<2>(), values[2]};
}

DofConditions apply_conditions(const scene::Scene& scene, const Discretization& d) {
  DofConditions c;
  const auto dofs = 2 * static_cast<Eigen::Index>(d.positions.size());
  c.prescribed.assign(dofs, 0);
  c.displacement = c.force = Affine::Zero(dofs, 2);
  c.body_force = Affine::Zero(3 * scene.region_count(), 2);
  c.reaction_dofs.resize(scene.supports().size());
  c.held_dofs.resize(scene.supports().size());
  SupportTable table(d, c);
  for (std::size_t s = 0; s < scene.supports().size(); ++s) apply_support(scene, d, static_cast<int>(s), table);
  for (std::size_t l = 0; l < scene.loads().size(); ++l)
    if (!scene.loads()[l].removed()) scene.loads()[l].place->add_load(scene, d, static_cast<int>(l), c);
  const auto body_forces = [&](int id) -> std::array<BodyForce, 2> {
    return {body_force_of(c.body_force, id, {1, 0}), body_force_of(c.body_force, id, {0, 1})};
  };
  for (int id : scene.region_ids()) c.work_within += d.region(id).loads().work_within(body_forces(id), c.crack_loads);
  for (const auto& region : d.regions) {
    const CrackElements* cracks = region->crack_elements();
    if (!cracks) continue;
    const Affine own = cracks->face_offsets(body_forces(region->id()), c.crack_loads);
    const Eigen::Index before = c.face_offsets.rows();
    c.face_offsets.conservativeResize(before + own.rows(), 2);
    c.face_offsets.bottomRows(own.rows()) = own;
  }
  return c;
}

}  // namespace bempd::regions
