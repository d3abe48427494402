#include "model/run_errors.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "error.hpp"
#include "model/model.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "stopwatch.hpp"

namespace bempd::model {

namespace {

// The error of a run's paths is their difference from those of a run with extensions twice as long, times a factor:
// least_caution_of_path plus caution_of_turns times the largest turn of an extension [rad], at most
// largest_caution_of_path. Such differences are 0.8 to 1.4 times the error where extensions turn by more than 0.05, and
// two to four times the error where they turn by 0.01 (docs/bodies.md).
constexpr double least_caution_of_path = 0.7, caution_of_turns = 20, largest_caution_of_path = 1.9;

// Number of extensions of the extra run with short extensions, which shows whether the resistance rises right after the
// first growth.
constexpr std::int64_t short_extensions = 3;
// Length of the extensions of that extra run over that of the run's own extensions (shorter). The rise of resistance
// that it shows is multiplied by caution_of_rise, because the highest resistance may lie between two extensions.
constexpr double shorter = 0.25, caution_of_rise = 1.5;

// Computing time of a repeated run over that of the run itself: with extensions twice as long (share_of_coarser), and
// with elements in place of lattice patches (share_of_elements).
constexpr double share_of_coarser = 0.5, share_of_elements = 1;

// Length of the extensions of a coarser run over that of the run's own extensions.
constexpr double longer = 2;

scene::Crack as_given(scene::Crack crack) {
  const std::span<const Point> given = crack.given();
  crack.points = std::vector<Point>(given.begin(), given.end());
  crack.grown_at_start = crack.grown_at_end = 0;
  return crack;
}

}  // namespace

// Repetition of a model's run in another mesh, from the scene at the beginning of the run. The destructor returns the
// model to the state that it had before the repetition.
class TwinRun {
 public:
  TwinRun(Model& model, int halvings, double step_share, bool takes_patches)
      : model_(model),
        frozen_(model.growth().frozen()),
        cracks_(model.scene().cracks()),
        values_(model.scene().values()),
        tip_history_(model.cracks().history()),
        journal_(model.accuracy().journal_) {
    std::vector<scene::Crack> given;
    for (const scene::Crack& crack : cracks_)
      if (!crack.has_begun) given.push_back(as_given(crack));
    regions::Refinement refinement = model.accuracy().refinement();
    refinement.of_all = halvings;
    scene::Scene& scene = model.preparation().scene();
    prepared_ = model.preparation().exchange(nullptr);
    loads_ = std::exchange(model.loads().present(), {});
    listeners_ = model.host().exchange({});
    step_share_ = std::exchange(model.accuracy().step_share_, step_share);
    scene.set_cracks(std::move(given));
    if (takes_patches) patches_ = model.treatments().set_aside();
    refinement_ = regions::refine(scene, refinement);
  }
  TwinRun(const TwinRun&) = delete;
  TwinRun& operator=(const TwinRun&) = delete;

  ~TwinRun() {
    // The operators of the repeated run are freed first, so that there is memory for restoring the model.
    model_.preparation().exchange(std::move(prepared_));
    scene::Scene& scene = model_.preparation().scene();
    regions::refine(scene, refinement_);
    if (!patches_.present.empty()) model_.treatments().bring_back(std::move(patches_));
    scene.exchange_values(values_);
    scene.set_cracks(std::move(cracks_));
    model_.loads().present() = std::move(loads_);
    model_.host().exchange(std::move(listeners_));
    model_.growth().set_all_frozen(std::move(frozen_));
    model_.cracks().set_history(std::move(tip_history_));
    model_.accuracy().step_share_ = step_share_;
    model_.accuracy().journal_ = std::move(journal_);
    model_.growth().forget_factors();
    model_.preparation().has_changed();
  }

  // Repeats the run until its cracks have grown as far as they had in the run itself.
  RunAnswers run() { return run(100 + 8 * prepared_->evolution->progress().events); }

  // Repeats the run, and stops after `most_events` events at the latest.
  RunAnswers run(std::int64_t most_events) {
    most_events_ = most_events;
    bool has_begun = false;
    for (const RunJournal::Piece& piece : journal_.pieces) {
      scene::SceneValues values = *piece.values;
      const auto take_values = [&] { model_.preparation().scene().exchange_values(values); };
      if (has_begun) {
        model_.loads().change(take_values);
      } else {
        take_values();
        model_.preparation().exchange(model_.preparation().build(nullptr));
        model_.preparation().has_changed();
      }
      has_begun = true;
      model_.growth().set_all_frozen(piece.frozen);
      run_piece(piece);
      if (model_.prepared().evolution->progress().events >= most_events_) break;
    }
    return run_answers(model_.prepared().evolution->state());
  }

