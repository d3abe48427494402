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

// Values of loads and supports: those that the host sets, those that act on the body, and the time at which the first
// become the second.
class LoadValues {
 public:
  explicit LoadValues(Model& model) : model_(model) {}

  // Sets values, which act from the next step or result on.
  template <class Values>
  void set_load_values(int load, Values values);
  template <class Values>
  void set_support_values(int support, Values values);
  // Sets one value for each node of a support's or load's edge part, as pairs of x and y.
  void set_nodal_values(bool of_support, int id, std::vector<double> constant, std::vector<double> proportional);

  // Changes values of the scene by `set`, in other ways than above; they also act from the next step or result on.
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

  struct ActingValues {
    Acting acting = Acting::values;
    // Values at the end of the last step, at the present load factor. Empty before the first step, when the body is at
    // rest.
    std::optional<scene::SceneValues> in_force;
    double path_end = 0;                        // load factor
    std::optional<scene::SceneValues> earlier;  // that act, while others do
  };
  ActingValues& present() { return present_; }
  const ActingValues& present() const { return present_; }

  struct Before {  // to come back to
    regions::DofConditions conditions;
    fracture::RunLoads::SavedLoads run;
    Acting acting;
    std::optional<fracture::RunLoads::Heat> heat;
    std::optional<fracture::RunLoads::FaceLoads> faces;
  };
  // Lets other values act on the prepared body, or those that the host has set.
  Before replace(regions::DofConditions conditions, Acting acting);
  Before apply_pending();
  void go_back_to(Before before) noexcept;
  // Calls `read` while the prepared body is in equilibrium under other values, in the state in which it is.
  void under(scene::SceneValues values, const std::function<void(PreparedScene&)>& read);
  // Ends a path of values at its end values, which act already: enters them as the values in force, with the conditions
  // `known` that they cause. The conditions are computed here if empty (cracks have grown since). A failure leaves the
  // model at that point of the path.
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
