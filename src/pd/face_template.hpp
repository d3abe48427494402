#pragma once

#include <vector>

#include "pd/bond_family.hpp"

namespace bempd::pd {

// Stiffnesses of bonds next to straight faces, as multiples of the bulk stiffness, with which a half plane or a strip
// of material points reproduces linear displacement fields up to its faces. A bond is identified by the depth `row` of
// its end nearer to the face, and by its step across (>= 0) and away from the face (>= 0).
class FaceTemplate {
 public:
  FaceTemplate() = default;
  FaceTemplate(int horizon_ratio, int rows)
      : horizon_ratio_(horizon_ratio), ratio_(static_cast<std::size_t>(rows) * horizon_ratio * horizon_ratio, 1.0) {}

  double& ratio(int row, int across, int away) { return ratio_[index(row, across, away)]; }
  double ratio(int row, int across, int away) const { return ratio_[index(row, across, away)]; }

 private:
  std::size_t index(int row, int across, int away) const {
    return (static_cast<std::size_t>(row) * horizon_ratio_ + across) * horizon_ratio_ + away;
  }
  int horizon_ratio_ = 0;
  std::vector<double> ratio_;
};

// Stiffness templates shared by all bodies with one horizon ratio and one kernel; templates do not depend on the
// material. Bonds beside straight faces along lattice rows have the stiffnesses of a template, and only bonds around
// corners are balanced for each body. Without templates the smallest stiffness would be 0.02 to 0.25 of the bulk
// stiffness in place of 0.4, and large bodies would take 2 to 6 times as long to build (benchmarks/run.sh outlines).
struct LatticeTemplates {
  std::vector<BondOffset> family;
  FaceTemplate face;                 // one face, rows 0 .. m - 1; deeper bonds keep the bulk stiffness
  std::vector<FaceTemplate> strips;  // strips[n] for two faces n cells apart, 2 <= n < 2 m
  double residual = 0;               // largest error of the equations that define the templates

  // Ratio of a bond's stiffness to its bulk stiffness. `below` is the number of cells between the bond's lower end and
  // the face below, `above` that between its upper end and the face above. The bond spans `across` cells along the
  // faces and `away` cells from one face towards the other.
  double ratio(int below, int above, int across, int away) const;
  int horizon_ratio = 0;
};

// Templates for a horizon ratio, 3 <= horizon_ratio <= 8. They are computed on first use and kept; several threads may
// call this.
const LatticeTemplates& lattice_templates(int horizon_ratio, const BondKernel& kernel = quartic_kernel());

}  // namespace bempd::pd
