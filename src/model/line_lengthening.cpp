#include "model/line_lengthening.hpp"

#include <algorithm>
#include <cmath>

#include "crack/cannot_grow.hpp"
#include "geometry/turning.hpp"
#include "model/kept_cracks.hpp"

namespace bempd::model {

LineLengthening::LineLengthening(Model& model) : CrackLengthening(model, false) {
  require(scene().evolution->lines(),
          "cracks in peridynamic regions do not grow as lines, as cycles let them; set crack.rule to line or tips");
  save_accepted_state();
}

void LineLengthening::save_accepted_state() {
  accepted_ = scene().evolution->state();
  accepted_continuation_ = scene().evolution->continuation();
  in_trial_ = false;
}

void LineLengthening::return_to_accepted() {
  if (!in_trial_) return;
  scene().evolution->restore(accepted_, accepted_continuation_);
  in_trial_ = false;
  model_.preparation().has_changed();
}

namespace {

// Corrects the stress intensity factors of a grown tip around which no contour (ring) fits. They become the geometric
// mean of the factors by the stress ahead of the tip and the factors by the energy of the tip's next step. If that
// energy does not give the tip's load factor of growth, the factors stay as they are.
void scale_to_step_energy(regions::TipValues& tip, const scene::Options& options, double load_factor) {
  const bool is_told = tip.grown && tip.load_rule == crack::LoadRule::energy && tip.constant_factors.isZero(0) &&
                       load_factor > 0 && tip.critical_load_factor > 0;
  if (!is_told) return;
  const double by_stress = law_of(tip, options).kink(tip.factors).equivalent_factor;
  const double share = tip.toughness * load_factor / tip.critical_load_factor / by_stress;
  if (!(by_stress > 0) || !std::isfinite(share)) return;
  tip.factors *= std::sqrt(share), tip.proportional_factors *= std::sqrt(share);
}

}  // namespace

std::vector<regions::TipValues> LineLengthening::tips_of_lines() {
  std::vector<regions::TipValues> found = model_.cracks().tips_of_lines(false);
  const auto needs_energy = [](const regions::TipValues& tip) {
    return tip.method == regions::TipMethod::stress_ahead && tip.grown;
  };
  if (std::ranges::any_of(found, needs_energy)) found = model_.cracks().tips_of_lines();
  for (regions::TipValues& tip : found)
    if (needs_energy(tip)) scale_to_step_energy(tip, model_.options(), model_.load_factor());
  std::erase_if(found, [&](const regions::TipValues& tip) {
    return model_.growth().is_frozen(tip.id()) || !tip.factors.allFinite();
  });
  return found;
}

std::vector<regions::TipValues> LineLengthening::tips() {
  std::vector<regions::TipValues> found = CrackLengthening::tips();
  const std::vector<regions::TipValues> lines = tips_of_lines();
  found.insert(found.end(), lines.begin(), lines.end());
  return found;
}

std::vector<regions::TipValues> LineLengthening::loaded_tips(regions::TipDetail detail) {
  std::vector<regions::TipValues> found = CrackLengthening::loaded_tips(detail);
  const std::vector<regions::TipValues> lines = tips_of_lines();
  found.insert(found.end(), lines.begin(), lines.end());
  return found;
}

void LineLengthening::in_scene_of(LongerCracks* longer, const std::function<void()>& read) {
  longer && longer->grown.scene ? CrackLengthening::in_scene_of(longer, read) : read();
}

bool LineLengthening::grows_lines(const PreparedScene& scene) const {
  const std::vector<fracture::GrowingTip>& tips = scene.evolution->progress().tips;
  return std::ranges::any_of(tips, [](const fracture::GrowingTip& tip) { return !crack::has_ended(tip.state); });
}

std::vector<scene::Crack> LineLengthening::cracks() const {
  std::vector<scene::Crack> all;
  for (int id = 1; id <= model_.cracks().count(); ++id) all.push_back({points_of_path(model_.cracks().path(id)), 0, 0});
  return all;
}

int LineLengthening::region_of(const regions::TipValues& tip, const PreparedScene& scene) const {
  if (tip.method == regions::TipMethod::elements) return CrackLengthening::region_of(tip, scene);
  const scene::Scene& described = model_.scene();
  for (const auto& region : scene.discretization.regions)
    if (!described.region(region->id()).has_elements() &&
        scene::contains(described, region->id(), tip.place, scene.discretization.tolerance))
      return region->id();
  return 0;
}

// Place in boundary elements at which the next step of a crack line ends; empty if the line continues in its lattice.
std::optional<Point> LineLengthening::behind_border(const regions::TipValues& tip) const {
  const crack::Extension last = last_extension_of(tip.id(), model_.cracks().extensions());
  const regions::Discretization& discretization = model_.prepared().discretization;
  const bool is_here = last.crack > 0 && (Point(last.x, last.y) - tip.place).norm() <= discretization.tolerance;
  if (!is_here || !leaves_lattice(last, model_.scene(), discretization)) return std::nullopt;
  return place_behind_border(last, model_.scene(), discretization);
}

double LineLengthening::growth_increment(const regions::TipValues& tip) const {
  if (tip.method == regions::TipMethod::elements) return 0;
  if (const std::optional<Point> behind = behind_border(tip)) return (*behind - tip.place).norm();
  return spacing_at(tip, model_.prepared());
}

// Growth law of crack lines in the lattice around a tip; empty if the tip lies in no lattice.
std::optional<pd::TipLaw> LineLengthening::law_at(const regions::TipValues& tip, const PreparedScene& scene) const {
  const int region = region_of(tip, scene);
  const regions::RegionBonds* bonds = region == 0 ? nullptr : scene.discretization.region(region).bonds();
  return bonds ? bonds->tip_law(model_.options()) : std::nullopt;
}

double LineLengthening::spacing_at(const regions::TipValues& tip, const PreparedScene& scene) const {
  const auto law = law_at(tip, scene);
  return law ? law->spacing : 0;
}

double LineLengthening::spread(const regions::TipValues& tip, const PreparedScene& scene) const {
  if (tip.method == regions::TipMethod::elements) return 0;
  const auto law = law_at(tip, scene);
  return law ? 2 * law->horizon : 0;
}

// Distance by which the effective tip lies ahead of a tip's place. It is 0 for an initial crack, whose cut ends so that
// the effective tip is at the described place. For a line that has grown, the stress field gives the distance or, if
// its value is implausible, the mean distance of straight lines is taken.
double LineLengthening::effective_tip_ahead(const regions::TipValues& tip, const PreparedScene& scene) const {
  constexpr double in_the_mean = 0.1, farthest = 1;  // in spacings
  if (tip.method == regions::TipMethod::elements || !tip.grown) return 0;
  const double spacing = spacing_at(tip, scene);
  return std::abs(tip.felt_ahead) < farthest * spacing ? tip.felt_ahead : in_the_mean * spacing;
}

// Moves the load factor with all tips frozen. Throws Error (unsolvable) if bonds break meanwhile: they lie away from
// the tips, so the body cannot bear the load.
void LineLengthening::go_to(double load_factor) {
  std::set<crack::TipId> all;
  for (const regions::TipValues& tip : model_.cracks().tips_of_lines(false)) all.insert(tip.id());
  const std::int64_t events = scene().evolution->progress().events;
  move_load(scene(), load_factor, all);
  model_.preparation().has_changed();
  if (scene().evolution->progress().events != events || scene().evolution->progress().load_factor != load_factor)
    fail(Failure::unsolvable, "bonds break away from the tips on the way to the load factor ", load_factor,
         ", the highest of the blocks: the body does not bear it; choose lower blocks, or crack.rule = tips");
  save_accepted_state();
}

crack::Extension LineLengthening::extend(const Lengthened& one) {
  fracture::CrackEvolution& evolution = *scene().evolution;
  const crack::TipId id = one.tip.id();
  const double spacing = growth_increment(one.tip);
  const auto steps = std::max<std::int64_t>(1, std::llround(one.length / spacing));
  const double before = model_.cracks().length(id.crack);
  std::optional<Point> direction;
  if (!one.turns_by_itself) direction = turned(one.tip.direction, one.angle);
  crack::Extension whole;
  for (std::int64_t k = 0; k < steps; ++k) {
    const std::vector<crack::Extension> grown =
        evolution.lines()->advance({.tip = id, .is_driven = false, .direction = direction}).extensions;
    if (grown.empty()) {
      if (k > 0) break;
      throw crack::CannotGrow(text("no bond lies ahead of the tip of crack ", id.crack, "; it stops"));
    }
    const crack::Extension& last = grown.back();
    const double released = whole.released_energy + last.released_energy;
    whole = last;
    whole.released_energy = released;
    if (last.has_ended()) break;
    const regions::Discretization& discretization = scene().discretization;
    if (!leaves_lattice(last, model_.scene(), discretization)) continue;
    if (place_behind_border(last, model_.scene(), discretization)) break;
    if (!is_at_border(last, model_.scene(), discretization)) continue;
    evolution.events().stop_line(id);
    whole.state = crack::TipState::at_interface;
    break;
  }
  // The length of the extension is that by which the crack's path becomes longer, not the sum of the steps: the
  // effective tip of an initial crack lies ahead of the end of its cut, where the first step begins.
  whole.from_x = one.tip.place.x(), whole.from_y = one.tip.place.y();
  whole.length = model_.cracks().length(id.crack) - before;
  return whole;
}

// Continues a crack line in the boundary elements that it has reached; returns false if it continues in its lattice.
bool LineLengthening::continue_in_elements(const Lengthened& one, LongerCracks& longer) {
  std::optional<Grown> next;
  std::vector<scene::Crack> cracks;
  in_scene_of(&longer, [&] {
    if (one.tip.method == regions::TipMethod::elements || !behind_border(one.tip)) return;
    const KeptCracks kept(model_.preparation().scene(), model_.scene().cracks());
    scene().evolution->sources().bring_up_to_date();
    next = carrier_.continued_in_elements(one.tip.id(), false);
    cracks = model_.scene().cracks();
    if (!next)
      throw crack::CannotGrow(text("crack ", one.tip.crack, " has come to boundary elements in which it cannot go on"));
  });
  if (!next) return false;
  longer.grown.growth.extensions.push_back(next->growth.extensions.front());
  longer.grown.scene = std::move(next->scene), longer.cracks = std::move(cracks);
  return true;
}

LongerCracks LineLengthening::lengthened(const std::vector<Lengthened>& tips) {
  return_to_accepted();
  in_trial_ = true;
  LongerCracks longer;
  std::vector<Lengthened> in_elements, lines;
  for (const Lengthened& one : tips)
    (one.tip.method == regions::TipMethod::elements ? in_elements : lines).push_back(one);
  try {
    if (!in_elements.empty()) longer = CrackLengthening::lengthened(in_elements);
    for (const Lengthened& one : lines)
      if (!continue_in_elements(one, longer))
        in_scene_of(&longer, [&] { longer.grown.growth.extensions.push_back(extend(one)); });
    model_.preparation().has_changed();
    in_scene_of(&longer, [&] { longer.grown.tips = this->tips(); });
  } catch (...) {
    return_to_accepted();
    throw;
  }
  return longer;
}

void LineLengthening::go_on_in(LongerCracks longer) {
  if (longer.grown.scene) {
    CrackLengthening::go_on_in(std::move(longer));
  } else {
    model_.preparation().has_changed();
    if (model_.cracks().are_recorded()) model_.cracks().record();
  }
  save_accepted_state();
}

std::unique_ptr<CrackLengthening> lengthening_for(Model& model) {
  model.prepare();
  const auto& cracks = model.prepared().discretization.cracks;
  const bool in_bonds = std::any_of(cracks.begin(), cracks.end(), [](const auto& one) { return one.cuts_bonds(); });
  if (in_bonds || model.prepared().evolution->lines()) return std::make_unique<LineLengthening>(model);
  return std::make_unique<CrackLengthening>(model);
}

}  // namespace bempd::model
