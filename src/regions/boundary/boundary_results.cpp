#include "bem/element_geometry.hpp"
#include "error.hpp"
#include "regions/boundary/boundary_region.hpp"

namespace bempd::regions {

namespace {

FieldValues pairs_of(const Eigen::VectorXd& values) { return {{values.data(), values.data() + values.size()}, 2}; }

void append(FieldValues& field, const Eigen::Vector3d& stress) {
  field.values.insert(field.values.end(), {stress[0], stress[1], stress[2]});
}

Point traction_of(const Eigen::Vector3d& stress, const Point& normal) {
  return {stress[0] * normal.x() + stress[2] * normal.y(), stress[2] * normal.x() + stress[1] * normal.y()};
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
      return boundary_stress(solution);
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
  if (subdomains_) return element_stress_by_subdomains(particular, solution);
  const bem::InteriorEvaluator rest = interior_without(particular, solution);
  FieldValues field{{}, 3};
  for (int e = 0; e < static_cast<int>(mesh_.elements.size()); ++e) {
    for (int k = 0; k < 3; ++k)
      append(field, rest.stress_on(e, k - 1) + particular.stress(mesh_.nodes[mesh_.elements[e].nodes[k]]));
  }
  return field;
}

// Stress at the mesh's nodes: the mean of the elements that meet there.
FieldValues BoundaryRegion::boundary_stress(const Solution& solution) const {
  const FieldValues sides = element_stress(solution);
  Eigen::Matrix3Xd sums = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(mesh_.nodes.size()));
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(sums.cols());
  const double* side = sides.values.data();
  for (const BoundaryElement& element : mesh_.elements) {
    for (int node : element.nodes) {
      sums.col(node) += Eigen::Map<const Eigen::Vector3d>(side);
      counts[node] += 1;
      side += 3;
    }
  }
  FieldValues field{{}, 3};
  for (Eigen::Index node = 0; node < sums.cols(); ++node) append(field, sums.col(node) / counts[node]);
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
  if (which != Field::traction) return values;
  FieldValues field{std::vector<double>(2 * mesh_.nodes.size(), 0.0), 2};
  std::vector<int> count(mesh_.nodes.size(), 0);
  for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
    for (int k = 0; k < 3; ++k) {
      const int node = mesh_.elements[e].nodes[k];
      for (int c = 0; c < 2; ++c) field.values[2 * node + c] += values.values[2 * (3 * e + k) + c];
      ++count[node];
    }
  }
  for (std::size_t i = 0; i < field.values.size(); ++i) field.values[i] /= count[i / 2];
  return field;
}

std::unique_ptr<Evaluator> BoundaryRegion::evaluator(const Solution& solution, const FieldsOfRegion&,
                                                     bool with_stress) const {
  const LinearBodyForce particular = this->particular(solution.body_force(id()));
  return std::make_unique<BoundaryEvaluator>(*this, inside_without(particular, solution), particular,
                                             solution.load_factor, with_stress);
}

}  // namespace bempd::regions
