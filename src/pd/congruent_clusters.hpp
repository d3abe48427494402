#pragma once

#include <Eigen/Core>
#include <vector>

#include "pd/corners.hpp"

namespace bempd::pd {

// Clusters of bonds that are images of each other under a symmetry of the square lattice, and whose points have missing
// moments (corners.hpp) that are images, too. The least changes of their stiffnesses are then images as well, so that
// one solution serves them all.
struct CongruentClusters {
  struct Image {
    int original;            // the cluster to solve; itself for an original
    std::vector<int> bonds;  // per bond of the cluster: position of its image in the original; empty for an original
  };
  std::vector<Image> images;   // per cluster
  std::vector<int> originals;  // clusters to solve
};

CongruentClusters find_congruent(const CellLattice& lattice, const std::vector<Eigen::Vector4d>& missing,
                                 const DraftBonds& bonds, const std::vector<std::vector<int>>& clusters);

// Index of the bond between two points, -1 if there is none.
int find_bond(const DraftBonds& bonds, int first, int second);

}  // namespace bempd::pd
