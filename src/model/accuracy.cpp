#include "model/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "error.hpp"
#include "geometry/turning.hpp"
#include "model/element_growth.hpp"
#include "model/model.hpp"
#include "regions/boundary/boundary_region.hpp"
#include "regions/memory_limit.hpp"
#include "scene/moved_values.hpp"
#include "stopwatch.hpp"

namespace bempd::model {

namespace {

// Least and largest ratio of the times of two meshes, the second with half as long elements.
constexpr double least_ratio = 2, largest_ratio = 8;

// Scenes with at most so many elements are solved with halved elements to tell errors: that is quick, and needs no
// order of convergence. The error is the difference times 8/7 for the order 3, times 2 for the order 1.
constexpr std::int64_t few_elements = 100;
constexpr double caution_of_halved = 2.25;

// Meshes with more halvings than this would only be needed for errors within rounding.
constexpr int most_halvings = 8;

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

double bytes_of(const PreparedScene& scene, double times) {
  double bytes = 0;
  for (const auto& region : scene.discretization.regions)
    if (const auto* boundary = dynamic_cast<const regions::BoundaryRegion*>(region.get()))
      bytes += boundary->memory_of_preparing(times);
  return bytes;
}

// Relative difference between the next load factors of growth by the two growth criteria; 0 if no tip grows.
double between_criteria(const std::vector<regions::TipValues>& tips) {
  const auto load_by = [&](KinkCriterion criterion) {
    double least = std::numeric_limits<double>::infinity();
    for (const regions::TipValues& tip : tips) {
      const crack::GrowthLaw law{tip.toughness, tip.plane_modulus, criterion, tip.directions,
                                 heading_of(tip.direction)};
      if (tip.toughness > 0) least = std::min(least, law.range(factors_of(tip)).highest);
    }
    return least;
  };
  const double first = load_by(KinkCriterion::hoop_stress), second = load_by(KinkCriterion::energy_release_rate);
  return std::isfinite(first) && std::isfinite(second) ? std::abs(first - second) / std::abs(first) : 0;
}

// Whether results hardly converge, as the displacement at a support or a force that acts at a point.
bool stagnates(const std::vector<MeshErrors>& differences) {
  constexpr std::size_t enough = 3;
  constexpr double least_reduction = 1.5;
  return differences.size() >= enough && expected_reduction(differences) < least_reduction;
}

const scene::OptionGroup hooks(scene::OptionPlace::test_hooks, [] {
  return std::vector<scene::OptionDescription>{
      scene::number_option("test.halvings", "Times that the elements of bodies are halved; -1: as error.wanted asks.",
                           -1, -1, most_halvings, true)};
});

}  // namespace

double Accuracy::wanted() const { return model_.options().number("error.wanted"); }

std::uint64_t Accuracy::mark() const {
  Hash hash;
  const SceneFingerprint found = fingerprint(model_.scene(), model_.options());
  hash.add(found.body), hash.add(found.supports), hash.add(found.loads);
  return hash.value();
}

void Accuracy::forget() {
  levels_.clear();
  finest_.reset();
  promised_.reset(), chosen_.reset();
}

// Results of the scene with another mesh, at a load factor. The model's own prepared scene, if there is one, is set
// aside meanwhile; `level` gets the cost and the finished scene is kept for it.
MeshAnswers Accuracy::answers_with(const regions::Refinement& refinement, const scene::SceneValues& values,
                                   double load_factor, Level* level) {
  const regions::Refinement before = regions::refine(model_.scene_, refinement);
  std::unique_ptr<PreparedScene> own = std::move(model_.prepared_);
  const auto go_back = [&] {
    std::unique_ptr<PreparedScene> used = std::exchange(model_.prepared_, std::move(own));
    regions::refine(model_.scene_, before);
    model_.tip_factors_.scene = nullptr;
    return used;
  };
  double seconds = 0;
  MeshAnswers answers;
  try {
    const Stopwatch watch(seconds);
    model_.prepared_ = model_.build(nullptr);
    model_.under(scene::moved(values, load_factor), [&](PreparedScene& scene) {
      std::vector<regions::TipValues> tips = model_.tips_of(scene, regions::TipDetail::factors);
      std::vector<TipLoad> loads = growth_loads(scene, tips, model_.frozen_tips_, load_factor);
      answers = read_answers(scene, model_.scene_.supports().size(), std::move(tips), std::move(loads));
    });
  } catch (...) {
    go_back();
    throw;
  }
  std::unique_ptr<PreparedScene> used = go_back();
  if (!level) return answers;
  const regions::Discretization& d = used->discretization;
  const regions::RegionStatistics sizes = d.statistics();
  tolerance_ = d.tolerance;
  level->cost.halvings = refinement.of_bodies;
  level->cost.elements = static_cast<double>(sizes.boundary_elements);
  level->cost.unknowns = 2 * static_cast<double>(d.positions.size());
  level->cost.material_points = sizes.material_points;
  level->cost.bonds = static_cast<std::int64_t>(used->system->terms().stiffness.size());
  level->cost.bytes = bytes_of(*used, 1);
  level->cost.seconds = seconds;
  finest_ = std::move(used);
  return answers;
}

std::vector<TipLoad> Accuracy::loads_of_elements() {
  constexpr int halvings = 1;
  return answers_with({halvings, 0}, model_.scene().values(), 1, nullptr).loads;
}

void Accuracy::solve_next() {
  const std::uint64_t now = mark();
  if (mark_ != now) forget();
  mark_ = now;
  finest_.reset();
  Level level;
  level.answers = answers_with({static_cast<int>(levels_.size()), 0}, model_.scene().values(), 1, &level);
  levels_.push_back(std::move(level));
}

std::vector<MeshErrors> Accuracy::differences() const {
  std::vector<MeshErrors> all;
  for (std::size_t k = 1; k < levels_.size(); ++k)
    all.push_back(difference(levels_[k].answers, levels_[k - 1].answers, tolerance_));
  return all;
}

MeshErrors Accuracy::estimate() const { return estimated(differences()); }

// Cost of the mesh after `more` halvings of the finest one solved.
MeshCost Accuracy::predicted(int more) const {
  MeshCost cost = levels_.back().cost;
  const MeshCost& before = levels_[levels_.size() - 2].cost;
  const double ratio = std::clamp(cost.seconds / before.seconds, least_ratio, largest_ratio);
  const double times = std::exp2(more);
  cost.bytes = bytes_of(*finest_, times);
  cost.halvings += more;
  cost.seconds *= std::pow(ratio, more);
  cost.unknowns += 4 * (times - 1) * cost.elements;
  cost.elements *= times;
  return cost;
}

// Whether the results are too far off.
bool Accuracy::wants_more() const {
  const int given = model_.options().whole_number("test.halvings");
  return given < 0 ? estimate().largest() > wanted() : levels_.back().cost.halvings < given;
}

// Whether results still converge, and time and memory allow the next mesh.
bool Accuracy::may_refine() const {
  if (levels_.size() > most_halvings || stagnates(differences())) return false;
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
  for (const Level& level : levels_) plan.seconds_spent += level.cost.seconds;
  if (is_solved) plan.seconds_spent -= cost.seconds;
  const double more = cost.halvings - levels_.back().cost.halvings;
  plan.errors = std::pow(expected_reduction(differences()), -more) * estimate();
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
  model_.treatments_.lay();
  if (promised_ && mark_ == mark()) return *promised_;
  while (levels_.size() < 2 || mark_ != mark()) solve_next();
  for (;;) {
    const double over = estimate().largest() / wanted();
    if (over <= 1 || !may_refine()) return promised_.emplace(plan_of(levels_.back().cost, true));
    if (over <= expected_reduction(differences())) return promised_.emplace(plan_of(predicted(1), false));
    solve_next();
  }
}

const PreparedScene& Accuracy::scene_of_plan() {
  if (!model_.prepared_ && regions::has_bodies(model_.scene())) plan();
  return model_.prepared_ || !finest_ ? model_.prepared() : *finest_;
}

void Accuracy::prepare() {
  if (!regions::has_bodies(model_.scene())) {
    model_.prepared_ = model_.build(nullptr);
    return;
  }
  while (levels_.size() < 2 || mark_ != mark()) solve_next();
  while (wants_more() && may_refine()) solve_next();
  chosen_ = plan_of(levels_.back().cost, true);
  regions::refine(model_.scene_, {levels_.back().cost.halvings, 0});
  model_.prepared_ = std::move(finest_);
  const char* left_over = chosen_->meets_wish ? ""
                          : stagnates(differences())
                              ? "; they hardly fall with shorter elements: does a support or a force act at a point?"
                              : "; shorter elements need more time or memory than the options allow";
  levels_.clear();
  const MeshErrors& errors = chosen_->errors;
  model_.say([&] {
    model_.log(chosen_->meets_wish ? 0 : 1,
               text("bodies have ", chosen_->cost.elements, " boundary elements; errors by estimate: displacement ",
                    errors.displacement, ", reactions ", errors.reaction, ", stress intensity factors ",
                    errors.intensity, left_over));
  });
}

ErrorSources Accuracy::errors_now() {
  PreparedScene& scene = model_.in_equilibrium();
  const fracture::EvolutionState& state = scene.evolution->progress();
  if (state.broken_bonds > 0 || state.fragments > 0 || state.separated)
    fail(Failure::order,
         "bonds have broken or a part has come off, and the scene cannot be solved with longer elements "
         "from there; ask before that");
  const double load_factor = model_.load_factor();
  const std::size_t supports = model_.scene().supports().size();
  const double tolerance = scene.discretization.tolerance;
  std::vector<regions::TipValues> tips = model_.tips_of(scene, regions::TipDetail::factors);
  ErrorSources errors;
  errors.model = between_criteria(tips);
  errors.has_lattices = scene.discretization.statistics().material_points > 0;
  errors.halving_bytes = bytes_of(scene, 2);
  std::vector<TipLoad> loads = growth_loads(scene, tips, model_.frozen_tips_, 0);
  const MeshAnswers present = read_answers(scene, supports, std::move(tips), std::move(loads));
  const int own = chosen_ ? chosen_->cost.halvings : 0;
  const auto with = [&](int halvings, double& seconds) {
    const Stopwatch watch(seconds);
    return answers_with({own, halvings}, model_.acting_values(), load_factor, nullptr);
  };
  if (scene.discretization.statistics().boundary_elements <= few_elements) {
    const MeshAnswers finer = with(1, errors.halving_seconds);
    errors.boundary = caution_of_halved * difference(finer, present, tolerance);
    return errors;
  }
  double seconds_of_coarsest = 0, seconds_of_coarser = 0;
  std::vector<MeshErrors> differences;
  const MeshAnswers coarser = with(-1, seconds_of_coarser);
  // The coarsest mesh of a body has no coarser one that would tell an order.
  if (!chosen_ || own > 1) differences.push_back(difference(coarser, with(-2, seconds_of_coarsest), tolerance));
  differences.push_back(difference(present, coarser, tolerance));
  errors.boundary = estimated(differences);
  const double ratio = seconds_of_coarsest > 0 ? seconds_of_coarser / seconds_of_coarsest : largest_ratio;
  errors.halving_seconds = seconds_of_coarser * std::pow(std::clamp(ratio, least_ratio, largest_ratio), 2);
  return errors;
}

}  // namespace bempd::model
