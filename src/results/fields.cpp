#include <cmath>

#include "bem/interior.hpp"
#include "error.hpp"
#include "model/model.hpp"
#include "pd/damage.hpp"
#include "pd/deformation.hpp"

namespace bempd::model {

namespace {

FieldValues pairs_of(const Eigen::VectorXd& values) { return {{values.data(), values.data() + values.size()}, 2}; }

// Displacements of the material points, 2 * point + component.
Eigen::VectorXd point_displacements(const LatticePart& part, const Eigen::VectorXd& scene_displacement) {
  Eigen::VectorXd values(2 * static_cast<Eigen::Index>(part.nodes.size()));
  for (std::size_t i = 0; i < part.nodes.size(); ++i) {
    values.segment<2>(2 * static_cast<Eigen::Index>(i)) = scene_displacement.segment<2>(2 * part.nodes[i]);
  }
  return values;
}

FieldValues lattice_positions(const LatticePart& part) {
  FieldValues field{{}, 2};
  for (int i = 0; i < part.point_count(); ++i) {
    const Point p = part.position(i);
    field.values.insert(field.values.end(), {p.x(), p.y()});
  }
  return field;
}

// One entry a bond, nonzero where it is broken or cut.
std::vector<std::uint8_t> broken_bonds(const LatticePart& part, const std::vector<char>& intact) {
  std::vector<std::uint8_t> broken(part.bonds().size());
  for (std::size_t b = 0; b < broken.size(); ++b) broken[b] = intact[part.first_bond + b] ? 0 : 1;
  return broken;
}

// 1 - intact bonds / bonds before any crack; by volumes where points stand for volumes.
FieldValues damage(const LatticePart& part, int horizon_ratio, const std::vector<char>& intact) {
  if (!part.volumes.empty()) {
    return {pd::volume_damage(*part.network, part.volumes, horizon_ratio, broken_bonds(part, intact)), 1};
  }
  std::vector<int> all(part.nodes.size(), 0), left(part.nodes.size(), 0);
  for (std::size_t b = 0; b < part.bonds().size(); ++b) {
    for (int point : {part.bonds()[b].first, part.bonds()[b].second}) {
      ++all[point];
      left[point] += intact[part.first_bond + b];
    }
  }
  FieldValues field{std::vector<double>(part.nodes.size(), 0.0), 1};
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i] > 0) field.values[i] = 1 - static_cast<double>(left[i]) / all[i];
  }
  return field;
}

FieldValues lattice_stress(const LatticePart& part, const PlaneElasticity& elasticity, const std::vector<char>& intact,
                           const Eigen::VectorXd& scene_displacement) {
  const Eigen::VectorXd displacement = point_displacements(part, scene_displacement) / part.spacing();
  FieldValues field{{}, 3};
  for (const Eigen::Vector3d& strain :
       pd::bond_strains(part.point_count(), *part.network, broken_bonds(part, intact), displacement)) {
    const Eigen::Vector3d stress = pd::stress_of(strain, elasticity);
    field.values.insert(field.values.end(), {stress[0], stress[1], stress[2]});
  }
  return field;
}

FieldValues boundary_positions(const BoundaryPart& part) {
  FieldValues field{{}, 2};
  for (const Point& p : part.mesh.nodes) field.values.insert(field.values.end(), {p.x(), p.y()});
  return field;
}

FieldValues element_tractions(const BoundaryPart& part, const Eigen::VectorXd& tractions) {
  FieldValues field{{}, 2};
  for (const BoundaryElement& element : part.mesh.elements) {
    for (int node : element.traction_nodes) {
      field.values.push_back(tractions[2 * node]);
      field.values.push_back(tractions[2 * node + 1]);
    }
  }
  return field;
}

// At the three nodes of every element, from its own traction and tangential strain.
FieldValues element_stress(const BoundaryPart& part, const bem::InteriorEvaluator& evaluator) {
  FieldValues field{{}, 3};
  for (int e = 0; e < static_cast<int>(part.mesh.elements.size()); ++e) {
    for (const double xi : {-1.0, 0.0, 1.0}) {
      const Eigen::Vector3d stress = evaluator.stress_on(e, xi);
      field.values.insert(field.values.end(), {stress[0], stress[1], stress[2]});
    }
  }
  return field;
}

// The mean of the elements that meet in a node.
FieldValues boundary_stress(const BoundaryPart& part, const bem::InteriorEvaluator& evaluator) {
  const FieldValues sides = element_stress(part, evaluator);
  Eigen::Matrix3Xd sums = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(part.mesh.nodes.size()));
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(sums.cols());
  const double* side = sides.values.data();
  for (const BoundaryElement& element : part.mesh.elements) {
    for (int node : element.nodes) {
      sums.col(node) += Eigen::Map<const Eigen::Vector3d>(side);
      counts[node] += 1;
      side += 3;
    }
  }
  FieldValues field{{}, 3};
  for (Eigen::Index node = 0; node < sums.cols(); ++node) {
    const Eigen::Vector3d mean = sums.col(node) / counts[node];
    field.values.insert(field.values.end(), {mean[0], mean[1], mean[2]});
  }
  return field;
}

}  // namespace

Eigen::VectorXd Model::boundary_tractions(const BoundaryPart& part) const {
  return part.boundary_operator->tractions(part.mesh_displacement(prepared_->evolution->state().total_displacement));
}

