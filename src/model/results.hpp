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

// The solution of a prepared scene as regions read it.
regions::Solution solution_of(const PreparedScene& prepared);

// Fields of regions, values at places and reactions of supports in the equilibrium of a model.
class Results {
 public:
  explicit Results(Model& model) : model_(model) {}

  // What a region is made of; throws Error (argument) if there is none of this number.
  const regions::Region& region(int id);
  // Bonds of a region; throws Error (argument) for a region that has none.
  std::span<const pd::Bond> bonds(int region);
  std::vector<regions::BondState> bond_states(int region);

  // Fields of a region; computed once per generation.
  const regions::FieldValues& field(int region, regions::Field field);
  regions::FieldSize field_size(int region, regions::Field field) { return this->region(region).field_size(field); }
  results::FieldsOfScene fields();

  // Sums of a support's nodal forces [N] and of their moments about a place [N m].
  Eigen::Vector2d reaction(int support);
  double reaction_moment(int support, const Point& about);

  // Values at places in the body; stress only if asked for.
  std::vector<regions::PointValue> evaluate(const std::vector<Point>& places, bool with_stress,
                                            const results::Side& side = {});
  // Places where stress is unbounded.
  const std::vector<regions::SingularPlace>& singular_places();
  // Order of the stress at each of some places: 0 where it is bounded.
  std::vector<double> stress_orders(const std::vector<Point>& places);

  void forget() { fields_ = {}; }

 private:
  Model& model_;
  results::FieldCache fields_;
};

}  // namespace bempd::model
