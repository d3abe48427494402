#include "fracture/window/flexibility.hpp"

#include <algorithm>

#include "fracture/window/window_settings.hpp"
#include "linalg/dense_inverse.hpp"

namespace bempd::fracture {

namespace {

// Product of a symmetric matrix, given by its lower triangle, with a vector. The routine dsymv is not used, because
// OpenBLAS 0.3.21 reads past the matrix in its version for Prescott processors.
Eigen::VectorXd product_with_symmetric(const Eigen::Ref<const Eigen::MatrixXd>& lower, const Eigen::VectorXd& x) {
  Eigen::VectorXd y = lower.diagonal().cwiseProduct(x);
  for (Eigen::Index j = 0; j + 1 < x.size(); ++j) {
    const Eigen::Index below = x.size() - j - 1;
    const auto column = lower.col(j).tail(below);
    y.tail(below) += x[j] * column;
    y[j] += column.dot(x.tail(below));
  }
  return y;
}

}  // namespace

Flexibility::Flexibility(const coupling::Condensation& condensation, Eigen::Index functions)
    : size_(condensation.factor().rows()), functions_(functions) {
  matrix_.resize(size_ + functions_, size_);
  matrix_.topRows(size_) = condensation.factor();
  linalg::invert_from_cholesky(matrix_.topRows(size_));
  pending_.resize(size_ + functions_, WindowSettings::most_pending_changes);
  signs_.resize(pending_.cols());
}

void Flexibility::set_functions(const Eigen::MatrixXd& weights) {
  const Eigen::MatrixXd answers = matrix_.topRows(size_).selfadjointView<Eigen::Lower>() * weights;
  matrix_.bottomRows(functions_) = answers.transpose();
}

Eigen::MatrixXd Flexibility::responses(std::span<const Pull> pulls) const {
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(matrix_.rows(), static_cast<Eigen::Index>(pulls.size()));
  Eigen::MatrixXd along = Eigen::MatrixXd::Zero(pending_count_, w.cols());
  for (Eigen::Index c = 0; c < w.cols(); ++c) {
    const Pull& pull = pulls[static_cast<std::size_t>(c)];
    for (std::size_t k = 0; k < pull.size(); ++k) {
      const Eigen::Index d = pull.place[k];
      if (d >= size_ || pull.weight[k] == 0) continue;
      w.col(c).head(d) += pull.weight[k] * matrix_.row(d).head(d).transpose();
      w.col(c).tail(w.rows() - d) += pull.weight[k] * matrix_.col(d).tail(w.rows() - d);
      along.col(c) += pull.weight[k] * pending_.row(d).head(pending_count_).transpose();
    }
  }
  along.array().colwise() *= signs_.head(pending_count_).array();
  w.noalias() += pending_.leftCols(pending_count_) * along;
  return w;
}

Eigen::VectorXd Flexibility::answer(const Eigen::VectorXd& force) const {
  if (size_ == 0) return force;
  Eigen::VectorXd u = product_with_symmetric(matrix_.topRows(size_), force);
  if (pending_count_ == 0) return u;
  const auto columns = pending_.leftCols(pending_count_).topRows(size_);
  Eigen::VectorXd along = columns.transpose() * force;
  along.array() *= signs_.head(pending_count_).array();
  u.noalias() += columns * along;
  return u;
}

void Flexibility::update_response(const Pull& pull, Eigen::Index changes_known,
                                  Eigen::Ref<Eigen::VectorXd> response) const {
  for (Eigen::Index c = changes_known; c < pending_count_; ++c) {
    double along = 0;
    for (std::size_t i = 0; i < pull.size(); ++i) {
      if (pull.place[i] < size_) along += pull.weight[i] * pending_(pull.place[i], c);
    }
    response += signs_[c] * along * pending_.col(c);
  }
}

void Flexibility::make_room(Eigen::Index count) {
  if (pending_count_ + count > WindowSettings::most_pending_changes) flush();
  if (count <= pending_.cols()) return;
  pending_.conservativeResize(Eigen::NoChange, count);
  signs_.conservativeResize(count);
}

void Flexibility::flush() {
  if (size_ == 0 || pending_count_ == 0) return;
  const auto signs = signs_.head(pending_count_).array();
  if ((signs > 0).all()) {
    add(pending_.leftCols(pending_count_), 1);
  } else {
    std::vector<Eigen::Index> gained, lost;
    for (Eigen::Index c = 0; c < pending_count_; ++c) (signs_[c] > 0 ? gained : lost).push_back(c);
    add(pending_(Eigen::all, gained), 1);
    add(pending_(Eigen::all, lost), -1);
  }
  pending_count_ = 0;
}

void Flexibility::add(const Eigen::Ref<const Eigen::MatrixXd>& columns, double sign) {
  if (columns.cols() == 0) return;  // Eigen divides by the number of columns
  matrix_.topRows(size_).selfadjointView<Eigen::Lower>().rankUpdate(columns.topRows(size_), sign);
  matrix_.bottomRows(functions_).noalias() +=
      sign * columns.bottomRows(functions_) * columns.topRows(size_).transpose();
}

void Flexibility::subtract_from_function(Eigen::Index function, const Eigen::Ref<const Eigen::VectorXd>& values) {
  matrix_.row(size_ + function) -= values.transpose();
}

Eigen::MatrixXd Flexibility::block(const std::vector<int>& rows, const std::vector<int>& columns) const {
  const Eigen::MatrixXd from = pending_.leftCols(pending_count_)(rows, Eigen::all);
  const Eigen::MatrixXd to = pending_.leftCols(pending_count_)(columns, Eigen::all);
  Eigen::MatrixXd result = from * signs_.head(pending_count_).asDiagonal() * to.transpose();
  for (std::size_t c = 0; c < columns.size(); ++c) {
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const auto [column, row] = std::minmax(columns[c], rows[r]);
      result(r, c) += matrix_(row, column);
    }
  }
  return result;
}

void Flexibility::keep(const std::vector<int>& followed) {
  std::vector<int> rows = followed;
  for (Eigen::Index r = size_; r < matrix_.rows(); ++r) rows.push_back(static_cast<int>(r));
  size_ = static_cast<Eigen::Index>(followed.size());
  pending_ = Eigen::MatrixXd(pending_(rows, Eigen::all));
  Eigen::MatrixXd smaller(size_ + functions_, size_);
  for (Eigen::Index c = 0; c < size_; ++c) {
    for (Eigen::Index r = c; r < smaller.rows(); ++r) smaller(r, c) = matrix_(rows[r], followed[c]);
  }
  matrix_.swap(smaller);
}

}  // namespace bempd::fracture
