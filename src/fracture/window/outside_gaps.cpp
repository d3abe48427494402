#include "fracture/window/outside_gaps.hpp"

#include <algorithm>

#include "cancellation.hpp"
#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

OutsideGaps::OutsideGaps(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation) {
  if (system.face_count() > 0) add_faces(system, condensation);
  const coupling::Contacts& places = system.contacts();
  if (places.size() == 0) return;
  std::vector<char> known(2 * static_cast<std::size_t>(system.node_count()), 0);
  for (std::size_t dof = 0; dof < known.size(); ++dof) known[dof] = system.is_prescribed(static_cast<int>(dof)) ? 1 : 0;
  for (const int dof : condensation.dofs()) known[dof] = 1;
  const auto is_outside = [&](const coupling::TermEntry& e) { return !known[2 * e.node] || !known[2 * e.node + 1]; };
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::vector<coupling::TermEntry>& pull = places[i].pull;
    if (!places.is_barred(i) && std::any_of(pull.begin(), pull.end(), is_outside)) places_.push_back(i);
  }
  const auto count = static_cast<Eigen::Index>(places_.size());
  weights_.resize(static_cast<Eigen::Index>(condensation.dofs().size()), count);
  constant_.resize(count, 2);
  constexpr Eigen::Index at_once = WindowSettings::states_solved_at_once;
  for (Eigen::Index begin = 0; begin < count; begin += at_once) {
    const Eigen::Index width = std::min(at_once, count - begin);
    Eigen::MatrixXd functions = Eigen::MatrixXd::Zero(2 * system.node_count(), width);
    for (Eigen::Index k = 0; k < width; ++k) {
      check_cancelled();
      Eigen::VectorXd weights = Eigen::VectorXd::Zero(2 * system.node_count());
      for (const coupling::TermEntry& e : places[places_[static_cast<std::size_t>(begin + k)]].pull)
        weights.segment<2>(2 * e.node) += Eigen::Vector2d(e.x, e.y);
      system.ties().collect(weights);
      functions.col(k) = weights;
    }
    Eigen::Index k = begin;
    for (const coupling::CondensedFunction& f : condensation.condense(functions)) {
      weights_.col(k) = f.weights;
      constant_.row(k++) = f.constant;
    }
  }
}

Eigen::MatrixXd OutsideGaps::at(std::span<const coupling::Affine> kept, int part) const {
  if (places_.empty()) return Eigen::MatrixXd(0, kept.size());
  Eigen::MatrixXd states(weights_.rows(), kept.size());
  for (std::size_t s = 0; s < kept.size(); ++s) states.col(static_cast<Eigen::Index>(s)) = kept[s].col(part);
  Eigen::MatrixXd gaps = weights_.transpose() * states;
  gaps.colwise() += constant_.col(part);
  return gaps;
}

void OutsideGaps::add_faces(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation) {
  constexpr std::size_t at_once = WindowSettings::states_solved_at_once;
  for (std::size_t begin = 0; begin < system.face_count(); begin += at_once) {
    const std::size_t count = std::min(at_once, system.face_count() - begin);
    Eigen::MatrixXd functions(2 * system.node_count(), static_cast<Eigen::Index>(count));
    for (std::size_t k = 0; k < count; ++k)
      functions.col(static_cast<Eigen::Index>(k)) = system.gap_function(begin + k);
    std::vector<coupling::CondensedFunction> condensed = condensation.condense(functions);
    for (std::size_t k = 0; k < count; ++k) {
      condensed[k].constant += system.face_offsets().row(static_cast<Eigen::Index>(begin + k));
      faces_.push_back({std::move(condensed[k])});
    }
  }
}

}  // namespace bempd::fracture
