#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "model/mesh_errors.hpp"
#include "model/prepared_scene.hpp"
#include "model/run_journal.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "scene/scene_values.hpp"

namespace bempd::model {

class Model;

// Size and cost of a mesh of the scene.
struct MeshCost {
  int halvings = 0;  // number of times that the elements of bodies are halved
  double elements = 0, unknowns = 0;
  double seconds = 0, bytes = 0;  // time [s] and memory [bytes] for preparing the scene and its first solution
  std::int64_t material_points = 0, bonds = 0;
};

// Ratio of the time for a mesh with halved elements to the time for the mesh itself, limited to the usual range 2 to 8.
double clamped_time_ratio(double ratio);

// Memory that the boundary elements of a scene need while it is prepared, with `times` as many elements [bytes].
double bytes_of_elements(const PreparedScene& scene, double times);

// Mesh for the bodies of a scene (regions whose elements the library chooses): either chosen and solved, or predicted
// from coarser meshes.
struct MeshPlan {
  MeshCost cost;
  double seconds_spent = 0;  // time for other meshes, which give the errors [s]
  MeshErrors errors;
  double growth_load = 0;      // load factor of the first growth; infinite if no tip grows
  crack::TipId first;          // tip that grows first
  std::vector<TipLoad> loads;  // load factor of growth of each tip
  bool meets_wish = false;     // whether the errors are below the option error.wanted
  bool is_solved = false;      // false: errors and cost are extrapolated from coarser meshes
};

// Choice of the boundary elements of bodies (regions whose elements the library chooses). Meshes with ever shorter
// elements are solved until the difference of their results shows that errors are below the option error.wanted, or
// until the options budget.seconds or memory.limit forbid the next mesh. If two meshes suffice, a small scene is solved
// once more with halved elements to estimate the errors, because two meshes do not show how fast errors fall.
class Accuracy {
 public:
  explicit Accuracy(Model& model) : model_(model) {}

  // Plan of the mesh, found by solving coarser meshes or the planned mesh itself. The model stays unprepared.
  const MeshPlan& plan();
  // Prepares the model with the mesh that the library chooses for bodies.
  void prepare();
  // Plan of the mesh in use; empty if the scene has no bodies, or before the model is prepared.
  const std::optional<MeshPlan>& chosen() const { return chosen_; }
  // Raises the error of each tip's stress intensity factors to that of the chosen mesh, if the latter is larger.
  void raise_errors(std::vector<regions::TipValues>& tips) const;

  // Load factor at which each tip first grows, as found for the last MeshPlan; empty if the scene has no bodies or no
  // mesh was planned.
  std::vector<TipLoad> loads_by_plan() const {
    const std::optional<MeshPlan>& last = chosen_ ? chosen_ : planned_;
    return last ? last->loads : std::vector<TipLoad>();
  }
  // Prepared scene of the model. Before the model is prepared: the finest scene that was solved for the plan of the
  // mesh or, if the scene has no bodies (regions whose elements the library chooses), the scene, which is prepared now.
  const PreparedScene& scene_of_plan();
  // Load factor at which each tip of the present scene first grows, computed with the elements of bodies halved once,
  // whatever mesh the plan would choose.
  std::vector<TipLoad> loads_of_elements();

  // Calls `read` with the scene in another mesh and in equilibrium under `values` at `load_factor`. In that scene this
  // load factor counts as 0 (scene::moved()). Meanwhile the model's own prepared scene, if any, is set aside. Returns
  // the scene with the other mesh.
  std::unique_ptr<PreparedScene> solve_with(const regions::Refinement& refinement, const scene::SceneValues& values,
                                            double load_factor, const std::function<void(PreparedScene&)>& read);
  // Results that are compared between meshes, of a scene in equilibrium at a load factor. `scene` must have taken the
  // place of the model's own prepared scene.
  MeshAnswers answers_of(PreparedScene& scene, double load_factor) const;

  // Record of the steps of the run so far, by which the run can be repeated in another mesh (run_errors.hpp).
  RunJournal& journal() { return journal_; }
  // Number of times that the elements of bodies are halved at present.
  regions::Refinement refinement() const { return {chosen_ ? chosen_->cost.halvings : 0, 0}; }
  // Factor by which the lengths of extensions that the library chooses are multiplied: 1, except in tests and in runs
  // that are repeated to estimate errors (run_errors.hpp).
  double step_share() const;

  // Drops all meshes that were solved and all plans, because the scene or its loads have changed.
  void forget();
  // Hash of what decides when tips grow beside the scene: options, and tips that the host has frozen.
  std::uint64_t mark_of_growth() const;

 private:
  friend class TwinRun;
  struct Level {
    MeshCost cost;
    MeshAnswers answers;
  };

  Level solve(int halvings, std::unique_ptr<PreparedScene>& scene);
  void solve_next();
  bool solve_halved_once_more();
  MeshCost predicted(int more) const;
  MeshErrors estimate() const;
  std::vector<const MeshAnswers*> meshes() const;
  double reduction() const;
  bool stagnates() const;
  bool wants_more() const;
  bool may_refine() const;
  MeshPlan plan_of(const MeshCost& cost, bool is_solved) const;
  double wanted() const;
  std::uint64_t mark() const;

  Model& model_;
  std::vector<Level> levels_;
  std::uint64_t mark_ = 0;                 // fingerprint of the scene and options of levels_
  std::unique_ptr<PreparedScene> finest_;  // prepared scene of the last level
  // Errors of the last of `levels_`, estimated by a mesh with its elements halved once more; empty without such a mesh.
  std::optional<MeshErrors> errors_by_halving_;
  double seconds_of_halving_ = 0;
  double tolerance_ = 0;
  std::optional<MeshPlan> planned_, chosen_;
  RunJournal journal_;
  double step_share_ = 1;
};

}  // namespace bempd::model
