#include "regions/region.hpp"

#include "error.hpp"

namespace bempd::regions {

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
