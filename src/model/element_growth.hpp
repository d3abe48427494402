#pragma once

#include <optional>
#include <vector>

#include "crack/carrier.hpp"
#include "fracture/crack_evolution.hpp"
#include "model/answers.hpp"
#include "regions/region.hpp"
#include "scene/options.hpp"
#include "scene/scene.hpp"

// Growth of cracks with boundary elements: choice of tips, lengths of extensions, and energies.
namespace bempd::model {

// Tips that grow together at a load factor, each with its extension and the length that it is to have.
struct Growing {
  double load_factor = 0;
  double ratio = 1;                 // of the first tip: equivalent factor over toughness
  double critical_load_factor = 0;  // at which that tip just reaches its toughness
  int ties = 0;                     // others that would have grown as soon
  // Whether the tips grow because the load brings them to their toughness. If not, another process (as fatigue) makes
  // them grow below it, and all energy that is released counts as taken by that process.
  bool is_driven = true;
  std::vector<regions::TipValues> tips;
  std::vector<fracture::CrackExtension> extensions;
  std::vector<double> lengths;

  bool is_in_equilibrium() const { return ratio <= 1 + fracture::ratio_rounding; }
};

crack::AffineFactors factors_of(const regions::TipValues& tip);
crack::GrowthLaw law_of(const regions::TipValues& tip, const scene::Options& options);
// Tip with known stress intensity factors as a carrier of cracks (crack::Carrier) describes it.
crack::Tip tip_for_carrier(const regions::TipValues& tip, const scene::Options& options);

// Computes the results of the growth criterion in force for a tip with known stress intensity factors.
void complete(regions::TipValues& tip, const scene::Options& options);

// Growth of the tip with the index `first`, and of the tips that the option crack.tie_share lets grow with it.
Growing growing_with(const std::vector<regions::TipValues>& tips, std::size_t first, double load_factor,
                     const scene::Options& options);

// Sets the lengths of the extensions: `length` times (equivalent K_I / toughness)^(2 m) for each tip, where m is the
// option crack.exponent.
void set_lengths(Growing& growing, double length, const scene::Options& options);

// Length of the extensions [m]: the option crack.step, or else a share of the crack's length and of the distance to the
// nearest obstacle.
double chosen_length(const scene::Scene& scene, const Growing& growing, const scene::Options& options);

// Copies of the cracks with the extensions added. The extensions in `growing` get their end points, lengths and states.
std::vector<scene::Crack> extended(const scene::Scene& scene, std::vector<scene::Crack> cracks, double tolerance,
                                   Growing& growing);

// Largest angle [rad] by which a crack would turn at the end of its extension; `after` are the tips of the extended
// cracks. Tips whose fracture energy depends on the direction do not count: their turns are kinks, not a curved path.
double largest_turn(const Growing& growing, const std::vector<regions::TipValues>& after,
                    const scene::Options& options);

// Turns extensions so that they become chords of curved paths: by half of the angle by which the crack would turn at
// its end.
void turn_to_chords(Growing& growing, const std::vector<regions::TipValues>& after, const scene::Options& options);

// Load factor of the equilibrium path after growth that began in equilibrium; empty if it began out of equilibrium, or
// is not known because a tip has ended.
std::optional<double> end_of_path(const Growing& growing, const std::vector<regions::TipValues>& after,
                                  const scene::Options& options);

// Record of a growth with the energies of its extensions. `thickness` is given by extension, `released` is the energy
// released at constant loads. `beyond_path` is the part of that which exceeds the release along the equilibrium path;
// empty if that is not known.
fracture::Growth with_energies(Growing growing, const std::vector<regions::TipValues>& after,
                               const std::vector<double>& thickness, double released,
                               std::optional<double> beyond_path);

// Summary of a growth for the host, without the energy released.
GrowthResult result_of(const fracture::Growth& growth);

// Whether the end of a crack has stopped, before an interface or because it cannot grow.
bool has_stopped(const crack::TipId& tip, const fracture::EvolutionState& state);

}  // namespace bempd::model
