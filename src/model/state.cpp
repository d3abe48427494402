#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <tuple>

#include "error.hpp"
#include "model/driven_growth.hpp"
#include "model/fingerprint.hpp"
#include "model/model.hpp"
#include "model/state_checks.hpp"
#include "model/states.hpp"
#include "undo.hpp"

namespace bempd::model {

namespace {

// Throws Error (argument) unless a state belongs to this body: numbers that are consistent may be those of another
// body.
void require_fit(const SavedState& saved, const PreparedScene& scene) {
  const fracture::EvolutionState& state = saved.evolution;
  const auto dofs = static_cast<Eigen::Index>(2 * scene.discretization.positions.size());
  const coupling::Terms& terms = scene.system->terms();
  const auto must = [](bool good) {
    require(good, "the state's arrays do not fit the scene that it names; its bytes were altered");
  };
  must(state.total_displacement.size() == dofs && state.stages.size() == terms.size() &&
       state.reactions.size() == 2 * state.history.size() * scene.conditions.reaction_dofs.size());
  must(state.tips.size() >= scene.first_tips && (scene.tip_laws > 0 || state.tips.empty()));
  for (const fracture::GrowingTip& tip : state.tips)
    must(is_sound(tip) && static_cast<std::size_t>(tip.law) < scene.tip_laws);
  const auto is_broken = [&](std::size_t term) { return terms.is_broken(term, state.stages[term]); };
  std::int64_t broken = 0;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    must(state.stages[t] <= terms.law_of(t).broken_stage());
    broken += is_broken(t) && !terms.follows(static_cast<int>(t)) ? 1 : 0;
  }
  for (const coupling::Terms::Following& pair : terms.following)
    must(!is_broken(static_cast<std::size_t>(pair.leader)) || is_broken(static_cast<std::size_t>(pair.follower)));
  // A contact place that the run has added must belong to a broken bond, and the list of closed constraints must have
  // an entry for this place.
  std::set<int> grown;
  for (const fracture::GrownFace& face : state.faces.grown) {
    must(face.term >= 0 && face.term < static_cast<int>(terms.size()) && grown.insert(face.term).second &&
         is_broken(static_cast<std::size_t>(face.term)) && scene.evolution->faces().can_have(face));
  }
  must(state.faces.closed.size() == scene.evolution->faces().first_grown() + grown.size());
  for (const std::vector<int>& terms_of_event : state.faces.pending)
    for (const int term : terms_of_event)
      must(term >= 0 && term < static_cast<int>(terms.size()) && is_broken(static_cast<std::size_t>(term)));
  const std::vector<int>& cut = scene.cut_bonds;
  // A crack line that has continued in elements may have broken bonds that the longer crack of the scene cuts as well,
  // so that these bonds may be counted twice.
  const bool both = std::any_of(scene.discretization.cracks.begin(), scene.discretization.cracks.end(),
                                [](const auto& crack) { return crack.has_elements() && crack.cuts_bonds(); });
  // Broken bonds of lattice parts that elements have replaced are counted, although they do not exist in the scene.
  const bool has_fewer = std::ranges::any_of(state.layouts, regions::gives_back);
  const auto most = static_cast<std::int64_t>(cut.size()) + state.broken_bonds;
  must((has_fewer ? broken <= most
        : both    ? broken <= most && broken >= state.broken_bonds
                  : broken == most) &&
       std::all_of(cut.begin(), cut.end(), [&](int bond) { return is_broken(static_cast<std::size_t>(bond)); }));
  must(fits(saved.continuation, state, scene));
}

// Values of a saved state for those supports and loads of the scene whose values they can replace (are_alike());
// elsewhere the present values. Functions are not written to bytes, and the scene may have other loads.
scene::SceneValues fitted(const scene::SceneValues& values, const scene::SceneValues& present) {
  const auto fit = [](const std::vector<scene::Values>& of_state, const std::vector<scene::Values>& of_scene) {
    std::vector<scene::Values> all = of_scene;
    for (std::size_t i = 0; of_state.size() == of_scene.size() && i < all.size(); ++i)
      if (scene::are_alike(of_state[i], of_scene[i])) all[i] = of_state[i];
    return all;
  };
  return {fit(values.supports, present.supports), fit(values.loads, present.loads)};
}

// Whether all values of a state can replace those of the scene's supports and loads (are_alike()), so that none of them
// is an unknown function.
bool are_known(const scene::SceneValues& values, const scene::SceneValues& present) {
  return std::equal(values.supports.begin(), values.supports.end(), present.supports.begin(), present.supports.end(),
                    scene::are_alike) &&
         std::equal(values.loads.begin(), values.loads.end(), present.loads.begin(), present.loads.end(),
                    scene::are_alike);
}

// Whether an extension is a step of a crack line in a lattice: neither end of it lies inside boundary elements. Lines
// may begin or end slightly outside the outline of their lattice, so it does not suffice to look for the lattice.
bool grew_in_lattice(const Model& model, const crack::Extension& e) {
  const scene::Scene& scene = model.scene();
  const double tolerance = model.prepared_or_null()->discretization.tolerance;
  const auto lies_in_elements = [&, ids = scene.region_ids()](double x, double y) {
    return std::any_of(ids.begin(), ids.end(), [&](int id) {
      return scene.region(id).has_elements() && scene::has_inside(scene, id, {x, y}, tolerance);
    });
  };
  // The end of a stopped line is not tested, because it may lie a little behind the border.
  const bool has_stopped = e.state == crack::TipState::at_interface;
  return !lies_in_elements(e.from_x, e.from_y) && (has_stopped || !lies_in_elements(e.x, e.y));
}

// Whether two extensions are equal but for loads and energies.
bool are_same(const crack::Extension& a, const crack::Extension& b) {
  const auto place = [](const crack::Extension& e) { return std::tuple(e.crack, e.end, e.x, e.y, e.from_x, e.from_y); };
  return place(a) == place(b);
}

}  // namespace

