#include "regions/region.hpp"

#include "error.hpp"

namespace bempd::regions {

void Contributions::add_bond(const pd::Bond& between_nodes, const Point& step, double spacing, double limit,
                             int law) const {
  const double length = step.norm();
  const int term =
      bonds.add_bond(between_nodes.first, between_nodes.second, step / length, spacing * length, between_nodes.stiffness);
  if (law != 0) bonds.set_law(term, law);
  critical_stretch.push_back(limit);
}

void Region::follow(const LeadingElements&, int leader, coupling::NodeTies&) const {
  throw std::logic_error(text("region ", id_, " cannot follow the elements of region ", leader));
}

std::optional<coupling::DenseOperator> Region::dense_operator(std::span<const RegionOperator>) const {
  return std::nullopt;
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
