#pragma once

#include <Eigen/SparseCore>

#include "bem/boundary_operator.hpp"
#include "bem/interior.hpp"
#include "elasticity/linear_body_force.hpp"
#include "geometry/boundary_mesh.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/boundary/boundary_meshing.hpp"
#include "regions/boundary/cracked_part.hpp"
#include "regions/boundary/interior_of_pieces.hpp"
#include "regions/region.hpp"

namespace bempd::regions {

class RegionCracks;
class RegionSubdomains;

// Boundary element region of the symmetric scheme. Mid nodes of elements at a grid are not nodes of the scene: the
// displacement there is linear between grid points, so that a constant traction has its exact nodal forces. Other
// schemes override the protected virtual functions.
class BoundaryRegion : public Region {
 public:
  BoundaryRegion(int id, const BoundaryDescription& described, const scene::Material& material);
  ~BoundaryRegion() override;

  const BoundaryMesh& boundary_mesh() const { return mesh_; }
  const bem::BoundaryOperator* boundary_operator() const { return operator_.get(); }
  // Whether cracks cut the region, or a subdomain of it, into pieces (boundary_pieces.cpp).
  bool is_cut() const override;
  bool has_inner_crack(int crack) const override;

  void mesh(const Preparation& preparation) override;
  void build(const Preparation& preparation, Contributions& contributions) override;
  std::vector<LeadingElements> leading_elements() const override;
  std::vector<Point> places_facing(int other_region) const override;

  std::vector<coupling::DenseOperator> dense_operators(std::span<const RegionOperator> before) const override;
  std::vector<OperatorNodes> nodes_of_operators() const override;
  std::optional<Eigen::VectorXd> outflow(Eigen::Index dof_count) const override;

  std::vector<PlacedNode> nodes_on(const EdgeSpan& span, double tolerance) const override;
  void add_traction(const EdgeSpan& span, const std::function<Point(const Point&)>& traction,
                    Eigen::Ref<Eigen::VectorXd> force) const override;
  std::vector<Point> forces_on_edge(const EdgeSpan& span, const std::vector<int>& nodes_of_scene,
                                    const FieldsOfRegion& fields) const override;
  // Adds the nodal forces of a body force, which a particular solution carries.
  void add_body_force(const BodyForce& body_force, Eigen::Ref<Eigen::VectorXd> force) const override;

  Eigen::Matrix2d work_within(const std::array<BodyForce, 2>& body_force,
                              const std::vector<CrackLoad>& crack_loads) const override;

  coupling::Affine face_offsets(const std::array<BodyForce, 2>& body_force,
                                const std::vector<CrackLoad>& crack_loads) const override;

  // Takes a swelling strain. Throws Error (argument) for one that is not linear: it causes stress in the interior.
  void swell(const Swelling& strain, LatticeSwelling& lattices) override;
  std::optional<Eigen::Matrix2d> free_displacement(const Point& place) const override;

  // Functions about cracks of the region (crack_results.cpp).
  bool has_crack_elements() const override { return true; }
  void add_crack_load(const CrackLoad& load, int part, Eigen::Ref<Eigen::VectorXd> force) const override;
  std::vector<TipValues> tips(const Solution& solution, TipDetail detail) const override;
  std::vector<Point> crack_openings(int crack, const std::vector<double>& fractions,
                                    const Solution& solution) const override;
  std::vector<CrackPicture> crack_pictures(const Solution& solution) const override;
  std::optional<Overlap> overlap(const Solution& solution) const override;

  std::vector<int> entries_of_nodes() const override;
  std::vector<int> nodes_of_entries() const override;
  FieldSize field_size(Field field) const override;
  FieldValues field(Field field, const Solution& solution) const override;
  std::int64_t cell_count() const override { return static_cast<std::int64_t>(mesh_.elements.size()); }
  Cells cells() const override;
  SnapshotBlock snapshot_block() const override;
  bool has_inside() const override { return true; }
  const CrackLines* crack_lines() const override;
  FieldValues at_nodes(Field field, const FieldValues& values) const override;
  std::unique_ptr<Evaluator> evaluator(const Solution& solution, const FieldsOfRegion& fields,
                                       bool with_stress) const override;
  int rank_at_interfaces() const override { return 1; }
  // Estimated memory [B] that preparing takes with `times` as many elements.
  double memory_of_preparing(double times) const;
  void add_statistics(RegionStatistics& statistics) const override;

 protected:
  virtual MeshingRules meshing_rules(const Preparation& preparation) const;
  virtual BoundaryMesh make_mesh(const std::vector<std::vector<Panel>>& loops) const { return mesh_boundary(loops); }
  // Whether the region may be cut into subdomains if it is large.
  virtual bool can_be_cut() const { return true; }
  // Solver for systems that contain the stiffness of this region.
  virtual const coupling::SolutionMethod& solution_method() const { return coupling::symmetric_solution(); }
  virtual std::shared_ptr<const bem::BoundaryOperator> make_operator(const Preparation& preparation,
                                                                     const bem::AssemblyOptions& assembly) const;
  // Stiffness in schemes where it depends on the neighbours of edges; empty to keep that of the operator.
  virtual Eigen::MatrixXd own_stiffness(const Preparation& /*preparation*/) const { return {}; }