SavedState States::save(bool with_values) const {
  if (!model_.prepared_or_null()) fail(Failure::order, "there is no state yet; call bempd_prepare() or step first");
  const PreparedScene& prepared = model_.prepared();
  const LoadValues::ActingValues& loads = model_.loads().present();
  const std::uint64_t said =
      loads.acting == Acting::values
          ? load_fingerprint(model_.scene(), prepared.conditions)
          : load_fingerprint(model_.scene(), regions::apply_conditions(model_.scene(), prepared.discretization));
  std::vector<int> frozen;
  if (with_values)
    for (const auto& [crack, end] : model_.growth().frozen()) frozen.insert(frozen.end(), {crack, end});
  return {
      .scene = prepared.fingerprint,
      .load_fingerprint = said,
      .evolution = prepared.evolution->state(),
      .continuation = prepared.evolution->continuation(),
      .tips = model_.cracks().history(),
      .journal = model_.accuracy().journal(),
      .in_force = loads.in_force,
      .acting = loads.acting,
      .path_end = loads.acting == Acting::on_path ? loads.path_end : 0,
      .acting_values = model_.loads().acting_values(),
      .host_values = with_values ? std::optional(model_.scene().values()) : std::nullopt,
      .frozen = std::move(frozen),
      .overloads = numbers_of(model_.fatigue().overloads()),
  };
}

void States::restore(const SavedState& state) {
  model_.prepare();
  require(!state.host_values || state.scene.loads == model_.prepared().fingerprint.loads,
          "the state has the values of other loads, or of the same ones in another order; add those of the model that "
          "was saved, in its order");
  scene::SceneValues said =
      state.host_values ? fitted(*state.host_values, model_.scene().values()) : model_.scene().values();
  model_.preparation().scene().exchange_values(said);
  undone_on_failure([&] { restore_body(state); }, [&] { model_.preparation().scene().exchange_values(said); });
  if (!state.host_values) return;
  std::set<crack::TipId> frozen;
  for (std::size_t k = 1; k < state.frozen.size(); k += 2) frozen.insert({state.frozen[k - 1], state.frozen[k]});
  model_.growth().set_all_frozen(std::move(frozen));
}

// Whether the present scene has the cracks in elements and the lattice patches of a state.
bool States::has_grown_as(const fracture::EvolutionState& state) const {
  const fracture::EvolutionState& present = model_.prepared_or_null()->evolution->progress();
  const auto has_same = [&](std::int64_t number) {
    const auto k = static_cast<std::size_t>(regions::extension_of(number));
    return number < 0 || (k < state.extensions.size() && k < present.extensions.size() &&
                          are_same(state.extensions[k], present.extensions[k]));
  };
  if (state.layouts != present.layouts || !std::ranges::all_of(state.layouts, has_same)) return false;
  const auto in_elements = [&](std::vector<crack::Extension> extensions) {
    std::erase_if(extensions, [&](const crack::Extension& e) { return grew_in_lattice(model_, e); });
    return extensions;
  };
  return std::ranges::equal(in_elements(state.extensions), in_elements(present.extensions), are_same);
}