 private:
  void run_piece(const RunJournal::Piece& piece) {
    if (piece.grown < 0) {
      advance(piece.end, fracture::Goal::load_factor);
      return;
    }
    const double goal = piece.grown * (1 - 1e-9);
    while (grown_ < goal && model_.prepared().evolution->progress().events < most_events_) {
      const fracture::StopReason reason = advance(piece.target, fracture::Goal::next_event);
      if (reason != fracture::StopReason::event && reason != fracture::StopReason::crack_stopped) return;
    }
  }

  fracture::StopReason advance(double target, fracture::Goal goal) {
    const fracture::StopReason reason = model_.driver().advance(target, goal).reason;
    if (reason == fracture::StopReason::requested)
      fail(Failure::cancelled, "stopped on request; the model is as it was before the call");
    const std::vector<crack::Extension>& all = model_.prepared().evolution->progress().extensions;
    for (; counted_ < all.size(); ++counted_) grown_ += all[counted_].length;
    return reason;
  }

  Model& model_;
  std::unique_ptr<PreparedScene> prepared_;
  LoadValues::ActingValues loads_;
  HostRequests::Listeners listeners_;
  std::set<crack::TipId> frozen_;
  std::vector<scene::Crack> cracks_;
  scene::SceneValues values_;
  std::vector<results::TipRecord> tip_history_;
  RunJournal journal_;
  CrackTreatments::Laid patches_;
  regions::Refinement refinement_;
  double step_share_ = 1;
  std::int64_t most_events_ = 0;
  std::size_t counted_ = 0;  // number of extensions that grown_ contains
  double grown_ = 0;
};

namespace {

void require_repeatable(const Model& model, const RunJournal& journal) {
  const scene::Scene& scene = model.scene();
  for (const int id : scene.region_ids())
    if (!scene.region(id).has_elements() && scene.region(id).part_of() == 0)
      fail(Failure::order, "region ", id, " is a lattice of the host, whose spacing decides its errors; run the scene ",
           "with half the spacing instead, or make it a body with bempd_add_body()");
  if (!journal.is_known)
    fail(Failure::order,
         "the run cannot be repeated: it has load programs, steps to values, growth by a given length or by cycles, or "
         "began from bytes of a state; ask after steps that move the load factor");
  if (!model.cracks().extensions().empty()) return;
  const PreparedScene* prepared = model.prepared_or_null();
  if (prepared && prepared->evolution->progress().broken_bonds > 0)
    fail(Failure::order,
         "cracks have grown bond by bond, which has no longer extensions to compare with; run the scene with half the "
         "spacing (bempd_set_body_lattice) and compare, or with crack.rule = line");
  fail(Failure::order, "no crack has grown yet; bempd_error_estimate() tells the errors of the present results");
}

// Errors of a run: the differences `d` between the run and a run with longer extensions, times factors of caution.
// `beginning` is the beginning of the run with shorter extensions, which may show that the resistance rises higher;
// `plan` is the mesh that was chosen for bodies, whose error of the load factor of first growth counts too.
RunDifference cautious(RunDifference d, const RunAnswers& run, const RunAnswers& beginning,
                       const std::optional<MeshPlan>& plan) {
  if (plan) d.first_growth = plan->errors.growth_load;
  if (d.is_at_start) d.peak = 0;
  d.peak = std::max({d.peak, d.first_growth, caution_of_rise * rise_above_peak(run, beginning)});
  d.path *= std::min(least_caution_of_path + caution_of_turns * largest_turn_of(run), largest_caution_of_path);
  return d;
}

}  // namespace

RunErrors errors_of_run(Model& model, double allowed) {
  const RunJournal& journal = model.accuracy().journal();
  require_repeatable(model, journal);
  RunErrors errors;
  errors.has_patches = !model.treatments().patches().empty();
  const auto events = static_cast<double>(model.prepared().evolution->progress().events);
  const double share_of_others = share_of_coarser + std::min(1.0, static_cast<double>(short_extensions) / events);
  errors.expected_seconds =
      journal.seconds * (share_of_others + (errors.has_patches ? share_of_elements * (1 + share_of_others) : 0));
  if (errors.expected_seconds > allowed) return errors;
  const Stopwatch watch(errors.seconds);
  RunAnswers run = run_answers(model.prepared().evolution->progress());
  if (errors.has_patches) {
    RunAnswers by_elements = TwinRun(model, 0, 1, true).run();
    errors.lattice = difference(run, by_elements);
    run = std::move(by_elements);
  }
  const std::optional<MeshPlan>& plan = model.accuracy().chosen();
  const int halvings = plan ? 0 : -1;  // -1: elements of the host are merged in pairs
  const RunAnswers coarser = TwinRun(model, halvings, longer, errors.has_patches).run();
  const RunAnswers beginning = TwinRun(model, 0, shorter, errors.has_patches).run(short_extensions);
  errors.boundary = cautious(difference(run, coarser), run, beginning, plan);
  errors.is_made = true;
  return errors;
}

}  // namespace bempd::model
