#include "window.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

#include "linalg/dense_inverse.hpp"
#include "linalg/nested_dissection.hpp"
#include "linalg/sparse_cholesky.hpp"

namespace directions {
namespace {

constexpr int most_pending = 192;
constexpr double loose = 1e-7;  // of what is left of a bond's compliance where it holds something alone

struct System {
  std::vector<int> unknown;  // of a point, -1 if held
  Eigen::SparseMatrix<double> matrix;
  Eigen::VectorXd load;
};

void add_bond(const Body& body, const Bond& bond, System& system, std::vector<Eigen::Triplet<double>>& entries) {
  const Eigen::Matrix2d block = bond.stiffness * bond.direction * bond.direction.transpose();
  const int ends[2] = {bond.first, bond.second};
  for (int a = 0; a < 2; ++a) {
    const int row = system.unknown[static_cast<std::size_t>(ends[a])];
    if (row < 0) continue;
    for (int b = 0; b < 2; ++b) {
      const int column = system.unknown[static_cast<std::size_t>(ends[b])];
      const Eigen::Matrix2d part = a == b ? block : Eigen::Matrix2d(-block);
      if (column < 0) {
        system.load.segment<2>(2 * row) -= part * body.given[static_cast<std::size_t>(ends[b])];
        continue;
      }
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          if (2 * row + i >= 2 * column + j) entries.emplace_back(2 * row + i, 2 * column + j, part(i, j));
    }
  }
}

System assemble(const Body& body) {
  System system;
  int free = 0;
  for (const char held : body.held) system.unknown.push_back(held ? -1 : free++);
  system.load = Eigen::VectorXd::Zero(2 * free);
  std::vector<Eigen::Triplet<double>> entries;
  for (const Bond& bond : body.bonds) add_bond(body, bond, system, entries);
  system.matrix.resize(2 * free, 2 * free);
  system.matrix.setFromTriplets(entries.begin(), entries.end());
  return system;
}

// Unknowns in order of elimination, those of the window last, in the window's order.
std::vector<int> elimination(const Body& body, const System& system, const std::vector<int>& window) {
  std::vector<Eigen::Vector2d> positions;
  std::vector<char> member;
  for (std::size_t k = 0; k < body.points.size(); ++k)
    if (!body.held[k]) positions.push_back(body.points[k]), member.push_back(!body.in_window[k]);
  std::vector<int> first, second;
  for (const Bond& bond : body.bonds) {
    const int a = system.unknown[static_cast<std::size_t>(bond.first)],
              b = system.unknown[static_cast<std::size_t>(bond.second)];
    if (a >= 0 && b >= 0) first.push_back(a), second.push_back(b);
  }
  std::vector<int> order;
  for (const int node : bempd::linalg::nested_dissection({positions, first, second, {}}, member))
    order.insert(order.end(), {2 * node, 2 * node + 1});
  for (const int point : window)
    for (int i = 0; i < 2; ++i) order.push_back(2 * system.unknown[static_cast<std::size_t>(point)] + i);
  return order;
}

}  // namespace

Window::Window(Body& body) : body_(body), local_(body.points.size(), -1), changes_() {
  for (std::size_t k = 0; k < body.points.size(); ++k)
    if (body.in_window[k]) local_[k] = static_cast<int>(points_.size()), points_.push_back(static_cast<int>(k));
  for (std::size_t k = 0; k < body.bonds.size(); ++k) {
    stiffness_.push_back(body.bonds[k].stiffness);
    const bool inside = local(body.bonds[k].first) >= 0 && local(body.bonds[k].second) >= 0;
    place_.push_back(inside ? static_cast<int>(bonds_.size()) : -1);
    if (inside) bonds_.push_back(static_cast<int>(k));
  }
  const System system = assemble(body);
  const int size = 2 * static_cast<int>(points_.size());
  const auto factor = bempd::linalg::make_sparse_cholesky();
  factor->set_elimination_order(elimination(body, system, points_), size);
  if (!factor->factorize(system.matrix)) throw std::runtime_error("the body is loose");
  Eigen::MatrixXd all = system.load;
  factor->solve_in_place(all);
  const std::vector<int>& order = factor->elimination_order();
  Eigen::MatrixXd inverse = factor->trailing_factor(size);
  bempd::linalg::invert_from_cholesky(inverse);
  // Rows of the trailing block are in the factor's own order.
  std::vector<int> where(static_cast<std::size_t>(2 * all.rows()), -1);
  for (std::size_t k = 0; k < points_.size(); ++k)
    for (int i = 0; i < 2; ++i)
      where[static_cast<std::size_t>(2 * system.unknown[static_cast<std::size_t>(points_[k])] + i)] =
          2 * static_cast<int>(k) + i;
  std::vector<int> target(static_cast<std::size_t>(size));
  for (int k = 0; k < size; ++k)
    target[static_cast<std::size_t>(k)] = where[static_cast<std::size_t>(
        order[order.size() - static_cast<std::size_t>(size) + static_cast<std::size_t>(k)])];
  flexibility_.resize(size, size);
  for (int j = 0; j < size; ++j)
    for (int i = j; i < size; ++i) {
      const int a = target[static_cast<std::size_t>(i)], b = target[static_cast<std::size_t>(j)];
      flexibility_(a, b) = flexibility_(b, a) = inverse(i, j);
    }
  displacement_.resize(size);
  for (std::size_t k = 0; k < points_.size(); ++k)
    displacement_.segment<2>(2 * static_cast<long>(k)) =
        all.col(0).segment<2>(2 * system.unknown[static_cast<std::size_t>(points_[k])]);
  changes_.resize(size, most_pending);
}

double Window::elongation(int bond) const {
  const Bond& b = body_.bonds[static_cast<std::size_t>(bond)];
  return b.direction.dot(displacement(b.second) - displacement(b.first));
}

void Window::fold() {
  flexibility_.selfadjointView<Eigen::Lower>().rankUpdate(changes_.leftCols(pending_));
  flexibility_.triangularView<Eigen::StrictlyUpper>() = flexibility_.transpose();
  pending_ = 0;
}

double Window::soften(int bond, double loss) {
  const Bond& b = body_.bonds[static_cast<std::size_t>(bond)];
  const int i = 2 * local(b.first), j = 2 * local(b.second);
  Eigen::VectorXd column = (flexibility_.middleCols<2>(j) - flexibility_.middleCols<2>(i)) * b.direction;
  if (pending_ > 0) {
    const Eigen::VectorXd along =
        (changes_.block(j, 0, 2, pending_) - changes_.block(i, 0, 2, pending_)).transpose() * b.direction;
    column.noalias() += changes_.leftCols(pending_) * along;
  }
  const double pivot = 1 - loss * b.direction.dot(column.segment<2>(j) - column.segment<2>(i));
  if (pivot < loose) return -1;
  const double opening = elongation(bond);
  displacement_ += column * (loss * opening / pivot);
  for (std::size_t k = 0; k < compliance_.size(); ++k) {
    const Bond& other = body_.bonds[static_cast<std::size_t>(bonds_[k])];
    const double along =
        other.direction.dot(column.segment<2>(2 * local(other.second)) - column.segment<2>(2 * local(other.first)));
    compliance_[static_cast<std::size_t>(k)] += loss / pivot * along * along;
  }
  changes_.col(pending_++) = column * std::sqrt(loss / pivot);
  if (pending_ == most_pending) fold();
  stiffness_[static_cast<std::size_t>(bond)] -= loss;
  return loss * opening * opening / pivot / 2;
}

double Window::flexibility(int bond, int other) const {
  const Bond &a = body_.bonds[static_cast<std::size_t>(bond)], &b = body_.bonds[static_cast<std::size_t>(other)];
  const int i = 2 * local(a.first), j = 2 * local(a.second), k = 2 * local(b.first), l = 2 * local(b.second);
  const Eigen::Matrix2d block = flexibility_.block<2, 2>(j, l) - flexibility_.block<2, 2>(j, k) -
                                flexibility_.block<2, 2>(i, l) + flexibility_.block<2, 2>(i, k);
  return a.direction.dot(block * b.direction);
}

void Window::keep_compliances() {
  compliance_.clear();
  for (const int bond : bonds_) compliance_.push_back(flexibility(bond, bond));
}

double Window::release_of(int bond) const {
  const double left =
      1 - stiffness(bond) * compliance_[static_cast<std::size_t>(place_[static_cast<std::size_t>(bond)])];
  const double opening = elongation(bond);
  return left < loose ? 0 : stiffness(bond) * opening * opening / left / 2;
}

double Window::release_of(const std::vector<int>& bonds) const {
  const long n = static_cast<long>(bonds.size());
  Eigen::MatrixXd along(pending_, n), matrix(n, n);
  Eigen::VectorXd force(n);
  for (long k = 0; k < n; ++k) {
    const Bond& b = body_.bonds[static_cast<std::size_t>(bonds[static_cast<std::size_t>(k)])];
    const int i = 2 * local(b.first), j = 2 * local(b.second);
    along.col(k) = (changes_.block(j, 0, 2, pending_) - changes_.block(i, 0, 2, pending_)).transpose() * b.direction;
    force[k] = elongation(bonds[static_cast<std::size_t>(k)]);
  }
  matrix.noalias() = -along.transpose() * along;
  for (long k = 0; k < n; ++k)
    for (long l = 0; l < n; ++l)
      matrix(k, l) -= flexibility(bonds[static_cast<std::size_t>(k)], bonds[static_cast<std::size_t>(l)]);
  for (long k = 0; k < n; ++k) matrix(k, k) += 1 / stiffness(bonds[static_cast<std::size_t>(k)]);
  const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
  return factor.info() == Eigen::Success ? force.dot(factor.solve(force)) / 2 : 1e300;
}

namespace {

// Displacements of all points at load factor one.
std::vector<Point> solved(const Body& body) {
  const System system = assemble(body);
  const auto factor = bempd::linalg::make_sparse_cholesky();
  if (!factor->factorize(system.matrix)) throw std::runtime_error("the body is loose");
  Eigen::MatrixXd free = system.load;
  factor->solve_in_place(free);
  std::vector<Point> moved = body.given;
  for (std::size_t k = 0; k < moved.size(); ++k)
    if (system.unknown[k] >= 0) moved[k] = free.col(0).segment<2>(2 * system.unknown[k]);
  return moved;
}

double energy_of(const Bond& bond, const std::vector<Point>& moved) {
  const double opening =
      bond.direction.dot(moved[static_cast<std::size_t>(bond.second)] - moved[static_cast<std::size_t>(bond.first)]);
  return bond.stiffness * opening * opening / 2;
}

}  // namespace

double elastic_energy(const Body& body, const std::vector<char>& out) {
  Body left = body;
  for (std::size_t k = 0; k < out.size(); ++k)
    if (out[k]) left.bonds[k].stiffness = 0;
  const std::vector<Point> moved = solved(left);
  double energy = 0;
  for (const Bond& bond : left.bonds) energy += energy_of(bond, moved);
  return energy;
}

double strip_release(Layout layout, double half_height, double growth) {
  layout.cracked = false;
  const Body body = strip(layout, half_height, growth);
  const std::vector<Point> moved = solved(body);
  double energy = 0;
  for (const Bond& bond : body.bonds) {
    const double middle = (body.points[static_cast<std::size_t>(bond.first)].x() +
                           body.points[static_cast<std::size_t>(bond.second)].x()) /
                          2;
    if (middle > 0 && middle < growth) energy += energy_of(bond, moved);
  }
  return energy / growth;
}

}  // namespace directions
