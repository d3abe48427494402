#include <algorithm>
#include <cmath>

#include "crack/growth_law.hpp"
#include "elasticity/griffith.hpp"
#include "elasticity/kinked_tip.hpp"
#include "error.hpp"
#include "model/growth_options.hpp"
#include "model/model.hpp"
#include "number_range.hpp"
#include "regions/tips/lattice_pictures.hpp"
#include "regions/tips/lattice_tips.hpp"

namespace bempd::model {

namespace {

// Load factors and angle at which a tip with known factors grows by a criterion.
void complete(regions::TipValues& tip, KinkCriterion criterion) {
  if (!tip.factors.allFinite() || !tip.constant_factors.allFinite() || !tip.proportional_factors.allFinite()) return;
  const crack::AffineFactors factors{tip.constant_factors, tip.proportional_factors};
  const crack::GrowthRange range = crack::growth_range(factors, tip.toughness, criterion);
  tip.kink_angle = kink_of(tip.factors, criterion).angle;
  tip.critical_load_factor = in_range(range.highest);
  tip.critical_load_factor_down = in_range(range.lowest);
  if (std::isfinite(range.highest)) tip.critical_kink_angle = kink_of(factors.at(range.highest), criterion).angle;
  tip.straight_load_factor = straight_load_factor(factors.constant, factors.proportional, tip.toughness);
}

}  // namespace

regions::BondedBody Model::bonded_body() const {
  const coupling::EquilibriumSystem& system = *prepared_->system;
  return {scene_,
          prepared_->discretization,
          system.terms(),
          system.present_stiffness(),
          system.intact(),
          prepared_->cut_bonds,
          pressures_of(prepared_->conditions)};
}

std::vector<regions::TipValues> Model::tips_of(const PreparedScene& prepared, regions::TipDetail detail) const {
  std::vector<regions::TipValues> tips;
  for (const auto& region : prepared.discretization.regions) {
    const std::vector<regions::TipValues> found = region->tips(solution_of(prepared), detail);
    tips.insert(tips.end(), found.begin(), found.end());
  }
  for (regions::TipValues& tip : tips) complete(tip, growth_criterion(options_));
  // By crack, its first point first.
  std::stable_sort(tips.begin(), tips.end(), [](const regions::TipValues& a, const regions::TipValues& b) {
    return std::pair(a.crack, a.end) < std::pair(b.crack, b.end);
  });
  return tips;
}

std::vector<regions::TipValues> Model::compute_tips() const {
  std::vector<regions::TipValues> all = tips_of(*prepared_, regions::TipDetail::everything);
  std::vector<regions::TipValues> in_lattices = regions::lattice_tips(bonded_body(), solution(), options_);
  for (regions::TipValues& tip : in_lattices) complete(tip, growth_criterion(options_));
  all.insert(all.end(), in_lattices.begin(), in_lattices.end());
  return all;
}

const std::vector<regions::TipValues>& Model::tips() {
  ensure_equilibrium();
  if (tips_generation_ == generation_) return tips_;
  tips_ = compute_tips();
  tips_generation_ = generation_;
  return tips_;
}

std::vector<regions::CrackPicture> Model::crack_pictures() const {
  std::vector<regions::CrackPicture> cracks;
  for (const auto& region : prepared_->discretization.regions) {
    const auto pictures = region->crack_pictures(solution());
    cracks.insert(cracks.end(), pictures.begin(), pictures.end());
  }
  const auto in_lattices = regions::lattice_crack_pictures(bonded_body(), solution().displacement);
  cracks.insert(cracks.end(), in_lattices.begin(), in_lattices.end());
  return cracks;
}

std::vector<Point> Model::crack_openings(int crack, const std::vector<double>& fractions) {
  scene_.crack(crack);
  for (const double fraction : fractions)
    require(fraction >= 0 && fraction <= 1, "a fraction of the crack's length is ", fraction,
            "; it must lie between 0 and 1");
  prepare();
  const int region = prepared_->discretization.crack_regions[static_cast<std::size_t>(crack) - 1];
  require(region > 0, "crack ", crack,
          " lies in a peridynamic region, where it has no opening of its own; ask for "
          "displacements on both sides of it");
  ensure_equilibrium();
  return this->region(region).crack_openings(crack, fractions, solution());
}

bool Model::has_crack_elements() const {
  const std::vector<int>& regions = prepared_->discretization.crack_regions;
  return std::any_of(regions.begin(), regions.end(), [](int region) { return region > 0; });
}

void Model::warn_of_overlap() {
  if (warned_of_overlap_ || !log_ || !has_crack_elements()) return;
  for (const auto& region : prepared_->discretization.regions) {
    const auto overlap = region->overlap(solution());
    if (!overlap) continue;
    warned_of_overlap_ = true;
    log(1, text("the faces of crack ", overlap->crack, " overlap by ", overlap->depth, " at (", overlap->place.x(),
                ", ", overlap->place.y(), "): they do not know contact; what closes a crack makes its results wrong"));
  }
}

}  // namespace bempd::model
