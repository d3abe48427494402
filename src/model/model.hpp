#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cancellation.hpp"
#include "coupling/equilibrium_system.hpp"
#include "fracture/crack_evolution.hpp"
#include "model/fingerprint.hpp"
#include "regions/boundary_conditions.hpp"
#include "regions/discretization.hpp"
#include "results/field_cache.hpp"
#include "results/point_values.hpp"
#include "results/snapshots.hpp"
#include "scene/options.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

struct StepResult {
  fracture::StopReason reason;
  std::int64_t events = 0;
  std::int64_t broken_bonds = 0;
  double seconds_total = 0, seconds_solve = 0, seconds_update = 0, seconds_search = 0;
};

// State of a run, tied to a scene by its fingerprint.
struct SavedState {
  SceneFingerprint scene;
  std::uint64_t load_fingerprint = 0;
  fracture::EvolutionState evolution;
};

// Everything that is built from a finished scene.
struct PreparedScene {
  SceneFingerprint fingerprint;
  regions::Discretization discretization;
  regions::DofConditions conditions;
  std::vector<int> cut_bonds;
  std::unique_ptr<coupling::EquilibriumSystem> system;
  std::unique_ptr<fracture::CrackEvolution> evolution;
  std::int64_t interior_kernel_evaluations = 0;
};

struct GrowthResult {
  int tips = 0;   // that have grown
  int ended = 0;  // of them at an edge, a hole or another crack
  double load_factor = 0;
};

// A scene, its state, and what can be asked of them.
class Model {
 public:
  scene::Options& options() { return options_; }
  const scene::Options& options() const { return options_; }
  const scene::Scene& scene() const { return scene_; }

  // Throws Error (order) once the model is prepared.
  scene::Scene& editable_scene();
  // After a call that failed: what it has prepared is given up, and so is a body whose first equilibrium was not found,
  // so that the scene can be corrected.
  void call_failed(bool was_prepared, bool unsolvable) noexcept;
  void set_load_values(int load, scene::SampledValues values);
  void set_support_values(int support, scene::SampledValues values);

  void prepare();
  const PreparedScene& prepared();  // prepares if needed
  const PreparedScene* prepared_or_null() const { return prepared_.get(); }

  StepResult advance(double target, fracture::Goal goal);

  // Tips that reach their fracture energy first grow by a length, in the direction of the largest hoop stress; then the
  // scene is built anew, at the load factor at which they did. Throws Error if no tip can grow, or if a crack would cut
  // a region in two; then nothing has changed (crack_growth.cpp).
  GrowthResult grow_cracks(double length);

  using Progress = std::function<bool(double load_factor, std::int64_t events, std::int64_t broken_bonds)>;
  using Log = std::function<void(int level, const std::string& message)>;
  void set_progress(Progress progress) { progress_ = std::move(progress); }
  void set_log(Log log) { log_ = std::move(log); }
  void request_cancel() { cancel_requested_ = true; }
  // For the length of a call, which hears requests made while it runs.
  [[nodiscard]] CancellationScope hear_cancellation() {
    cancel_requested_ = false;
    return CancellationScope(&cancel_requested_);
  }

  double load_factor() const;
  std::int64_t generation() const { return generation_; }

  // What a region is made of, once prepared; throws Error (argument) if there is none of this number.
  const regions::Region& region(int id);
  // Its bonds; throws Error (argument) for a region that has none.
  std::span<const pd::Bond> bonds(int region);
  std::vector<regions::BondState> bond_states(int region);

  // Fields of a region; computed once per generation.
  const regions::FieldValues& field(int region, regions::Field field);
  regions::FieldSize field_size(int region, regions::Field field) { return this->region(region).field_size(field); }

  Eigen::Vector2d reaction(int support);
  double reaction_moment(int support, const Point& about);

  // Values at places in the body; stress only if asked for.
  std::vector<regions::PointValue> evaluate(const std::vector<Point>& places, bool with_stress);

  // Tips of cracks that have elements, by crack; computed once per generation (crack_results.cpp).
  const std::vector<regions::TipValues>& tips();
  // Openings along a crack and normal to it [m].
  std::vector<Point> crack_openings(int crack, const std::vector<double>& fractions);

  // state.cpp
  SavedState save();
  void restore(const SavedState& state);

  // Files
  void write_snapshot(const std::string& prefix);
  void write_history(const std::string& path) const;

 private:
  void set_values(scene::Condition& condition, const char* what, int id, scene::SampledValues values);
  void ensure_equilibrium();
  void warn_of_condition();
  void warn_of_held_parts();
  void warn_of_blas() const;
  void warn_of_overlap();
  void warn_of_equilibrium();  // all there is
  bool has_crack_elements() const;
  void reload();
  void rebuild_with(std::vector<scene::Crack> cracks, double load_factor, std::vector<scene::Crack> before);
  void check_mechanism(const PreparedScene& prepared) const;
  regions::Solution solution() const;
  results::FieldsOfScene fields();
  void log(int level, const std::string& message) const;
  void tell_of_preparation() const;
  void tell_of_step(const StepResult& result, std::int64_t new_fragments);

  scene::Options options_;
  scene::Scene scene_;
  std::unique_ptr<PreparedScene> prepared_;
  std::int64_t generation_ = 1;
  results::FieldCache fields_;
  results::Snapshots snapshots_;
  Progress progress_;
  Log log_;
  std::atomic<bool> cancel_requested_{false};
  std::vector<regions::TipValues> tips_;
  std::int64_t tips_generation_ = 0;
  bool warned_of_energies_ = false, warned_of_condition_ = false, warned_of_overlap_ = false;
};

// Bytes of a saved state and back (state_bytes.cpp); throws Error (argument) for damaged bytes.
std::vector<std::uint8_t> to_bytes(const SavedState& state);
SavedState from_bytes(const std::uint8_t* bytes, std::size_t size);

}  // namespace bempd::model
