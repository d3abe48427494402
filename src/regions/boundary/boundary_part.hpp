#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <span>
#include <vector>

#include "bem/boundary_operator.hpp"
#include "coupling/operators.hpp"
#include "geometry/arrangement.hpp"
#include "geometry/boundary_mesh.hpp"
#include "regions/formulation.hpp"
#include "regions/node_registry.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

// What a piece of an edge borders on.
enum class Border { free, boundary_elements, peridynamics };

// Where a panel of a boundary mesh comes from.
struct PanelSource {
  int edge;         // number in its region
  double from, to;  // fractions of the edge
  Border border;
  int other_region;  // id of the region it borders on, 0 for none
  bool tied;         // an interface at which the elements do not follow the lattice: lattice points are tied to them
};

// Panels and elements of one boundary element region, loop by loop (boundary_meshing.cpp).
struct BoundaryPanels {
  std::vector<std::vector<Panel>> loops;
  std::vector<PanelSource> sources;
};
BoundaryPanels mesh_edges(const Scene& scene, const Arrangement& arrangement, const Formulation& formulation,
                          double tolerance, int region);

// A boundary element region on its nodes. In scheme `symmetric` mid nodes of elements that follow a lattice are not
// nodes of the scene: there the displacement is linear between lattice points, so that a constant traction gives the
// lattice its exact forces.
struct BoundaryPart {
  int region;
  std::vector<PanelSource> panels;
  BoundaryMesh mesh;
  std::vector<int> nodes;                                          // of the scene
  std::vector<int> node_of_mesh_node;                              // of the scene, or -1
  Eigen::SparseMatrix<double> trace;                               // mesh displacements from those of `nodes`
  std::shared_ptr<const bem::BoundaryOperator> boundary_operator;  // shared by regions that are alike
  Eigen::MatrixXd stiffness;                                       // on the mesh's nodes, if not the operator's own

  Eigen::VectorXd mesh_displacement(const Eigen::VectorXd& scene_displacement) const;
  const Eigen::MatrixXd& mesh_stiffness() const {
    return stiffness.size() > 0 ? stiffness : boundary_operator->stiffness();
  }
  // Matrix and all are taken over from one of those that parts have had before if they are the same.
  coupling::DenseOperator dense_operator(std::span<const BoundaryPart> before,
                                         std::span<const coupling::DenseOperator> theirs) const;
};

void number_nodes(BoundaryPart& part, const Formulation& formulation, NodeRegistry& registry);

// Takes over the operator of one of the parts built before if they differ by a translation only.
void build_operator(BoundaryPart& part, std::span<const BoundaryPart> built, const Scene& scene,
                    const Formulation& formulation, const Options& options);

}  // namespace bempd::model
