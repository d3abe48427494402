// Processor seconds of one sparse Cholesky factorization: the library's own, which can be cancelled between its parts,
// and that of CHOLMOD with the same order of elimination. The matrices are those of square lattices with bonds of up to
// three spacings.
//   bempd_factorization POINTS...   points along a side; prints a line of CSV for each
#include <cholmod.h>

#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <vector>

#include "linalg/sparse_cholesky.hpp"

namespace {

using Matrix = Eigen::SparseMatrix<double>;

double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Least time of three calls.
template <class Call>
double seconds_of(const Call& call) {
  double least = 0;
  for (int round = 0; round < 3; ++round) {
    const double start = processor_time();
    if (!call()) std::exit(1);
    const double seconds = processor_time() - start;
    least = round == 0 ? seconds : std::min(least, seconds);
  }
  return least;
}

// Lower triangle of the stiffness of a lattice whose lowest row is held by springs.
Matrix lattice_stiffness(int points) {
  constexpr int reach = 3;
  std::vector<Eigen::Triplet<double>> entries;
  const auto unknown = [points](int i, int j) { return 2 * (i * points + j); };
  for (int i = 0; i < points; ++i) {
    for (int j = 0; j < points; ++j) {
      const int own = unknown(i, j);
      for (int part = 0; part < 2; ++part) entries.emplace_back(own + part, own + part, i == 0 ? 1.0 : 0.0);
      for (int a = -reach; a <= reach; ++a) {
        for (int b = -reach; b <= reach; ++b) {
          const int row = i + a, column = j + b, square = a * a + b * b;
          if (square == 0 || square > reach * reach || std::min(row, column) < 0 || std::max(row, column) >= points)
            continue;
          const std::array<double, 2> along = {a / std::sqrt(square), b / std::sqrt(square)};
          const int other = unknown(row, column);
          for (int p = 0; p < 2; ++p) {
            for (int q = 0; q < 2; ++q) {
              if (p >= q) entries.emplace_back(own + p, own + q, along[p] * along[q]);
              if (own > other) entries.emplace_back(own + p, other + q, -along[p] * along[q]);
            }
          }
        }
      }
    }
  }
  Matrix lower(2 * points * points, 2 * points * points);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

// Time of CHOLMOD's factorization with the order that was used before.
double seconds_of_cholmod(Matrix& lower, std::vector<int> order) {
  cholmod_common common;
  cholmod_start(&common);
  common.supernodal = CHOLMOD_SUPERNODAL;
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_GIVEN;
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(lower.rows());
  view.nzmax = static_cast<std::size_t>(lower.nonZeros());
  view.p = lower.outerIndexPtr();
  view.i = lower.innerIndexPtr();
  view.x = lower.valuePtr();
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = view.packed = 1;
  cholmod_factor* factor = cholmod_analyze_p(&view, order.data(), nullptr, 0, &common);
  const double seconds = seconds_of([&] { return cholmod_factorize(&view, factor, &common) != 0; });
  cholmod_free_factor(&factor, &common);
  cholmod_finish(&common);
  return seconds;
}

}  // namespace

int main(int count, char** words) {
  std::puts("unknowns,entries of the factor,own seconds,CHOLMOD seconds,CHOLMOD over own");
  for (int w = 1; w < count; ++w) {
    Matrix lower = lattice_stiffness(std::atoi(words[w]));
    const std::unique_ptr<bempd::linalg::SparseCholesky> own = bempd::linalg::own_cholesky(false);
    if (!own->factorize(lower)) return 1;  // the analysis, which both have alike
    const double ours = seconds_of([&] { return own->factorize(lower); });
    const double theirs = seconds_of_cholmod(lower, own->elimination_order());
    std::printf("%d,%lld,%.3g,%.3g,%.2f\n", static_cast<int>(lower.rows()),
                static_cast<long long>(own->factor_nonzeros()), ours, theirs, theirs / ours);
    std::fflush(stdout);
  }
}
