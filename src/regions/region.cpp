#include "regions/region.hpp"

#include <array>
#include <limits>

#include "pd/cell_squares.hpp"

namespace bempd::regions {

void Contributions::add_bond(const pd::Bond& between_nodes, const Point& step, double spacing,
                             const Breaking& breaking) const {
  const double length = step.norm();
  const int term = terms.add_bond(between_nodes.first, between_nodes.second, step / length, spacing * length,
                                  between_nodes.stiffness);
  if (breaking.law != 0) terms.set_law(term, breaking.law);
  if (breaking.contraction > 0) terms.set_contraction(term, breaking.contraction);
  critical_stretch.push_back(breaking.limit);
}

std::vector<int> Contributions::add_squares(const pd::CellLattice& grid, const std::vector<pd::Bond>& of_grid,
                                            const PlaneElasticity& elasticity, double spacing,
                                            const std::function<int(int)>& node,
                                            const std::function<int(int)>& term) const {
  const std::vector<pd::CellSquare> squares = pd::cell_squares(elasticity);
  if (squares.empty()) return {};
  std::vector<int> first_of(static_cast<std::size_t>(grid.point_count()), -1);
  for (const pd::Cell& cell : pd::cells_with_bonds(grid, of_grid)) {
    std::vector<int> leaders;
    for (const int bond : cell.bonds) leaders.push_back(term(bond));
    for (const pd::CellSquare& square : squares) {
      std::array<coupling::TermEntry, 4> entries;
      for (std::size_t k = 0; k < 4; ++k) entries[k] = {node(cell.corners[k]), square.pull[k].x(), square.pull[k].y()};
      const int number = terms.add_wide(entries, spacing, square.stiffness);
      critical_stretch.push_back(std::numeric_limits<double>::infinity());
      terms.add_follower(number, leaders);
      int& first = first_of[static_cast<std::size_t>(cell.corners[0])];
      if (first < 0) first = number;
    }
  }
  return first_of;
}

Eigen::VectorXd Region::gather(const Eigen::VectorXd& of_scene) const {
  Eigen::VectorXd own(2 * static_cast<Eigen::Index>(nodes_.size()));
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    own.segment<2>(2 * static_cast<Eigen::Index>(i)) = of_scene.segment<2>(2 * nodes_[i]);
  }
  return own;
}

void Region::scatter(const Eigen::VectorXd& own, Eigen::Ref<Eigen::VectorXd> of_scene) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    of_scene.segment<2>(2 * nodes_[i]) += own.segment<2>(2 * static_cast<Eigen::Index>(i));
  }
}

}  // namespace bempd::regions