  const std::vector<PanelSource>& panels() const { return panels_; }

 private:
  struct NodeRoles;

  NodeRoles roles() const;
  void follow_rows_to_mouths(NodeRoles& roles) const;
  std::vector<int> sides_of_cracks(const Preparation& preparation) const;
  void number_nodes(const Preparation& preparation, NodeRegistry& registry);
  void cut_if_large(const Preparation& preparation);
  BoundaryMesh mesh_without_cracks(const Preparation& preparation) const;
  void mesh_cracks(const Preparation& preparation);
  const BoundaryRegion* before_growth(const Preparation& preparation) const;
  const CrackedPart* part_before(const Preparation& preparation, const CrackedPart& part) const;
  void build_cracks(const Preparation& preparation, const bem::AssemblyOptions& assembly);
  std::vector<const BoundaryRegion*> regions_alike(const Preparation& preparation) const;
  // Places of the mesh's nodes, and of those on cuts between subdomains.
  const std::vector<Point>& places() const;
  std::shared_ptr<const Eigen::MatrixXd> stiffness_of_nodes() const;
  const Eigen::MatrixXd& mesh_stiffness() const { return stiffness_.size() > 0 ? stiffness_ : operator_->stiffness(); }
  bool has_operator_of(const BoundaryRegion& other) const;
  int node_at(int place) const;  // of the scene, -1 where nodes follow others
  LinearBodyForce particular(const BodyForce& body_force) const;
  // Particular solution of a body force at places(): displacement_of() gives its displacements u_p,
  // force_besides() the forces K u_p - f(t_p) by which it changes the nodal forces.
  Eigen::VectorXd displacement_of(const LinearBodyForce& particular) const;
  Eigen::VectorXd force_besides(const LinearBodyForce& particular) const;
  double work_within(const BodyForce& body_force, const BodyForce& other) const;
  // Particular solutions at the nodes and on the crack faces of a part.
  CrackedPart::Particulars particulars(const std::array<BodyForce, 2>& body_force, const CrackedPart& part) const;
  // Displacements of places() without those of free swelling. `displacement` is that of the scene's nodes;
  // `constant` and `proportional` are the factors of the swelling's two parts.
  Eigen::VectorXd elastic(const Eigen::VectorXd& displacement, double constant, double proportional) const;
  // Displacements of places() without those of free swelling and of a particular solution; interior_without()
  // evaluates the interior for them.
  Eigen::VectorXd displacement_without(const LinearBodyForce& particular, const Solution& solution) const;
  bem::InteriorEvaluator interior_without(const LinearBodyForce& particular, const Solution& solution) const;
  // Evaluators of the interior for a solution without free swelling and the solution `particular`, one for each piece
  // into which cracks cut the region.
  InteriorOfPieces inside_without(const LinearBodyForce& particular, const Solution& solution) const;
  // Openings and tractions of each part with cracks for displacements of the scene's nodes and the loads on faces,
  // `constant` and `proportional` being the factors of the loads' two parts.
  std::vector<bem::CrackedState> cracked_states(const Eigen::VectorXd& displacement, const Solution& solution,
                                                double constant, double proportional) const;
  std::vector<bem::CrackedState> cracked_states(const Solution& solution) const;
  // Tractions on the boundary for displacements of places().
  Eigen::VectorXd tractions_under(const Eigen::VectorXd& displacement, const Solution& solution) const;
  FieldValues element_tractions(const Solution& solution) const;
  FieldValues element_stress(const Solution& solution) const;

  std::vector<PanelSource> panels_;
  BoundaryMesh mesh_;
  std::vector<int> node_of_mesh_node_;                     // of the scene, or -1
  Eigen::SparseMatrix<double> trace_;                      // displacements of places() from the region's nodes'
  std::shared_ptr<const bem::BoundaryOperator> operator_;  // shared by regions that are alike
  std::unique_ptr<RegionCracks> cracks_;                   // null without
  std::unique_ptr<RegionSubdomains> subdomains_;           // null if one operator serves the region
  std::vector<CrackedPart> cracked_;                       // the region, or subdomains of it
  Eigen::MatrixXd stiffness_;                              // on the mesh's nodes, if not the operator's own
  std::optional<FreeSwelling> free_swelling_;
  coupling::Affine rest_{0, 2};      // rest displacements of the region's nodes, if it swells
  bool middles_follow_ends_ = true;  // at grids that the elements follow
};

}  // namespace bempd::regions
