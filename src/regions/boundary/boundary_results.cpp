#include "regions/boundary/boundary_results.hpp"

#include <utility>

#include "bem/element_geometry.hpp"
#include "error.hpp"

namespace bempd::regions {

namespace {

FieldValues pairs_of(const Eigen::VectorXd& values) { return {{values.data(), values.data() + values.size()}, 2}; }

Point traction_across(const Eigen::Vector3d& stress, const Point& normal) {
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

// Values at a mesh's nodes, given values at the three nodes of each element: mean over the elements that meet at a
// node.
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

// Fills gaps (-1) in `nodes`, which are the scene's nodes of a mesh. The end of an element at a crack's mouth gets the
// node of the element's other end, which lies on the same side of the crack. A mid node gets the node of its element's
// start.
std::vector<int> with_neighbours(std::vector<int> nodes, const BoundaryMesh& mesh) {
  for (const BoundaryElement& element : mesh.elements)
    for (const int k : {0, 2})
      if (nodes[element.nodes[k]] < 0) nodes[element.nodes[k]] = nodes[element.nodes[2 - k]];
  for (const BoundaryElement& element : mesh.elements)
    if (nodes[element.nodes[1]] < 0) nodes[element.nodes[1]] = nodes[element.nodes[0]];
  return nodes;
}

// Evaluates the interior: Somigliana's identity gives the part of the solution without body force and swelling, to
// which the particular solution and the free swelling are added.
class BoundaryEvaluator final : public Evaluator {
 public:
  BoundaryEvaluator(int region, const RegionSwelling& swelling, InteriorOfPieces interior,
                    const LinearBodyForce& particular, double load_factor, bool with_stress)
      : region_(region),
        swelling_(swelling),
        interior_(std::move(interior)),
        particular_(particular),
        load_factor_(load_factor),
        with_stress_(with_stress) {}

  PointValue at(const Point& place) override {
    const Point beside =
        particular_.displacement(place) + *swelling_.free_displacement(place) * Eigen::Vector2d(1, load_factor_);
    if (!with_stress_) return {region_, interior_.displacement_at(place) + beside, Eigen::Vector3d::Zero()};
    const auto rest = interior_.at(place);
    return {region_, rest.displacement + beside, rest.stress + particular_.stress(place)};
  }
  void choose_right_face(bool right) override { interior_.choose_right_face(right); }
  std::int64_t kernel_evaluations() const override { return interior_.kernel_evaluations(); }

 private:
  int region_;
  const RegionSwelling& swelling_;
  InteriorOfPieces interior_;
  LinearBodyForce particular_;
  double load_factor_;
  bool with_stress_;
};

}  // namespace

// Entries of the region's nodes in fields on the mesh. Mid nodes of elements at a grid are left out if they are not
// nodes of the scene.
std::vector<int> BoundaryResults::entries_of_nodes() const {
  std::vector<int> entries;
  for (std::size_t i = 0; i < mesh_.scene_nodes().size(); ++i)
    if (mesh_.scene_nodes()[i] >= 0) entries.push_back(static_cast<int>(i));
  entries.resize(region_.nodes().size(), -1);  // nodes on cuts have no entry
  return entries;
}

std::vector<int> BoundaryResults::nodes_of_entries() const {
  return with_neighbours(mesh_.scene_nodes(), mesh_.mesh());
}

FieldSize BoundaryResults::field_size(Field field) const {
  const BoundaryMesh& mesh = mesh_.mesh();
  require(field != Field::damage && field != Field::bond_stretch, "region ", region_.id(),
          " is a BEM region and has no bonds; ask a peridynamic region");
  const bool of_elements = field == Field::traction || field == Field::element_stress;
  return {static_cast<std::int64_t>(of_elements ? 3 * mesh.elements.size() : mesh.nodes.size()), components_of(field)};
}

FieldValues BoundaryResults::field(Field field, const Solution& solution) const {
  const BoundaryMesh& mesh = mesh_.mesh();
  switch (field) {
    case Field::position: {
      FieldValues positions{{}, 2};
      for (const Point& p : mesh.nodes) positions.values.insert(positions.values.end(), {p.x(), p.y()});
      return positions;
    }
    case Field::displacement:
      return pairs_of((mesh_.trace() * region_.gather(solution.displacement))
                          .head(2 * static_cast<Eigen::Index>(mesh.nodes.size())));
    case Field::traction:
      return element_tractions(solution);
    case Field::stress:
      return mean_at_nodes(mesh, element_stress(solution));
    case Field::element_stress:
      return element_stress(solution);
    case Field::damage:
    case Field::bond_stretch:  // refused by field_size()
    case Field::stress_order:  // a matter of the whole scene
      break;
  }
  return {};
}

FieldValues BoundaryResults::element_tractions(const Solution& solution) const {
  const BoundaryMesh& mesh = mesh_.mesh();
  const LinearBodyForce particular = particulars_.of(solution);
  const Eigen::VectorXd tractions = states_.tractions(particular, solution);
  FieldValues field{{}, 2};
  for (const BoundaryElement& element : mesh.elements) {
    const auto geometry = bem::element_through(mesh.nodes[element.nodes[0]], mesh.nodes[element.nodes[1]],
                                               mesh.nodes[element.nodes[2]], element.sweep);
    for (int k = 0; k < 3; ++k) {
      const Point normal = bem::scaled_normal(geometry.derivative(k - 1)).normalized();
      const Point traction = Point(tractions.segment<2>(2 * element.traction_nodes[k])) +
                             traction_across(particular.stress(mesh.nodes[element.nodes[k]]), normal);
      field.values.insert(field.values.end(), {traction.x(), traction.y()});
    }
  }
  return field;
}

// Stress at the three nodes of every element, from the element's traction and tangential strain.
FieldValues BoundaryResults::element_stress(const Solution& solution) const {
  const BoundaryMesh& mesh = mesh_.mesh();
  const LinearBodyForce particular = particulars_.of(solution);
  FieldValues field{states_.element_stress(particular, solution), 3};
  add_stress(particular, mesh, field);
  return field;
}

Cells BoundaryResults::cells() const {
  const BoundaryMesh& mesh = mesh_.mesh();
  Cells cells{3, {}};
  for (const BoundaryElement& element : mesh.elements)
    cells.nodes.insert(cells.nodes.end(), element.nodes.begin(), element.nodes.end());
  return cells;
}

SnapshotBlock BoundaryResults::snapshot_block() const {
  return {"boundary",
          1,
          output::VtuCell::quadratic_edge,
          {{"displacement", Field::displacement}, {"traction", Field::traction}, {"stress", Field::stress}}};
}

// Field for pictures, with one value for each node of the mesh. The traction at a corner, which differs between the two
// elements there, is the mean of both elements.
FieldValues BoundaryResults::at_nodes(Field which, const FieldValues& values) const {
  return which == Field::traction ? mean_at_nodes(mesh_.mesh(), values) : values;
}

std::unique_ptr<Evaluator> BoundaryResults::evaluator(const Solution& solution, const FieldsOfRegion&,
                                                      bool with_stress) const {
  const LinearBodyForce particular = particulars_.of(solution);
  return std::make_unique<BoundaryEvaluator>(region_.id(), swelling_, states_.inside(particular, solution), particular,
                                             solution.load_factor, with_stress);
}

}  // namespace bempd::regions
