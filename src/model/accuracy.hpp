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
  int halvings = 0;  // of the elements of bodies
  double elements = 0, unknowns = 0;
  double seconds = 0, bytes = 0;  // that preparing and the first solution take
  std::int64_t material_points = 0, bonds = 0;
};

// Ratio of the times of two meshes, the second with half as long elements, within the usual limits.
double clamped_time_ratio(double ratio);

// Memory that the boundary elements of a scene need while it is prepared, with so many times the elements.
double bytes_of_elements(const PreparedScene& scene, double times);

// Mesh that the library has chosen for the bodies of a scene, or that it predicts from coarser meshes to choose.
struct MeshPlan {
  MeshCost cost;
  double seconds_spent = 0;  // on other meshes, which tell the errors
  MeshErrors errors;
  double growth_load = 0;  // load factor of the first growth; infinite if no tip grows
  crack::TipId first;
  std::vector<TipLoad> loads;
  bool meets_wish = false;  // the errors are below the option error.wanted
  bool is_solved = false;   // else errors and cost are extrapolated from coarser meshes
};

// Choice of the boundary elements of bodies: meshes with shorter and shorter elements are solved until the difference
// of their results says that errors are below the option error.wanted, or the options budget.seconds or memory.limit
// forbid the next one. Where the first two meshes are enough, a small scene is solved with elements halved once more to
// tell its errors: two meshes do not tell how fast errors fall.
class Accuracy {
 public:
  explicit Accuracy(Model& model) : model_(model) {}

  // Plan of the mesh, for which meshes much coarser than it are solved. The model is not prepared by that.
  const MeshPlan& plan();
  // Prepares the model with the mesh chosen.
  void prepare();
  // Plan of the present mesh; empty without bodies or before the model is prepared.
  const std::optional<MeshPlan>& chosen() const { return chosen_; }
  // Sets the errors of the stress intensity factors of tips to those by the chosen mesh, where these are larger.
  void raise_errors(std::vector<regions::TipValues>& tips) const;

  // Load factors of growth in the last plan; none without bodies.
  std::vector<TipLoad> loads_by_plan() const {
    const std::optional<MeshPlan>& last = chosen_ ? chosen_ : planned_;
    return last ? last->loads : std::vector<TipLoad>();
  }
  // The prepared scene, or the finest one that was solved to plan it. A scene without bodies is prepared.
  const PreparedScene& scene_of_plan();
  // Load factors of growth in the scene as it is described, without the plan of its mesh.
  std::vector<TipLoad> loads_of_elements();

  // Calls `read` while the scene has another mesh and is in equilibrium under `values` at `load_factor`, which is load
  // factor 0 there (scene::moved()). The model's own prepared scene, if there is one, is set aside meanwhile; the other
  // one is returned.
  std::unique_ptr<PreparedScene> solve_with(const regions::Refinement& refinement, const scene::SceneValues& values,
                                            double load_factor, const std::function<void(PreparedScene&)>& read);
  // Results that are compared between meshes, of a prepared scene that has taken the place of the model's own.
  MeshAnswers answers_of(PreparedScene& scene, double load_factor) const;

  // Steps of the run so far, which run_errors.hpp repeats.
  RunJournal& journal() { return journal_; }
  const RunJournal& journal() const { return journal_; }
  // Times that the present elements are halved.
  regions::Refinement refinement() const { return {chosen_ ? chosen_->cost.halvings : 0, 0}; }
  // Factor on the lengths of extensions that the library chooses: 1 but in tests, and in runs that are repeated to
  // estimate errors (run_errors.hpp).
  double step_share() const;

  void forget();  // the scene or its loads have changed

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
  std::uint64_t mark_ = 0;                       // of the scene and options for which levels_ are
  std::unique_ptr<PreparedScene> finest_;        // of the last level
  std::optional<MeshErrors> errors_by_halving_;  // errors of the last level by elements that are halved once more
  double seconds_of_halving_ = 0;
  double tolerance_ = 0;
  std::optional<MeshPlan> planned_, chosen_;
  RunJournal journal_;
  double step_share_ = 1;
};

}  // namespace bempd::model
