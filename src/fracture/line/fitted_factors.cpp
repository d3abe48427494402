#include <algorithm>

#include "fracture/line/tip_stress.hpp"

// Stress intensity factors of a tip, corrected from those that the fit of Williams' series gives.
namespace bempd::fracture {

namespace {

// Ratio of the K_II that a fit of Williams' series gives to the K_II that boundary elements give: measured as 1.06 to
// 1.11 on inclined cracks (docs/directions.md). Under shear the effective tip lies some 0.15 horizons farther ahead
// than under opening.
constexpr double shear_as_fitted = 1.08;
// Ratio of the K_II that a fit gives to the K_II by which a tip grows: away from surfaces (shear_for_load), and beside
// an edge, where stress points are nearer to the tip (shear_for_load_beside). The first ratio is smaller than
// shear_as_fitted, because under shear the effective tip really lies farther ahead. The second one is below 1, because
// beside an edge the K_I of the fit is too small as well. Both are measured on first loads of kinks of 10 to 70 degrees
// and of edge cracks at 20 to 70 degrees.
constexpr double shear_for_load = 1.03, shear_for_load_beside = 0.94;

}  // namespace

AffineIntensity TipStress::corrected_factors(AffineIntensity fitted) const {
  if (laws_.loads_by_energy) fitted.two /= shear_as_fitted;
  return fitted;
}

AffineIntensity TipStress::factors_for_load(const WilliamsFit& fit, double horizon) const {
  AffineIntensity found = fit.factors(horizon);
  const double away = (fit.reach() - outer_reach_beside) / (outer_reach - outer_reach_beside);
  if (laws_.loads_by_energy) found.two /= std::lerp(shear_for_load_beside, shear_for_load, std::clamp(away, 0.0, 1.0));
  return found;
}

}  // namespace bempd::fracture
