#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "coupling/affine.hpp"
#include "fracture/crack_evolution.hpp"
#include "model/prepared_scene.hpp"
#include "model/saved_state.hpp"
#include "regions/boundary_conditions.hpp"
#include "scene/scene_values.hpp"

namespace bempd::model {

class Model;

// Values of loads and supports: those that the host sets, those that act on the body, and the time at which the values
// that were set take effect.
class LoadValues {
 public:
  explicit LoadValues(Model& model) : model_(model) {}

  // Sets values of a load or support, which act from the next step or result on.
  template <class Values>
  void set_load_values(int load, Values values);
  template <class Values>
  void set_support_values(int support, Values values);
  // Sets values at the nodes of the part of an edge on which a support or load acts: x and y for each node in order.
  void set_nodal_values(bool of_support, int id, std::vector<double> constant, std::vector<double> proportional);

  // Changes values of the scene by calling `set`. The new values act from the next step or result on.
  template <class Set>
  void change(const Set& set) {
    values_will_be_set();
    set();
    values_were_set();
  }

  // Prescribed displacements and forces on the degrees of freedom for given values of supports and loads.
  regions::DofConditions conditions_under(scene::SceneValues values) const;
  // Nodal forces [N] of the loads on some regions, with the values that act at present.
  coupling::Affine loads_in_force_on(const std::vector<int>& regions_of_body) const;
  scene::SceneValues acting_values() const;

  // Values of loads and supports that act on the body, and where they come from.
  struct ActingValues {
    Acting acting = Acting::values;
    // Values at the end of the last step, at the present load factor. Empty before the first step, when the body is at
    // rest.
    std::optional<scene::SceneValues> in_force;
    double path_end = 0;  // load factor at the end of the path of values
    // Values that act while new values of the host wait to take effect.
    std::optional<scene::SceneValues> earlier;
  };
  ActingValues& present() { return present_; }

  // Loads that acted before a change; go_back_to() lets them act again.
  struct Before {
    regions::DofConditions conditions;
    fracture::RunLoads::SavedLoads run;
    Acting acting;
    std::optional<fracture::RunLoads::Heat> heat;
    std::optional<fracture::RunLoads::FaceLoads> faces;
  };
  // Lets other values act on the prepared body. Returns the loads that acted before.
  Before replace(regions::DofConditions conditions, Acting acting);
  // Lets the values that the host has set act on the prepared body. Returns the loads that acted before.
  Before apply_pending();
  void go_back_to(Before before) noexcept;
  // Calls `read` while the prepared body is in equilibrium under other values, with its present bonds and cracks. The
  // state of the run is restored afterwards.
  void under(scene::SceneValues values, const std::function<void(PreparedScene&)>& read);
  // Ends a step in which values changed linearly: its end values, which act already, become the values in force.
  // `known` are the conditions that these values cause; empty: the conditions are computed here, because cracks have
  // grown since. After a failure the model stays at the end of the step, with the values still marked as on the way.
  void arrive(std::optional<regions::DofConditions> known, std::optional<scene::SceneValues> host_values) noexcept;

 private:
  std::optional<fracture::RunLoads::Heat> heat(const regions::DofConditions& conditions);
  std::optional<fracture::RunLoads::FaceLoads> load_faces(const regions::DofConditions& conditions);
  void values_will_be_set();
  void values_were_set();

  Model& model_;
  ActingValues present_;
};

}  // namespace bempd::model
