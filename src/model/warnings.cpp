#include <algorithm>
#include <cmath>

#include "fracture/resistance.hpp"
#include "linalg/blas.hpp"
#include "model/explanation.hpp"
#include "model/model.hpp"
#include "model/scene_advice.hpp"

// Warnings and other messages for the log.
namespace bempd::model {

namespace {

// Reciprocal condition number at which three or four digits of the displacements are left.
constexpr double poor_condition = 1e-12;

// Residual above which a warning is logged. Bent strips of 400 : 1 have it, with errors of 1e-5 in reactions.
constexpr double poor_residual = 1e-8;

// Number of unknowns above which the speed of the BLAS matters.
constexpr std::int64_t unknowns_that_need_a_fast_blas = 5000;

}  // namespace

void Model::log(int level, const std::string& message) const {
  if (log_) log_(level, names_.in(message));
}

void Model::tell_of_preparation() const {
  for (const std::string& warning : prepared_->discretization.warnings) log(1, warning);
  if (log_) {
    const Advice advice = advice_on(scene_, prepared_->discretization);
    for (const std::string& warning : advice.warnings) log(1, warning);
    for (const std::string& fact : advice.facts) log(2, fact);
  }
  const regions::RegionStatistics sizes = prepared_->discretization.statistics();
  if (sizes.subdomains > 0)
    log(2, text("large BEM regions are cut into ", sizes.subdomains, " subdomains with ", sizes.cut_nodes,
                " nodes on the cuts"));
  log(2, text("prepared: ", prepared_->discretization.positions.size(), " nodes, ",
              prepared_->system->terms().bond_count(), " bonds, ", prepared_->cut_bonds.size(),
              " of them cut by initial cracks"));
  if (log_ && prepared_->system->counters().sparse_unknowns > unknowns_that_need_a_fast_blas) warn_of_blas();
}

void Model::warn_of_blas() const {
  const linalg::Blas blas = linalg::running_blas();
  log(3, "matrices are multiplied by " + linalg::describe(blas));
  if (!linalg::processor_has_avx2() || !linalg::is_before_avx2(blas.core)) return;
  log(1, text("the BLAS takes the processor for an older one, ", blas.core,
              ", and computes at half its rate or less; use another BLAS, or name the kind to it (OpenBLAS reads "
              "OPENBLAS_CORETYPE, for instance Haswell)"));
}

void Model::warn_of_equilibrium() {
  warn_of_condition();
  warn_of_held_parts();
  warn_of_overlap();
}

void Model::warn_of_condition() {
  if (warned_of_condition_) return;
  const double residual = prepared_->evolution->progress().residual;
  if (residual > poor_residual) {
    warned_of_condition_ = true;
    log(1, text("forces are out of balance by ", residual,
                " of the largest one: reactions of parts that are very slender or hardly supported lose digits"));
    return;
  }
  const double condition = prepared_->system->counters().reciprocal_condition;
  if (condition >= poor_condition) return;
  warned_of_condition_ = true;
  log(1, text("the equations are badly conditioned: about ", static_cast<int>(std::lround(-std::log10(condition))),
              " digits of the displacement are lost; look for parts that are very slender or hardly supported"));
}

void Model::warn_of_held_parts() {
  constexpr std::size_t most_named = 4;
  std::vector<int> held = prepared_->evolution->take_held();
  std::sort(held.begin(), held.end());
  held.erase(std::unique(held.begin(), held.end()), held.end());
  if (held.empty()) return;
  std::string places;
  for (std::size_t i = 0; i < std::min(held.size(), most_named); ++i) {
    const Point& place = prepared_->discretization.positions[held[i]];
    const int crack = scene_.crack_nearest(place);
    places += text(i == 0 ? "" : ", ", "(", place.x(), ", ", place.y(), ")");
    if (crack > 0) places += text(" by initial crack ", crack);
  }
  if (held.size() > most_named) places += text(" and at ", held.size() - most_named, " places more");
  // The report tells of a body that has come apart, whose parts are expected to move freely.
  const int level = prepared_->evolution->progress().separated ? 2 : 1;
  log(level,
      "parts can move freely, cut off or left hanging on a hinge, at " + places + "; they are held where they are");
}

void Model::warn_of_interface() {
  if (warned_of_interface_) return;
  const std::optional<int> node = prepared_->interface_bonds->reached();
  if (!node) return;
  warned_of_interface_ = true;
  const Point& place = prepared_->discretization.positions[*node];
  // A lattice point that is tied to boundary elements belongs to the lattice alone.
  const std::string regions = prepared_->discretization.regions_with({*node});
  const char* const meet = regions.starts_with("regions") ? " meet" : " meets boundary elements";
  log(1, text("bonds have broken where ", regions, meet, ", at (", place.x(), ", ", place.y(),
              "): a crack cannot go on into a boundary element region and runs along it; give the "
              "peridynamic region more room there if it should go on"));
}

// Logs that the body counts as separated although a hinge remains. The bond with the largest force belongs to the hinge
// and gives its place.
void Model::tell_of_hinge() {
  fracture::CrackEvolution& evolution = *prepared_->evolution;
  const fracture::EvolutionState& state = evolution.state();
  const coupling::Terms& terms = prepared_->system->terms();
  double largest = -1;
  std::size_t place = 0;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const double force = prepared_->system->present_stiffness()[t] *
                         terms.elastic_elongation(t, state.total_displacement.data(), state.load_factor);
    if (std::abs(force) <= largest) continue;
    largest = std::abs(force);
    place = t;
  }
  const Point& at = prepared_->discretization.positions[static_cast<std::size_t>(terms.first[place])];
  log(1, text("separated but for a hinge: bonds near (", at.x(), ", ", at.y(), ") bear ",
              state.resistance.present / state.resistance.peak,
              " of the largest force so far, less than the option stepping.separation_share"));
}

