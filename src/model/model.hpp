#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "cancellation.hpp"
#include "crack/path.hpp"
#include "fracture/crack_evolution.hpp"
#include "linalg/external_solver.hpp"
#include "model/accuracy.hpp"
#include "model/answers.hpp"
#include "model/edge_results.hpp"
#include "model/fatigue.hpp"
#include "model/host_listener.hpp"
#include "model/load_cases.hpp"
#include "model/pieces.hpp"
#include "model/prepared_scene.hpp"
#include "model/results.hpp"
#include "model/saved_state.hpp"
#include "model/tip_factors.hpp"
#include "regions/boundary_conditions.hpp"
#include "regions/discretization.hpp"
#include "regions/tips/tip_rings.hpp"
#include "results/snapshots.hpp"
#include "results/tip_record.hpp"
#include "scene/load_table.hpp"
#include "scene/names.hpp"
#include "scene/options.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

struct Growing;
struct Grown;
enum class Turning;
class ElementCarrier;
class CrackLengthening;

// Model of a host: its scene and the state of the run. It prepares the scene, applies loads, grows cracks, and saves
// states; Results, Pieces and EdgeResults answer requests for results.
class Model {
 public:
  scene::Options& options() { return options_; }
  const scene::Options& options() const { return options_; }
  const scene::Scene& scene() const { return scene_; }

  // Scene for changes. Throws Error (order) once the model is prepared.
  scene::Scene& editable_scene();
  // Cleans up after a failed call: discards what the call has prepared. A body whose first equilibrium was not found
  // (`unsolvable`) is discarded too, so that the host can correct the scene.
  void call_failed(bool was_prepared, bool unsolvable) noexcept;
  template <class Values>
  void set_load_values(int load, Values values);
  template <class Values>
  void set_support_values(int support, Values values);
  // Sets one value for each node of a support's or load's edge part, as pairs of x and y.
  void set_nodal_values(bool of_support, int id, std::vector<double> constant, std::vector<double> proportional);

  void prepare();
  PreparedScene& prepared();        // prepares if needed
  PreparedScene& in_equilibrium();  // likewise, under the values that were set
  const PreparedScene* prepared_or_null() const { return prepared_.get(); }

  // Prescribed displacements and forces on the degrees of freedom for given values of supports and loads.
  regions::DofConditions conditions_under(scene::SceneValues values);
  // Nodal forces [N] of the loads on some regions, with the values that act at present.
  coupling::Affine loads_in_force_on(const std::vector<int>& regions_of_body);

  // Steps (loads.cpp). advance() changes the load factor. advance_to_values() also changes loads and supports, linearly
  // from the values at the end of the last step to those that the host has set since.
  StepResult advance(double target, fracture::Goal goal);
  StepResult advance_to_values(double target, fracture::Goal goal);
  // Runs a table of load values row by row from the present load factor, which is the table's time (programs.cpp).
  StepResult run_program(const scene::LoadTable& table, fracture::Goal goal);

  // Extends the tips that become critical first by a length, at their critical load factor; unchanged operators of the
  // scene are kept. Throws Error and changes nothing if no tip can grow (crack_growth.cpp).
  GrowthResult grow_cracks(double length);
  void set_tip_frozen(int crack, int end, bool frozen);
  bool is_frozen(const crack::TipId& tip) const { return frozen_tips_.contains(tip); }
  std::span<const fracture::CrackExtension> extensions() const;

  using Progress = std::function<bool(double load_factor, std::int64_t events, std::int64_t broken_bonds)>;
  using Log = std::function<void(int level, const std::string& message)>;
  void set_progress(Progress progress) { progress_ = std::move(progress); }
  void set_log(Log log) {
    phases_.write(log);
    log_ = std::move(log);
  }
  void request_cancel() { cancel_requested_ = true; }
  void request_stop() { stop_requested_ = true; }
  void set_phase_progress(HostListener::Function function) { phases_.tell(std::move(function)); }
  const std::atomic<bool>* stop_request() const { return &stop_requested_; }
  PhaseListener* phase_listener() { return phases_.or_null(); }
  // Number of threads that the BLAS may use in a call.
  int blas_threads() const { return std::max(1, options_.whole_number("threads")); }
  // Solver of the sparse systems in calls (solver_choice.cpp). A solver from outside is set before the model is
  // prepared, else Error (order); null takes it away again, with all that it has factorized.
  linalg::SolverChoice solver_choice() const;
  void set_external_solver(std::shared_ptr<linalg::ExternalSolver> solver);
  // Begins a call: forgets earlier requests to cancel or stop, and lets the returned scope listen to new ones.
  [[nodiscard]] CancellationScope hear_requests() {
    cancel_requested_ = stop_requested_ = false;
    return CancellationScope(&cancel_requested_);
  }

