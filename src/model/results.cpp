#include "error.hpp"
#include "model/model.hpp"
#include "results/history_table.hpp"

namespace bempd::model {

using regions::Field;
using regions::FieldValues;

Eigen::Vector2d Model::reaction(int support) {
  scene_.support(support);
  ensure_equilibrium();
  return prepared_->evolution->reaction(static_cast<std::size_t>(support - 1));
}

const regions::Region& Model::region(int id) {
  scene_.region(id);
  prepare();
  return prepared_->discretization.region(id);
}

const std::vector<pd::Bond>& Model::bonds(int id) {
  const std::vector<pd::Bond>* bonds = region(id).bonds();
  require(bonds != nullptr, "region ", id, " is a ", scene_.region(id).adjective(),
          " region and has no bonds; ask a peridynamic region");
  return *bonds;
}

std::vector<regions::BondState> Model::bond_states(int id) {
  bonds(id);
  return results::bond_states(region(id), prepared_->evolution->progress().intact, prepared_->cut_bonds);
}

regions::Solution Model::solution() const {
  const fracture::EvolutionState& state = prepared_->evolution->state();
  return {state.total_displacement,
          prepared_->system->bonds(),
          state.intact,
          prepared_->conditions.body_forces(state.load_factor),
          &state.displacement,
          &prepared_->conditions.crack_loads,
          state.load_factor};
}

const FieldValues& Model::field(int id, Field which) {
  region(id).field_size(which);
  ensure_equilibrium();
  return fields_.of(region(id), which, solution(), generation_);
}

results::FieldsOfScene Model::fields() {
  return [this](int region, Field which) -> const FieldValues& { return field(region, which); };
}

std::vector<regions::PointValue> Model::evaluate(const std::vector<Point>& places, bool with_stress) {
  ensure_equilibrium();
  results::PointValues found =
      results::evaluate(scene_, prepared_->discretization, solution(), fields(), places, with_stress);
  prepared_->interior_kernel_evaluations += found.kernel_evaluations;
  return std::move(found.values);
}

void Model::write_snapshot(const std::string& prefix) {
  ensure_equilibrium();
  std::vector<regions::CrackPicture> cracks;
  for (const auto& region : prepared_->discretization.regions) {
    const auto pictures = region->crack_pictures(solution());
    cracks.insert(cracks.end(), pictures.begin(), pictures.end());
  }
  snapshots_.write(prefix, load_factor(), prepared_->discretization, fields(), cracks);
}

void Model::write_history(const std::string& path) const {
  std::vector<char> there;
  for (const scene::Condition& support : scene_.supports()) there.push_back(support.removed() ? 0 : 1);
  results::write_history(path, prepared_ ? &prepared_->evolution->progress() : nullptr, there);
}

}  // namespace bempd::model
