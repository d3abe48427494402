#include "model/model.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/rigid_motion.hpp"
#include "error.hpp"
#include "fracture/connectivity.hpp"
#include "linalg/blas.hpp"
#include "model/stepping_options.hpp"
#include "regions/incompressible.hpp"
#include "regions/initial_cracks.hpp"
#include "regions/memory_limit.hpp"
#include "stopwatch.hpp"

namespace bempd::model {

namespace {

// Reciprocal condition that leaves displacements three or four digits.
constexpr double poor_condition = 1e-12;

// Bent strips of 400 : 1 come to it, with reactions that are off by 1e-5.
constexpr double poor_residual = 1e-8;

// Systems that take long enough for the rate of the BLAS to matter.
constexpr std::int64_t unknowns_that_need_a_fast_blas = 5000;

// Rounding in the ratio of a bond that just reaches its critical stretch.
constexpr double ratio_rounding = 1e-9;

// The first event for which the load had to be higher than what bonds could carry; 0 if there is none.
std::int64_t first_unstable(std::span<const fracture::HistoryEntry> lines) {
  const auto unstable = [](const fracture::HistoryEntry& h) { return h.stretch_ratio > 1 + ratio_rounding; };
  const auto found = std::find_if(lines.begin(), lines.end(), unstable);
  return found == lines.end() ? 0 : found->event;
}

// "region 2" or "regions 1 and 3": those that have any of the nodes.
std::string regions_with(const regions::Discretization& d, const std::vector<int>& nodes) {
  std::vector<char> member(d.positions.size(), 0);
  for (int node : nodes) member[node] = 1;
  std::vector<int> ids;
  for (const auto& region : d.regions) {
    const std::vector<int>& own = region->nodes();
    if (std::any_of(own.begin(), own.end(), [&](int node) { return member[node] != 0; })) ids.push_back(region->id());
  }
  std::string names = ids.size() > 1 ? "regions " : "region ";
  for (std::size_t i = 0; i < ids.size(); ++i) {
    names += (i == 0 ? "" : i + 1 == ids.size() ? " and " : ", ") + std::to_string(ids[i]);
  }
  return names;
}

}  // namespace

scene::Scene& Model::editable_scene() {
  if (prepared_) {
    fail(Failure::order,
         "the model is prepared and its scene can no longer change; add everything before the first step or result, or "
         "create a new model");
  }
  return scene_;
}

void Model::call_failed(bool was_prepared, bool unsolvable) noexcept {
  if (!prepared_) return;
  const fracture::EvolutionState& state = prepared_->evolution->progress();
  const bool has_begun = state.in_equilibrium || !state.history.empty() || state.load_factor != 0;
  if (was_prepared && (has_begun || !unsolvable)) return;
  prepared_.reset();
  fields_ = {};
  ++generation_;
}

void Model::log(int level, const std::string& message) const {
  if (log_) log_(level, message);
}

void Model::check_mechanism(const PreparedScene& p) const {
  const std::vector<Point>& positions = p.discretization.positions;
  for (const std::vector<int>& nodes : fracture::Connectivity(*p.system).pieces()) {
    std::vector<coupling::HeldDirection> held;
    for (int node : nodes) {
      if (p.conditions.prescribed[2 * node]) held.push_back({node, 1, 0});
      if (p.conditions.prescribed[2 * node + 1]) held.push_back({node, 0, 1});
    }
    const coupling::RigidMotion motion(positions, nodes, held);
    if (motion.free_count() == 0) continue;
    fail(Failure::unsolvable, regions_with(p.discretization, nodes), " can ", motion.describe(),
         "; add supports that prevent this, for example with bempd_fix_point()");
  }
}

void Model::prepare() {
  if (prepared_) return;
  if (scene_.region_ids().empty()) fail(Failure::order, "the scene has no region; add one first");
  regions::require_memory(scene_, options_);
  prepared_ = build();
  ++generation_;
  for (const std::string& warning : prepared_->discretization.warnings) log(1, warning);
  log(2, text("prepared: ", prepared_->discretization.positions.size(), " nodes, ", prepared_->system->terms().size(),
              " bonds, ", prepared_->cut_bonds.size(), " of them cut by initial cracks"));
  if (log_ && prepared_->system->counters().sparse_unknowns > unknowns_that_need_a_fast_blas) warn_of_blas();
}

std::unique_ptr<PreparedScene> Model::build() const {
  auto p = std::make_unique<PreparedScene>();
  p->fingerprint = fingerprint(scene_, options_);
  p->discretization = regions::discretize(scene_, options_, prepared_ ? &prepared_->discretization : nullptr);
  regions::Discretization& d = p->discretization;
  p->conditions = regions::apply_conditions(scene_, d);
  regions::require_determined_pressure(d, p->conditions.prescribed);
  p->cut_bonds = regions::bonds_cut_by_cracks(scene_, d, d.warnings);
  p->system = std::make_unique<coupling::EquilibriumSystem>(static_cast<int>(d.positions.size()), d.dense_operators(),
                                                            std::move(d.bonds), p->conditions.prescribed, d.ties);
  p->system->note_condition(regions::condition_of_held_pressure(scene_, d, p->conditions.prescribed, d.warnings));
  check_mechanism(*p);
  p->evolution = std::make_unique<fracture::CrackEvolution>(*p->system, d.positions, d.critical_stretch, p->cut_bonds,
                                                            p->conditions.reaction_dofs);
  p->evolution->set_load(p->conditions.force, p->conditions.displacement, p->conditions.work_within);
  p->interface_bonds.emplace(*p->system, d.positions);
  return p;
}

const PreparedScene& Model::prepared() {
  prepare();
  return *prepared_;
}

void Model::ensure_equilibrium() {
  prepare();
  fracture::CrackEvolution& evolution = *prepared_->evolution;
  if (evolution.progress().in_equilibrium) return;
  evolution.find_equilibrium();
  warn_of_equilibrium();
  if (evolution.progress().fragments > 0) {
    log(1,
        text(evolution.progress().fragments, " pieces are cut off from all supports by initial cracks; they are held"));
  }
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
  log(1, "parts can move freely, cut off or left hanging on a hinge, at " + places + "; they are held where they are");
}

void Model::warn_of_interface() {
  if (warned_of_interface_) return;
  const std::optional<int> node = prepared_->interface_bonds->reached();
  if (!node) return;
  warned_of_interface_ = true;
  const Point& place = prepared_->discretization.positions[*node];
  log(1, text("bonds have broken where ", regions_with(prepared_->discretization, {*node}), " meet, at (", place.x(),
              ", ", place.y(),
              "): a crack cannot go on into a boundary element region and runs along it; give the "
              "peridynamic region more room there if it should go on"));
}

void Model::reload() {
  if (!prepared_) return;
  regions::DofConditions conditions = regions::apply_conditions(scene_, prepared_->discretization);
  prepared_->evolution->set_load(conditions.force, conditions.displacement, conditions.work_within);
  prepared_->conditions = std::move(conditions);
  ++generation_;
}

void Model::set_values(scene::Condition& condition, const char* what, int id, scene::SampledValues values) {
  scene::Condition before = condition;
  scene_.set_values(condition, what, id, std::move(values));
  try {
    reload();
  } catch (...) {
    condition = std::move(before);
    throw;
  }
}

void Model::set_load_values(int load, scene::SampledValues values) {
  set_values(scene_.load(load), "load", load, std::move(values));
}

void Model::set_support_values(int support, scene::SampledValues values) {
  set_values(scene_.support(support), "support", support, std::move(values));
}

fracture::LoadInterval Model::admissible_load_factors() {
  ensure_equilibrium();
  return prepared_->evolution->admissible_load_factors();
}

StepResult Model::advance(double target, fracture::Goal goal) {
  prepare();
  fracture::CrackEvolution& evolution = *prepared_->evolution;
  const fracture::SteppingOptions stepping = stepping_options(options_);
  const auto& counters = prepared_->system->counters();
  const double solve = counters.seconds_solve, update = counters.seconds_update, search = evolution.seconds_search();
  const std::int64_t events = evolution.progress().events, broken = evolution.progress().broken_bonds;
  const std::int64_t fragments = evolution.progress().fragments;
  const auto lines = static_cast<std::ptrdiff_t>(evolution.progress().history.size());
  StepResult result;
  {
    const Stopwatch watch(result.seconds_total);
    ++generation_;
    result.reason = run_recording(target, goal, stepping);
  }
  result.events = evolution.progress().events - events;
  result.broken_bonds = evolution.progress().broken_bonds - broken;
  result.unstable_event = first_unstable(std::span(evolution.progress().history).subspan(lines));
  result.seconds_solve = counters.seconds_solve - solve;
  result.seconds_update = counters.seconds_update - update;
  result.seconds_search = evolution.seconds_search() - search;
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
  if (evolution.progress().fragments > fragments) {
    log(1, text(evolution.progress().fragments - fragments,
                " pieces have come free of all supports; they stay where they are"));
  }
  return result;
}

double Model::load_factor() const { return prepared_ ? prepared_->evolution->progress().load_factor : 0.0; }

}  // namespace bempd::model
