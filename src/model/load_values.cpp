#include "model/load_values.hpp"

#include "error.hpp"
#include "model/model.hpp"
#include "regions/edge_nodes.hpp"
#include "regions/places/edge_part.hpp"
#include "regions/swelling.hpp"
#include "undo.hpp"

// Values of loads and supports, and the time at which they take effect.
namespace bempd::model {

template <class Values>
void LoadValues::set_load_values(int load, Values values) {
  scene::Scene& scene = model_.preparation().scene();
  scene.load(load);  // throws without it
  values_will_be_set();
  scene.set_values(scene.load(load), "load", load, std::move(values));
  values_were_set();
}

// Applies temperature loads: sets the rest lengths of bonds and operators for the present temperatures. Returns what is
// needed to undo this; empty if there are no temperatures, or if nothing changes.
std::optional<fracture::RunLoads::Heat> LoadValues::heat(const regions::DofConditions& conditions) {
  coupling::EquilibriumSystem& system = *model_.prepared().system;
  if (conditions.swelling.empty()) return std::nullopt;
  system.condense();
  coupling::Rests rests = system.stress_free().rests();
  rests.of_terms =
      regions::changed_rest_elongations(model_.prepared().discretization, conditions.swelling, system.terms());
  for (const auto& region : model_.prepared().discretization.regions) {
    if (!region->operators()) continue;
    for (const regions::OperatorNodes& one : region->operators()->nodes_of_operators())
      if (one.rest.rows() > 0)
        rests.of_operators[static_cast<std::size_t>(system.operators().number_on(one.nodes))] = one.rest;
  }
  if (rests == system.stress_free().rests()) return std::nullopt;
  return model_.prepared().evolution->loads().heat(std::move(rests));
}

std::optional<fracture::RunLoads::FaceLoads> LoadValues::load_faces(const regions::DofConditions& conditions) {
  if (conditions.face_offsets == model_.prepared().system->operators().gap_offsets()) return std::nullopt;
  return model_.prepared().evolution->loads().load_faces(conditions.face_offsets);
}

template <class Values>
void LoadValues::set_support_values(int support, Values values) {
  scene::Scene& scene = model_.preparation().scene();
  values_will_be_set();
  scene.set_values(scene.support(support), "support", support, std::move(values));
  values_were_set();
}

template void LoadValues::set_load_values(int, scene::SampledValues);
template void LoadValues::set_load_values(int, scene::PlacedValues);
template void LoadValues::set_support_values(int, scene::SampledValues);
template void LoadValues::set_support_values(int, scene::PlacedValues);

void LoadValues::set_nodal_values(bool of_support, int id, std::vector<double> constant,
                                  std::vector<double> proportional) {
  const char* what = of_support ? "support" : "load";
  const scene::Condition& condition = of_support ? model_.scene().support(id) : model_.scene().load(id);
  const auto* part = dynamic_cast<const regions::EdgePart*>(condition.place.get());
  require(part != nullptr, what, " ", id, " does not lie along an edge, which has nodes in order");
  const std::vector<regions::PlacedNode> nodes = part->nodes(model_.scene(), model_.prepared().discretization);
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

// Keeps the values that act now, because a state may be saved before the new values take effect.
void LoadValues::values_will_be_set() {
  if (!model_.prepared_or_null()) model_.accuracy().forget();
  if (!model_.prepared_or_null() || present_.acting == Acting::earlier) return;
  present_.earlier = acting_values();
}

void LoadValues::values_were_set() {
  if (!model_.prepared_or_null()) return;
  model_.accuracy().journal().has_new_values = true;
  present_.acting = Acting::earlier;
  model_.preparation().has_changed();
}

regions::DofConditions LoadValues::conditions_under(scene::SceneValues values) const {
  const regions::Discretization& d = model_.prepared().discretization;
  return model_.preparation().scene().under(values, [&] { return regions::apply_conditions(model_.scene(), d); });
}

coupling::Affine LoadValues::loads_in_force_on(const std::vector<int>& regions_of_body) const {
  scene::SceneValues acting = present_.acting == Acting::on_path ? *present_.in_force : model_.scene().values();
  const regions::Discretization& d = model_.prepared().discretization;
  return model_.preparation().scene().under(acting,
                                            [&] { return regions::loads_on(model_.scene(), d, regions_of_body); });
}

scene::SceneValues LoadValues::acting_values() const {
  switch (present_.acting) {
    case Acting::earlier:
      return *present_.earlier;
    case Acting::on_path:
      return *present_.in_force;
    case Acting::values:
      break;
  }
  return model_.scene().values();
}

LoadValues::Before LoadValues::replace(regions::DofConditions conditions, Acting acting) {
  fracture::CrackEvolution& evolution = *model_.prepared().evolution;
  Before before{{}, evolution.loads().present(), present_.acting, heat(conditions), {}};
  try {
    before.faces = load_faces(conditions);
    evolution.loads().set(conditions.force, conditions.displacement, conditions.work_within, pressures_of(conditions));
  } catch (...) {
    if (before.faces) evolution.loads().unload_faces(std::move(*before.faces));
    if (before.heat) evolution.loads().restore_rest_lengths(std::move(*before.heat));
    throw;
  }
  before.conditions = std::exchange(model_.prepared().conditions, std::move(conditions));
  present_.acting = acting;
  model_.growth().forget_factors();
  model_.preparation().has_changed();
  return before;
}

void LoadValues::under(scene::SceneValues values, const std::function<void(PreparedScene&)>& read) {
  fracture::CrackEvolution& evolution = *model_.prepared().evolution;
  fracture::EvolutionState state = evolution.state();
  fracture::Continuation continuation = evolution.continuation();
  Before loads = replace(conditions_under(std::move(values)), Acting::values);
  undone_afterwards(
      [&] {
        evolution.loads().find_equilibrium();
        read(model_.prepared());
      },
      [&] {
        evolution.records().take_held();
        evolution.restore(std::move(state), std::move(continuation));
        go_back_to(std::move(loads));
      });
}

void LoadValues::go_back_to(Before before) noexcept {
  PreparedScene& prepared = model_.prepared();
  if (before.faces) prepared.evolution->loads().unload_faces(std::move(*before.faces));
  if (before.heat) prepared.evolution->loads().restore_rest_lengths(std::move(*before.heat));
  prepared.evolution->loads().restore(std::move(before.run));
  // Regions have a copy of their swelling for results. If there is no memory to restore the copy, the next change of
  // loads sets it.
  say([&] {
    if (before.heat)
      regions::changed_rest_elongations(prepared.discretization, before.conditions.swelling, prepared.system->terms());
  });
  prepared.conditions = std::move(before.conditions);
  present_.acting = before.acting;
  model_.growth().forget_factors();
  model_.preparation().has_changed();
}

LoadValues::Before LoadValues::apply_pending() {
  return replace(regions::apply_conditions(model_.scene(), model_.prepared().discretization), Acting::values);
}

void LoadValues::arrive(std::optional<regions::DofConditions> known,
                        std::optional<scene::SceneValues> host_values) noexcept {
  say([&] {
    regions::DofConditions conditions =
        known ? std::move(*known) : regions::apply_conditions(model_.scene(), model_.prepared().discretization);
    heat(conditions);
    load_faces(conditions);
    model_.prepared().evolution->loads().take_over(conditions.force, conditions.displacement, conditions.work_within,
                                                   pressures_of(conditions));
    model_.prepared().conditions = std::move(conditions);
    model_.growth().forget_factors();
    present_.in_force.swap(host_values);
    present_.acting = Acting::values;
  });
}

}  // namespace bempd::model
