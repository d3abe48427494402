#include "model/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "error.hpp"
#include "hash.hpp"
#include "model/model.hpp"
#include "regions/memory_limit.hpp"
#include "scene/moved_values.hpp"
#include "stopwatch.hpp"

namespace bempd::model {

namespace {

// Largest number of times that elements are halved; more halvings would only be needed for errors as small as rounding.
constexpr int most_halvings = 8;

// Largest number of elements of a scene that is solved in a third mesh with halved elements to estimate errors, if the
// scene has no lattice and only two meshes were solved. The third mesh takes two to three times as long as the two
// meshes together. Scenes with tips may have more elements, since the length and the direction of (K_I, K_II) have
// errors of different orders.
constexpr double most_elements_to_halve = 125, most_elements_to_halve_with_tips = 160;

const scene::OptionGroup accuracy_group(scene::OptionPlace::general, [] {
  scene::OptionDescription budget = scene::number_option(
      "budget.seconds",
      "Time that the choice of a body's elements may take by estimate. A mesh that would take longer is not tried, and "
      "the log tells the errors that are left. 0: no limit.",
      0, 0, 1e9, false);
  budget.unit = "s";
  return std::vector<scene::OptionDescription>{
      scene::number_option("error.wanted",
                           "Error that bodies may have, relative to the largest displacement, reaction and stress "
                           "intensity factor; it chooses their boundary elements.",
                           0.01, 1e-7, 0.5, false),
      budget};
});

const scene::OptionGroup hooks(scene::OptionPlace::test_hooks, [] {
  return std::vector<scene::OptionDescription>{
      scene::number_option("test.halvings", "Times that the elements of bodies are halved; -1: as error.wanted asks.",
                           -1, -1, most_halvings, true),
      scene::number_option("test.step_share", "Lengths of extensions of cracks over the usual ones.", 1, 1e-3, 1e3,
                           false)};
});

}  // namespace

double Accuracy::wanted() const { return model_.options().number("error.wanted"); }

double Accuracy::step_share() const { return step_share_ * model_.options().number("test.step_share"); }

std::uint64_t Accuracy::mark() const {
  Hash hash;
  const SceneFingerprint found = fingerprint(model_.scene(), model_.options());
  hash.add(found.body), hash.add(found.supports), hash.add(found.loads), hash.add(mark_of_growth());
  return hash.value();
}

std::uint64_t Accuracy::mark_of_growth() const {
  Hash hash;
  for (const char* option : {"crack.criterion", "crack.load"})
    hash.add(std::string_view(model_.options().text_value(option)));
  for (const crack::TipId& tip : model_.growth().frozen()) hash.add(tip.crack), hash.add(tip.end);
  return hash.value();
}

void Accuracy::forget() {
  levels_.clear();
  errors_by_halving_.reset(), seconds_of_halving_ = 0;
  finest_.reset();
  planned_.reset(), chosen_.reset();
}

double clamped_time_ratio(double ratio) {
  constexpr double least = 2, largest = 8;
  return std::clamp(ratio, least, largest);
}

double bytes_of_elements(const PreparedScene& scene, double times) {
  double bytes = 0;
  for (const auto& region : scene.discretization.regions)
    if (const regions::RegionOperators* operators = region->operators()) bytes += operators->memory_of_preparing(times);
  return bytes;
}

std::unique_ptr<PreparedScene> Accuracy::solve_with(const regions::Refinement& refinement,
                                                    const scene::SceneValues& values, double load_factor,
                                                    const std::function<void(PreparedScene&)>& read) {
  const regions::Refinement before = regions::refine(model_.preparation().scene(), refinement);
  std::unique_ptr<PreparedScene> own = model_.preparation().exchange(nullptr);
  const auto go_back = [&] {
    std::unique_ptr<PreparedScene> used = model_.preparation().exchange(std::move(own));
    regions::refine(model_.preparation().scene(), before);
    model_.growth().forget_factors();
    return used;
  };
  try {
    model_.preparation().exchange(model_.preparation().build(nullptr));
    model_.loads().under(scene::moved(values, load_factor), read);
  } catch (...) {
    go_back();
    throw;
  }
  return go_back();
}

MeshAnswers Accuracy::answers_of(PreparedScene& scene, double load_factor) const {
  std::vector<regions::TipValues> tips = model_.cracks().tips_of(scene, regions::TipDetail::factors);
  std::vector<TipLoad> loads = growth_loads(scene, tips, model_.growth().frozen(), load_factor);
  return read_answers(scene, model_.scene().supports().size(), std::move(tips), std::move(loads));
}

std::vector<TipLoad> Accuracy::loads_of_elements() {
  constexpr int halvings = 1;
  MeshAnswers answers;
  solve_with({halvings, 0}, model_.scene().values(), 1, [&](PreparedScene& scene) { answers = answers_of(scene, 1); });
  return answers.loads;
}

Accuracy::Level Accuracy::solve(int halvings, std::unique_ptr<PreparedScene>& scene) {
  Level level;
  {
    const Stopwatch watch(level.cost.seconds);
    scene = solve_with({halvings, 0}, model_.scene().values(), 1,
                       [&](PreparedScene& other) { level.answers = answers_of(other, 1); });
  }
  const regions::Discretization& d = scene->discretization;
  const regions::RegionStatistics sizes = d.statistics();
  tolerance_ = d.tolerance;
  level.cost.halvings = halvings;
  level.cost.elements = static_cast<double>(sizes.boundary_elements);
  level.cost.unknowns = 2 * static_cast<double>(d.positions.size());
  level.cost.material_points = sizes.material_points;
  level.cost.bonds = static_cast<std::int64_t>(scene->system->terms().stiffness.size());
  level.cost.bytes = bytes_of_elements(*scene, 1);
  return level;
}

// Solves the scene with elements half as long as those of the last mesh. After a failure no mesh is known: without its
// scene the last one cannot tell the cost of the next.
void Accuracy::solve_next() {
  const std::uint64_t now = mark();
  if (mark_ != now) forget();
  mark_ = now;
  finest_.reset();  // makes room for the next one
  try {
    std::unique_ptr<PreparedScene> scene;
    levels_.push_back(solve(static_cast<int>(levels_.size()), scene));
    finest_ = std::move(scene);
  } catch (...) {
    forget();
    throw;
  }
}

// Solves a small scene, of which two meshes were solved, in a third mesh with halved elements. If the errors of the
// second mesh are larger than wanted, the third mesh is kept; else only the error estimate that it gives is kept.
// Returns whether a third mesh was solved.
bool Accuracy::solve_halved_once_more() {
  const Level& last = levels_.back();
  const double most = last.answers.tips.empty() ? most_elements_to_halve : most_elements_to_halve_with_tips;
  const bool is_small = last.cost.elements <= most && last.cost.material_points == 0;
  if (errors_by_halving_ || levels_.size() != 2 || !is_small || !may_refine()) return false;
  std::unique_ptr<PreparedScene> scene;
  Level finer = solve(static_cast<int>(levels_.size()), scene);
  errors_by_halving_ = estimated_by_finer(finer.answers, last.answers, tolerance_, model_.options());
  seconds_of_halving_ = finer.cost.seconds;
  if (wants_more()) {
    errors_by_halving_.reset(), seconds_of_halving_ = 0;
    levels_.push_back(std::move(finer));
    finest_ = std::move(scene);
  }
  return true;
}

std::vector<const MeshAnswers*> Accuracy::meshes() const {
  std::vector<const MeshAnswers*> all;
  for (const Level& level : levels_) all.push_back(&level.answers);
  return all;
}

MeshErrors Accuracy::estimate() const {
  return errors_by_halving_ ? *errors_by_halving_ : estimated(meshes(), tolerance_, model_.options());
}

double Accuracy::reduction() const { return expected_reduction(meshes(), tolerance_, model_.options()); }

// Whether the differences between meshes hardly fall with shorter elements, as where a support or a force acts at a
// point.
bool Accuracy::stagnates() const {
  constexpr std::size_t enough = 4;  // number of meshes that shows this
  constexpr double least_reduction = 1.5;
  return levels_.size() >= enough && reduction() < least_reduction;
}

// Size and cost of the mesh after `more` halvings of the finest mesh that was solved, extrapolated from the last two
// meshes.
MeshCost Accuracy::predicted(int more) const {
  MeshCost cost = levels_.back().cost;
  const MeshCost& before = levels_[levels_.size() - 2].cost;
  const double ratio = clamped_time_ratio(cost.seconds / before.seconds);
  const double times = std::exp2(more);
  cost.bytes = bytes_of_elements(*finest_, times);
  cost.halvings += more;
  cost.seconds *= std::pow(ratio, more);
  cost.unknowns += 4 * (times - 1) * cost.elements;
  cost.elements *= times;
  return cost;
}

// Whether the errors of the finest mesh are larger than wanted, or the option test.halvings asks for more halvings.
bool Accuracy::wants_more() const {
  const int given = model_.options().whole_number("test.halvings");
  return given < 0 ? estimate().largest() > wanted() : levels_.back().cost.halvings < given;
}

// Whether shorter elements still reduce the errors, and time and memory allow the next mesh.
bool Accuracy::may_refine() const {
  if (levels_.size() > most_halvings || stagnates()) return false;
  const MeshCost next = predicted(1);
  double spent = 0;
  for (const Level& level : levels_) spent += level.cost.seconds;
  const double budget = model_.options().number("budget.seconds");
  if (budget > 0 && spent + next.seconds > budget) return false;
  return next.bytes <= regions::memory_allowed(model_.options());
}

MeshPlan Accuracy::plan_of(const MeshCost& cost, bool is_solved) const {
  MeshPlan plan;
  plan.cost = cost;
  plan.seconds_spent = seconds_of_halving_;
  for (const Level& level : levels_) plan.seconds_spent += level.cost.seconds;
  if (is_solved) plan.seconds_spent -= cost.seconds;
  const double more = cost.halvings - levels_.back().cost.halvings;
  plan.errors = std::pow(reduction(), -more) * estimate();
  plan.growth_load = levels_.back().answers.growth_load;
  plan.first = levels_.back().answers.first;
  plan.loads = levels_.back().answers.loads;
  plan.meets_wish = plan.errors.largest() <= wanted();
  plan.is_solved = is_solved;
  return plan;
}

const MeshPlan& Accuracy::plan() {
  require(regions::has_bodies(model_.scene()), "the scene has no body; add one with bempd_add_body()");
  if (chosen_) return *chosen_;
  model_.treatments().add_patches();
  if (planned_ && mark_ == mark()) return *planned_;
  while (levels_.size() < 2 || mark_ != mark()) solve_next();
  for (;;) {
    const double over = estimate().largest() / wanted();
    if (over <= 1 || !may_refine()) {
      if (solve_halved_once_more()) continue;
      return planned_.emplace(plan_of(levels_.back().cost, true));
    }
    if (over <= reduction()) return planned_.emplace(plan_of(predicted(1), false));
    solve_next();
  }
}

const PreparedScene& Accuracy::scene_of_plan() {
  if (!model_.prepared_or_null() && regions::has_bodies(model_.scene())) plan();
  return model_.prepared_or_null() || !finest_ ? model_.prepared() : *finest_;
}

void Accuracy::prepare() {
  if (!regions::has_bodies(model_.scene())) {
    model_.preparation().exchange(model_.preparation().build(nullptr));
    return;
  }
  while (levels_.size() < 2 || mark_ != mark()) solve_next();
  do {
    while (wants_more() && may_refine()) solve_next();
  } while (solve_halved_once_more());
  MeshPlan plan = plan_of(levels_.back().cost, true);
  regions::refine(model_.preparation().scene(), {levels_.back().cost.halvings, 0});
  model_.preparation().exchange(std::move(finest_));
  chosen_ = std::move(plan);
  const char* left_over = chosen_->meets_wish ? ""
                          : stagnates()
                              ? "; they hardly fall with shorter elements: does a support or a force act at a point?"
                              : "; shorter elements need more time or memory than the options allow";
  levels_.clear();
  errors_by_halving_.reset(), seconds_of_halving_ = 0;
  const MeshErrors& errors = chosen_->errors;
  say([&] {
    model_.reports().log(chosen_->meets_wish ? 2 : 1, text("bodies have ", chosen_->cost.elements,
                                                           " boundary elements; errors by estimate: displacement ",
                                                           errors.displacement, ", reactions ", errors.reaction,
                                                           ", stress intensity factors ", errors.intensity, left_over));
  });
}

}  // namespace bempd::model
