#include "coupling/interface_trace.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "linalg/least_change.hpp"

namespace bempd::coupling {

namespace {

// Largest residual accepted in the equations for the entries of the trace matrix N; the equations are of order one.
constexpr double largest_residual = 1e-11;

struct Elements {
  const std::vector<double>& stations;

  int count() const { return static_cast<int>(stations.size()) - 1; }
  int node_count() const { return 2 * count() + 1; }
  double node(int a) const { return a % 2 == 0 ? stations[a / 2] : 0.5 * (stations[a / 2] + stations[a / 2 + 1]); }
  double length(int element) const { return stations[element + 1] - stations[element]; }
  // Element that contains the coordinate s; where two elements meet, the element that ends there.
  int at(double s) const {
    const auto after = std::lower_bound(stations.begin() + 1, stations.end() - 1, s);
    return static_cast<int>(after - stations.begin()) - 1;
  }
  double interpolation(int a, double s) const {
    const int e = at(s);
    if (a < 2 * e || a > 2 * e + 2) return 0;
    const double xi = 2 * (s - stations[e]) / length(e) - 1;
    if (a == 2 * e) return 0.5 * xi * (xi - 1);
    return a == 2 * e + 1 ? 1 - xi * xi : 0.5 * xi * (xi + 1);
  }
  // Integral of the shape function of node number `a` over the interface.
  double share(int a) const {
    if (a % 2 == 1) return length(a / 2) * 2 / 3;
    return ((a > 0 ? length(a / 2 - 1) : 0) + (a < node_count() - 1 ? length(a / 2) : 0)) / 6;
  }
};

struct Entry {
  int row, column;
};

// Row of lattice points 0 .. length along an interface. The first and the last point lie on boundary nodes, unless the
// interface goes on for half a spacing beyond the point (at the mouth of a crack).
struct LatticeRow {
  explicit LatticeRow(const std::vector<double>& stations)
      : length(static_cast<int>(std::floor(stations.back() + 0.25))),
        starts_at_point(stations.front() > -0.25),
        ends_at_point(stations.back() < length + 0.25) {}

  int length;
  bool starts_at_point, ends_at_point;

  bool is_end(int i) const { return (i == 0 && starts_at_point) || (i == length && ends_at_point); }
  // Shares of the interface's length, in spacings, that the lattice points stand for; their sum and first moment are
  // those of the whole interface. At the mouth of a crack the interface goes on half a spacing beyond the last point,
  // and the shares of the last two points are changed so that the moment is right, too.
  std::vector<double> shares() const {
    constexpr double lever = 0.125;
    std::vector<double> all(static_cast<std::size_t>(length) + 1, 1.0);
    if (starts_at_point) all.front() = 0.5;
    if (ends_at_point) all.back() = 0.5;
    if (!starts_at_point && length > 0) all[0] += lever, all[1] -= lever;
    if (!ends_at_point && length > 0) all.end()[-1] += lever, all.end()[-2] -= lever;
    return all;
  }
};

// Places of the entries of N that may differ from zero: each lattice point depends on the nodes of all elements within
// one spacing of the point.
std::vector<Entry> pattern(const Elements& elements, const LatticeRow& row) {
  std::vector<Entry> entries;
  for (int i = 0; i <= row.length; ++i) {
    if (row.is_end(i)) {
      entries.push_back({i, i == 0 ? 0 : elements.node_count() - 1});
      continue;
    }
    const double reach = 1 - 1e-9;
    const int first = elements.at(std::max(elements.stations.front(), i - reach)), last = elements.at(i + reach);
    for (int a = 2 * first; a <= 2 * last + 2; ++a) entries.push_back({i, a});
  }
  return entries;
}

}  // namespace

std::optional<Eigen::SparseMatrix<double, Eigen::RowMajor>> interface_trace(const std::vector<double>& stations) {
  const Elements elements{stations};
  const LatticeRow row(stations);
  const int length = row.length;
  assert(length >= 1 || !row.starts_at_point || !row.ends_at_point);
  const std::vector<Entry> entries = pattern(elements, row);
  const auto count = static_cast<Eigen::Index>(entries.size());

  // Equations for the entries N_ia, for lattice points i at x_i and nodes a at x_a. Each lattice point has two: the
  // sums of N_ia and of N_ia (x_a - x_i) over its nodes are 1 and 0. Each node has one equation: under a constant
  // traction its force, the sum of N_ia times the share of point i, is that of the boundary elements.
  linalg::LeastChange problem;
  problem.lower = -std::numeric_limits<double>::infinity();
  problem.start.resize(count);
  problem.scale.setOnes(count);
  problem.target.setZero(2 * (length + 1) + elements.node_count());
  const std::vector<double> shares = row.shares();
  std::vector<Eigen::Triplet<double>> equations;
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto [i, a] = entries[k];
    const bool is_end = row.is_end(i);
    problem.start[k] = elements.interpolation(a, i);
    if (is_end) problem.scale[k] = 0;
    equations.emplace_back(2 * i, k, 1.0);
    equations.emplace_back(2 * i + 1, k, elements.node(a) - i);
    equations.emplace_back(2 * (length + 1) + a, k, shares[static_cast<std::size_t>(i)]);
  }
  for (int i = 0; i <= length; ++i) problem.target[2 * i] = 1;
  for (int a = 0; a < elements.node_count(); ++a) problem.target[2 * (length + 1) + a] = elements.share(a);
  problem.constraints.resize(problem.target.size(), count);
  problem.constraints.setFromTriplets(equations.begin(), equations.end());
  const linalg::LeastChangeResult result = linalg::solve_least_change(problem);
  if (!(result.residual <= largest_residual)) return std::nullopt;
  const Eigen::VectorXd& weights = result.values;

  std::vector<Eigen::Triplet<double>> values;
  for (Eigen::Index k = 0; k < count; ++k) {
    if (weights[k] != 0) values.emplace_back(entries[k].row, entries[k].column, weights[k]);
  }
  Eigen::SparseMatrix<double, Eigen::RowMajor> trace(length + 1, elements.node_count());
  trace.setFromTriplets(values.begin(), values.end());
  return trace;
}

}  // namespace bempd::coupling
