#include "linalg/supernodal_cholesky.hpp"

#include <algorithm>
#include <vector>

#include "cancellation.hpp"
#include "linalg/dense_parts.hpp"
#include "linalg/expected_time.hpp"
#include "phase.hpp"

extern "C" void dpotrf_(const char* triangle, const int* size, double* matrix, const int* stride, int* info);

namespace bempd::linalg {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Panel = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

constexpr int none = -1;

// Lower triangle of the matrix in the order of elimination, in compressed columns.
struct Ordered {
  std::vector<int> begin, row;
  std::vector<double> value;

  template <class Index>
  Ordered(const SparseMatrix& lower, const Index* order) : begin(static_cast<std::size_t>(lower.cols()) + 1, 0) {
    const auto n = static_cast<int>(lower.cols());
    std::vector<int> position(static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k) position[static_cast<std::size_t>(order[k])] = k;
    const auto for_each_entry = [&](const auto& visit) {
      for (int j = 0; j < n; ++j) {
        for (SparseMatrix::InnerIterator it(lower, j); it; ++it) {
          const auto [column, below] = std::minmax(position[it.row()], position[j]);
          visit(column, below, it.value());
        }
      }
    };
    for_each_entry([&](int column, int, double) { ++begin[column + 1]; });
    for (int k = 0; k < n; ++k) begin[k + 1] += begin[k];
    row.resize(static_cast<std::size_t>(begin[n]));
    value.resize(row.size());
    std::vector<int> next(begin.begin(), begin.end() - 1);
    for_each_entry([&](int column, int below, double entry) {
      row[next[column]] = below;
      value[next[column]++] = entry;
    });
  }
};

template <class Index>
class Factorization {
 public:
  Factorization(const SparseMatrix& lower, cholmod_factor& factor)
      : matrix_(lower, static_cast<const Index*>(factor.Perm)),
        first_column_(static_cast<const Index*>(factor.super)),
        rows_begin_(static_cast<const Index*>(factor.pi)),
        values_begin_(static_cast<const Index*>(factor.px)),
        row_(static_cast<const Index*>(factor.s)),
        values_(static_cast<double*>(factor.x)),
        count_(static_cast<int>(factor.nsuper)),
        supernode_of_(factor.n),
        place_(factor.n),
        done_(factor.nsuper, 0),
        head_(factor.nsuper, none),
        next_(factor.nsuper, none),
        product_(factor.maxcsize),
        target_(factor.maxesize) {
    for (int s = 0; s < count_; ++s)
      std::fill(supernode_of_.begin() + first_column_[s], supernode_of_.begin() + first_column_[s + 1], s);
  }

  bool run() {
    const double work = operations(count_);
    const Phase phase("sparse factorization", work, expected_time_of_products(work));
    double done = 0;
    for (int s = 0; s < count_; ++s) {
      check_cancelled();
      phase.reach(done);
      done += operations_of(s);
      assemble(s);
      for (int d = head_[s]; d != none;) {
        const int following = next_[d];
        subtract(s, d);
        d = following;
      }
      if (!eliminate(s)) return false;
      done_[s] = columns(s);
      queue_at_ancestor(s);
    }
    return true;
  }

 private:
  int columns(int s) const { return static_cast<int>(first_column_[s + 1] - first_column_[s]); }
  int rows(int s) const { return static_cast<int>(rows_begin_[s + 1] - rows_begin_[s]); }
  double* panel(int s) { return values_ + values_begin_[s]; }

  // Work of a supernode (its own elimination and its contributions to later supernodes), in proportion to its
  // floating-point operations.
  double operations_of(int s) const { return static_cast<double>(columns(s)) * rows(s) * rows(s); }
  double operations(int count) const {
    double sum = 0;
    for (int s = 0; s < count; ++s) sum += operations_of(s);
    return sum;
  }

  void assemble(int s) {
    const int height = rows(s), first = static_cast<int>(first_column_[s]), end = first + columns(s);
    for (int r = 0; r < height; ++r) place_[row_[rows_begin_[s] + r]] = r;
    double* column = panel(s);
    std::fill(column, column + static_cast<std::ptrdiff_t>(height) * columns(s), 0.0);
    for (int k = first; k < end; ++k, column += height) {
      for (int p = matrix_.begin[k]; p < matrix_.begin[k + 1]; ++p) column[place_[matrix_.row[p]]] += matrix_.value[p];
    }
  }

