#include "regions/boundary/boundary_operators.hpp"

#include <typeinfo>
#include <utility>

#include "bem/boundary_loads.hpp"

namespace bempd::regions {

// Operators of earlier regions of the same kind and material. This region uses such an operator, or one of an earlier
// region's subdomain, again where its own mesh, or that of its subdomain, is a translated copy. Operators with cracks
// are not shared.
std::vector<const BoundaryOperators*> BoundaryOperators::alike_before(const Preparation& preparation) const {
  std::vector<const BoundaryOperators*> found;
  for (const auto& other : preparation.regions) {
    if (other.get() == &region_ || parts_.is_whole_with_cracks()) break;
    const auto* before = dynamic_cast<const BoundaryOperators*>(other->operators());
    if (!before || region_.elasticity() != other->elasticity()) continue;
    if (!before->parts_.is_whole_with_cracks()) found.push_back(before);
  }
  return found;
}

const BoundaryParts* BoundaryOperators::parts_before_growth(const Preparation& preparation) const {
  if (!preparation.before) return nullptr;
  for (const auto& region : *preparation.before)
    if (region->id() == region_.id()) return &static_cast<const BoundaryOperators*>(region->operators())->parts_;
  return nullptr;
}

void BoundaryOperators::build(const Preparation& preparation) {
  const BoundaryMesh& mesh = mesh_.mesh();
  const bem::AssemblyOptions assembly{preparation.options.number("bem.quadrature_tolerance"),
                                      preparation.options.whole_number("threads")};
  std::vector<const RegionSubdomains*> lent;
  for (const BoundaryOperators* alike : alike_before(preparation)) {
    if (alike->parts_.subdomains()) lent.push_back(alike->parts_.subdomains());
    if (!whole_ && alike->whole_ && differ_by_translation(mesh, alike->mesh_.mesh())) whole_ = alike->whole_;
  }
  const BoundaryParts* before = parts_before_growth(preparation);
  if (before && before->subdomains()) lent.push_back(before->subdomains());
  parts_.build(preparation, assembly, mesh, lent, before);
  if (parts_.subdomains()) return;
  if (parts_.cracks()) whole_ = parts_.cracked().front().body;
  const ElementsOfRegion elements{region_.id(), mesh, mesh_.panels(), region_.elasticity()};
  if (!whole_) whole_ = method_.make_operator(elements, assembly);
  // The stiffness may depend on the interfaces of a region. Regions that share an operator may then have different
  // stiffnesses.
  stiffness_ = method_.own_stiffness(preparation.scene, elements, *whole_);
}

bool BoundaryOperators::has_operator_of(const BoundaryOperators& other) const {
  const Eigen::SparseMatrix<double>&own = mesh_.trace(), &theirs = other.mesh_.trace();
  return whole_ && other.whole_ == whole_ && other.stiffness_.size() == stiffness_.size() &&
         (stiffness_.size() == 0 || other.stiffness_ == stiffness_) && theirs.rows() == own.rows() &&
         theirs.cols() == own.cols() && theirs.isApprox(own, 0);
}

std::vector<coupling::DenseOperator> BoundaryOperators::dense_operators(std::span<const KnownOperator> before) const {
  const std::vector<int>& nodes = region_.nodes();
  const Eigen::SparseMatrix<double>& trace = mesh_.trace();
  const auto node_at = [this](int place) { return mesh_.node_at(place); };
  if (const RegionSubdomains* subdomains = parts_.subdomains()) {
    const TraceRows rows = trace;
    auto all = subdomains->dense_operators(nodes, rows, swelling_.rest());
    for (const CrackedPart& part : parts_.cracked()) {
      coupling::DenseOperator& own = all[part.subdomain];
      own.constraints = part.constraints_for(subdomains->trace_of_subdomain(part.subdomain, rows));
      own.pieces = part.pieces(node_at);
    }
    return all;
  }
  for (const KnownOperator& other : before) {
    if (typeid(*other.owner) == typeid(*this) && has_operator_of(static_cast<const BoundaryOperators&>(*other.owner)))
      return {{nodes, other.dense.stiffness, &method_.solution_method(), swelling_.rest()}};
  }
  coupling::DenseOperator whole{nodes, stiffness_of_nodes(), &method_.solution_method(), swelling_.rest()};
  if (parts_.cracks()) {
    const CrackedPart& cracked = parts_.cracked().front();
    whole.constraints = cracked.constraints_for(trace);
    whole.pieces = cracked.pieces(node_at);
  }
  return {std::move(whole)};
}

std::vector<OperatorNodes> BoundaryOperators::nodes_of_operators() const {
  const std::vector<int>& nodes = region_.nodes();
  if (!parts_.subdomains()) return {{nodes, swelling_.rest()}};
  return parts_.subdomains()->nodes_of_operators(nodes, mesh_.trace(), swelling_.rest());
}

std::shared_ptr<const Eigen::MatrixXd> BoundaryOperators::stiffness_of_nodes() const {
  // The region's nodes are the nodes of the mesh in the same order, unless the displacements of some nodes follow from
  // other nodes.
  const Eigen::SparseMatrix<double>& trace = mesh_.trace();
  const bool all_nodes = trace.rows() == trace.cols();
  if (all_nodes && stiffness_.size() == 0) return {whole_, &whole_->stiffness()};
  if (all_nodes) return std::make_shared<const Eigen::MatrixXd>(stiffness_);
  const Eigen::MatrixXd half = mesh_stiffness() * trace;
  return std::make_shared<const Eigen::MatrixXd>(trace.transpose() * half);
}

std::optional<Eigen::VectorXd> BoundaryOperators::outflow(Eigen::Index dof_count) const {
  // A region with cracks is not incompressible as a whole, because opening cracks can take up a change of volume.
  if (!region_.elasticity().incompressible() || parts_.cracks()) return std::nullopt;
  Eigen::VectorXd on_mesh = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(mesh_.mesh().nodes.size()));
  bem::add_normal_integrals(mesh_.mesh(), on_mesh);
  Eigen::VectorXd flow = Eigen::VectorXd::Zero(dof_count);
  region_.scatter(mesh_.trace().transpose() * on_mesh, flow);
  return flow;
}

double BoundaryOperators::memory_of_preparing(double times) const {
  return parts_.memory_of_preparing(static_cast<double>(mesh_.mesh().elements.size()), times);
}

void BoundaryOperators::add_statistics(RegionStatistics& statistics) const {
  if (parts_.subdomains()) return parts_.subdomains()->add_statistics(statistics);
  if (statistics.counted.insert(whole_.get()).second) statistics.kernel_evaluations += whole_->kernel_evaluations();
}

}  // namespace bempd::regions
