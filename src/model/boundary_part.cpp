#include "model/boundary_part.hpp"

#include <algorithm>

#include "bem/galerkin_operator.hpp"
#include "error.hpp"
#include "paper/collocation_operator.hpp"

namespace bempd::model {

namespace {

// Nodes that other regions may have too, and mid nodes whose displacement is the mean of the element's ends.
struct NodeRoles {
  std::vector<char> shared, slaved;
  std::vector<std::array<int, 2>> masters;
};

NodeRoles roles_of(const BoundaryPart& part, const Formulation& formulation) {
  const std::size_t count = part.mesh.nodes.size();
  NodeRoles roles{std::vector<char>(count, 0), std::vector<char>(count, 0), std::vector<std::array<int, 2>>(count)};
  for (std::size_t e = 0; e < part.mesh.elements.size(); ++e) {
    const BoundaryElement& element = part.mesh.elements[e];
    const PanelSource& panel = part.panels[element.panel];
    if (panel.border == Border::free) continue;
    if (panel.tied) {
      // The ends of the interface are nodes of both sides.
      if (e == 0 || part.mesh.elements[e - 1].panel != element.panel) roles.shared[element.nodes[0]] = 1;
      const bool is_last = e + 1 == part.mesh.elements.size() || part.mesh.elements[e + 1].panel != element.panel;
      if (is_last) roles.shared[element.nodes[2]] = 1;
      continue;
    }
    for (int node : element.nodes) roles.shared[node] = 1;
    if (panel.border == Border::peridynamics && !formulation.paper) {
      roles.slaved[element.nodes[1]] = 1;
      roles.masters[element.nodes[1]] = {element.nodes[0], element.nodes[2]};
    }
  }
  return roles;
}

// Nodal forces of the scheme `paper`: consistent with the elements, but at lattice interfaces. There every node takes
// its traction times the length between the middles of its neighbours (half of that at the ends of the interface): the
// traction t that balances the point's body force, t = -b dx (Yang and Liu 2021, Eq. 26), as a force. Consistent forces
// would alternate between 2/3 and 4/3 of that from node to node.
Eigen::MatrixXd balanced_stiffness(const BoundaryPart& part, double thickness,
                                   const paper::CollocationOperator& collocation) {
  Eigen::MatrixXd stiffness = collocation.stiffness();
  Eigen::Matrix3d consistent, lumped = Eigen::Vector3d(0.25, 0.5, 0.25).asDiagonal();
  consistent << 4, 2, -1, 2, 16, 2, -1, 2, 4;
  const Eigen::Matrix3d change = lumped - consistent / 30;
  for (const BoundaryElement& element : part.mesh.elements) {
    if (part.panels[element.panel].border != Border::peridynamics) continue;
    const double length = (part.mesh.nodes[element.nodes[2]] - part.mesh.nodes[element.nodes[0]]).norm();
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        stiffness.middleRows<2>(2 * element.nodes[a]) +=
            thickness * length * change(a, b) *
            collocation.traction_matrix().middleRows<2>(2 * element.traction_nodes[b]);
      }
    }
  }
  return stiffness;
}

// The equations as printed (Eqs. 23 and 27), every row times a length: t = -b dx at the nodes of lattice interfaces, dx
// being the lattice spacing also at their ends, and t as given at the others (the sum where there are two).
Eigen::MatrixXd pointwise_stiffness(const BoundaryPart& part, const Scene& scene, double thickness,
                                    const paper::CollocationOperator& collocation) {
  const Eigen::MatrixXd& tractions = collocation.traction_matrix();
  Eigen::MatrixXd stiffness =
      Eigen::MatrixXd::Zero(2 * static_cast<Eigen::Index>(part.mesh.nodes.size()), tractions.cols());
  for (const bool at_interface : {false, true}) {
    for (const BoundaryElement& element : part.mesh.elements) {
      const PanelSource& panel = part.panels[element.panel];
      if ((panel.border == Border::peridynamics) != at_interface) continue;
      const double length =
          Arc{part.mesh.nodes[element.nodes[0]], part.mesh.nodes[element.nodes[2]], element.sweep}.length();
      for (int a = 0; a < 3; ++a) {
        auto rows = stiffness.middleRows<2>(2 * element.nodes[a]);
        const auto traction = tractions.middleRows<2>(2 * element.traction_nodes[a]);
        if (at_interface) {
          rows = thickness * scene.region(panel.other_region).lattice.spacing * traction;
        } else {
          rows += thickness * length * (a == 1 ? 4.0 : 1.0) / 6 * traction;
        }
      }
    }
  }
  return stiffness;
}