void Model::tell_of_growth(const fracture::Growth& growth, const PreparedScene& before) const {
  const std::vector<std::string>& told = before.discretization.warnings;
  for (const std::string& warning : prepared_->discretization.warnings)
    if (std::find(told.begin(), told.end(), warning) == told.end()) log(1, warning);
  for (const fracture::CrackExtension& e : growth.extensions) {
    log(2, text("load factor ", e.load_factor, ": crack ", e.crack, " has grown by ", e.length, " to (", e.x, ", ", e.y,
                ")"));
    if (e.state == crack::TipState::at_interface)
      log(1, text("crack ", e.crack, " has stopped at (", e.x, ", ", e.y,
                  "), before an interface of its region with another material, across which it cannot go on"));
  }
}

// Logs once that windows save less time in this run: tips with elements need the displacements of the whole body at
// each event.
void Model::tell_of_whole_body() {
  if (told_of_whole_body_ || prepared_->system->terms().size() == 0) return;
  told_of_whole_body_ = true;
  log(2,
      "cracks of boundary element regions grow beside lattices: each event in a window takes the displacements of the "
      "whole body");
}

void Model::tell_of_step(const StepResult& result, std::int64_t new_fragments, bool upwards) {
  const fracture::CrackEvolution& evolution = *prepared_->evolution;
  log(2, text("load factor ", evolution.progress().load_factor, ": ", result.events, " events, ", result.broken_bonds,
              " bonds broken"));
  if (!warned_of_energies_ && evolution.energies_are_lost()) {
    warned_of_energies_ = true;
    log(1,
        "energies are too large or too small for a number; displacements, stresses and forces are right, energies "
        "and their balance are not; choose other units");
  }
  warn_of_equilibrium();
  if (result.broken_bonds > 0) warn_of_interface();
  const fracture::EvolutionState& state = evolution.progress();
  // A body of boundary elements alone has no bonds that could form a hinge.
  const bool has_bonds = prepared_->system->terms().size() > 0;
  if (log_ && has_bonds && !warned_of_hinge_ && state.separated && fracture::hangs(state.resistance)) {
    warned_of_hinge_ = true;
    tell_of_hinge();
  }
  if (log_ && result.reason == fracture::StopReason::no_further_event)
    log(state.events == 0 ? 1 : 2, explain(*this, upwards).text);
  if (new_fragments > 0)
    log(1, text(new_fragments, " pieces have come free of all supports; they stay where they are"));
}

}  // namespace bempd::model
