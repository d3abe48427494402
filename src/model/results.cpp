#include "error.hpp"
#include "model/model.hpp"
#include "results/history_table.hpp"
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

Eigen::Vector2d Model::reaction(int support) {
  scene_.support(support);
  ensure_equilibrium();
  const Eigen::Vector2d sum = prepared_->evolution->reaction(static_cast<std::size_t>(support - 1));
  require_numbers(sum);
  return sum;
}

double Model::reaction_moment(int support, const Point& about) {
  scene_.support(support);
  ensure_equilibrium();
  return prepared_->evolution->reaction_moment(static_cast<std::size_t>(support - 1), about);
}

const regions::Region& Model::region(int id) {
  scene_.region(id);
  prepare();
  return prepared_->discretization.region(id);
}

std::span<const pd::Bond> Model::bonds(int id) {
  const auto bonds = region(id).bonds();
  require(bonds.has_value(), "region ", id, " is a ", scene_.region(id).adjective(),
          " region and has no bonds; ask a peridynamic region");
  return *bonds;
}

std::vector<regions::BondState> Model::bond_states(int id) {
  bonds(id);
  prepared_->evolution->bring_terms_up_to_date();
  return results::bond_states(region(id), prepared_->system->intact(), prepared_->cut_bonds);
}

regions::Solution Model::solution_of(const PreparedScene& prepared) {
  const fracture::EvolutionState& state = prepared.evolution->state();
  std::vector<std::vector<char>> closed(prepared.conditions.body_force.rows() / 3);
  if (prepared.system->closed_face_count() > 0)
    for (const auto& region : prepared.discretization.regions)
      closed[static_cast<std::size_t>(region->id()) - 1] = prepared.system->closed_faces_on(region->nodes());
  return {
      .displacement = state.total_displacement,
      .bonds = prepared.system->terms(),
      .intact = prepared.system->intact(),
      .body_forces = prepared.conditions.body_forces(state.load_factor),
      .parts = &state.displacement,
      .crack_loads = &prepared.conditions.crack_loads,
      .load_factor = state.load_factor,
      .stages = &prepared.system->stages(),
      .closed_faces = std::move(closed),
      .body_force_parts = &prepared.conditions.body_force,
  };
}

const FieldValues& Model::field(int id, Field which) {
  region(id).field_size(which);
  ensure_equilibrium();
  const FieldValues& field = fields_.of({id, which}, generation_, [&] {
    if (which != Field::stress_order) return region(id).field(which, solution());
    const results::StressOrders orders(singular_places(), prepared_->discretization.tolerance);
    return orders.at_nodes(region(id).field(Field::position, solution()));
  });
  require_numbers(
      Eigen::Map<const Eigen::VectorXd>(field.values.data(), static_cast<Eigen::Index>(field.values.size())));
  return field;
}

results::FieldsOfScene Model::fields() {
  return [this](int region, Field which) -> const FieldValues& { return field(region, which); };
}

const std::vector<regions::SingularPlace>& Model::singular_places() {
  prepare();
  auto& known = prepared_->singular_places;
  if (!known) known = regions::singular_places(scene_, prepared_->discretization);
  return *known;
}

std::vector<double> Model::stress_orders(const std::vector<Point>& places) {
  const results::StressOrders orders(singular_places(), prepared_->discretization.tolerance);
  std::vector<double> found;
  for (const Point& place : places) found.push_back(orders.order_at(place));
  return found;
}

std::vector<regions::PointValue> Model::evaluate(const std::vector<Point>& places, bool with_stress,
                                                 const results::Side& side) {
  if (side.region != 0) scene_.region(side.region);
  ensure_equilibrium();
  results::PointValues found =
      results::evaluate(scene_, prepared_->discretization, solution(), fields(), places, with_stress, side);
  prepared_->interior_kernel_evaluations += found.kernel_evaluations;
  for (const regions::PointValue& value : found.values) {
    require_numbers(value.displacement);
    require_numbers(value.stress);
  }
  return std::move(found.values);
}

void Model::write_snapshot(const std::string& prefix) {
  ensure_equilibrium();
  const results::CracksShown cracks{crack_pictures(), records_tips() ? tips() : std::vector<regions::TipValues>()};
  snapshots_.write(prefix, {load_factor(), prepared_->evolution->progress().events},
                   results::pictures(scene_, prepared_->discretization, solution(), fields(), cracks,
                                     options_.number("snapshots.inside")),
                   options_);
}

void Model::write_history(const std::string& path) const {
  std::vector<char> there;
  for (const scene::Condition& support : scene_.supports()) there.push_back(support.removed() ? 0 : 1);
  results::write_history(path, prepared_ ? &prepared_->evolution->progress() : nullptr, there);
}

}  // namespace bempd::model
