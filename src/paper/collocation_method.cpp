#include "paper/collocation_method.hpp"

#include "error.hpp"
#include "paper/collocation_operator.hpp"

namespace bempd::paper {

using namespace regions;

namespace {

// Nodal forces of the scheme `paper` per displacement: consistent with the elements, except at lattice interfaces. At
// an interface every node has its traction times the length between the middles of its neighbours (half of this length
// at the ends of the interface). This force corresponds to the traction t = -b dx (dx: lattice spacing) that balances
// the body force b of the material point (Yang and Liu 2021, Eq. 26). Consistent forces would alternate between 2/3 and
// 4/3 of this force from node to node.
Eigen::MatrixXd balanced_stiffness(const ElementsOfRegion& elements, const CollocationOperator& collocation) {
  const BoundaryMesh& mesh = elements.mesh;
  Eigen::MatrixXd stiffness = collocation.stiffness();
  Eigen::Matrix3d consistent, lumped = Eigen::Vector3d(0.25, 0.5, 0.25).asDiagonal();
  consistent << 4, 2, -1, 2, 16, 2, -1, 2, 4;
  const Eigen::Matrix3d change = lumped - consistent / 30;
  for (const BoundaryElement& element : mesh.elements) {
    if (elements.panels[element.panel].border != Border::grid) continue;
    const double length = (mesh.nodes[element.nodes[2]] - mesh.nodes[element.nodes[0]]).norm();
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        stiffness.middleRows<2>(2 * element.nodes[a]) +=
            elements.elasticity.thickness * length * change(a, b) *
            collocation.traction_matrix().middleRows<2>(2 * element.traction_nodes[b]);
      }
    }
  }
  return stiffness;
}

// Equations as published (Yang and Liu 2021, Eqs. 23 and 27), every row times a length. At nodes of lattice interfaces,
// also at the ends of the interface, the traction is t = -b dx with the lattice spacing dx and the body force b of the
// material point. At other nodes t is given (at nodes with two tractions, their sum).
Eigen::MatrixXd pointwise_stiffness(const scene::Scene& scene, const ElementsOfRegion& elements,
                                    const CollocationOperator& collocation) {
  const BoundaryMesh& mesh = elements.mesh;
  const Eigen::MatrixXd& tractions = collocation.traction_matrix();
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * static_cast<Eigen::Index>(mesh.nodes.size()), tractions.cols());
  for (const bool at_interface : {false, true}) {
    for (const BoundaryElement& element : mesh.elements) {
      const PanelSource& panel = elements.panels[element.panel];
      if ((panel.border == Border::grid) != at_interface) continue;
      const double length = Arc{mesh.nodes[element.nodes[0]], mesh.nodes[element.nodes[2]], element.sweep}.length();
      for (int a = 0; a < 3; ++a) {
        auto rows = stiffness.middleRows<2>(2 * element.nodes[a]);
        const auto traction = tractions.middleRows<2>(2 * element.traction_nodes[a]);
        if (at_interface) {
          rows = elements.elasticity.thickness * scene.region(panel.other_region).node_grid()->spacing * traction;
        } else {
          rows += elements.elasticity.thickness * length * (a == 1 ? 4.0 : 1.0) / 6 * traction;
        }
      }
    }
  }
  return stiffness;
}

}  // namespace

BoundaryMesh CollocationMethod::make_mesh(const std::vector<std::vector<Panel>>& loops) const {
  const BoundaryMesh mesh = mesh_boundary(loops);
  return rules_.one_traction_at_corners ? with_one_traction_at_corners(mesh) : mesh;
}

std::shared_ptr<const bem::BoundaryOperator> CollocationMethod::make_operator(
    const ElementsOfRegion& elements, const bem::AssemblyOptions& assembly) const {
  require(!elements.elasticity.incompressible(), "region ", elements.region,
          " is incompressible (Poisson's ratio 1/2 in plane strain); scheme paper cannot solve that, choose scheme "
          "symmetric");
  return std::make_shared<const CollocationOperator>(elements.mesh, elements.elasticity, assembly);
}

Eigen::MatrixXd CollocationMethod::own_stiffness(const scene::Scene& scene, const ElementsOfRegion& elements,
                                                 const bem::BoundaryOperator& whole) const {
  const auto& collocation = static_cast<const CollocationOperator&>(whole);
  return rules_.pointwise_traction ? pointwise_stiffness(scene, elements, collocation)
                                   : balanced_stiffness(elements, collocation);
}

}  // namespace bempd::paper