  // Subtracts the part of supernode s that the elimination of an earlier supernode d contributes.
  void subtract(int s, int d) {
    check_cancelled();
    const Index* const own_rows = row_ + rows_begin_[d];
    const int height = rows(d), from = done_[d];
    int to = from;
    while (to < height && own_rows[to] < first_column_[s + 1]) ++to;
    const int wide = to - from, high = height - from;
    multiply(panel(d) + from, height, columns(d), wide, high);
    for (int r = 0; r < high; ++r) target_[r] = place_[own_rows[from + r]];
    double* const into = panel(s);
    const auto stride = static_cast<std::ptrdiff_t>(rows(s));
    for (int j = 0; j < wide; ++j) {
      double* const column = into + target_[j] * stride;
      const double* const product = product_.data() + static_cast<std::ptrdiff_t>(j) * high;
      for (int r = j; r < high; ++r) column[target_[r]] -= product[r];
    }
    done_[d] = to;
    queue_at_ancestor(d);
  }

  // Computes the first `wide` columns of A A^T, where A consists of `high` rows of a panel with `inner` columns.
  void multiply(const double* a, int stride, int inner, int wide, int high) {
    const double work = 2.0 * inner * wide * high;
    const int at_once =
        is_long(work) ? std::max(16, static_cast<int>(operations_at_once / (2.0 * inner * high))) : wide;
    constexpr double one = 1, zero = 0;
    for (int j = 0; j < wide; j += at_once) {
      const int columns = std::min(at_once, wide - j), below = high - j - columns;
      double* const c = product_.data() + j + static_cast<std::ptrdiff_t>(j) * high;
      if (j > 0) check_cancelled();
      dsyrk_("L", "N", &columns, &inner, &one, a + j, &stride, &zero, c, &high);
      if (below > 0)
        dgemm_("N", "C", &below, &columns, &inner, &one, a + j + columns, &stride, a + j, &stride, &zero, c + columns,
               &high);
    }
  }

  bool eliminate(int s) {
    const int wide = columns(s), high = rows(s), below = high - wide;
    double* const values = panel(s);
    if (is_long(static_cast<double>(wide) * wide * (wide / 3.0 + below))) {
      Panel top(values, wide, wide, Eigen::OuterStride<>(high));
      Panel bottom(values + wide, below, wide, Eigen::OuterStride<>(high));
      if (!factorize_in_parts(top)) return false;
      solve_upper_from_right(top, bottom);
      return true;
    }
    int info = 0;
    dpotrf_("L", &wide, values, &high, &info);
    if (info != 0) return false;
    constexpr double one = 1;
    if (below > 0) dtrsm_("R", "L", "C", "N", &below, &wide, &one, values, &high, values + wide, &high);
    return true;
  }

  // Adds supernode d to the list of the next supernode that it contributes to, which contains the next row of d.
  void queue_at_ancestor(int d) {
    if (done_[d] >= rows(d)) return;
    const int ancestor = supernode_of_[row_[rows_begin_[d] + done_[d]]];
    next_[d] = head_[ancestor];
    head_[ancestor] = d;
  }

  Ordered matrix_;
  const Index *first_column_, *rows_begin_, *values_begin_, *row_;
  double* values_;
  int count_;
  std::vector<int> supernode_of_;  // supernode of each column
  std::vector<int> place_;         // place of each row in the present supernode
  std::vector<int> done_;          // number of rows of each supernode that are finished
  std::vector<int> head_, next_;   // linked list of the supernodes that update a supernode
  std::vector<double> product_;
  std::vector<int> target_;
};

}  // namespace

template <class Index>
bool factorize_supernodes(const SparseMatrix& lower, cholmod_factor& factor) {
  return Factorization<Index>(lower, factor).run();
}

template bool factorize_supernodes<int>(const SparseMatrix&, cholmod_factor&);
template bool factorize_supernodes<SuiteSparse_long>(const SparseMatrix&, cholmod_factor&);

}  // namespace bempd::linalg
