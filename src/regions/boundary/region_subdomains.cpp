#include "regions/boundary/region_subdomains.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "bem/boundary_loads.hpp"
#include "bem/galerkin_operator.hpp"
#include "linalg/blas_threads.hpp"
#include "parallel.hpp"

namespace bempd::regions {

namespace {

// Largest number of elements in a region that is not cut.
constexpr std::size_t most_undivided = 500;

// Largest number of elements in a subdomain of a region that is cut.
constexpr std::size_t most_elements = 80;

// Memory estimate of an operator: bytes per square of the number of elements (four unknowns each), for the matrices
// that exist at the same time while it is built. Measured as 500 to 600 with 220 and 420 elements.
constexpr double bytes_per_square_of_elements = 500;

// Ratio of the sum of the squares of the subdomains' numbers of elements to the product of the region's number of
// elements and `most_elements`. Measured as 1.1 to 1.5.
constexpr double squares_of_subdomains = 1.1;

// Finds the nodes of a region (columns of its trace matrix) that determine the displacements of a subdomain's nodes.
class TraceColumns {
 public:
  explicit TraceColumns(const TraceRows& trace)
      : trace_(trace), known_(static_cast<std::size_t>(trace.cols()) / 2, 0) {}

  // Numbers of the region's nodes that determine a subdomain's nodes, in the order of the latter.
  std::vector<int> of(const Subdomain& part) {
    std::vector<int> columns;
    columns.reserve(part.nodes.size());
    for (const int node : part.nodes)
      for (TraceRows::InnerIterator entry(trace_, 2 * node); entry; ++entry) {
        const auto column = static_cast<std::size_t>(entry.col()) / 2;
        if (!known_[column]) columns.push_back(static_cast<int>(column));
        known_[column] = 1;
      }
    for (const int column : columns) known_[static_cast<std::size_t>(column)] = 0;
    return columns;
  }

 private:
  const TraceRows& trace_;
  std::vector<char> known_;
};

// Part of the trace matrix that gives the displacements of a subdomain's nodes from those of the nodes `columns`.
Eigen::SparseMatrix<double> trace_of(const Subdomain& part, const std::vector<int>& columns, const TraceRows& trace) {
  std::vector<int> place(static_cast<std::size_t>(trace.cols()) / 2, -1);
  for (std::size_t i = 0; i < columns.size(); ++i) place[static_cast<std::size_t>(columns[i])] = static_cast<int>(i);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < part.nodes.size(); ++i)
    for (int component = 0; component < 2; ++component)
      for (TraceRows::InnerIterator entry(trace, 2 * part.nodes[i] + component); entry; ++entry)
        entries.emplace_back(2 * static_cast<int>(i) + component,
                             2 * place[static_cast<std::size_t>(entry.col()) / 2] + component, entry.value());
  Eigen::SparseMatrix<double> own(2 * static_cast<Eigen::Index>(part.nodes.size()),
                                  2 * static_cast<Eigen::Index>(columns.size()));
  own.setFromTriplets(entries.begin(), entries.end());
  return own;
}

}  // namespace

double memory_of_operator(double elements) { return bytes_per_square_of_elements * elements * elements; }

double least_memory_of_region(double elements) {
  if (elements <= static_cast<double>(most_undivided)) return memory_of_operator(elements);
  return bytes_per_square_of_elements * squares_of_subdomains * elements * static_cast<double>(most_elements);
}

namespace {

// Limits on numbers of elements: `most_undivided` for a region that is not cut, `most_elements` for a subdomain.
struct CutSizes {
  std::size_t most_undivided, most_elements;
};

CutSizes cut_sizes(const scene::Options& options) {
  const auto wanted = static_cast<std::size_t>(options.number("test.subdomain_elements"));
  return wanted > 0 ? CutSizes{wanted, wanted} : CutSizes{most_undivided, most_elements};
}

}  // namespace

