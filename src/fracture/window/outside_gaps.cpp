#include "fracture/window/outside_gaps.hpp"

#include <algorithm>
#include <cmath>

#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

OutsideGaps::OutsideGaps(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                         const coupling::Affine& displacement, double load_factor) {
  if (system.face_count() > 0) add_faces(system, condensation, displacement, load_factor);
  const coupling::Contacts& places = system.contacts();
  if (places.size() == 0) return;
  std::vector<char> kept(static_cast<std::size_t>(system.node_count()), 0);
  for (const int dof : condensation.dofs()) kept[dof / 2] = 1;
  const Eigen::VectorXd u = coupling::evaluate(displacement, load_factor);
  std::vector<double> size;
  for (std::size_t i = 0; i < places.size(); ++i) size.push_back(std::abs(places[i].gap(u.data())));
  const double limit = WindowSettings::gap_at_risk * *std::max_element(size.begin(), size.end());
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto is_outside = [&](const coupling::TermEntry& e) { return kept[e.node] == 0; };
    if (size[i] > limit || places.is_barred(i)) continue;
    if (std::any_of(places[i].pull.begin(), places[i].pull.end(), is_outside)) chosen.push_back(i);
  }
  constexpr std::size_t batch = WindowSettings::states_solved_at_once;
  for (std::size_t begin = 0; begin < chosen.size(); begin += batch) {
    const std::size_t count = std::min(batch, chosen.size() - begin);
    Eigen::MatrixXd functions = Eigen::MatrixXd::Zero(2 * system.node_count(), static_cast<Eigen::Index>(count));
    for (std::size_t k = 0; k < count; ++k) {
      Eigen::VectorXd weights = Eigen::VectorXd::Zero(2 * system.node_count());
      for (const coupling::TermEntry& e : places[chosen[begin + k]].pull)
        weights.segment<2>(2 * e.node) += Eigen::Vector2d(e.x, e.y);
      system.ties().collect(weights);
      functions.col(static_cast<Eigen::Index>(k)) = weights;
    }
    std::vector<coupling::CondensedFunction> condensed = condensation.condense(functions);
    for (std::size_t k = 0; k < count; ++k) gaps_.push_back({chosen[begin + k], std::move(condensed[k])});
  }
}

void OutsideGaps::add_faces(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                            const coupling::Affine& displacement, double load_factor) {
  const Eigen::VectorXd gaps = coupling::evaluate(system.face_gaps(displacement), load_factor);
  const double limit = WindowSettings::gap_at_risk * gaps.lpNorm<Eigen::Infinity>();
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < system.face_count(); ++i)
    if (gaps[static_cast<Eigen::Index>(i)] <= limit) chosen.push_back(i);
  constexpr std::size_t batch = WindowSettings::states_solved_at_once;
  for (std::size_t begin = 0; begin < chosen.size(); begin += batch) {
    const std::size_t count = std::min(batch, chosen.size() - begin);
    Eigen::MatrixXd functions(2 * system.node_count(), static_cast<Eigen::Index>(count));
    for (std::size_t k = 0; k < count; ++k)
      functions.col(static_cast<Eigen::Index>(k)) = system.gap_function(chosen[begin + k]);
    std::vector<coupling::CondensedFunction> condensed = condensation.condense(functions);
    for (std::size_t k = 0; k < count; ++k) {
      condensed[k].constant += system.face_offsets().row(static_cast<Eigen::Index>(chosen[begin + k]));
      faces_.push_back({chosen[begin + k], std::move(condensed[k])});
    }
  }
}

}  // namespace bempd::fracture
