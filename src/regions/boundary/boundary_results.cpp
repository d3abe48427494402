#include "bem/element_geometry.hpp"
#include "error.hpp"
#include "regions/boundary/boundary_region.hpp"
#include "regions/boundary/region_subdomains.hpp"

namespace bempd::regions {

namespace {

FieldValues pairs_of(const Eigen::VectorXd& values) { return {{values.data(), values.data() + values.size()}, 2}; }

void append(FieldValues& field, const Eigen::Vector3d& stress) {
  field.values.insert(field.values.end(), {stress[0], stress[1], stress[2]});
}

Point traction_of(const Eigen::Vector3d& stress, const Point& normal) {
  return {stress[0] * normal.x() + stress[2] * normal.y(), stress[2] * normal.x() + stress[1] * normal.y()};
}

// Adds the stress of a particular solution to values at the three nodes of each element.
void add_stress(const LinearBodyForce& particular, const BoundaryMesh& mesh, FieldValues& field) {
  double* value = field.values.data();
  for (const BoundaryElement& element : mesh.elements)
    for (const int node : element.nodes) {
      Eigen::Map<Eigen::Vector3d>{value} += particular.stress(mesh.nodes[static_cast<std::size_t>(node)]);
      value += 3;
    }
}

// Values at a mesh's nodes: the mean of the elements that meet there, of values at the three nodes of each element.
FieldValues mean_at_nodes(const BoundaryMesh& mesh, const FieldValues& of_elements) {
  const auto components = static_cast<std::size_t>(of_elements.components);
  FieldValues field{std::vector<double>(components * mesh.nodes.size(), 0.0), of_elements.components};
  std::vector<int> count(mesh.nodes.size(), 0);
  const double* value = of_elements.values.data();
  for (const BoundaryElement& element : mesh.elements)
    for (const int node : element.nodes) {
      for (std::size_t c = 0; c < components; ++c)
        field.values[components * static_cast<std::size_t>(node) + c] += *value++;
      ++count[static_cast<std::size_t>(node)];
    }
  for (std::size_t i = 0; i < field.values.size(); ++i) field.values[i] /= count[i / components];
  return field;
}

// Evaluates the interior by Somigliana's identity for the part of the solution without body force and swelling, and
// adds the particular solution and the free swelling.
class BoundaryEvaluator final : public Evaluator {
 public:
  BoundaryEvaluator(const BoundaryRegion& region, InteriorOfPieces interior, const LinearBodyForce& particular,
                    double load_factor, bool with_stress)
      : region_(region),
        interior_(std::move(interior)),
        particular_(particular),
        load_factor_(load_factor),
        with_stress_(with_stress) {}

  PointValue at(const Point& place) override {
    const Point beside =
        particular_.displacement(place) + *region_.free_displacement(place) * Eigen::Vector2d(1, load_factor_);
    if (!with_stress_) return {region_.id(), interior_.displacement_at(place) + beside, Eigen::Vector3d::Zero()};
    const auto rest = interior_.at(place);
    return {region_.id(), rest.displacement + beside, rest.stress + particular_.stress(place)};
  }
  void choose_right_face(bool right) override { interior_.choose_right_face(right); }
  std::int64_t kernel_evaluations() const override { return interior_.kernel_evaluations(); }

