#pragma once

#include <optional>
#include <vector>

#include "crack/carrier.hpp"
#include "fracture/crack_evolution.hpp"
#include "model/answers.hpp"
#include "regions/region.hpp"
#include "scene/options.hpp"
#include "scene/scene.hpp"

// Growth of cracks with boundary elements: which tips, by how much, and what that takes.
namespace bempd::model {

// The tips that grow at a load factor, each with its extension, and how long that is to be.
struct Growing {
  double load_factor = 0;
  double ratio = 1;                 // of the first tip: equivalent factor over toughness
  double critical_load_factor = 0;  // at which that tip just reaches its toughness
  int ties = 0;                     // others that would have grown as soon
  std::vector<regions::TipValues> tips;
  std::vector<fracture::CrackExtension> extensions;
  std::vector<double> lengths;

  bool is_in_equilibrium() const { return ratio <= 1 + fracture::ratio_rounding; }
};

crack::AffineFactors factors_of(const regions::TipValues& tip);
crack::GrowthLaw law_of(const regions::TipValues& tip, const scene::Options& options);
// The tip of a carrier, with known factors.
crack::Tip carried(const regions::TipValues& tip, const scene::Options& options);

// The tip with this number, and with it those that the option crack.tie_share lets grow too.
Growing growing_with(const std::vector<regions::TipValues>& tips, std::size_t first, double load_factor,
                     const scene::Options& options);

// Every tip grows by this length, or by less as the option crack.exponent has it.
void set_lengths(Growing& growing, double length, const scene::Options& options);

// How far growing tips go at once: a share of the crack's length and of the way to what is near, or what the option
// crack.step says.
double chosen_length(const scene::Scene& scene, const Growing& growing, const scene::Options& options);

// The cracks with their extensions, which become known.
std::vector<scene::Crack> extended(const scene::Scene& scene, std::vector<scene::Crack> cracks, double tolerance,
                                   Growing& growing);

// Largest angle by which an extension's end would turn on.
double largest_turn(const Growing& growing, const std::vector<regions::TipValues>& after,
                    const scene::Options& options);

// Extensions become the chords of curved paths: each turns on by half of what its end would.
void turn_to_chords(Growing& growing, const std::vector<regions::TipValues>& after, const scene::Options& options);

// Load factor to which the path of equilibrium has come to after growth that began in equilibrium; nothing if it is not
// known, as where a tip has ended.
std::optional<double> end_of_path(const Growing& growing, const std::vector<regions::TipValues>& after,
                                  const scene::Options& options);

// What growth that released an energy at constant loads is in the books, some of that beyond the path of equilibrium:
// its extensions with their energies. `thickness` by extension.
fracture::Growth booked(Growing growing, const std::vector<regions::TipValues>& after,
                        const std::vector<double>& thickness, double released, std::optional<double> beyond_path);

// What such an event did, without the energy released.
GrowthResult result_of(const fracture::Growth& growth);

// The ends of cracks that have stopped before an interface.
bool has_stopped(const crack::TipId& tip, const fracture::EvolutionState& state);

}  // namespace bempd::model