std::unique_ptr<RegionSubdomains> RegionSubdomains::of(const BoundaryMesh& body, const scene::Options& options) {
  const CutSizes sizes = cut_sizes(options);
  if (body.elements.size() <= sizes.most_undivided) return nullptr;
  Subdivision subdivision = subdivide(body, sizes.most_elements);
  if (subdivision.subdomains.size() == 1) return nullptr;
  return std::make_unique<RegionSubdomains>(std::move(subdivision), body);
}

std::unique_ptr<RegionSubdomains> RegionSubdomains::around(const std::vector<Stations>& cracks,
                                                           const BoundaryMesh& body, BoundaryMesh uncracked,
                                                           const scene::Options& options,
                                                           const RegionSubdomains* before) {
  const CutSizes sizes = cut_sizes(options);
  if (uncracked.elements.size() <= sizes.most_undivided) return nullptr;
  std::shared_ptr<const Uncracked> known = before ? before->uncracked_ : nullptr;
  if (!known || known->most_elements != sizes.most_elements || known->mesh.nodes != uncracked.nodes) {
    std::vector<Stations> cuts = subdivide(uncracked, sizes.most_elements).cuts;
    known = std::make_shared<const Uncracked>(Uncracked{std::move(uncracked), sizes.most_elements, std::move(cuts)});
  }
  Subdivision subdivision =
      subdivide(body, sizes.most_elements, known->cuts, cracks, before ? &before->subdivision_ : nullptr);
  if (subdivision.subdomains.size() == 1) return nullptr;
  auto made = std::make_unique<RegionSubdomains>(std::move(subdivision), body);
  made->uncracked_ = std::move(known);
  return made;
}

RegionSubdomains::RegionSubdomains(Subdivision subdivision, const BoundaryMesh& body)
    : subdivision_(std::move(subdivision)), operators_(subdivision_.subdomains.size()) {
  number(body);
}

void RegionSubdomains::number(const BoundaryMesh& body) {
  traction_node_count_ = body.traction_node_count;
  traction_nodes_.clear();
  for (const BoundaryElement& element : body.elements) traction_nodes_.push_back(element.traction_nodes);
}

void RegionSubdomains::build(const PlaneElasticity& elasticity, const bem::AssemblyOptions& assembly,
                             const std::vector<const RegionSubdomains*>& before) {
  using Source = std::pair<const RegionSubdomains*, std::size_t>;
  std::map<std::pair<std::size_t, int>, std::vector<Source>> known;  // by numbers of elements and traction nodes
  const auto kin = [&](const BoundaryMesh& mesh) -> std::vector<Source>& {
    return known[{mesh.elements.size(), mesh.traction_node_count}];
  };
  for (const RegionSubdomains* other : before)
    for (std::size_t i = 0; i < other->count(); ++i)
      if (!other->has_cracks(i)) kin(other->subdivision_.subdomains[i].mesh).emplace_back(other, i);
  std::vector<Source> source(count());
  std::vector<std::size_t> own;
  for (std::size_t i = 0; i < count(); ++i) {
    if (has_cracks(i)) continue;
    const BoundaryMesh& mesh = subdivision_.subdomains[i].mesh;
    std::vector<Source>& candidates = kin(mesh);
    const auto alike = std::find_if(candidates.begin(), candidates.end(), [&](const Source& one) {
      return differ_by_translation(mesh, one.first->subdivision_.subdomains[one.second].mesh);
    });
    source[i] = alike != candidates.end() ? *alike : Source(this, i);
    if (alike != candidates.end()) continue;
    candidates.emplace_back(this, i);
    own.push_back(i);
  }
  {
    const linalg::BlasThreads one_each(1);
    bem::AssemblyOptions serial = assembly;
    serial.threads = 1;
    serial.compact = true;
    parallel_for(own.size(), assembly.threads, [&](std::size_t i) {
      operators_[own[i]] =
          std::make_shared<const bem::GalerkinOperator>(subdivision_.subdomains[own[i]].mesh, elasticity, serial);
    });
  }
  for (std::size_t i = 0; i < count(); ++i)
    if (!has_cracks(i)) operators_[i] = source[i].first->operators_[source[i].second];
}

