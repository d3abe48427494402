#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "model/mesh_answers.hpp"
#include "model/prepared_scene.hpp"
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

// Errors of the present results by source.
struct ErrorSources {
  MeshErrors boundary;
  double model = 0;  // difference of the next load of growth between the growth criteria
  bool has_lattices = false;
  double halving_seconds = 0, halving_bytes = 0;  // of preparing with half as long elements
};

// Mesh that the library has chosen for the bodies of a scene, or a promise of it.
struct MeshPlan {
  MeshCost cost;
  double seconds_spent = 0;  // on coarser meshes, which tell the errors
  MeshErrors errors;
  double growth_load = 0;  // load factor of the first growth; infinite if no tip grows
  crack::TipId first;
  std::vector<TipLoad> loads;
  bool meets_wish = false;  // the errors are below the option error.wanted
  bool is_solved = false;   // else errors and cost are extrapolated from coarser meshes
};

// Choice of the boundary elements of bodies: meshes with shorter and shorter elements are solved until the difference
// of their results says that errors are below the option error.wanted, or the options budget.seconds or memory.limit
// forbid the next one.
class Accuracy {
 public:
  explicit Accuracy(Model& model) : model_(model) {}

  // Plan of the mesh, for which meshes much coarser than it are solved. The model is not prepared by that.
  const MeshPlan& plan();
  // Prepares the model with the mesh chosen.
  void prepare();
  // Plan of the present mesh; empty without bodies or before the model is prepared.
  const std::optional<MeshPlan>& chosen() const { return chosen_; }
  // Errors at the present loads and cracks, for which the scene is solved with its elements merged in pairs and fours.
  ErrorSources errors_now();
  // Error of the stress intensity factors at tips of bodies, relative to the largest; 0 without bodies.
  double intensity_error() const { return chosen_ ? chosen_->errors.intensity : 0; }

  // Load factors of growth in the last plan; none without bodies.
  std::vector<TipLoad> loads_by_plan() const {
    const std::optional<MeshPlan>& last = chosen_ ? chosen_ : promised_;
    return last ? last->loads : std::vector<TipLoad>();
  }
  // The prepared scene, or the finest one that was solved to plan it. A scene without bodies is prepared.
  const PreparedScene& scene_of_plan();
  // Load factors of growth in the scene as it is described, without the plan of its mesh.
  std::vector<TipLoad> loads_of_elements();

  void forget();  // the scene or its loads have changed

 private:
  struct Level {
    MeshCost cost;
    MeshAnswers answers;
  };

  void solve_next();
  MeshCost predicted(int more) const;
  MeshErrors estimate() const;
  std::vector<MeshErrors> differences() const;
  bool wants_more() const;
  bool may_refine() const;
  MeshAnswers answers_with(const regions::Refinement& refinement, const scene::SceneValues& values, double load_factor,
                           Level* level);
  MeshPlan plan_of(const MeshCost& cost, bool is_solved) const;
  double wanted() const;
  std::uint64_t mark() const;

  Model& model_;
  std::vector<Level> levels_;
  std::uint64_t mark_ = 0;                 // of the scene and options for which levels_ are
  std::unique_ptr<PreparedScene> finest_;  // of the last level
  double tolerance_ = 0;
  std::optional<MeshPlan> promised_, chosen_;
};

}  // namespace bempd::model
