#include "pd/congruent_clusters.hpp"

#include <algorithm>
#include <cmath>

#include "cancellation.hpp"

namespace bempd::pd {

namespace {

using Eigen::Vector2i;
using Eigen::Vector4d;

// Largest difference of missing moments, or stiffnesses, that counts as equal: these are of order one, so it is
// rounding.
constexpr double same_lack = 1e-12;

// Symmetry of the square lattice, one of eight, that maps a box to another box.
struct Symmetry {
  bool mirror_x, mirror_y, transpose;

  Vector2i apply(Vector2i p, const Vector2i& size) const {
    if (mirror_x) p.x() = size.x() - p.x();
    if (mirror_y) p.y() = size.y() - p.y();
    return transpose ? Vector2i(p.y(), p.x()) : p;
  }
  // Image of third moments, in the order 111, 112, 122, 222.
  Vector4d apply(Vector4d m) const {
    if (mirror_x) m[0] = -m[0], m[2] = -m[2];
    if (mirror_y) m[1] = -m[1], m[3] = -m[3];
    return transpose ? Vector4d(m.reverse()) : m;
  }
};

struct ClusterBox {
  Vector2i low, size;
};

ClusterBox box_of(const CellLattice& lattice, const DraftBonds& bonds, const std::vector<int>& cluster) {
  Vector2i low = lattice.point(bonds.first[cluster.front()]), high = low;
  for (const int b : cluster) {
    for (const int point : {bonds.first[b], bonds.second[b]}) {
      low = low.cwiseMin(lattice.point(point));
      high = high.cwiseMax(lattice.point(point));
    }
  }
  return {low, high - low};
}

class Finder {
 public:
  Finder(const CellLattice& lattice, const std::vector<Vector4d>& missing, const DraftBonds& bonds,
         const std::vector<std::vector<int>>& clusters)
      : lattice_(lattice), missing_(missing), bonds_(bonds), clusters_(clusters), place_(bonds.first.size(), -1) {
    for (std::size_t c = 0; c < clusters.size(); ++c) {
      boxes_.push_back(box_of(lattice, bonds, clusters[c]));
      for (std::size_t k = 0; k < clusters[c].size(); ++k) place_[clusters[c][k]] = static_cast<int>(k);
    }
    cluster_of_.assign(bonds.first.size(), -1);
    for (std::size_t c = 0; c < clusters.size(); ++c) {
      for (const int b : clusters[c]) cluster_of_[b] = static_cast<int>(c);
    }
  }

  // Image of the bonds of `cluster` under a symmetry that maps them to `original`, as positions in its list; empty if
  // no symmetry does.
  std::vector<int> image(int cluster, int original) const {
    if (clusters_[cluster].size() != clusters_[original].size()) return {};
    for (const bool transpose : {false, true}) {
      const Vector2i size = boxes_[cluster].size;
      if (boxes_[original].size != (transpose ? Vector2i(size.reverse()) : size)) continue;
      for (const bool x : {false, true}) {
        for (const bool y : {false, true}) {
          std::vector<int> found = image(cluster, original, {x, y, transpose});
          if (!found.empty()) return found;
        }
      }
    }
    return {};
  }

 private:
  std::vector<int> image(int cluster, int original, const Symmetry& symmetry) const {
    const auto point_image = [&](int point) {
      const Vector2i p = lattice_.point(point) - boxes_[cluster].low;
      return lattice_.find_point(boxes_[original].low + symmetry.apply(p, boxes_[cluster].size));
    };
    std::vector<int> found;
    found.reserve(clusters_[cluster].size());
    for (const int b : clusters_[cluster]) {
      const int first = point_image(bonds_.first[b]), second = point_image(bonds_.second[b]);
      const int other = first < 0 || second < 0 ? -1 : find_bond(bonds_, first, second);
      if (other < 0 || cluster_of_[other] != original) return {};
      if (std::abs(bonds_.stiffness[other] - bonds_.stiffness[b]) > same_lack) return {};
      for (const auto& [point, at] : {std::pair{bonds_.first[b], first}, std::pair{bonds_.second[b], second}}) {
        const Vector4d difference = symmetry.apply(missing_[point]) - missing_[at];
        if (difference.lpNorm<Eigen::Infinity>() > same_lack) return {};
      }
      found.push_back(place_[other]);
    }
    return found;
  }

  const CellLattice& lattice_;
  const std::vector<Vector4d>& missing_;
  const DraftBonds& bonds_;
  const std::vector<std::vector<int>>& clusters_;
  std::vector<ClusterBox> boxes_;
  std::vector<int> place_, cluster_of_;  // per bond
};

}  // namespace

CongruentClusters find_congruent(const CellLattice& lattice, const std::vector<Vector4d>& missing,
                                 const DraftBonds& bonds, const std::vector<std::vector<int>>& clusters) {
  const Finder finder(lattice, missing, bonds, clusters);
  CongruentClusters result;
  for (int c = 0; c < static_cast<int>(clusters.size()); ++c) {
    CongruentClusters::Image image{c, {}};
    for (const int original : result.originals) {
      check_cancelled();
      image.bonds = finder.image(c, original);
      if (image.bonds.empty()) continue;
      image.original = original;
      break;
    }
    if (image.original == c) result.originals.push_back(c);
    result.images.push_back(std::move(image));
  }
  return result;
}

int find_bond(const DraftBonds& bonds, int first, int second) {
  if (first > second) std::swap(first, second);
  const int begin = bonds.start[first], end = bonds.start[first + 1];
  const auto at =
      std::lower_bound(bonds.second.begin() + begin, bonds.second.begin() + end, second) - bonds.second.begin();
  return at < end && bonds.second[at] == second ? static_cast<int>(at) : -1;
}

}  // namespace bempd::pd
