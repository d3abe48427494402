#include "regions/incompressible.hpp"

#include <algorithm>

#include "error.hpp"
#include "linalg/symmetric_modes.hpp"

namespace bempd::regions {

namespace {

std::optional<Eigen::VectorXd> outflow_of(const Region& region, Eigen::Index dofs) {
  const RegionOperators* operators = region.operators();
  return operators ? operators->outflow(dofs) : std::nullopt;
}

}  // namespace

void require_determined_pressure(const Discretization& d, const std::vector<char>& prescribed) {
  // Each incompressible region has a pressure. The forces of this pressure on free degrees of freedom are a column of
  // `flows` (scaled). If a linear combination of the columns is zero, the pressures in it are undetermined.
  const auto dofs = static_cast<Eigen::Index>(prescribed.size());
  std::vector<int> ids;
  std::vector<Eigen::VectorXd> outflows;
  for (const auto& region : d.regions) {
    if (const auto outflow = outflow_of(*region, dofs)) {
      ids.push_back(region->id());
      outflows.push_back(outflow->normalized());
    }
  }
  if (ids.empty()) return;
  Eigen::MatrixXd flows(dofs, static_cast<Eigen::Index>(ids.size()));
  for (std::size_t p = 0; p < ids.size(); ++p) flows.col(static_cast<Eigen::Index>(p)) = outflows[p];
  for (Eigen::Index dof = 0; dof < dofs; ++dof)
    if (prescribed[static_cast<std::size_t>(dof)]) flows.row(dof).setZero();
  const linalg::SymmetricModes spectrum = linalg::symmetric_modes(flows.transpose() * flows);
  constexpr double none = 1e-18;  // eigenvalues below count as 0
  if (spectrum.values[0] > none) return;
  std::string regions;
  int count = 0;
  for (std::size_t p = 0; p < ids.size(); ++p)
    if (std::abs(spectrum.vectors(static_cast<Eigen::Index>(p), 0)) > 1e-6)
      regions += text(count++ == 0 ? "" : ", ", ids[p]);
  fail(Failure::unsolvable, "the pressure in the incompressible region", count > 1 ? "s " : " ", regions,
       " is undetermined: supports hold the whole boundary; leave a part of it free, or use a Poisson's ratio below "
       "1/2");
}

double condition_of_held_pressure(const scene::Scene& scene, const Discretization& d,
                                  const std::vector<char>& prescribed, std::vector<std::string>& warnings) {
  constexpr double many = 1e-6;
  double condition = 1;
  for (const auto& region : d.regions) {
    const PlaneElasticity& elasticity = scene.material_of(region->id()).elasticity;
    if (elasticity.state != PlaneState::strain || outflow_of(*region, static_cast<Eigen::Index>(prescribed.size())))
      continue;
    const std::vector<int>& nodes = region->nodes();
    const bool is_held = std::all_of(nodes.begin(), nodes.end(), [&](int node) {
      const std::size_t first = 2 * static_cast<std::size_t>(node);
      return prescribed[first] && prescribed[first + 1];
    });
    if (!is_held) continue;
    const double share = 1 - 2 * elasticity.poisson_ratio;
    condition = std::min(condition, share);
    if (share > many) continue;
    warnings.push_back(text("region ", region->id(), " is nearly incompressible and supports hold its whole boundary: ",
                            "errors of their displacements enter its pressure ", 1 / share,
                            "-fold; leave a part of the boundary free"));
  }
  return condition;
}

}  // namespace bempd::regions
