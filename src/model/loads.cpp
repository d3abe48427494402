#include <cmath>

#include "error.hpp"
#include "model/model.hpp"
#include "model/step_beginning.hpp"
#include "regions/edge_nodes.hpp"
#include "regions/fluid_paths.hpp"
#include "regions/places/edge_part.hpp"
#include "regions/swelling.hpp"

// Values of loads and supports, and the time at which they take effect.
namespace bempd::model {

template <class Values>
void Model::set_load_values(int load, Values values) {
  scene_.load(load);  // throws without it
  values_will_be_set();
  scene_.set_values(scene_.load(load), "load", load, std::move(values));
  values_were_set();
}

// Temperature loads: sets the rest lengths of bonds and operators for the present temperatures. Returns what is needed
// to undo that; empty if there are no temperatures, or if nothing changes.
std::optional<fracture::CrackEvolution::Heat> Model::heat(const regions::DofConditions& conditions) {
  coupling::EquilibriumSystem& system = *prepared_->system;
  if (conditions.swelling.empty()) return std::nullopt;
  system.condense();
  coupling::Rests rests = system.rests();
  rests.of_terms = regions::swell_again(prepared_->discretization, conditions.swelling, system.terms());
  for (const auto& region : prepared_->discretization.regions)
    for (const regions::OperatorNodes& one : region->nodes_of_operators())
      if (one.rest.rows() > 0)
        rests.of_operators[static_cast<std::size_t>(system.operators().number_on(one.nodes))] = one.rest;
  if (rests == system.rests()) return std::nullopt;
  return prepared_->evolution->heat(std::move(rests));
}

std::optional<fracture::CrackEvolution::FaceLoads> Model::load_faces(const regions::DofConditions& conditions) {
  if (conditions.face_offsets == prepared_->system->operators().gap_offsets()) return std::nullopt;
  return prepared_->evolution->load_faces(conditions.face_offsets);
}

template <class Values>
void Model::set_support_values(int support, Values values) {
  values_will_be_set();
  scene_.set_values(scene_.support(support), "support", support, std::move(values));
  values_were_set();
}

template void Model::set_load_values(int, scene::SampledValues);
template void Model::set_load_values(int, scene::PlacedValues);
template void Model::set_support_values(int, scene::SampledValues);
template void Model::set_support_values(int, scene::PlacedValues);

void Model::set_nodal_values(bool of_support, int id, std::vector<double> constant, std::vector<double> proportional) {
  const char* what = of_support ? "support" : "load";
  const scene::Condition& condition = of_support ? scene_.support(id) : scene_.load(id);
  const auto* part = dynamic_cast<const regions::EdgePart*>(condition.place.get());
  require(part != nullptr, what, " ", id, " does not lie along an edge, which has nodes in order");
  prepare();
  const std::vector<regions::PlacedNode> nodes = part->nodes(scene_, prepared_->discretization);
  require(constant.size() == 2 * nodes.size(), what, " ", id, " has ", nodes.size(),
          " nodes, and there are values for ", constant.size() / 2,
          "; bempd_copy_edge_nodes() tells of all nodes of its edge");
  scene::PlacedValues values{{}, std::move(constant), std::move(proportional)};
  for (const regions::PlacedNode& n : nodes) values.fractions.push_back(n.fraction);
  if (of_support) {
    set_support_values(id, std::move(values));
  } else {
    set_load_values(id, std::move(values));
  }
}

void Model::add_crack_fluid(PreparedScene& p) const {
  if (p.conditions.crack_pressures.empty()) return;
  std::map<int, std::vector<int>> cut;
  for (const regions::CrackPressure& pressure : p.conditions.crack_pressures) {
    std::vector<std::string> told_before;
    std::vector<int>& bonds = cut[pressure.crack];
    if (!bonds.empty()) continue;
    const scene::Crack& crack = p.in_lattices.cracks[static_cast<std::size_t>(pressure.crack) - 1];
    for (const auto& region : p.discretization.regions) region->cut(crack, pressure.crack, bonds, told_before);
  }
  const coupling::Terms& terms = p.system->terms();
  p.evolution->add_crack_fluid({regions::fluid_paths(scene_, p.discretization, terms, p.in_lattices.weakened),
                                std::move(cut), terms, p.discretization.positions});
}

fracture::CrackPressures pressures_of(const regions::DofConditions& conditions) {
  fracture::CrackPressures sums;
  for (const regions::CrackPressure& pressure : conditions.crack_pressures) {
    sums.try_emplace(pressure.crack, Eigen::RowVector2d::Zero());
    sums[pressure.crack] += pressure.value;
  }
  return sums;
}

// Keeps the values that act now, because a state may be saved before the new values take effect.
void Model::values_will_be_set() {
  if (!prepared_) accuracy_.forget();
  if (!prepared_ || loads_.acting == Acting::others) return;
  loads_.others = acting_values();
}

void Model::values_were_set() {
  if (!prepared_) return;
  loads_.acting = Acting::others;
  ++generation_;
}

regions::DofConditions Model::conditions_under(scene::SceneValues values) {
  return scene_.under(values, [&] { return regions::apply_conditions(scene_, prepared_->discretization); });
}

coupling::Affine Model::loads_in_force_on(const std::vector<int>& regions_of_body) {
  scene::SceneValues acting = loads_.acting == Acting::on_a_way ? *loads_.in_force : scene_.values();
  return scene_.under(acting, [&] { return regions::loads_on(scene_, prepared_->discretization, regions_of_body); });
}

Model::LoadsBefore Model::replace_loads(regions::DofConditions conditions, Acting acting) {
  fracture::CrackEvolution& evolution = *prepared_->evolution;
  LoadsBefore before{{}, evolution.loads(), loads_.acting, heat(conditions), {}};
  try {
    before.faces = load_faces(conditions);
    evolution.set_load(conditions.force, conditions.displacement, conditions.work_within, pressures_of(conditions));
  } catch (...) {
    if (before.faces) evolution.unload_faces(std::move(*before.faces));
    if (before.heat) evolution.restore_rest_lengths(std::move(*before.heat));
    throw;
  }
  before.conditions = std::exchange(prepared_->conditions, std::move(conditions));
  loads_.acting = acting;
  tip_factors_.scene = nullptr;
  ++generation_;
  return before;
}

void Model::under(scene::SceneValues values, const std::function<void(PreparedScene&)>& read) {
  fracture::CrackEvolution& evolution = *prepared_->evolution;
  fracture::EvolutionState state = evolution.state();
  fracture::Continuation continuation = evolution.continuation();
  LoadsBefore loads = replace_loads(conditions_under(std::move(values)), Acting::values);
  const auto go_back = [&] {
    evolution.take_held();
    evolution.restore(std::move(state), std::move(continuation));
    go_back_to(std::move(loads));
  };
  try {
    evolution.find_equilibrium();
    read(*prepared_);
  } catch (...) {
    go_back();
    throw;
  }
  go_back();
}

void Model::go_back_to(LoadsBefore before) noexcept {
  if (before.faces) prepared_->evolution->unload_faces(std::move(*before.faces));
  if (before.heat) prepared_->evolution->restore_rest_lengths(std::move(*before.heat));
  prepared_->evolution->restore_loads(std::move(before.run));
  // Regions keep their swelling for results. If memory for restoring it is missing, they get it with the next loads.
  say([&] {
    if (before.heat)
      regions::swell_again(prepared_->discretization, before.conditions.swelling, prepared_->system->terms());
  });
  prepared_->conditions = std::move(before.conditions);
  loads_.acting = before.acting;
  tip_factors_.scene = nullptr;
  ++generation_;
}

void Model::apply_pending_values() {
  replace_loads(regions::apply_conditions(scene_, prepared_->discretization), Acting::values);
}

StepResult Model::advance(double target, fracture::Goal goal) {
  prepare_for_step(*this);
  std::optional<scene::SceneValues> said = scene_.values();
  std::optional<LoadsBefore> before;
  if (loads_.acting != Acting::values)
    before = replace_loads(regions::apply_conditions(scene_, prepared_->discretization), Acting::values);
  try {
    const StepResult result = run(target, goal);
    loads_.in_force.swap(said);
    return result;
  } catch (...) {
    if (before) go_back_to(std::move(*before));
    throw;
  }
}

StepResult Model::advance_to_values(double target, fracture::Goal goal) {
  prepare_for_step(*this);
  const double present = load_factor();
  std::optional<scene::SceneValues> said = scene_.values();
  regions::DofConditions at_end = regions::apply_conditions(scene_, prepared_->discretization);
  std::optional<LoadsBefore> before;
  std::optional<scene::SceneValues> way;
  if (loads_.acting == Acting::on_a_way && target == loads_.end_of_way) {
    way = loads_.in_force;
  } else {
    require(target != present, "load_factor is ", target,
            ", where the model is already; values move with the load factor, so give another one, such as the time at "
            "the end of the step");
    require(std::abs(target - present) >= 1e-8 * std::abs(target), "load_factor is ", target,
            ", nearer than 1e-8 of it to ", present,
            ", where the model is: values on so short a way lose that many digits; let the load factor count "
            "from a later beginning, or in larger steps");
    way = scene::line_between(loads_.in_force ? *loads_.in_force : scene::at_rest(*said), present, *said, target);
    before = replace_loads(conditions_under(*way), Acting::on_a_way);
  }
  try {
    const PreparedScene* const before_run = prepared_.get();
    const StepResult result = run(target, goal, &*way);
    loads_.in_force.swap(way);
    loads_.end_of_way = target;
    using fracture::StopReason;
    const bool arrived = result.reason == StopReason::load_factor ||
                         (result.reason == StopReason::separated && goal == fracture::Goal::load_factor);
    if (arrived)
      arrive(prepared_.get() == before_run ? std::optional(std::move(at_end)) : std::nullopt, std::move(said));
    return result;
  } catch (...) {
    if (before) go_back_to(std::move(*before));
    throw;
  }
}

// Ends a path of values: its end values, which act already, become the conditions `known`. These are computed here if
// empty (cracks have grown since). A failure leaves the model at that point of the path.
void Model::arrive(std::optional<regions::DofConditions> known, std::optional<scene::SceneValues> said) noexcept {
  say([&] {
    regions::DofConditions conditions =
        known ? std::move(*known) : regions::apply_conditions(scene_, prepared_->discretization);
    heat(conditions);
    load_faces(conditions);
    prepared_->evolution->take_over(conditions.force, conditions.displacement, conditions.work_within,
                                    pressures_of(conditions));
    prepared_->conditions = std::move(conditions);
    tip_factors_.scene = nullptr;
    loads_.in_force.swap(said);
    loads_.acting = Acting::values;
  });
}

}  // namespace bempd::model
