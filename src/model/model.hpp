#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/crack_evolution.hpp"
#include "regions/boundary_conditions.hpp"
#include "regions/discretization.hpp"
#include "scene/options.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

enum class Field { position = 1, displacement, stress, damage, traction, bond_stretch, element_stress };
enum class BondState { intact = 0, broken = 1, cut = 2 };

// A field as numbers, entry by entry.
struct FieldValues {
  std::vector<double> values;
  int components = 1;
  std::int64_t count() const { return static_cast<std::int64_t>(values.size()) / components; }
};

struct FieldSize {
  std::int64_t count;
  int components;
};

struct StepResult {
  fracture::StopReason reason;
  std::int64_t events = 0;
  std::int64_t broken_bonds = 0;
  double seconds_total = 0, seconds_solve = 0, seconds_update = 0, seconds_search = 0;
};

struct PointValue {
  int region = 0;
  Point displacement = Point::Zero();
  Eigen::Vector3d stress = Eigen::Vector3d::Zero();
};

// State of a run, tied to a scene by its fingerprint.
struct SavedState {
  std::uint64_t scene_fingerprint = 0;
  std::uint64_t load_fingerprint = 0;
  fracture::EvolutionState evolution;
};

// Everything that is built from a finished scene.
struct PreparedScene {
  Discretization discretization;
  DofConditions conditions;
  std::vector<int> cut_bonds;
  std::unique_ptr<coupling::EquilibriumSystem> system;
  std::unique_ptr<fracture::CrackEvolution> evolution;
  std::int64_t interior_kernel_evaluations = 0;
};

// A scene, its state, and what can be asked of them.
class Model {
 public:
  Options& options() { return options_; }
  const Options& options() const { return options_; }
  const Scene& scene() const { return scene_; }

  // Throws Error (order) once the model is prepared.
  Scene& editable_scene();
  void set_load_values(int load, SampledValues values);
  void set_support_values(int support, SampledValues values);

  void prepare();
  bool is_prepared() const { return prepared_ != nullptr; }
  const PreparedScene& prepared();  // prepares if needed
  const PreparedScene* prepared_or_null() const { return prepared_.get(); }

  StepResult advance(double target, fracture::Goal goal);

  using Progress = std::function<bool(double load_factor, std::int64_t events, std::int64_t broken_bonds)>;
  using Log = std::function<void(int level, const std::string& message)>;
  void set_progress(Progress progress) { progress_ = std::move(progress); }
  void set_log(Log log) { log_ = std::move(log); }
  void request_cancel() { cancel_requested_ = true; }

  double load_factor() const;
  std::int64_t generation() const { return generation_; }

  // Fields of a region; computed once per generation (fields.cpp).
  const FieldValues& field(int region, Field field);
  FieldSize field_size(int region, Field field);
  std::int64_t node_count(int region);
  std::int64_t element_count(int region);
  const LatticePart& lattice(int region);  // throws Error (argument) for a BEM region
  std::vector<BondState> bond_states(int region);
  std::vector<std::int32_t> elements(int region);  // nodes of boundary elements (3 each) or cells (4 each)

  Eigen::Vector2d reaction(int support);

  // Values at places in the body; stress only if asked for (point_values.cpp).
  std::vector<PointValue> evaluate(const std::vector<Point>& places, bool with_stress);

  // state.cpp
  SavedState save();
  void restore(const SavedState& state);

  // Files (snapshot.cpp).
  void write_snapshot(const std::string& prefix);
  void write_history(const std::string& path) const;

 private:
  void set_values(Condition& condition, const char* what, int id, SampledValues values);
  void ensure_equilibrium();
  void warn_of_condition();
  void warn_of_blas() const;
  void reload();
  void check_mechanism(const PreparedScene& prepared) const;
  FieldValues compute_field(int region, Field field);
  Eigen::VectorXd boundary_tractions(const BoundaryPart& part) const;
  std::uint64_t scene_fingerprint() const;
  std::uint64_t load_fingerprint() const;
  void log(int level, const std::string& message) const;

  Options options_;
  Scene scene_;
  std::unique_ptr<PreparedScene> prepared_;
  std::int64_t generation_ = 1;
  std::int64_t cached_generation_ = 0;
  std::map<std::pair<int, int>, FieldValues> fields_;
  struct Snapshot {
    double load_factor;
    std::string lattice_file, boundary_file;
  };
  std::map<std::string, std::vector<Snapshot>> snapshots_;  // by prefix
  Progress progress_;
  Log log_;
  std::atomic<bool> cancel_requested_{false};
  bool warned_of_energies_ = false, warned_of_condition_ = false;
};

// Bytes of a saved state and back (state.cpp); throws Error (argument) for damaged bytes.
std::vector<std::uint8_t> to_bytes(const SavedState& state);
SavedState from_bytes(const std::uint8_t* bytes, std::size_t size);

}  // namespace bempd::model