 private:
  const BoundaryRegion& region_;
  InteriorOfPieces interior_;
  LinearBodyForce particular_;
  double load_factor_;
  bool with_stress_;
};

}  // namespace

// Entries of the region's nodes in fields on the mesh. Mid nodes of elements at a grid are left out if they are no
// nodes of the scene.
std::vector<int> BoundaryRegion::entries_of_nodes() const {
  std::vector<int> entries;
  for (std::size_t i = 0; i < node_of_mesh_node_.size(); ++i)
    if (node_of_mesh_node_[i] >= 0) entries.push_back(static_cast<int>(i));
  entries.resize(nodes_.size(), -1);  // nodes on cuts have no entry
  return entries;
}

FieldSize BoundaryRegion::field_size(Field field) const {
  require(field != Field::damage && field != Field::bond_stretch, "region ", id(),
          " is a BEM region and has no bonds; ask a peridynamic region");
  const bool of_elements = field == Field::traction || field == Field::element_stress;
  return {static_cast<std::int64_t>(of_elements ? 3 * mesh_.elements.size() : mesh_.nodes.size()),
          components_of(field)};
}

FieldValues BoundaryRegion::field(Field field, const Solution& solution) const {
  switch (field) {
    case Field::position: {
      FieldValues positions{{}, 2};
      for (const Point& p : mesh_.nodes) positions.values.insert(positions.values.end(), {p.x(), p.y()});
      return positions;
    }
    case Field::displacement:
      return pairs_of((trace_ * gather(solution.displacement)).head(2 * static_cast<Eigen::Index>(mesh_.nodes.size())));
    case Field::traction:
      return element_tractions(solution);
    case Field::stress:
      return mean_at_nodes(mesh_, element_stress(solution));
    case Field::element_stress:
      return element_stress(solution);
    case Field::damage:
    case Field::bond_stretch:  // refused by field_size()
    case Field::stress_order:  // a matter of the whole scene
      break;
  }
  return {};
}

FieldValues BoundaryRegion::element_tractions(const Solution& solution) const {
  const LinearBodyForce particular = this->particular(solution.body_force(id()));
  const Eigen::VectorXd tractions = tractions_under(displacement_without(particular, solution), solution);
  FieldValues field{{}, 2};
  for (const BoundaryElement& element : mesh_.elements) {
    const auto geometry = bem::element_through(mesh_.nodes[element.nodes[0]], mesh_.nodes[element.nodes[1]],
                                               mesh_.nodes[element.nodes[2]], element.sweep);
    for (int k = 0; k < 3; ++k) {
      const Point normal = bem::scaled_normal(geometry.derivative(k - 1)).normalized();
      const Point traction = Point(tractions.segment<2>(2 * element.traction_nodes[k])) +
                             traction_of(particular.stress(mesh_.nodes[element.nodes[k]]), normal);
      field.values.insert(field.values.end(), {traction.x(), traction.y()});
    }
  }
  return field;
}

// Stress at the three nodes of every element, from the element's traction and tangential strain.
FieldValues BoundaryRegion::element_stress(const Solution& solution) const {
  const LinearBodyForce particular = this->particular(solution.body_force(id()));
  FieldValues field{{}, 3};
  if (subdomains_) {
    const Eigen::VectorXd displacement = displacement_without(particular, solution);
    field.values = subdomains_->element_stress(elasticity(), displacement, cracked_, cracked_states(solution));
  } else {
    const bem::InteriorEvaluator rest = interior_without(particular, solution);
    for (int e = 0; e < static_cast<int>(mesh_.elements.size()); ++e)
      for (int k = 0; k < 3; ++k) append(field, rest.stress_on(e, k - 1));
  }
  add_stress(particular, mesh_, field);
  return field;
}

Cells BoundaryRegion::cells() const {
  Cells cells{3, {}};
  for (const BoundaryElement& element : mesh_.elements)
    cells.nodes.insert(cells.nodes.end(), element.nodes.begin(), element.nodes.end());
  return cells;
}

SnapshotBlock BoundaryRegion::snapshot_block() const {
  return {"boundary",
          1,
          output::VtuCell::quadratic_edge,
          {{"displacement", Field::displacement}, {"traction", Field::traction}, {"stress", Field::stress}}};
}

// Field for pictures, one value for each node of the mesh. For tractions, which differ between the two elements at a
// corner, it is the mean of both.
FieldValues BoundaryRegion::at_nodes(Field which, const FieldValues& values) const {
  return which == Field::traction ? mean_at_nodes(mesh_, values) : values;
}

std::unique_ptr<Evaluator> BoundaryRegion::evaluator(const Solution& solution, const FieldsOfRegion&,
                                                     bool with_stress) const {
  const LinearBodyForce particular = this->particular(solution.body_force(id()));
  return std::make_unique<BoundaryEvaluator>(*this, inside_without(particular, solution), particular,
                                             solution.load_factor, with_stress);
}

}  // namespace bempd::regions
