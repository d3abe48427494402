#include <algorithm>
#include <cmath>
#include <utility>

#include "fracture/resistance.hpp"
#include "linalg/blas.hpp"
#include "model/explanation.hpp"
#include "model/model.hpp"
#include "model/scene_advice.hpp"

// Warnings and other messages for the log.
namespace bempd::model {

namespace {

// Reciprocal condition number of the system of equations at which three or four digits of the displacements are left.
constexpr double poor_condition = 1e-12;

// Residual (largest force out of balance over the largest force) above which a warning is logged. Bent strips that are
// 400 times as long as wide reach this residual; their reactions have relative errors of 1e-5.
constexpr double poor_residual = 1e-8;

// Number of unknowns above which the speed of the BLAS matters.
constexpr std::int64_t unknowns_that_need_a_fast_blas = 5000;

}  // namespace

void RunReports::log(int level, const std::string& message) const {
  if (is_heard()) model_.host().log()(level, model_.names().in(message));
}

bool RunReports::is_heard() const { return static_cast<bool>(model_.host().log()); }

void RunReports::tell_of_preparation() const {
  for (const std::string& warning : model_.prepared().discretization.warnings) log(1, warning);
  if (is_heard()) {
    const Advice advice = advice_on(model_.scene(), model_.prepared().discretization);
    for (const std::string& warning : advice.warnings) log(1, warning);
    for (const std::string& fact : advice.facts) log(2, fact);
  }
  const regions::RegionStatistics sizes = model_.prepared().discretization.statistics();
  if (sizes.subdomains > 0)
    log(2, text("large BEM regions are cut into ", sizes.subdomains, " subdomains with ", sizes.cut_nodes,
                " nodes on the cuts"));
  log(2, text("prepared: ", model_.prepared().discretization.positions.size(), " nodes, ",
              model_.prepared().system->terms().bond_count(), " bonds, ", model_.prepared().cut_bonds.size(),
              " of them cut by initial cracks"));
  if (is_heard() && model_.prepared().system->counters().sparse_unknowns > unknowns_that_need_a_fast_blas)
    warn_of_blas();
}

void RunReports::warn_of_blas() const {
  const linalg::Blas blas = linalg::running_blas();
  log(3, "matrices are multiplied by " + linalg::describe(blas));
  if (!linalg::processor_has_avx2() || !linalg::is_before_avx2(blas.core)) return;
  log(1, text("the BLAS takes the processor for an older one, ", blas.core,
              ", and computes at half its rate or less; use another BLAS, or name the kind to it (OpenBLAS reads "
              "OPENBLAS_CORETYPE, for instance Haswell)"));
}

void RunReports::warn_of_equilibrium() {
  warn_of_condition();
  warn_of_held_parts();
  warn_of_overlap();
}

void RunReports::warn_of_condition() {
  if (warned_of_condition_) return;
  const double residual = model_.prepared().evolution->progress().residual;
  if (residual > poor_residual) {
    warned_of_condition_ = true;
    log(1, text("forces are out of balance by ", residual,
                " of the largest one: reactions of parts that are very slender or hardly supported lose digits"));
    return;
  }
  const double condition = model_.prepared().system->counters().reciprocal_condition;
  if (condition >= poor_condition) return;
  warned_of_condition_ = true;
  log(1, text("the equations are badly conditioned: about ", static_cast<int>(std::lround(-std::log10(condition))),
              " digits of the displacement are lost; look for parts that are very slender or hardly supported"));
}

void RunReports::warn_of_held_parts() {
  constexpr std::size_t most_named = 4;
  std::vector<int> held = model_.prepared().evolution->records().take_held();
  std::sort(held.begin(), held.end());
  held.erase(std::unique(held.begin(), held.end()), held.end());
  if (held.empty()) return;
  std::string places;
  std::vector<std::vector<Point>> cracks;
  for (const scene::Crack& crack : model_.scene().cracks()) cracks.push_back(crack.points);
  for (std::size_t i = 0; i < std::min(held.size(), most_named); ++i) {
    const Point& place = model_.prepared().discretization.positions[held[i]];
    const int crack = scene::crack_nearest(cracks, place);
    places += text(i == 0 ? "" : ", ", "(", place.x(), ", ", place.y(), ")");
    if (crack > 0) places += text(" by initial crack ", crack);
  }
  if (held.size() > most_named) places += text(" and at ", held.size() - most_named, " places more");
  // Free parts are expected in a body that has come apart, so that the message is information and no warning.
  const int level = model_.prepared().evolution->progress().separated ? 2 : 1;
  log(level,
      "parts can move freely, cut off or left hanging on a hinge, at " + places + "; they are held where they are");
}

void RunReports::warn_of_overlap() {
  if (warned_of_overlap_ || !is_heard() || !model_.cracks().have_elements()) return;
  for (const auto& region : model_.prepared().discretization.regions) {
    const regions::CrackElements* cracks = region->crack_elements();
    if (!cracks) continue;
    const auto overlap = cracks->overlap(solution_of(model_.prepared()));
    if (!overlap) continue;
    warned_of_overlap_ = true;
    log(1, text("the faces of crack ", overlap->crack, " overlap by ", overlap->depth, " at (", overlap->place.x(),
                ", ", overlap->place.y(), "): they do not know contact; what closes a crack makes its results wrong"));
  }
}

void RunReports::warn_of_interface() {
  if (warned_of_interface_) return;
  const std::optional<int> node = model_.prepared().interface_bonds->reached();
  if (!node) return;
  warned_of_interface_ = true;
  const Point& place = model_.prepared().discretization.positions[*node];
  // A lattice point that is tied to boundary elements belongs to the lattice alone.
  const std::string regions = model_.prepared().discretization.regions_with({*node});
  const char* const meet = regions.starts_with("regions") ? " meet" : " meets boundary elements";
  log(1, text("bonds have broken where ", regions, meet, ", at (", place.x(), ", ", place.y(),
              "): a crack cannot go on into a boundary element region and runs along it; give the "
              "peridynamic region more room there if it should go on"));
}

// Logs that the body counts as separated although a hinge remains. The bond with the largest force belongs to the hinge
// and gives the place of the hinge.
void RunReports::tell_of_hinge() {
  fracture::CrackEvolution& evolution = *model_.prepared().evolution;
  const fracture::EvolutionState& state = evolution.state();
  const coupling::Terms& terms = model_.prepared().system->terms();
  double largest = -1;
  std::size_t place = 0;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const double force = model_.prepared().system->stages().stiffness()[t] *
                         terms.elastic_elongation(t, state.total_displacement.data(), state.load_factor);
    if (std::abs(force) <= largest) continue;
    largest = std::abs(force);
    place = t;
  }
  const Point& at = model_.prepared().discretization.positions[static_cast<std::size_t>(terms.first[place])];
  log(1, text("separated but for a hinge: bonds near (", at.x(), ", ", at.y(), ") bear ",
              state.resistance.present / state.resistance.peak,
              " of the largest force so far, less than the option stepping.separation_share"));
}

