#include "model/crack_lengthening.hpp"

#include "undo.hpp"

namespace bempd::model {

void move_load(PreparedScene& scene, double load_factor, const std::set<crack::TipId>& frozen) {
  if (scene.evolution->progress().load_factor == load_factor) return;
  fracture::SteppingOptions stepping;
  stepping.frozen = frozen;
  scene.evolution->advance(load_factor, fracture::Goal::load_factor, stepping, {}, {});
}

Model& CrackLengthening::prepared(Model& model) {
  model.prepare();
  return model;
}

CrackLengthening::CrackLengthening(Model& model, bool in_elements)
    : model_(prepared(model)), carrier_(model, nullptr, true) {
  require(!in_elements || model_.cracks().have_elements(),
          "no crack in a BEM region has a tip; add one, or let cracks in peridynamic regions grow by steps");
  if (model_.loads().present().acting != Acting::values) loads_ = model_.loads().apply_pending();
  present_ = model_.scene().cracks();
  state_ = model_.prepared().evolution->state();
  continuation_ = model_.prepared().evolution->continuation();
  recorded_ = model_.cracks().history().size();
  undone_on_failure([&] { model_.in_equilibrium(); }, [&] { take_back(); });
}

void CrackLengthening::go_to(double load_factor) {
  move_load(model_.prepared(), load_factor, model_.growth().frozen());
  model_.preparation().has_changed();
}

// Extends tips in a trial, and records with each extension the energy that the body releases. Below the toughness all
// of this energy goes into the process that lets the crack grow, such as fatigue, so none becomes kinetic energy.
LongerCracks CrackLengthening::lengthened(const std::vector<Lengthened>& tips) {
  Growing growing;
  growing.load_factor = growing.critical_load_factor = model_.load_factor();
  growing.ratio = 0;
  growing.is_driven = false;
  for (const Lengthened& one : tips) {
    const regions::TipValues& tip = one.tip;
    const crack::GrowthLaw law =
        law_of(tip, model_.options()).with_host_toughness(factors_of(tip), growing.load_factor);
    crack::Extension extension = crack::begin_extension(tip.id(), tip.place, one.angle, growing.load_factor,
                                                        factors_of(tip), law.resistance(one.angle));
    const Kink kink = law.kink(factors_of(tip), growing.load_factor);
    const double factor = kink.equivalent_factor;
    extension.rate_before = factor > 0 ? law.rate(kink) : 0;
    growing.tips.push_back(tip);
    growing.extensions.push_back(extension);
    growing.lengths.push_back(one.length);
    if (law.toughness > 0) growing.ratio = std::max(growing.ratio, factor / law.toughness);
  }
  LongerCracks longer;
  longer.grown = carrier_.longer(present_, growing, ExtensionDirections::given);
  longer.cracks = model_.scene().cracks();
  model_.preparation().scene().set_cracks(present_);
  return longer;
}

GrowthResult CrackLengthening::grown_first(const Growing& growing) {
  LongerCracks longer;
  longer.grown = carrier_.longer(present_, growing, ExtensionDirections::by_option);
  longer.cracks = model_.scene().cracks();
  GrowthResult result = result_of(longer.grown.growth);
  result.released_energy =
      longer.grown.scene->evolution->progress().released_energy - scene().evolution->progress().released_energy;
  go_on_in(std::move(longer));
  return result;
}

void CrackLengthening::go_on_in(LongerCracks longer) {
  present_ = longer.cracks;
  model_.preparation().scene().set_cracks(std::move(longer.cracks));
  carrier_.go_on_in(std::move(longer.grown.scene), longer.grown.growth);
  if (model_.cracks().are_recorded()) model_.cracks().record();
}

void CrackLengthening::in_scene_of(LongerCracks* longer, const std::function<void()>& read) {
  if (!longer) return read();
  const auto exchange = [&](const std::vector<scene::Crack>& cracks) {
    longer->grown.scene = model_.preparation().exchange(std::move(longer->grown.scene));
    model_.growth().forget_factors();
    model_.preparation().has_changed();
    model_.preparation().scene().set_cracks(cracks);
  };
  exchange(longer->cracks);
  undone_afterwards(read, [&] { exchange(present_); });
}

void CrackLengthening::report_progress() {
  check_cancelled();
  const fracture::EvolutionState& state = model_.prepared().evolution->progress();
  if (!model_.host().goes_on(state))
    fail(Failure::cancelled, "the progress callback asked to stop; the model is as it was before the call");
  if (model_.host().cancel_requested())
    fail(Failure::cancelled, "cancelled on request; the model is as it was before the call");
}

void CrackLengthening::keep_result() noexcept {
  model_.accuracy().journal().is_known = false;
  say([&] {
    model_.loads().present().in_force = model_.scene().values();
    model_.reports().warn_of_equilibrium();
  });
}

void CrackLengthening::take_back() noexcept {
  carrier_.take_back();
  model_.cracks().keep_records(recorded_);
  model_.prepared().evolution->restore(std::move(state_), std::move(continuation_));
  if (loads_) model_.loads().go_back_to(std::move(*loads_));
  model_.preparation().has_changed();
}

}  // namespace bempd::model
