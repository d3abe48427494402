#include "regions/incompressible.hpp"

#include "bem/boundary_loads.hpp"
#include "error.hpp"
#include "linalg/symmetric_modes.hpp"

namespace bempd::model {

namespace {

// Volume that flows out of a region per displacement of each of the scene's degrees of freedom.
Eigen::VectorXd outflow(const BoundaryPart& part, Eigen::Index dof_count) {
  Eigen::VectorXd on_mesh = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(part.mesh.nodes.size()));
  bem::add_normal_integrals(part.mesh, on_mesh);
  const Eigen::VectorXd on_nodes = part.trace.transpose() * on_mesh;
  Eigen::VectorXd flow = Eigen::VectorXd::Zero(dof_count);
  for (std::size_t i = 0; i < part.nodes.size(); ++i)
    flow.segment<2>(2 * part.nodes[i]) += on_nodes.segment<2>(2 * static_cast<Eigen::Index>(i));
  return flow;
}

}  // namespace

void require_determined_pressure(const Scene& scene, const Discretization& d, const std::vector<char>& prescribed) {
  std::vector<const BoundaryPart*> parts;
  for (const BoundaryPart& part : d.boundaries)
    if (scene.material(scene.region(part.region).material).elasticity.incompressible()) parts.push_back(&part);
  if (parts.empty()) return;

  // One pressure a region, scaled: a combination without effect on free displacements is undetermined.
  const auto dofs = static_cast<Eigen::Index>(prescribed.size());
  Eigen::MatrixXd flows(dofs, static_cast<Eigen::Index>(parts.size()));
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const auto column = static_cast<Eigen::Index>(p);
    flows.col(column) = outflow(*parts[p], dofs).normalized();
  }
  for (Eigen::Index dof = 0; dof < dofs; ++dof)
    if (prescribed[static_cast<std::size_t>(dof)]) flows.row(dof).setZero();
  const linalg::SymmetricModes spectrum = linalg::symmetric_modes(flows.transpose() * flows);
  constexpr double none = 1e-18;  // of squares
  if (spectrum.values[0] > none) return;
  std::string regions;
  int count = 0;
  for (std::size_t p = 0; p < parts.size(); ++p)
    if (std::abs(spectrum.vectors(static_cast<Eigen::Index>(p), 0)) > 1e-6)
      regions += text(count++ == 0 ? "" : ", ", parts[p]->region);
  fail(Failure::unsolvable, "the pressure in the incompressible region", count > 1 ? "s " : " ", regions,
       " is undetermined: supports hold the whole boundary; leave a part of it free, or use a Poisson's ratio below "
       "1/2");
}

}  // namespace bempd::model