void RunReports::tell_of_growth(const fracture::Growth& growth, const PreparedScene& before) const {
  const std::vector<std::string>& told = before.discretization.warnings;
  for (const std::string& warning : model_.prepared().discretization.warnings)
    if (std::find(told.begin(), told.end(), warning) == told.end()) log(1, warning);
  for (const fracture::CrackExtension& e : growth.extensions) {
    log(2, text("load factor ", e.load_factor, ": crack ", e.crack, " has grown by ", e.length, " to (", e.x, ", ", e.y,
                ")"));
    if (e.state == crack::TipState::at_interface)
      log(1, text("crack ", e.crack, " has stopped at (", e.x, ", ", e.y,
                  "), before an interface of its region with another material, across which it cannot go on"));
  }
}

void RunReports::tell_of_layout() const {
  const PreparedScene& now = model_.prepared();
  log(2, text("load factor ", now.evolution->progress().load_factor, ": lattice patches now have ",
              now.discretization.statistics().material_points, " material points; the stored energy changes by ",
              now.evolution->growth().stored_by_layout()));
}

void RunReports::warn_of_patch(const std::string& why) {
  if (!std::exchange(warned_of_patch_, true)) log(1, text("a lattice patch does not grow on: ", why));
}

void RunReports::warn_of_break(const Point& place) {
  if (std::exchange(warned_of_break_, true)) return;
  log(1, text("bonds have broken at (", place.x(), ", ", place.y(),
              "), within 2.5 horizons of boundary elements where their lattice patch has no room for more blocks; each "
              "event there ends its step, and loads are not those of a large lattice from here on: use a smaller "
              "spacing, or add the region with bempd_add_pd_region()"));
}

// Logs once that windows (regions around tips that are solved alone) save less time in this run: tips with elements
// need the displacements of the whole body at each event.
void RunReports::tell_of_whole_body() {
  if (told_of_whole_body_ || model_.prepared().system->terms().size() == 0) return;
  told_of_whole_body_ = true;
  log(2,
      "cracks of boundary element regions grow beside lattices: each event in a window takes the displacements of the "
      "whole body");
}

void RunReports::tell_of_step(const StepResult& result, std::int64_t new_fragments, bool upwards) {
  const fracture::CrackEvolution& evolution = *model_.prepared().evolution;
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
  const bool has_bonds = model_.prepared().system->terms().size() > 0;
  if (is_heard() && has_bonds && !warned_of_hinge_ && state.separated &&
      fracture::still_bears_force(state.resistance)) {
    warned_of_hinge_ = true;
    tell_of_hinge();
  }
  if (is_heard() && result.reason == fracture::StopReason::no_further_event)
    log(state.events == 0 ? 1 : 2, explain(model_, upwards).text);
  if (new_fragments > 0)
    log(1, text(new_fragments, " pieces have come free of all supports; they stay where they are"));
}

}  // namespace bempd::model
