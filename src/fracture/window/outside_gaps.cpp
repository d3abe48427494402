#include "fracture/window/outside_gaps.hpp"

#include <algorithm>

#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

namespace {

// Places with points that are neither kept nor prescribed.
std::vector<std::size_t> places_outside(const coupling::EquilibriumSystem& system, const std::vector<int>& kept) {
  const coupling::Contacts& places = system.contacts();
  std::vector<std::size_t> outside;
  if (places.size() == 0) return outside;
  std::vector<char> known(2 * static_cast<std::size_t>(system.node_count()), 0);
  for (std::size_t dof = 0; dof < known.size(); ++dof) known[dof] = system.is_prescribed(static_cast<int>(dof)) ? 1 : 0;
  for (const int dof : kept) known[dof] = 1;
  const auto is_outside = [&](const coupling::TermEntry& e) { return !known[2 * e.node] || !known[2 * e.node + 1]; };
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::vector<coupling::TermEntry>& pull = places[i].pull;
    if (!places.is_barred(i) && std::any_of(pull.begin(), pull.end(), is_outside)) outside.push_back(i);
  }
  return outside;
}

}  // namespace

void CondensedGaps::condense(const coupling::Condensation& condensation,
                             const std::function<Eigen::VectorXd(std::size_t)>& weights_of) {
  const auto count = static_cast<Eigen::Index>(places.size());
  weights.resize(static_cast<Eigen::Index>(condensation.dofs().size()), count);
  constant.resize(count, 2);
  constexpr Eigen::Index at_once = WindowSettings::states_solved_at_once;
  for (Eigen::Index begin = 0; begin < count; begin += at_once) {
    Eigen::MatrixXd functions;
    const Eigen::Index end = std::min(begin + at_once, count);
    for (Eigen::Index k = begin; k < end; ++k) {
      const Eigen::VectorXd of_place = weights_of(places[static_cast<std::size_t>(k)]);
      if (k == begin) functions.resize(of_place.size(), end - begin);
      functions.col(k - begin) = of_place;
    }
    Eigen::Index k = begin;
    for (const coupling::CondensedFunction& f : condensation.condense(functions)) {
      weights.col(k) = f.weights;
      constant.row(k++) = f.constant;
    }
  }
}

Eigen::MatrixXd CondensedGaps::at(std::span<const coupling::Affine> kept, int part) const {
  const auto count = static_cast<Eigen::Index>(kept.size());
  if (places.empty()) return Eigen::MatrixXd(0, count);
  Eigen::MatrixXd states(weights.rows(), count);
  for (Eigen::Index s = 0; s < count; ++s) states.col(s) = kept[static_cast<std::size_t>(s)].col(part);
  Eigen::MatrixXd gaps = weights.transpose() * states;
  gaps.colwise() += constant.col(part);
  return gaps;
}

OutsideGaps::OutsideGaps(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation) {
  places_.places = places_outside(system, condensation.dofs());
  places_.condense(condensation, [&](std::size_t place) {
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(2 * system.node_count());
    for (const coupling::TermEntry& e : system.contacts()[place].pull)
      weights.segment<2>(2 * e.node) += Eigen::Vector2d(e.x, e.y);
    system.ties().collect(weights);
    return weights;
  });
  for (std::size_t i = 0; i < system.face_count(); ++i) faces_.places.push_back(i);
  faces_.condense(condensation, [&](std::size_t face) { return Eigen::VectorXd(system.gap_function(face)); });
  if (!faces_.places.empty()) faces_.constant += system.face_offsets();
}

}  // namespace bempd::fracture