// Extends cracks event by event as in the run, so that operators get the same digits. Growth in lattices changes the
// scene only where the crack line has continued in elements, or its lattice patch has got more blocks.
std::unique_ptr<PreparedScene> States::as_grown(const fracture::EvolutionState& state) {
  if (has_grown_as(state)) return nullptr;
  const std::vector<crack::Extension>& extensions = state.extensions;
  std::vector<scene::Crack> cracks;
  for (const scene::Crack& crack : model_.scene().cracks())
    if (!crack.has_begun) cracks.push_back({{crack.given().begin(), crack.given().end()}, 0, 0});
  const std::size_t described = cracks.size();
  const double tolerance = model_.prepared().discretization.tolerance;
  Preparation& preparation = model_.preparation();
  preparation.scene().set_cracks(cracks);
  model_.treatments().replace_patches(model_.treatments().first_patches());
  std::unique_ptr<PreparedScene> grown;
  bool is_built = false;
  const auto build_anew = [&] {
    if (!is_built) grown = preparation.build(grown.get(), Preparation::Operators::anew);
    is_built = true;
  };
  const auto in_lattice = [&](const crack::Extension& e) { return grew_in_lattice(model_, e); };
  std::span<const std::int64_t> layouts = state.layouts;
  model_.treatments().repeat_layouts(layouts, {}, cracks);
  for (std::size_t k = 0; k < extensions.size(); ++k) {
    const crack::Extension& e = extensions[k];
    if (!in_lattice(e)) {
      const auto number = static_cast<std::size_t>(e.crack) - 1;
      require(number < described ? !cracks[number].points.empty() : number < described + extensions.size(),
              "the state's extensions are of crack ", e.crack,
              ", which the scene does not have; its bytes were altered");
      crack_with_line(cracks, e.tip(), std::span(extensions).first(k + 1), model_.scene(), tolerance);
      const auto next =
          std::find_if_not(extensions.begin() + static_cast<std::ptrdiff_t>(k) + 1, extensions.end(), in_lattice);
      if (next == extensions.end() || next->event != e.event) {
        build_anew();
        preparation.scene().set_cracks(cracks);
        grown = preparation.build(grown.get());
      }
    }
    if (model_.treatments().repeat_layouts(layouts, std::span(extensions).first(k + 1), cracks)) is_built = false;
  }
  require(layouts.empty(), "the state has more lattice patches than growth; its bytes were altered");
  build_anew();
  grown->fingerprint = model_.prepared().fingerprint;
  return grown;
}

void States::grow_as(const SavedState& state, const std::function<void()>& go_on) {
  std::vector<scene::Crack> cracks = model_.scene().cracks();
  CrackTreatments::Copy patches = model_.treatments().copy();
  std::unique_ptr<PreparedScene> before;
  try {
    std::unique_ptr<PreparedScene> grown = as_grown(state.evolution);
    require_fit(state, grown ? *grown : model_.prepared());
    if (grown) before = model_.preparation().exchange(std::move(grown));
    go_on();
  } catch (...) {
    if (before) model_.preparation().exchange(std::move(before));
    model_.growth().forget_factors();
    model_.preparation().scene().set_cracks(std::move(cracks));
    model_.treatments().go_back_to(std::move(patches));
    throw;
  }
}

LoadValues::ActingValues States::take_loads(const SavedState& state, fracture::EvolutionState& evolution) {
  LoadValues::ActingValues loads;
  if (state.in_force) loads.in_force = fitted(*state.in_force, model_.scene().values());
  regions::DofConditions conditions = model_.loads().conditions_under(model_.scene().values());
  const bool same_loads = state.load_fingerprint == load_fingerprint(model_.scene(), conditions);
  // If the saved loads differ from the present loads, the saved loads act until the next step, so that the work of the
  // change is counted.
  loads.acting = same_loads ? state.acting : Acting::earlier;
  const bool known = loads.acting == Acting::values || are_known(state.acting_values, model_.scene().values());
  if (!known) {  // unknown functions, or other loads: the present values act at once
    if (loads.acting == Acting::earlier) loads.acting = Acting::values;
    evolution.in_equilibrium = false;
    evolution.first_unit_energy = -1;
  }
  if (loads.acting != Acting::values) {
    scene::SceneValues acting = fitted(state.acting_values, model_.scene().values());
    conditions = model_.loads().conditions_under(acting);
    if (loads.acting == Acting::on_path) {
      loads.path_end = state.path_end;
    } else {
      loads.earlier = std::move(acting);
    }
  }
  model_.loads().replace(std::move(conditions), loads.acting);
  return loads;
}

void States::restore_body(const SavedState& state) {
  const SceneFingerprint& present = model_.prepared().fingerprint;
  std::vector<RememberedOverload> overloads = overloads_of(state.overloads);
  require(state.scene.body == (state.format == 14 ? present.body_of_format_14 : present.body),
          "the state belongs to another scene; restore it into the model that was saved or one built in the same way");
  require_same_ends(state, model_.prepared().in_lattices);
  require_nearby(state.evolution.extensions, model_.scene().bounding_box());
  require(state.scene.supports == present.supports,
          "the state was saved with other supports, or with the same ones in another order; add those of the model "
          "that was saved, in its order");
  fracture::EvolutionState copy = state.evolution;
  fracture::Continuation continuation = state.continuation;
  std::vector<results::TipRecord> tips = state.tips;
  RunJournal journal = RunJournal::continued(state.journal);
  LoadValues::ActingValues loads;
  grow_as(state, [&] { loads = take_loads(state, copy); });
  model_.prepared().evolution->restore(std::move(copy), std::move(continuation));
  model_.loads().present() = std::move(loads);
  model_.cracks().set_history(std::move(tips));
  model_.accuracy().journal() = std::move(journal);
  model_.fatigue().set_overloads(std::move(overloads));
  model_.preparation().has_changed();
}

}  // namespace bempd::model
