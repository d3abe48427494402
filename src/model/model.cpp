#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "coupling/rigid_motion.hpp"
#include "error.hpp"
#include "fracture/connectivity.hpp"
#include "geometry/outline.hpp"
#include "linalg/blas.hpp"
#include "model/crack_way.hpp"
#include "model/element_carrier.hpp"
#include "model/growth_options.hpp"
#include "model/line_factors.hpp"
#include "model/stepping_options.hpp"
#include "regions/crack_places.hpp"
#include "regions/incompressible.hpp"
#include "regions/initial_cracks.hpp"
#include "regions/memory_limit.hpp"
#include "regions/swelling.hpp"
#include "stopwatch.hpp"

namespace bempd::model {

namespace {

// Number of the first event in `lines` at which equilibrium was lost; 0 if there is none.
std::int64_t first_unstable(std::span<const fracture::HistoryEntry> lines) {
  for (const fracture::HistoryEntry& line : lines)
    if (line.stretch_ratio > 1 + fracture::ratio_rounding) return line.event;
  return 0;
}

// Whether `nodes` belong to a piece inside one region that only cracks bound.
bool is_island(const scene::Scene& scene, const regions::Discretization& d, const std::vector<int>& nodes) {
  const auto has = [&](const std::unique_ptr<regions::Region>& region) {
    const std::vector<int>& own = region->nodes();
    return region->is_cut() && std::find(own.begin(), own.end(), nodes.front()) != own.end();
  };
  const auto region = std::find_if(d.regions.begin(), d.regions.end(), has);
  if (region == d.regions.end()) return false;
  const Outline& outline = scene.region((*region)->id()).outline();
  return std::all_of(nodes.begin(), nodes.end(), [&](int node) {
    return locate(outline, d.positions[static_cast<std::size_t>(node)], d.tolerance) == Location::inside;
  });
}

// Throws Error (argument) for a lattice that breaks bond by bond and has a table of resistances.
void require_constant_resistance(const scene::Scene& scene) {
  for (const int id : scene.region_ids())
    require(scene.region(id).has_elements() || scene.material_of(id).resistance.is_constant(), "region ", id,
            " breaks bond by bond, which knows no resistance by growth or direction; let cracks grow as lines there "
            "(crack.rule = line or tips), or give its material no such table");
}

double extent(const std::vector<Point>& positions, const std::vector<int>& nodes) {
  double farthest = 0;
  for (const int node : nodes) farthest = std::max(farthest, (positions[node] - positions[nodes.front()]).norm());
  return farthest;
}

// Throws Error (unsolvable) for a body that can move freely. Supports on a very small part of a body prevent its
// rotation in theory, but not within rounding errors, which has a sentence of its own.
[[noreturn]] void fail_free(const std::string& regions, const std::string& motion, double held, double size,
                            const std::string& gap) {
  constexpr double small_part = 1e-5;
  if (motion == "rotate" && held > 0 && held < small_part * size)
    fail(Failure::unsolvable, "supports hold ", regions, " along ", held, " only, of a size of ", size,
         ", which does not keep it from rotating within the digits of a number: hold it at another place as well, or "
         "make it thicker there");
  fail(Failure::unsolvable, regions, " can ", motion, gap.empty() ? "" : ": ", gap,
       gap.empty() ? "; add" : "; if not, add", " supports that prevent this, for example with bempd_fix_point()");
}

// Flags of nodes of lattices on interfaces with boundary elements of the same material. The two ends of an interface
// are left out, unless another such interface begins there.
std::vector<char> nodes_where_material_goes_on(const scene::Scene& scene, const regions::Discretization& d) {
  constexpr int on_interface = 2, at_its_end = 1;
  std::vector<int> found(d.positions.size(), 0);
  for (const Contact& c : d.arrangement.contacts) {
    const int id = c.region + 1, other = c.other_region + 1;
    if (scene.region(id).has_elements() || !scene.region(other).has_elements()) continue;
    if (!(scene.material_of(id) == scene.material_of(other))) continue;
    const regions::EdgeSpan span{c.edge + 1, scene.region(id).edge(c.edge + 1), c.from, c.to};
    for (const regions::PlacedNode& node : d.region(id).nodes_on(span, d.tolerance)) {
      const bool at_end = std::min(node.fraction, 1 - node.fraction) < 1e-9;
      found[static_cast<std::size_t>(node.node)] += at_end ? at_its_end : on_interface;
    }
  }
  std::vector<char> goes_on;
  for (const int count : found) goes_on.push_back(count >= on_interface ? 1 : 0);
  return goes_on;
}

}  // namespace

scene::Scene& Model::editable_scene() {
  if (prepared_)
    fail(Failure::order,
         "the model is prepared and its scene can no longer change; add everything before the first step or result, or "
         "create a new model");
  treatments_.take_away();
  return scene_;
}

void Model::call_failed(bool was_prepared, bool unsolvable) noexcept {
  if (!prepared_) return treatments_.take_away();
  const fracture::EvolutionState& state = prepared_->evolution->progress();
  const bool has_begun = state.in_equilibrium || !state.history.empty() || state.load_factor != 0;
  if (was_prepared && (has_begun || !unsolvable)) return;
  prepared_.reset();
  treatments_.take_away(), accuracy_.forget();
  loads_ = {};
  results_.forget();
  ++generation_;
}

void Model::check_mechanism(const PreparedScene& p) const {
  const std::vector<Point>& positions = p.discretization.positions;
  for (const std::vector<int>& nodes : fracture::Connectivity(*p.system).pieces()) {
    std::vector<int> held;
    for (const coupling::HeldDirection& h : held_directions(p, nodes)) held.push_back(h.node);
    const coupling::RigidMotion motion(positions, nodes, held_directions(p, nodes));
    if (motion.free_count() == 0 || is_island(scene_, p.discretization, nodes)) continue;
    fail_free(p.discretization.regions_with(nodes), motion.describe(), extent(positions, held),
              extent(positions, nodes), p.discretization.gap);
  }
}

// Prepares crack lines in lattices: laws of growth and initial tips. Nothing is done if cracks grow bond by bond.
void Model::grow_lines(PreparedScene& p) const {
  const std::string rule = options_.text_in_effect("crack.rule");
  if (rule == "bond") return require_constant_resistance(scene_);
  pd::TipLaws laws;
  laws.more_begin = rule != "tips";
  laws.criterion = growth_criterion(options_);
  laws.loads_by_energy = options_.text_value("crack.load") == "energy";
  laws.of_node.assign(p.discretization.positions.size(), -1);
  laws.share_of_node.assign(laws.of_node.size(), 0);
  laws.joined = nodes_where_material_goes_on(scene_, p.discretization);
  std::map<int, int> law_of_region;
  for (const auto& region : p.discretization.regions) {
    const std::optional<pd::TipLaw> law = region->tip_law(options_);
    if (!law) continue;
    law_of_region[region->id()] = static_cast<int>(laws.laws.size());
    const std::vector<double> shares = region->shares_of_cells();
    for (std::size_t k = 0; k < region->nodes().size(); ++k) {
      const auto node = static_cast<std::size_t>(region->nodes()[k]);
      laws.of_node[node] = static_cast<int>(laws.laws.size());
      if (k < shares.size()) laws.share_of_node[node] += shares[k];
    }
    laws.laws.push_back(*law);
    if (law->energies) {
      laws.energy_share_of_node.resize(laws.of_node.size(), 1);
      for (const int node : region->nodes())
        laws.energy_share_of_node[static_cast<std::size_t>(node)] =
            law->energies->share(p.discretization.positions[static_cast<std::size_t>(node)]);
    }
    const Outline& outline = scene_.region(region->id()).outline();
    for (std::size_t k = 0; const Edge& edge : edges_of(outline))
      (k++ < outline.loops.front().size() ? laws.outer_edges : laws.hole_edges).push_back(edge);
  }
  std::vector<fracture::GrowingTip> tips;
  for (const regions::StartingTip& tip : regions::tips_of_cracks(scene_, p.in_lattices, p.discretization, options_)) {
    tips.push_back({tip.place, tip.direction, law_of_region.at(tip.region), tip.id});
    tips.back().even_ahead = tip.even_ahead;
    tips.back().grown = scene_.cracks()[static_cast<std::size_t>(tip.id.crack) - 1].grown(tip.id.end);
  }
  laws.of_crack = regions::lengths_of(p.in_lattices);
  laws.weakened = p.in_lattices.weakened;
  p.first_tips = tips.size(), p.tip_laws = laws.laws.size();
  p.evolution->grow_lines(
      std::move(laws), std::move(tips),
      [this](int crack, const std::vector<double>& fractions) { return openings_in_lattices(crack, fractions); },
      [this, &p](const auto& tip, const auto& displacement) {
        return factors_around(scene_, options_, p, tip, displacement);
      });
}

fracture::ContactPlan Model::contact_plan(const PreparedScene& p) const {
  if (options_.text_value("contact") == "none" || options_.text_value("scheme") != "symmetric") return {};
  pd::FacePlaces lattices = regions::face_lattices(p.discretization);
  if (lattices.lattice_count() == 0) return {};
  std::vector<pd::FacePlace> places = regions::places_on_cracks(p.in_lattices.cracks, p.discretization, lattices);
  return {true, std::move(lattices), std::move(places)};
}

void Model::prepare() {
  if (prepared_) return;
  if (scene_.region_ids().empty()) fail(Failure::order, "the scene has no region; add one first");
  treatments_.lay();
  regions::require_memory(scene_, options_);
  linalg::require_blas_buffer();
  accuracy_.prepare();
  ++generation_;
  prepared_->anchored_pieces = pieces_.anchored_count();
  say([&] { tell_of_preparation(); });
}

std::unique_ptr<PreparedScene> Model::build(const PreparedScene* before) const {
  auto p = std::make_unique<PreparedScene>();
  p->fingerprint = fingerprint(scene_, options_);
  p->discretization = regions::discretize(scene_, options_, before ? &before->discretization : nullptr);
  regions::Discretization& d = p->discretization;
  p->conditions = regions::apply_conditions(scene_, d);
  regions::swell(d, p->conditions.swelling);
  regions::require_determined_pressure(d, p->conditions.prescribed);
  p->in_lattices = regions::cracks_in_lattices(scene_, d, options_);
  for (const pd::WeakenedTerm& weak : p->in_lattices.weakened)
    d.bonds.stiffness[static_cast<std::size_t>(weak.term)] *= weak.share;
  d.warnings.insert(d.warnings.end(), p->in_lattices.warnings.begin(), p->in_lattices.warnings.end());
  p->cut_bonds = regions::bonds_cut_by_cracks(p->in_lattices.cracks, d, d.warnings);
  p->system = std::make_unique<coupling::EquilibriumSystem>(static_cast<int>(d.positions.size()), d.dense_operators(),
                                                            std::move(d.bonds), p->conditions.prescribed, d.ties);
  if (before) p->system->take_over(*before->system);
  p->system->note_condition(regions::condition_of_held_pressure(scene_, d, p->conditions.prescribed, d.warnings));
  if (!before) check_mechanism(*p);  // what growth has cut off is held
  if (before) check_loads_inside_free_pieces(*p);
  p->evolution = std::make_unique<fracture::CrackEvolution>(*p->system, d.positions, d.critical_stretch, p->cut_bonds,
                                                            p->conditions.reaction_dofs, contact_plan(*p));
  grow_lines(*p);
  add_crack_fluid(*p);
  p->evolution->load_faces(p->conditions.face_offsets);
  p->evolution->set_load(p->conditions.force, p->conditions.displacement, p->conditions.work_within,
                         pressures_of(p->conditions));
  p->interface_bonds.emplace(*p->system, d.positions);
  return p;
}

PreparedScene& Model::prepared() {
  prepare();
  return *prepared_;
}

PreparedScene& Model::in_equilibrium() {
  ensure_equilibrium();
  return *prepared_;
}

bool Model::hangs() {
  return prepared_->evolution->progress().separated && pieces_.anchored_count() <= prepared_->anchored_pieces;
}

void Model::ensure_equilibrium() {
  prepare();
  if (loads_.acting == Acting::others) apply_pending_values();
  fracture::CrackEvolution& evolution = *prepared_->evolution;
  if (evolution.progress().in_equilibrium) return;
  evolution.find_equilibrium();
  say([&] {
    warn_of_equilibrium();
    if (evolution.progress().fragments == 0) return;
    log(1,
        text(evolution.progress().fragments, " pieces are cut off from all supports by initial cracks; they are held"));
  });
}

fracture::LoadInterval Model::admissible_load_factors() {
  ensure_equilibrium();
  return prepared_->evolution->admissible_load_factors();
}

StepResult Model::run(double target, fracture::Goal goal, const scene::SceneValues* on_way) {
  fracture::SteppingOptions stepping = stepping_options(options_);
  stepping.stop = &stop_requested_;
  stepping.frozen = frozen_tips_;
  const bool drives = drives_elements(stepping);
  if (drives) say([&] { tell_of_whole_body(); });
  ElementCarrier elements(*this, on_way, drives);
  stepping.elements = &elements;
  const fracture::EvolutionState& begin = prepared_->evolution->progress();
  const std::int64_t events = begin.events, broken = begin.broken_bonds;
  const std::int64_t fragments = begin.fragments, switches = begin.contact_switches, ties = begin.ties;
  const auto lines = static_cast<std::ptrdiff_t>(begin.history.size());
  const Seconds before = seconds_of(*prepared_);
  StepResult result;
  {
    const Stopwatch watch(result.seconds_total);
    ++generation_;
    run_recording(target, goal, stepping, elements, result);
  }
  const fracture::EvolutionState& end = prepared_->evolution->progress();
  result.events = end.events - events;
  result.broken_bonds = end.broken_bonds - broken;
  result.face_switches = end.contact_switches - switches;
  result.ties = end.ties - ties;
  result.unstable_event = first_unstable(std::span(end.history).subspan(lines));
  Seconds seconds = seconds_of(*prepared_);
  seconds.add(elements.spent());
  result.seconds_solve = seconds.solve - before.solve;
  result.seconds_update = seconds.update - before.update;
  result.seconds_search = seconds.search - before.search;
  say([&] { tell_of_step(result, end.fragments - fragments, target >= end.load_factor); });
  return result;
}

double Model::load_factor() const { return prepared_ ? prepared_->evolution->progress().load_factor : 0.0; }

}  // namespace bempd::model
