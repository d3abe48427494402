#include "paper/collocation_operator.hpp"

#include <Eigen/SparseCore>
#include <array>
#include <atomic>
#include <numbers>

#include "cancellation.hpp"
#include "linalg/dense_parts.hpp"
#include "paper/point_integrals.hpp"
#include "parallel.hpp"

namespace bempd::paper {

using namespace bem;

namespace {

// Parameter of the collocation point inside an element beside a node with two tractions, if that node has xi = 1.
constexpr double shifted = 2.0 / 3;

// Collocation point, with its parameter on every element that contains the point: two elements if the point is their
// common end.
struct CollocationPoint {
  struct Home {
    int element;
    double xi;
  };
  std::vector<Home> homes;
};

// Collocation points, one for every traction node. A node with two tractions has a point inside each of its elements,
// because a point at the node itself would give the same equation twice.
std::vector<CollocationPoint> collocation_points(const BoundaryMesh& mesh) {
  std::vector<int> traction_of_node(mesh.nodes.size(), -1);
  std::vector<bool> has_two(mesh.nodes.size(), false);
  for (const BoundaryElement& e : mesh.elements)
    for (int k = 0; k < 3; ++k) {
      int& known = traction_of_node[e.nodes[k]];
      if (known >= 0 && known != e.traction_nodes[k]) has_two[e.nodes[k]] = true;
      known = e.traction_nodes[k];
    }
  std::vector<CollocationPoint> points(mesh.traction_node_count);
  for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e)
    for (int k = 0; k < 3; ++k) {
      const BoundaryElement& element = mesh.elements[e];
      const double xi = (k - 1) * (has_two[element.nodes[k]] ? shifted : 1.0);
      points[element.traction_nodes[k]].homes.push_back({e, xi});
    }
  return points;
}

// Assembler of G^T and H^T, the transposed matrices of Somigliana's identity H u = G t, with lengths over the body's
// diagonal and the shear modulus 1. Every point has its own pair of columns, so that threads can compute points
// independently.
class Assembler {
 public:
  Assembler(const BoundaryMesh& mesh, double nu, double tolerance)
      : mesh_(mesh),
        nu_(nu),
        boundary_(mesh),
        integrator_(boundary_.elements, tolerance),
        points_(collocation_points(mesh)) {
    single_layer_transpose.setZero(2 * mesh.traction_node_count, 2 * mesh.traction_node_count);
    double_layer_transpose.setZero(2 * mesh.nodes.size(), 2 * mesh.traction_node_count);
    for (const ElementGeometry& element : boundary_.elements) {
      ElementPoints points;
      fill_points(element, {}, max_regular_points, points);
      auto& lengths = element_lengths_.emplace_back();
      for (int b = 0; b < 3; ++b) {
        lengths[b] = 0;
        for (int p = 0; p < points.count; ++p) lengths[b] += points.mass[b][p];
      }
    }
  }

  std::int64_t add_point(int point) {
    const std::vector<CollocationPoint::Home>& homes = points_[point].homes;
    const auto [home_element, home_xi] = homes.front();
    const Point x = boundary_.elements[home_element].at(home_xi);
    Eigen::Matrix2d constant = Eigen::Matrix2d::Zero();  // integral of T over elements that do not contain x
    std::int64_t evaluations = 0;
    for (int e = 0; e < static_cast<int>(mesh_.elements.size()); ++e) {
      check_cancelled();
      const CollocationPoint::Home* home = nullptr;
      for (const auto& candidate : homes)
        if (candidate.element == e) home = &candidate;
      const PointMoments moments = home ? integrator_.on_element(e, home->xi) : integrator_.off_element(e, x);
      evaluations += moments.evaluations;
      for (int b = 0; b < 3; ++b) {
        single_layer_transpose.block<2, 2>(2 * mesh_.elements[e].traction_nodes[b], 2 * point) +=
            single_layer(moments, element_lengths_[e][b], b);
        const Eigen::Matrix2d block = double_layer(moments, b).transpose();
        double_layer_transpose.block<2, 2>(2 * mesh_.elements[e].nodes[b], 2 * point) += block;
        if (!home) constant += block;
      }
    }
    // The traction kernel T is applied to u - u(x) on all elements, because a constant displacement has no traction.
    // The free term at the point x is therefore not needed.
    const auto value = boundary_.elements[home_element].shape(home_xi);
    for (int b = 0; b < 3; ++b)
      double_layer_transpose.block<2, 2>(2 * mesh_.elements[home_element].nodes[b], 2 * point) -= value[b] * constant;
    return evaluations;
  }

