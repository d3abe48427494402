#include "model/results.hpp"

#include "error.hpp"
#include "model/model.hpp"
#include "results/stress_orders.hpp"

namespace bempd::model {

using regions::Field;
using regions::FieldValues;

namespace {

void require_numbers(const Eigen::Ref<const Eigen::VectorXd>& values) {
  if (values.allFinite()) return;
  fail(Failure::unsolvable, "a result is beyond the range of numbers; choose other units or smaller loads");
}

}  // namespace

regions::Solution solution_of(const PreparedScene& prepared) {
  const fracture::EvolutionState& state = prepared.evolution->state();
  std::vector<std::vector<char>> closed(prepared.conditions.body_force.rows() / 3);
  const std::vector<coupling::OperatorSchurComplement>& operators = prepared.system->operators().list();
  if (std::size_t first = 0; prepared.system->constraints().closed_exact_count() > 0)
    for (const auto& region : prepared.discretization.regions) {
      std::vector<char>& own = closed[static_cast<std::size_t>(region->id()) - 1];
      const std::size_t count = region->operators() ? region->operators()->count() : 0;
      for (std::size_t k = 0; k < count; ++k) {
        const std::vector<char> flags = operators[first++].closed();
        own.insert(own.end(), flags.begin(), flags.end());
      }
    }
  return {
      .displacement = state.total_displacement,
      .bonds = prepared.system->terms(),
      .intact = prepared.system->stages().intact(),
      .body_forces = prepared.conditions.body_forces(state.load_factor),
      .parts = &state.displacement,
      .crack_loads = &prepared.conditions.crack_loads,
      .load_factor = state.load_factor,
      .stages = &prepared.system->stages().numbers(),
      .closed_faces = std::move(closed),
      .body_force_parts = &prepared.conditions.body_force,
  };
}

const regions::Region& Results::region(int id) {
  model_.scene().region(id);  // throws without it
  return model_.prepared().discretization.region(id);
}

std::span<const pd::Bond> Results::bonds(int id) {
  const regions::RegionBonds* bonds = region(id).bonds();
  require(bonds != nullptr, "region ", id, " is a ", model_.scene().region(id).adjective(),
          " region and has no bonds; ask a peridynamic region");
  return bonds->list();
}

std::vector<regions::BondState> Results::bond_states(int id) {
  bonds(id);
  const PreparedScene& prepared = model_.prepared();
  prepared.evolution->sources().refresh();
  return results::bond_states(region(id), prepared.system->stages().intact(), prepared.cut_bonds);
}

const FieldValues& Results::field(int id, Field which) {
  region(id).results().field_size(which);
  const PreparedScene& prepared = model_.in_equilibrium();
  const FieldValues& field = fields_.of({id, which}, model_.generation(), [&] {
    if (which != Field::stress_order) return region(id).results().field(which, solution_of(prepared));
    const results::StressOrders orders(singular_places(), prepared.discretization.tolerance);
    return orders.at_nodes(region(id).results().field(Field::position, solution_of(prepared)));
  });
  require_numbers(
      Eigen::Map<const Eigen::VectorXd>(field.values.data(), static_cast<Eigen::Index>(field.values.size())));
  return field;
}

results::FieldsOfScene Results::fields() {
  return [this](int region, Field which) -> const FieldValues& { return field(region, which); };
}

Eigen::Vector2d Results::reaction(int support) {
  model_.scene().support(support);  // throws without it
  const Eigen::Vector2d sum =
      model_.in_equilibrium().evolution->body().supports().reaction(static_cast<std::size_t>(support - 1));
  require_numbers(sum);
  return sum;
}

double Results::reaction_moment(int support, const Point& about) {
  model_.scene().support(support);  // throws without it
  return model_.in_equilibrium().evolution->body().supports().reaction_moment(static_cast<std::size_t>(support - 1),
                                                                              about);
}

const std::vector<regions::SingularPlace>& Results::singular_places() {
  PreparedScene& prepared = model_.prepared();
  auto& known = prepared.singular_places;
  if (!known) known = regions::singular_places(model_.scene(), prepared.discretization);
  return *known;
}

std::vector<double> Results::stress_orders(const std::vector<Point>& places) {
  const results::StressOrders orders(singular_places(), model_.prepared().discretization.tolerance);
  std::vector<double> found;
  for (const Point& place : places) found.push_back(orders.order_at(place));
  return found;
}

std::vector<regions::PointValue> Results::evaluate(const std::vector<Point>& places, bool with_stress,
                                                   const results::Side& side) {
  if (side.region != 0) model_.scene().region(side.region);
  PreparedScene& prepared = model_.in_equilibrium();
  results::PointValues found = results::evaluate(model_.scene(), prepared.discretization, solution_of(prepared),
                                                 fields(), places, with_stress, side);
  prepared.interior_kernel_evaluations += found.kernel_evaluations;
  for (const regions::PointValue& value : found.values) {
    require_numbers(value.displacement);
    require_numbers(value.stress);
  }
  return std::move(found.values);
}

}  // namespace bempd::model
