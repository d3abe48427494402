#include "linalg/profile_cholesky.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "cancellation.hpp"

namespace bempd::linalg {

using Eigen::Index;
using Eigen::MatrixXd;

ProfileCholesky::ProfileCholesky(const std::vector<int>& first_coupled)
    : size_(group * static_cast<int>(first_coupled.size())) {
  for (std::size_t from = 0; from < first_coupled.size(); from += groups) {
    const auto end = first_coupled.begin() + static_cast<Index>(std::min(from + groups, first_coupled.size()));
    first_.push_back(
        static_cast<std::size_t>(*std::min_element(first_coupled.begin() + static_cast<Index>(from), end)) / groups);
    panels_.emplace_back(rows, static_cast<Index>(first_.size() - first_.back()) * rows);
  }
  clear();
}

void ProfileCholesky::clear() {
  for (MatrixXd& panel : panels_) panel.setZero();
  // Rows of the last panel beyond the last unknown get a unit diagonal.
  for (Index i = size_ - static_cast<Index>(panels_.size() - 1) * rows; !panels_.empty() && i < rows; ++i)
    panels_.back()(i, panels_.back().cols() - rows + i) = 1;
}

Eigen::Block<MatrixXd, ProfileCholesky::group, ProfileCholesky::group> ProfileCholesky::at(int row, int column) {
  const auto panel = static_cast<std::size_t>(row / groups);
  const Index from = static_cast<Index>(first_[panel]) * rows;
  return panels_[panel].block<group, group>(row % groups * group, column * group - from);
}

double ProfileCholesky::largest_diagonal() const {
  double largest = 0;
  for (std::size_t p = 0; p < panels_.size(); ++p)
    largest = std::max(largest, panels_[p].rightCols<rows>().diagonal().maxCoeff());
  return largest;
}

bool ProfileCholesky::factorize(double shift) {
  for (std::size_t i = 0; i < panels_.size(); ++i) {
    if (i % 64 == 0) check_cancelled();
    MatrixXd& own = panels_[i];
    own.rightCols<rows>().diagonal().array() += shift;
    for (std::size_t j = first_[i]; j <= i; ++j) {
      const std::size_t from = std::max(first_[i], first_[j]);
      const Index shared = static_cast<Index>(j - from) * rows;
      auto target = own.middleCols<rows>(column_of(i, j));
      if (shared > 0)
        target.noalias() -=
            own.middleCols(column_of(i, from), shared) * panels_[j].middleCols(column_of(j, from), shared).transpose();
      if (j == i) {
        Eigen::LLT<Eigen::Ref<MatrixXd>> diagonal(target);
        if (diagonal.info() != Eigen::Success) return false;
      } else {
        panels_[j].rightCols<rows>().triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(target);
      }
    }
  }
  return true;
}

void ProfileCholesky::solve_in_place(Eigen::Ref<Eigen::VectorXd> x) const {
  Eigen::VectorXd padded = Eigen::VectorXd::Zero(static_cast<Index>(panels_.size()) * rows);
  padded.head(size_) = x;
  for (std::size_t i = 0; i < panels_.size(); ++i) {
    const Index at = static_cast<Index>(i) * rows, from = static_cast<Index>(first_[i]) * rows;
    if (at > from)
      padded.segment<rows>(at).noalias() -= panels_[i].leftCols(at - from) * padded.segment(from, at - from);
    panels_[i].rightCols<rows>().triangularView<Eigen::Lower>().solveInPlace(padded.segment<rows>(at));
  }
  for (std::size_t i = panels_.size(); i-- > 0;) {
    const Index at = static_cast<Index>(i) * rows, from = static_cast<Index>(first_[i]) * rows;
    panels_[i].rightCols<rows>().triangularView<Eigen::Lower>().transpose().solveInPlace(padded.segment<rows>(at));
    if (at > from)
      padded.segment(from, at - from).noalias() -=
          panels_[i].leftCols(at - from).transpose() * padded.segment<rows>(at);
  }
  x = padded.head(size_);
}

std::vector<int> close_order(const std::vector<int>& start, const std::vector<int>& neighbours) {
  const int count = static_cast<int>(start.size()) - 1;
  std::vector<int> order, seen(static_cast<std::size_t>(count), 0);
  order.reserve(static_cast<std::size_t>(count));
  const auto degree = [&](int node) { return start[node + 1] - start[node]; };
  // Appends the part of the graph that is connected to `node`, by breadth-first search, and marks its nodes.
  const auto sweep = [&](int node, int mark) {
    const std::size_t begin = order.size();
    seen[node] = mark;
    order.push_back(node);
    for (std::size_t k = begin; k < order.size(); ++k) {
      const std::size_t known = order.size();
      for (int n = start[order[k]]; n < start[order[k] + 1]; ++n) {
        if (seen[neighbours[n]] >= mark) continue;
        seen[neighbours[n]] = mark;
        order.push_back(neighbours[n]);
      }
      std::sort(order.begin() + static_cast<Index>(known), order.end(),
                [&](int a, int b) { return degree(a) < degree(b) || (degree(a) == degree(b) && a < b); });
    }
    return begin;
  };
  for (int node = 0; node < count; ++node) {
    if (seen[node] != 0) continue;
    const std::size_t begin = sweep(node, 1);
    const int far = order.back();
    order.resize(begin);
    sweep(far, 2);
  }
  return order;
}

}  // namespace bempd::linalg
