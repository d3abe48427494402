#include "regions/incompressible.hpp"

#include "error.hpp"
#include "linalg/symmetric_modes.hpp"

namespace bempd::regions {

void require_determined_pressure(const Discretization& d, const std::vector<char>& prescribed) {
  // One pressure a region, scaled: a combination without effect on free displacements is undetermined.
  const auto dofs = static_cast<Eigen::Index>(prescribed.size());
  std::vector<int> ids;
  std::vector<Eigen::VectorXd> outflows;
  for (const auto& region : d.regions) {
    if (const auto outflow = region->outflow(dofs)) {
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
  constexpr double none = 1e-18;  // of squares
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

}  // namespace bempd::regions
