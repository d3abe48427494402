#pragma once

#include <vector>

#include "crack/carrier.hpp"
#include "fracture/line/growing_tip.hpp"
#include "fracture/line/tip_stress.hpp"
#include "fracture/loaded_body.hpp"

namespace bempd::fracture {

// Fields around the tips of crack lines (cracks that grow in a lattice by steps): stress intensity factors, and other
// data for the growth. The laws of the tips give the material data. Displacements need to be known around the tips
// only.
class TipFields {
 public:
  TipFields(LoadedBody& body, const pd::TipLaws& laws)
      : body_(body), laws_(laws), stress_(body.system(), body.positions(), laws) {}

  const pd::TipLaws& laws() const { return laws_; }
  const pd::TipLaw& law_of(const GrowingTip& tip) const { return laws_.laws[static_cast<std::size_t>(tip.law)]; }
  // Growth law of a tip at a place. `there` is the tip law (data of lattice and material) with the toughness at that
  // place.
  crack::GrowthLaw growth_law(const GrowingTip& tip, const Point& place) const {
    return growth_law(law_of(tip).at(place, tip.grown), tip, place);
  }
  crack::GrowthLaw growth_law(const pd::TipLaw& there, const GrowingTip& tip, const Point& place) const;
  const TipStress& stress() const { return stress_; }
  // Fit of Williams' series to the stresses ahead of a tip, whose crack may bear a fluid pressure.
  WilliamsFit fitted(const GrowingTip& tip, const pd::TipLaw& law, const coupling::Affine& displacement) const {
    return stress_.fitted(tip, law, displacement, body_.loads().pressure_in(tip.id.crack));
  }

  // Stress intensity factors of a tip as affine functions of the load factor.
  AffineIntensity intensity_at(const GrowingTip& tip, const coupling::Affine& displacement) const;
  // Stress intensity factors of a tip from a fit, corrected by TipStress::corrected_factors(). If the tip is shut (its
  // faces press on each other) and the tip laws take load factors from energies, K_I is 0.
  AffineIntensity intensity_of(const GrowingTip& tip, const WilliamsFit& fit) const;
  // Stress intensity factors that give the load factor of growth: intensity_of() if the tip is shut and the tip laws
  // take load factors from energies, else TipStress::factors_for_load().
  AffineIntensity intensity_for_load(const GrowingTip& tip, const WilliamsFit& fit) const;
  // Stress intensity factors that give the turn of a tip whose crack has begun during the run; 0 (no turn) if the
  // stress ahead is only rounding.
  AffineIntensity factors_for_turn(const GrowingTip& tip, const AffineIntensity& by_fit,
                                   const coupling::Affine& displacement, double present) const;
  // T-stress of a tip, constant and proportional part [Pa].
  Point t_stress_at(const GrowingTip& tip, const coupling::Affine& displacement) const {
    return fitted(tip, law_of(tip), displacement).t_stress();
  }
  // Angle by which a tip that grows at a load factor turns, counter-clockwise [rad].
  double kink_at(const GrowingTip& tip, const coupling::Affine& displacement, double load_factor) const;

  // Whether the faces of a crack press on each other near a tip.
  bool faces_press_at(const GrowingTip& tip) const;
  // Whether a tip is shut: the crack faces press on each other, and the fit of stresses has K_I <= 0.
  bool is_shut(const GrowingTip& tip, const WilliamsFit& fit) const;
  // Whether a tip is shut, by a fit of stresses for these displacements.
  bool is_closed(const GrowingTip& tip, const coupling::Affine& displacement) const;
  // Whether the crack of a tip has begun during the run.
  bool has_begun(const GrowingTip& tip) const;

  // Nodes whose displacements are needed for the fields of some tips, each once.
  std::vector<int> nodes_asked(const std::vector<GrowingTip>& tips) const;

 private:
  LoadedBody& body_;
  const pd::TipLaws& laws_;
  TipStress stress_;
};

}  // namespace bempd::fracture