  double length() const { return boundary_.length; }

  Eigen::MatrixXd single_layer_transpose, double_layer_transpose;

 private:
  // Integral of U N_b over an element, with the displacement kernel U and the shape function N_b. The trace part of e
  // e^T, half the unit matrix, gives half the integral of N_b (`length`).
  Eigen::Matrix2d single_layer(const PointMoments& m, double length, int b) const {
    const double isotropic = 0.5 * length - (3 - 4 * nu_) * m.mass[0][b];
    Eigen::Matrix2d block;
    block << isotropic + m.mass[1][b], m.mass[2][b], m.mass[2][b], isotropic - m.mass[1][b];
    return block / (8 * std::numbers::pi * (1 - nu_));
  }

  // Integral of T N_b over an element, with the traction kernel T and the shape function N_b; if the point x lies on
  // the element, of T (N_b - N_b(x)).
  Eigen::Matrix2d double_layer(const PointMoments& m, int b) const {
    const double isotropic = (2 - 2 * nu_) * m.double_layer[0][b], rotation = (1 - 2 * nu_) * m.double_layer[1][b];
    const double cosine = 2 * m.double_layer[2][b], sine = 2 * m.double_layer[3][b];
    Eigen::Matrix2d block;
    block << isotropic + cosine, sine + rotation, sine - rotation, isotropic - cosine;
    return block / (-4 * std::numbers::pi * (1 - nu_));
  }

  const BoundaryMesh& mesh_;
  double nu_;
  ScaledBoundary boundary_;
  PointIntegrator integrator_;
  std::vector<CollocationPoint> points_;
  std::vector<std::array<double, 3>> element_lengths_;  // integral of N_b
};

// Integrals of N_a N_b ds for both components, with the shape functions N_a of displacement nodes and N_b of traction
// nodes.
Eigen::SparseMatrix<double> trace_mass(const BoundaryMesh& mesh) {
  const ScaledBoundary boundary(mesh);
  std::vector<Eigen::Triplet<double>> entries;
  ElementPoints points;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    fill_points(boundary.elements[e], {}, max_regular_points, points);
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        double sum = 0;
        for (int p = 0; p < points.count; ++p) sum += points.shape[a][p] * points.mass[b][p];
        const int row = 2 * mesh.elements[e].nodes[a], column = 2 * mesh.elements[e].traction_nodes[b];
        for (int i = 0; i < 2; ++i) entries.emplace_back(row + i, column + i, boundary.length * sum);
      }
  }
  Eigen::SparseMatrix<double> mass(2 * mesh.nodes.size(), 2 * mesh.traction_node_count);
  mass.setFromTriplets(entries.begin(), entries.end());
  return mass;
}

}  // namespace

BoundaryMesh with_one_traction_at_corners(BoundaryMesh mesh) {
  for (BoundaryElement& element : mesh.elements) element.traction_nodes = element.nodes;
  mesh.traction_node_count = static_cast<int>(mesh.nodes.size());
  return mesh;
}

CollocationOperator::CollocationOperator(const BoundaryMesh& mesh, const PlaneElasticity& elasticity,
                                         const AssemblyOptions& options) {
  Assembler assembler(mesh, elasticity.effective_poisson_ratio(), options.quadrature_tolerance);
  const int threads = options.threads_for(mesh.elements.size());
  std::atomic<std::int64_t> evaluations = 0;
  parallel_for(static_cast<std::size_t>(mesh.traction_node_count), threads,
               [&](std::size_t point) { evaluations += assembler.add_point(static_cast<int>(point)); });
  kernel_evaluations_ = evaluations;

  linalg::DenseLU single_layer;
  single_layer.compute(assembler.single_layer_transpose.transpose());
  traction_matrix_ = linalg::solve_in_parts(single_layer, assembler.double_layer_transpose.transpose());
  traction_matrix_ *= elasticity.shear_modulus() / assembler.length();
  stiffness_ = elasticity.thickness * (trace_mass(mesh) * traction_matrix_);
}

Eigen::MatrixXd CollocationOperator::tractions(const Eigen::Ref<const Eigen::MatrixXd>& displacements) const {
  return traction_matrix_ * displacements;
}

}  // namespace bempd::paper