std::vector<OperatorNodes> RegionSubdomains::nodes_of_operators(const std::vector<int>& nodes, const TraceRows& trace,
                                                                const coupling::Affine& rest) const {
  TraceColumns columns_of(trace);
  std::vector<OperatorNodes> all;
  for (const Subdomain& part : subdivision_.subdomains) {
    std::vector<int> columns = columns_of.of(part);
    coupling::Affine own(rest.rows() > 0 ? 2 * static_cast<Eigen::Index>(columns.size()) : 0, 2);
    for (Eigen::Index i = 0; 2 * i < own.rows(); ++i)
      own.middleRows<2>(2 * i) = rest.middleRows<2>(2 * columns[static_cast<std::size_t>(i)]);
    for (int& column : columns) column = nodes[static_cast<std::size_t>(column)];  // its number in the scene
    all.push_back({std::move(columns), std::move(own)});
  }
  return all;
}

std::vector<coupling::DenseOperator> RegionSubdomains::dense_operators(const std::vector<int>& nodes,
                                                                       const TraceRows& trace,
                                                                       const coupling::Affine& rest) const {
  std::vector<OperatorNodes> own_nodes = nodes_of_operators(nodes, trace, rest);
  std::vector<coupling::DenseOperator> all;
  for (std::size_t i = 0; i < count(); ++i) {
    const Subdomain& part = subdivision_.subdomains[i];
    std::shared_ptr<const Eigen::MatrixXd> stiffness(operators_[i], &operators_[i]->stiffness());
    // A subdomain has the nodes of its mesh, in their order, unless displacements of some nodes follow from other
    // nodes.
    if (own_nodes[i].nodes.size() != part.nodes.size()) {
      const Eigen::SparseMatrix<double> own = trace_of_subdomain(i, trace);
      const Eigen::MatrixXd half = *stiffness * own;
      stiffness = std::make_shared<const Eigen::MatrixXd>(own.transpose() * half);
    }
    all.push_back({std::move(own_nodes[i].nodes), std::move(stiffness), &coupling::symmetric_solution(),
                   std::move(own_nodes[i].rest)});
  }
  return all;
}

Eigen::SparseMatrix<double> RegionSubdomains::trace_of_subdomain(std::size_t subdomain, const TraceRows& trace) const {
  const Subdomain& part = subdivision_.subdomains[subdomain];
  return trace_of(part, TraceColumns(trace).of(part), trace);
}

Eigen::VectorXd RegionSubdomains::values_of(const Subdomain& part, const Eigen::VectorXd& all) const {
  Eigen::VectorXd own(2 * static_cast<Eigen::Index>(part.nodes.size()));
  for (std::size_t i = 0; i < part.nodes.size(); ++i)
    own.segment<2>(2 * static_cast<Eigen::Index>(i)) = all.segment<2>(2 * part.nodes[i]);
  return own;
}

void RegionSubdomains::for_each_outline_element(const std::function<void(std::size_t, int, int)>& visit) const {
  for (std::size_t i = 0; i < count(); ++i) {
    const std::vector<int>& elements = subdivision_.subdomains[i].elements;
    for (std::size_t e = 0; e < elements.size(); ++e)
      if (elements[e] >= 0) visit(i, static_cast<int>(e), elements[e]);
  }
}

