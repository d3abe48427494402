#include "fracture/window/outside_gaps.hpp"

#include <algorithm>

#include "cancellation.hpp"
#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

OutsideGaps::OutsideGaps(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation) {
  const coupling::Constraints& all = system.constraints();
  if (all.size() == 0) return;
  std::vector<char> known(2 * static_cast<std::size_t>(system.node_count()), 0);
  for (std::size_t dof = 0; dof < known.size(); ++dof)
    known[dof] = system.unknowns().is_prescribed(static_cast<int>(dof)) ? 1 : 0;
  for (const int dof : condensation.dofs()) known[dof] = 1;
  const auto is_known = [&](int dof) { return known[dof] != 0; };
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!all.is_barred(i) && !all[i].is_on(is_known)) constraints_.push_back(i);
  const coupling::Affine& offsets = system.operators().gap_offsets();
  const auto count = static_cast<Eigen::Index>(constraints_.size());
  weights_.resize(static_cast<Eigen::Index>(condensation.dofs().size()), count);
  constant_.resize(count, 2);
  constexpr Eigen::Index at_once = WindowSettings::states_solved_at_once;
  for (Eigen::Index begin = 0; begin < count; begin += at_once) {
    const Eigen::Index width = std::min(at_once, count - begin);
    Eigen::MatrixXd functions(2 * system.node_count(), width);
    for (Eigen::Index k = 0; k < width; ++k) {
      check_cancelled();
      functions.col(k) = system.contact().gap_function(constraints_[static_cast<std::size_t>(begin + k)]);
    }
    Eigen::Index k = begin;
    for (const coupling::CondensedFunction& f : condensation.condense(functions)) {
      const std::size_t number = constraints_[static_cast<std::size_t>(k)];
      weights_.col(k) = f.weights;
      constant_.row(k) = f.constant;
      if (all[number].is_exact()) constant_.row(k) += offsets.row(static_cast<Eigen::Index>(number));
      ++k;
    }
  }
}

Eigen::MatrixXd OutsideGaps::at(std::span<const coupling::Affine> kept, int part) const {
  if (constraints_.empty()) return Eigen::MatrixXd(0, kept.size());
  Eigen::MatrixXd states(weights_.rows(), kept.size());
  for (std::size_t s = 0; s < kept.size(); ++s) states.col(static_cast<Eigen::Index>(s)) = kept[s].col(part);
  Eigen::MatrixXd gaps = weights_.transpose() * states;
  gaps.colwise() += constant_.col(part);
  return gaps;
}

}  // namespace bempd::fracture