  // Names that the host gave to parts of the scene; messages and files show them.
  scene::Names& names() { return names_; }
  const scene::Names& names() const { return names_; }

  double load_factor() const;
  fracture::LoadInterval admissible_load_factors();
  std::int64_t generation() const { return generation_; }

  // Results of the body in equilibrium, of pieces and of edges; crack results have functions of their own.
  Results& results() { return results_; }
  Pieces& pieces() { return pieces_; }
  EdgeResults& edges() { return edges_; }
  Fatigue& fatigue() { return fatigue_; }
  const Fatigue& fatigue() const { return fatigue_; }
  Accuracy& accuracy() { return accuracy_; }
  LoadCases& load_cases() { return load_cases_; }
  const LoadCases& load_cases() const { return load_cases_; }
  // Whether the body counts as separated although bonds still connect the held part and the loaded part, like a hinge.
  bool hangs();

  // Tips of cracks with elements, then tips in lattices, each sorted by crack; computed once for each generation
  // (crack_results.cpp).
  const std::vector<regions::TipValues>& tips();
  const std::vector<results::TipRecord>& tip_history() const { return tip_history_; }
  // Number of cracks: described ones, then those that began in the run. The other functions give path and length of a
  // crack (crack_results.cpp).
  int crack_count() const;
  std::vector<crack::PathVertex> crack_path(int crack) const;
  double crack_length(int crack) const;  // 0: of all
  // Tangential and normal openings of a crack at fractions of its length [m].
  std::vector<Point> crack_openings(int crack, const std::vector<double>& fractions);

  // Saving and restoring states (state.cpp).
  SavedState save(bool with_values = false) const;
  void restore(const SavedState& state);

  // Result files (files.cpp).
  void write_snapshot(const std::string& prefix);
  void write_history(const std::string& path) const;
  void write_tips(const std::string& path) const;

 private:
  friend class Accuracy;
  friend class CrackLengthening;
  friend class ElementCarrier;
  friend class LineLengthening;
  friend class LoadCases;