Eigen::VectorXd RegionSubdomains::tractions(const Eigen::VectorXd& displacement,
                                            const std::vector<CrackedPart>& cracked,
                                            const std::vector<bem::CrackedState>& states) const {
  std::vector<Eigen::VectorXd> of_part(count());
  for (std::size_t k = 0; k < cracked.size(); ++k) of_part[cracked[k].subdomain] = states[k].tractions;
  for (std::size_t i = 0; i < count(); ++i)
    if (!has_cracks(i)) of_part[i] = operators_[i]->tractions(values_of(subdivision_.subdomains[i], displacement));
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(traction_node_count_));
  std::vector<int> counts(static_cast<std::size_t>(traction_node_count_), 0);
  for_each_outline_element([&](std::size_t part, int element, int of_body) {
    const auto& own = subdivision_.subdomains[part].mesh.elements[static_cast<std::size_t>(element)].traction_nodes;
    const auto& theirs = traction_nodes_[static_cast<std::size_t>(of_body)];
    for (std::size_t k = 0; k < 3; ++k) {
      sums.segment<2>(2 * theirs[k]) += of_part[part].segment<2>(2 * own[k]);
      ++counts[static_cast<std::size_t>(theirs[k])];
    }
  });
  for (std::size_t i = 0; i < counts.size(); ++i) sums.segment<2>(2 * static_cast<Eigen::Index>(i)) /= counts[i];
  return sums;
}

Eigen::VectorXd RegionSubdomains::forces_less_stress(const Eigen::VectorXd& displacement,
                                                     const std::function<Eigen::Vector3d(const Point&)>& stress,
                                                     double thickness) const {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(displacement.size());
  for (std::size_t i = 0; i < count(); ++i) {
    const Subdomain& part = subdivision_.subdomains[i];
    Eigen::VectorXd of_stress = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(part.nodes.size()));
    bem::add_stress_forces(part.mesh, stress, thickness, of_stress);
    const Eigen::VectorXd own = operators_[i]->stiffness() * values_of(part, displacement) - of_stress;
    for (std::size_t k = 0; k < part.nodes.size(); ++k)
      forces.segment<2>(2 * part.nodes[k]) += own.segment<2>(2 * static_cast<Eigen::Index>(k));
  }
  return forces;
}

void RegionSubdomains::add_interiors(const PlaneElasticity& elasticity, const Eigen::VectorXd& displacement,
                                     InteriorOfPieces& all) const {
  for (std::size_t i = 0; i < count(); ++i) {
    if (has_cracks(i)) continue;
    const Subdomain& part = subdivision_.subdomains[i];
    const Eigen::VectorXd own = values_of(part, displacement);
    all.add({part.mesh, elasticity, own, operators_[i]->tractions(own)}, part.mesh);
  }
}

std::vector<double> RegionSubdomains::element_stress(const PlaneElasticity& elasticity,
                                                     const Eigen::VectorXd& displacement,
                                                     const std::vector<CrackedPart>& cracked,
                                                     const std::vector<bem::CrackedState>& states) const {
  std::vector<std::optional<bem::InteriorEvaluator>> inside(count());
  for (std::size_t k = 0; k < cracked.size(); ++k)
    inside[cracked[k].subdomain] = bem::interior_of_body(*cracked[k].body, states[k]);
  for (std::size_t i = 0; i < count(); ++i) {
    if (inside[i]) continue;
    const Eigen::VectorXd own = values_of(subdivision_.subdomains[i], displacement);
    inside[i].emplace(mesh_of(i), elasticity, own, operators_[i]->tractions(own));
  }
  std::vector<double> stress(9 * traction_nodes_.size());
  for_each_outline_element([&](std::size_t part, int element, int of_body) {
    double* own = &stress[9 * static_cast<std::size_t>(of_body)];
    for (int k = 0; k < 3; ++k, own += 3) Eigen::Map<Eigen::Vector3d>{own} = inside[part]->stress_on(element, k - 1);
  });
  return stress;
}

void RegionSubdomains::add_statistics(RegionStatistics& statistics) const {
  statistics.subdomains += static_cast<std::int64_t>(count());
  statistics.cut_nodes += static_cast<std::int64_t>(cut_nodes().size());
  for (const auto& one : operators_)
    if (statistics.counted.insert(one.get()).second) statistics.kernel_evaluations += one->kernel_evaluations();
}

}  // namespace bempd::regions
