#pragma once

#include <span>
#include <vector>

#include "regions/discretization.hpp"
#include "regions/singular_places.hpp"
#include "results/field_cache.hpp"
#include "results/point_values.hpp"

namespace bempd::model {

class Model;
struct PreparedScene;

// Solution of a prepared scene, in the form in which regions read it.
regions::Solution solution_of(const PreparedScene& prepared);

// Results of a model in equilibrium: fields of regions, values at places, reactions of supports.
class Results {
 public:
  explicit Results(Model& model) : model_(model) {}

  // Region as built from the scene; throws Error (argument) if no region has this id.
  const regions::Region& region(int id);
  // Bonds of a region; throws Error (argument) for a region without bonds.
  std::span<const pd::Bond> bonds(int region);
  std::vector<regions::BondState> bond_states(int region);

  // Field of a region; computed once for each generation (state of the body).
  const regions::FieldValues& field(int region, regions::Field field);
  regions::FieldSize field_size(int region, regions::Field field) {
    return this->region(region).results().field_size(field);
  }
  results::FieldsOfScene fields();

  // Reaction of a support: the sum of its nodal forces [N].
  Eigen::Vector2d reaction(int support);
  // Moment of the nodal forces of a support about a place [N m].
  double reaction_moment(int support, const Point& about);

  // Values at places in the body; stresses only if `with_stress`. `side` chooses a face for places on cracks.
  std::vector<regions::PointValue> evaluate(const std::vector<Point>& places, bool with_stress,
                                            const results::Side& side = {});
  // Places where the elastic stress is unbounded.
  const std::vector<regions::SingularPlace>& singular_places();
  // Order of the stress singularity at each place; 0 where stress is bounded.
  std::vector<double> stress_orders(const std::vector<Point>& places);

  void forget() { fields_ = {}; }

 private:
  Model& model_;
  results::FieldCache fields_;
};

}  // namespace bempd::model