  void restore_body(const SavedState& state);
  // Runs to a target. `on_way` are the values of loads and supports that act; null for those that the host has set.
  StepResult run(double target, fracture::Goal goal, const scene::SceneValues* on_way = nullptr);
  StepResult run_to_row(const scene::LoadTable& table, std::size_t row, const scene::SceneValues& given,
                        fracture::Goal goal);
  struct Loads {
    Acting acting = Acting::values;
    // Values at the end of the last step, at the present load factor. Empty before the first step, when the body is at
    // rest.
    std::optional<scene::SceneValues> in_force;
    double end_of_way = 0;                     // load factor
    std::optional<scene::SceneValues> others;  // that act, while others do
  };
  struct LoadsBefore {  // to come back to
    regions::DofConditions conditions;
    fracture::CrackEvolution::Loads run;
    Acting acting;
    std::optional<fracture::CrackEvolution::Heat> heat;
    std::optional<fracture::CrackEvolution::FaceLoads> faces;
  };
  LoadsBefore replace_loads(regions::DofConditions conditions, Acting acting);
  void go_back_to(LoadsBefore before) noexcept;
  // Calls `read` while the prepared body is in equilibrium under other values, in the state in which it is.
  void under(scene::SceneValues values, const std::function<void(PreparedScene&)>& read);
  void apply_pending_values();
  scene::SceneValues acting_values() const;
  std::optional<fracture::CrackEvolution::Heat> heat(const regions::DofConditions& conditions);
  std::optional<fracture::CrackEvolution::FaceLoads> load_faces(const regions::DofConditions& conditions);
  void values_will_be_set();
  void values_were_set();
  void arrive(std::optional<regions::DofConditions> known, std::optional<scene::SceneValues> said) noexcept;
  void ensure_equilibrium();
  void warn_of_condition();
  void warn_of_held_parts();
  void warn_of_blas() const;
  void warn_of_overlap();
  void warn_of_interface();
  void tell_of_hinge();
  void warn_of_equilibrium();  // all there is
  bool has_crack_elements() const;
  bool records_tips() const { return options_.whole_number("tips.record") > 0; }
  void record_tips();
  // Runs, records tips and calls the host's progress function; returns to the start of the run if that fails
  // (recording.cpp).
  void run_recording(double target, fracture::Goal goal, const fracture::SteppingOptions& stepping,
                     ElementCarrier& elements, StepResult& result);
  std::vector<regions::TipValues> compute_tips() const;
  void look_past_switches(std::vector<regions::TipValues>& tips);
  std::vector<regions::TipValues> tips_in_lattices() const;
  std::vector<regions::TipValues> tips_of_lines() const;
  std::vector<Point> openings_in_lattices(int crack, const std::vector<double>& fractions) const;
  std::vector<std::vector<Point>> paths_in_lattices() const;  // none of a crack with elements
  int crack_nearest(const Point& place, const std::vector<std::vector<Point>>& paths) const;
  std::vector<regions::CrackPicture> crack_pictures() const;
  // Builds the prepared scene. `before` is the scene with shorter cracks, whose unchanged operators are reused; null if
  // there is none.
  std::unique_ptr<PreparedScene> build(const PreparedScene* before) const;
  std::vector<regions::TipValues> tips_of(const PreparedScene& prepared, regions::TipDetail detail) const;
  const std::vector<regions::TipValues>& tip_factors();
  std::vector<regions::TipValues> growing_tips();
  std::vector<regions::TipValues> free_tips();
  Growing go_to_growth(double length);
  std::unique_ptr<PreparedScene> extended_scene(const std::vector<scene::Crack>& before, Growing& growing,
                                                const scene::SceneValues* on_way);
  std::vector<crack::TipId> entering(const regions::Discretization& next) const;
  std::unique_ptr<PreparedScene> built_with(std::vector<scene::Crack> longer, const scene::SceneValues* on_way);
  std::unique_ptr<PreparedScene> with_cracks(std::vector<scene::Crack> longer, const scene::SceneValues* on_way);
  // Prepares the scene after a growth. `chosen`: the library has chosen the lengths and may shorten them.
  Grown grown(const std::vector<scene::Crack>& before, Growing growing, Turning turning,
              const scene::SceneValues* on_way);
  bool drives_elements(const fracture::SteppingOptions& stepping) const;
  // Scene with the crack growth of a saved state; null if the present scene has it already.
  std::unique_ptr<PreparedScene> as_grown(const std::vector<fracture::CrackExtension>& extensions);
  void check_mechanism(const PreparedScene& prepared) const;
  void grow_lines(PreparedScene& prepared) const;
  fracture::ContactPlan contact_plan(const PreparedScene& prepared) const;
  void add_crack_fluid(PreparedScene& prepared) const;
  regions::Solution solution() const { return solution_of(*prepared_); }
  void log(int level, const std::string& message) const;
  // Runs code that only reports on finished work. Failures are ignored: a call must not fail for lack of memory for a
  // message.
  template <class Body>
  static void say(const Body& body) noexcept {
    try {
      body();
    } catch (...) {
    }
  }
  void tell_of_preparation() const;
  void tell_of_step(const StepResult& result, std::int64_t new_fragments, bool upwards);
  void tell_of_growth(const fracture::Growth& growth, const PreparedScene& before) const;
  void tell_of_whole_body();

  scene::Options options_;
  std::shared_ptr<linalg::ExternalSolver> external_solver_;
  scene::Scene scene_;
  scene::Names names_;
  std::unique_ptr<PreparedScene> prepared_;
  Loads loads_;
  std::int64_t generation_ = 1;
  Results results_{*this};
  Pieces pieces_{*this};
  EdgeResults edges_{*this};
  Fatigue fatigue_{*this};
  LoadCases load_cases_{*this};
  Accuracy accuracy_{*this};
  results::Snapshots snapshots_;
  Progress progress_;
  Log log_;
  HostListener phases_;
  std::atomic<bool> cancel_requested_{false}, stop_requested_{false};
  std::vector<regions::TipValues> tips_;
  std::int64_t tips_generation_ = 0;
  std::vector<results::TipRecord> tip_history_;
  std::set<crack::TipId> frozen_tips_;
  TipFactors tip_factors_;
  bool warned_of_energies_ = false, warned_of_condition_ = false, warned_of_overlap_ = false;
  bool warned_of_interface_ = false, warned_of_hinge_ = false, told_of_whole_body_ = false;
};

}  // namespace bempd::model
