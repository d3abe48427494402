#pragma once

#include <optional>
#include <vector>

#include "crack/carrier.hpp"
#include "fracture/crack_evolution.hpp"
#include "model/answers.hpp"
#include "regions/tip_values.hpp"
#include "scene/options.hpp"
#include "scene/scene.hpp"

// Growth of cracks with boundary elements: choice of tips, lengths of extensions, and energies.
namespace bempd::model {

// Tips that grow together at a load factor, each with its extension and the length that the extension is to have.
struct Growing {
  double load_factor = 0;
  double ratio = 1;                 // equivalent factor over toughness of the first tip
  double critical_load_factor = 0;  // load factor at which the first tip just reaches its toughness
  int ties = 0;                     // number of other tips that would have grown as soon
  // Whether the load brings the tips to their toughness. If not, another process such as fatigue makes them grow below
  // their toughness, and takes all energy that is released.
  bool is_driven = true;
  std::vector<regions::TipValues> tips;
  std::vector<fracture::CrackExtension> extensions;
  std::vector<double> lengths;

  bool is_in_equilibrium() const { return ratio <= 1 + fracture::ratio_rounding; }
};

crack::AffineFactors factors_of(const regions::TipValues& tip);
crack::GrowthLaw law_of(const regions::TipValues& tip, const scene::Options& options);
// Tip in the form that carriers of cracks use (crack::Carrier), from known stress intensity factors.
crack::Tip tip_for_carrier(const regions::TipValues& tip, const scene::Options& options);

// Computes the load factors at which a tip with known stress intensity factors grows, and its kink angles, by the
// growth criterion that the options name.
void complete(regions::TipValues& tip, const scene::Options& options);

// Growth of the tip with the index `first`, and of the tips that the option crack.tie_share lets grow together with
// that tip.
Growing growing_with(const std::vector<regions::TipValues>& tips, std::size_t first, double load_factor,
                     const scene::Options& options);

// Sets the length of each extension: `length` times (equivalent K_I / toughness)^(2 m), where m is the option
// crack.exponent.
void set_lengths(Growing& growing, double length, const scene::Options& options);

// Length of the extensions [m]: the option crack.step or, if that is 0, the smallest length over all growing tips. Each
// tip's length is a share of its crack's length, or of the distance to the nearest edge, hole or crack if that is less.
double chosen_length(const scene::Scene& scene, const Growing& growing, const scene::Options& options);

// Copies of the cracks with the extensions of `growing` added. These extensions get their end points, lengths and
// states.
std::vector<scene::Crack> extended(const scene::Scene& scene, std::vector<scene::Crack> cracks, double tolerance,
                                   Growing& growing);

// Largest angle [rad] by which a crack would turn at the end of its extension; `after` are the tips of the extended
// cracks. Tips whose fracture energy depends on the direction do not count: their turns are kinks, not a curved path.
double largest_turn(const Growing& growing, const std::vector<regions::TipValues>& after,
                    const scene::Options& options);

// Turns each extension by half of the angle by which the crack would turn at the extension's end, so that the extension
// is a chord of the curved path. Extensions whose tip has ended or has a fracture energy that depends on the direction
// keep their directions.
void turn_to_chords(Growing& growing, const std::vector<regions::TipValues>& after, const scene::Options& options);

// Load factor at which tips that have grown are in equilibrium again. Empty if the growth began out of equilibrium, or
// if the load factor is unknown because a tip has ended.
std::optional<double> end_of_path(const Growing& growing, const std::vector<regions::TipValues>& after,
                                  const scene::Options& options);

// Growth with the energies of its extensions. `thickness` is that of the body at each extension; `released` is the
// energy that the body releases at constant loads. `beyond_path` is the part of `released` that exceeds the release
// along the equilibrium path; empty if unknown.
fracture::Growth with_energies(Growing growing, const std::vector<regions::TipValues>& after,
                               const std::vector<double>& thickness, double released,
                               std::optional<double> beyond_path);

// Summary of a growth for the host, without the energy released.
GrowthResult result_of(const fracture::Growth& growth);

// Whether the tip of a crack has stopped, before an interface or because it cannot grow.
bool has_stopped(const crack::TipId& tip, const fracture::EvolutionState& state);

}  // namespace bempd::model
