#include "fracture/window/outside_stiffness.hpp"

#include <algorithm>

#include "cancellation.hpp"
#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

namespace {

std::vector<char> nodes_touched_outside(const coupling::EquilibriumSystem& system, const WindowTerms& terms) {
  const coupling::Terms& all = system.terms();
  std::vector<char> touched(system.node_count(), 0);
  for (std::size_t t = 0; t < all.size(); ++t) {
    if (system.stages().intact()[t] && !terms.contained(static_cast<int>(t)))
      all.for_each_node(t, [&](int node) { touched[node] = 1; });
  }
  for (const coupling::HoldingSpring& s : system.springs()) touched[s.node] = 1;
  system.constraints().for_each_closed_penalty([&](const coupling::Constraint& constraint) {
    for (const coupling::TermEntry& e : constraint.pull) touched[e.node] = 1;
  });
  return touched;
}

// Rows and columns `chosen` of the product of a lower triangular factor with its transpose. In a row of the factor,
// columns beyond the diagonal are zero and left out.
Eigen::MatrixXd part_of_product(const Eigen::MatrixXd& factor, const std::vector<int>& chosen) {
  const Eigen::Index columns = chosen.empty() ? 0 : chosen.back() + 1;
  const Eigen::MatrixXd rows = factor.leftCols(columns)(chosen, Eigen::all);
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(rows.rows(), rows.rows());
  const Eigen::Index at_once = WindowSettings::factor_columns_at_once;
  for (Eigen::Index c = 0; c < columns; c += at_once) {
    const auto reaching = std::lower_bound(chosen.begin(), chosen.end(), static_cast<int>(c));
    const Eigen::Index above = reaching - chosen.begin(), height = rows.rows() - above;
    check_cancelled();
    product.bottomRightCorner(height, height)
        .selfadjointView<Eigen::Lower>()
        .rankUpdate(rows.block(above, c, height, std::min(at_once, columns - c)));
  }
  product.triangularView<Eigen::StrictlyUpper>() = product.transpose();
  return product;
}

}  // namespace

OutsideStiffness outside_stiffness(const coupling::EquilibriumSystem& system,
                                   const coupling::Condensation& condensation, const WindowTerms& terms) {
  OutsideStiffness result;
  const std::vector<char> touched = nodes_touched_outside(system, terms);
  const auto size = static_cast<int>(condensation.dofs().size());
  std::vector<int> place_of(static_cast<std::size_t>(size), -1);
  for (int i = 0; i < size; ++i) {
    const int node = condensation.dofs()[i] / 2;
    if (!touched[node] && !system.dense_bodies().contain(node)) continue;
    place_of[i] = static_cast<int>(result.dofs.size());
    result.dofs.push_back(i);
  }
  result.matrix = part_of_product(condensation.factor(), result.dofs);
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const auto& [row, weight] = terms.pull(t);
    for (std::size_t r = 0; r < row.size(); ++r) {
      for (std::size_t c = 0; c < row.size(); ++c) {
        if (row[r] >= size || row[c] >= size || place_of[row[r]] < 0 || place_of[row[c]] < 0) continue;
        result.matrix(place_of[row[r]], place_of[row[c]]) -= terms.stiffness(t) * weight[r] * weight[c];
      }
    }
  }
  return result;
}

}  // namespace bempd::fracture