const PlaneElasticity& elasticity_of(const BoundaryPart& part, const Scene& scene) {
  return scene.material(scene.region(part.region).material).elasticity;
}

}  // namespace

Eigen::VectorXd BoundaryPart::mesh_displacement(const Eigen::VectorXd& scene_displacement) const {
  Eigen::VectorXd values(2 * nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    values.segment<2>(2 * static_cast<Eigen::Index>(i)) = scene_displacement.segment<2>(2 * nodes[i]);
  }
  return trace * values;
}

coupling::DenseOperator BoundaryPart::dense_operator(std::span<const BoundaryPart> before,
                                                     std::span<const coupling::DenseOperator> theirs) const {
  const auto is_same = [&](const BoundaryPart& other) {
    return other.boundary_operator == boundary_operator && other.stiffness.size() == stiffness.size() &&
           (stiffness.size() == 0 || other.stiffness == stiffness) && other.trace.rows() == trace.rows() &&
           other.trace.cols() == trace.cols() && other.trace.isApprox(trace, 0);
  };
  const auto same = std::find_if(before.begin(), before.end(), is_same);
  if (same != before.end()) {
    return {nodes, theirs[static_cast<std::size_t>(same - before.begin())].stiffness, boundary_operator->symmetric()};
  }
  const Eigen::MatrixXd half = mesh_stiffness() * trace;
  return {nodes, std::make_shared<const Eigen::MatrixXd>(trace.transpose() * half), boundary_operator->symmetric()};
}

void number_nodes(BoundaryPart& part, const Formulation& formulation, NodeRegistry& registry) {
  const std::size_t count = part.mesh.nodes.size();
  const NodeRoles roles = roles_of(part, formulation);
  part.node_of_mesh_node.assign(count, -1);
  std::vector<int> column(count, -1);
  for (std::size_t i = 0; i < count; ++i) {
    if (roles.slaved[i]) continue;
    column[i] = static_cast<int>(part.nodes.size());
    part.nodes.push_back(roles.shared[i] ? registry.add_shared(part.mesh.nodes[i], part.region)
                                         : registry.add(part.mesh.nodes[i]));
    part.node_of_mesh_node[i] = part.nodes.back();
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < count; ++i) {
    const int row = 2 * static_cast<int>(i);
    for (int component = 0; component < 2; ++component) {
      if (!roles.slaved[i]) {
        entries.emplace_back(row + component, 2 * column[i] + component, 1.0);
        continue;
      }
      for (int master : roles.masters[i]) entries.emplace_back(row + component, 2 * column[master] + component, 0.5);
    }
  }
  part.trace.resize(2 * static_cast<Eigen::Index>(count), 2 * static_cast<Eigen::Index>(part.nodes.size()));
  part.trace.setFromTriplets(entries.begin(), entries.end());
}

void build_operator(BoundaryPart& part, std::span<const BoundaryPart> built, const Scene& scene,
                    const Formulation& formulation, const Options& options) {
  const PlaneElasticity& elasticity = elasticity_of(part, scene);
  const bem::AssemblyOptions assembly{options.number("bem.quadrature_tolerance"), options.whole_number("threads")};
  const auto alike = std::find_if(built.begin(), built.end(), [&](const BoundaryPart& other) {
    return elasticity == elasticity_of(other, scene) && differ_by_translation(part.mesh, other.mesh);
  });
  const bool found = alike != built.end();
  if (!formulation.paper) {
    part.boundary_operator = found ? alike->boundary_operator
                                   : std::make_shared<const bem::GalerkinOperator>(part.mesh, elasticity, assembly);
    return;
  }
  require(!elasticity.incompressible(), "region ", part.region,
          " is incompressible (Poisson's ratio 1/2 in plane strain); scheme paper cannot solve that, choose scheme "
          "symmetric");
  const auto collocation = found ? std::static_pointer_cast<const paper::CollocationOperator>(alike->boundary_operator)
                                 : std::make_shared<const paper::CollocationOperator>(part.mesh, elasticity, assembly);
  // Which nodes have interfaces is a matter of the part, not of its shape.
  part.stiffness = formulation.pointwise_traction ? pointwise_stiffness(part, scene, elasticity.thickness, *collocation)
                                                  : balanced_stiffness(part, elasticity.thickness, *collocation);
  part.boundary_operator = collocation;
}

}  // namespace bempd::model