const FieldValues& Model::field(int region, Field which) {
  field_size(region, which);
  ensure_equilibrium();
  if (cached_generation_ != generation_) {
    fields_.clear();
    cached_generation_ = generation_;
  }
  const auto key = std::make_pair(region, static_cast<int>(which));
  const auto found = fields_.find(key);
  if (found != fields_.end()) return found->second;
  return fields_.emplace(key, compute_field(region, which)).first->second;
}

FieldValues Model::compute_field(int region, Field which) {
  const Discretization& d = prepared_->discretization;
  const fracture::EvolutionState& state = prepared_->evolution->state();
  const PlaneElasticity& elasticity = scene_.material(scene_.region(region).material).elasticity;
  if (const LatticePart* part = d.lattice_of(region)) {
    switch (which) {
      case Field::position:
        return lattice_positions(*part);
      case Field::displacement:
        return pairs_of(point_displacements(*part, state.total_displacement));
      case Field::damage:
        return damage(*part, scene_.region(region).horizon_ratio, state.intact);
      case Field::stress:
        return lattice_stress(*part, elasticity, state.intact, state.total_displacement);
      case Field::bond_stretch: {
        FieldValues field{{}, 1};
        const coupling::BondSet& bonds = prepared_->system->bonds();
        for (std::size_t b = part->first_bond; b < part->first_bond + part->bonds().size(); ++b) {
          field.values.push_back(bonds.elongation(b, state.total_displacement.data()) / bonds.length[b]);
        }
        return field;
      }
      case Field::traction:
      case Field::element_stress:
        break;  // refused by field_size()
    }
    return {};
  }
  const BoundaryPart& part = *d.boundary_of(region);
  switch (which) {
    case Field::position:
      return boundary_positions(part);
    case Field::displacement:
      return pairs_of(part.mesh_displacement(state.total_displacement));
    case Field::traction:
      return element_tractions(part, boundary_tractions(part));
    case Field::stress:
    case Field::element_stress: {
      const bem::InteriorEvaluator evaluator(part.mesh, elasticity, part.mesh_displacement(state.total_displacement),
                                             boundary_tractions(part));
      return which == Field::stress ? boundary_stress(part, evaluator) : element_stress(part, evaluator);
    }
    case Field::damage:
    case Field::bond_stretch:
      break;  // refused by field_size()
  }
  return {};
}

std::int64_t Model::node_count(int region) { return field_size(region, Field::position).count; }

std::int64_t Model::element_count(int region) {
  scene_.region(region);
  prepare();
  if (const LatticePart* part = prepared_->discretization.lattice_of(region)) return part->lattice->cell_count();
  return static_cast<std::int64_t>(prepared_->discretization.boundary_of(region)->mesh.elements.size());
}

const LatticePart& Model::lattice(int region) {
  scene_.region(region);
  prepare();
  const LatticePart* part = prepared_->discretization.lattice_of(region);
  require(part != nullptr, "region ", region, " is a BEM region and has no bonds; ask a peridynamic region");
  return *part;
}

FieldSize Model::field_size(int region, Field which) {
  scene_.region(region);
  prepare();
  const int components = which == Field::stress || which == Field::element_stress ? 3
                         : which == Field::damage || which == Field::bond_stretch ? 1
                                                                                  : 2;
  std::int64_t count = 0;
  if (const LatticePart* part = prepared_->discretization.lattice_of(region)) {
    require(which != Field::traction && which != Field::element_stress, "region ", region,
            " is peridynamic and has no tractions and no boundary elements; ask a BEM region");
    count = which == Field::bond_stretch ? static_cast<std::int64_t>(part->bonds().size()) : part->point_count();
  } else {
    require(which != Field::damage && which != Field::bond_stretch, "region ", region,
            " is a BEM region and has no bonds; ask a peridynamic region");
    const BoundaryMesh& mesh = prepared_->discretization.boundary_of(region)->mesh;
    count = static_cast<std::int64_t>(
        which == Field::traction || which == Field::element_stress ? 3 * mesh.elements.size() : mesh.nodes.size());
  }
  return {count, components};
}

std::vector<BondState> Model::bond_states(int region) {
  const LatticePart* part = &lattice(region);
  std::vector<BondState> states(part->bonds().size());
  const std::vector<char>& intact = prepared_->evolution->progress().intact;
  for (std::size_t b = 0; b < states.size(); ++b) {
    states[b] = intact[part->first_bond + b] ? BondState::intact : BondState::broken;
  }
  for (int cut : prepared_->cut_bonds) {
    const auto bond = static_cast<std::size_t>(cut);
    if (bond >= part->first_bond && bond < part->first_bond + states.size())
      states[bond - part->first_bond] = BondState::cut;
  }
  return states;
}

std::vector<std::int32_t> Model::elements(int region) {
  scene_.region(region);
  prepare();
  std::vector<std::int32_t> nodes;
  if (const LatticePart* part = prepared_->discretization.lattice_of(region)) {
    for (int i = 0; i < part->lattice->point_count(); ++i) {
      const Eigen::Vector2i corner = part->lattice->point(i);
      if (!part->lattice->has_cell(corner)) continue;
      const auto corners = part->lattice->cell_corners(corner);
      // From rows to counter-clockwise order.
      nodes.insert(nodes.end(), {corners[0], corners[1], corners[3], corners[2]});
    }
    return nodes;
  }
  for (const BoundaryElement& element : prepared_->discretization.boundary_of(region)->mesh.elements) {
    nodes.insert(nodes.end(), element.nodes.begin(), element.nodes.end());
  }
  return nodes;
}

}  // namespace bempd::model
