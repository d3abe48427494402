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

// Stiffness templates shared by all bodies with one horizon ratio and one kernel; they do not depend on the material.
// Bonds beside straight faces along lattice rows have these stiffnesses, and only those around corners are balanced for
// each body. A builder without templates, as for other outlines, finds the same bonds, but the smallest stiffness falls
// from 0.4 of the bulk's to 0.02 to 0.25, and large bodies take 2 to 6 times as long (benchmarks/run.sh outlines).
struct LatticeTemplates {
  std::vector<BondOffset> family;
  FaceTemplate face;                 // one face, rows 0 .. m - 1; deeper bonds keep the bulk stiffness
  std::vector<FaceTemplate> strips;  // strips[n] for two faces n cells apart, 2 <= n < 2 m
  double residual = 0;               // largest error of the equations that define the templates

  // Ratio of a bond's stiffness to the bulk value. `below` and `above` are the numbers of cells between the bond's ends
  // and the faces beyond them; the bond steps `across` along the faces and `away` from one to the other.
  double ratio(int below, int above, int across, int away) const;
  int horizon_ratio = 0;
};

// Templates for a horizon ratio, 3 <= horizon_ratio <= 8. They are computed on first use and kept; several threads may
// call this.
const LatticeTemplates& lattice_templates(int horizon_ratio, const BondKernel& kernel = quartic_kernel());

}  // namespace bempd::pd
