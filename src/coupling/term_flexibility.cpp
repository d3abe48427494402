#include "coupling/term_flexibility.hpp"

#include <algorithm>
#include <vector>

#include "error.hpp"
#include "linalg/sparse_cholesky.hpp"

namespace bempd::coupling {

namespace {

// Elongations of terms per displacement of the unknowns that they act on: `weights` has one row for each of the
// unknowns, in ascending order, and one column per term.
struct Pulls {
  std::vector<int> unknowns;
  Eigen::MatrixXd weights;
};

Pulls pulls_of(const EquilibriumSystem& system, std::span<const int> terms) {
  const std::vector<int>& unknown_of = system.unknowns().unknown_of;
  std::vector<std::vector<UnknownEntry>> entries(terms.size());
  Pulls pulls;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    system.terms().for_each_entry(static_cast<std::size_t>(terms[k]), [&](int node, double x, double y) {
      append_pull(unknown_of, system.ties(), node, x, y, 1, entries[k]);
    });
    for (const UnknownEntry& e : entries[k]) pulls.unknowns.push_back(e.unknown);
  }
  std::sort(pulls.unknowns.begin(), pulls.unknowns.end());
  pulls.unknowns.erase(std::unique(pulls.unknowns.begin(), pulls.unknowns.end()), pulls.unknowns.end());
  pulls.weights =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(pulls.unknowns.size()), static_cast<Eigen::Index>(terms.size()));
  for (std::size_t k = 0; k < terms.size(); ++k)
    for (const UnknownEntry& e : entries[k]) {
      const auto at = std::lower_bound(pulls.unknowns.begin(), pulls.unknowns.end(), e.unknown);
      pulls.weights(at - pulls.unknowns.begin(), static_cast<Eigen::Index>(k)) += e.weight;
    }
  return pulls;
}

Eigen::MatrixXd between(const Pulls& pulls, const linalg::SparseCholesky& cholesky) {
  const Eigen::MatrixXd block = cholesky.inverse_block(pulls.unknowns);
  return pulls.weights.transpose() * (block * pulls.weights);
}

}  // namespace

Eigen::MatrixXd flexibility_of(EquilibriumSystem& system, std::span<const int> terms) {
  if (!system.factor().is_current()) system.factor().forget();
  return between(pulls_of(system, terms), system.factorized().cholesky);
}

Eigen::MatrixXd flexibility_by_temporary_factor(const EquilibriumSystem& system, std::span<const int> terms) {
  const std::unique_ptr<linalg::SparseCholesky> cholesky = linalg::make_sparse_cholesky();
  if (!cholesky->factorize(system.matrix().assemble())) fail(Failure::unsolvable, "a part of the body can move freely");
  return between(pulls_of(system, terms), *cholesky);
}

}  // namespace bempd::coupling
