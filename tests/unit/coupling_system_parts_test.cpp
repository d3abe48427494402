// Parts of EquilibriumSystem, each without the others that it does not name.
#include <gtest/gtest.h>

#include "coupling_chain.hpp"

using namespace bempd::coupling;
using bempd::test::Chain;

namespace {

Eigen::VectorXd some_vector(Eigen::Index size) {
  return Eigen::VectorXd::NullaryExpr(size, [](Eigen::Index i) { return std::sin(2.0 + static_cast<double>(i * i)); });
}

std::unique_ptr<SystemParts> parts_of(const Chain& chain) {
  return std::make_unique<SystemParts>(Chain::nodes, std::vector<DenseOperator>{chain.op}, chain.bonds,
                                       chain.prescribed, NodeTies());
}

}  // namespace

TEST(TermStages, breaks_followers_once_and_counts_leaders_only) {
  Chain chain;
  const int leaders[] = {0, 1};
  chain.bonds.add_follower(4, leaders);
  TermStages stages(chain.bonds);
  const int broken[] = {0, 1};
  const std::vector<StageChange> changes = stages.breaking(broken);
  EXPECT_EQ(terms_of(changes), (std::vector{0, 1, 4}));
  EXPECT_EQ(stages.count_broken(changes), 2);
  stages.mark(changes);
  EXPECT_FALSE(stages.intact()[4]);
  EXPECT_EQ(stages.stiffness()[4], 1.5) << "until its stiffness is taken out, too";
  stages.enter(changes);
  EXPECT_EQ(stages.stiffness()[4], 0);
  EXPECT_EQ(terms_of(stages.breaking({broken, 1})), std::vector{0}) << "the follower is broken already";
  stages.enter_all(std::vector<std::uint8_t>(chain.bonds.size(), 0));
  EXPECT_EQ(stages.stiffness(), chain.bonds.stiffness);
  EXPECT_TRUE(stages.intact()[4]);
}

TEST(ElasticResponse, needs_no_factor) {
  Chain chain;
  const auto parts = parts_of(chain);
  const StageChange broken{1, 1};
  parts->stages.enter({&broken, 1});
  parts->condense();
  const ElasticResponse response(*parts);
  const Eigen::VectorXd u = some_vector(2 * Chain::nodes), force = chain.full(parts->stages.intact()) * u;
  EXPECT_LT((response.internal_force(u) - force).lpNorm<Eigen::Infinity>(), 1e-13);
  EXPECT_NEAR(response.energy(u), 0.5 * u.dot(force), 1e-13);
  EXPECT_NEAR(response.unit_energy(u), 0.5 * u.dot(force), 1e-13);
  EXPECT_FALSE(response.has_offsets());
}

TEST(SystemMatrix, multiplies_as_it_is_summed_up) {
  Chain chain;
  const auto parts = parts_of(chain);
  parts->springs.push_back({4, 0.6, 0.8, 7, 0.1});
  parts->constraints.add({{{3, -1, 0}, {4, 1, 0}}, 6});
  parts->constraints.set_closed(0, true);
  parts->condense();
  SystemMatrix matrix(*parts);
  const Eigen::VectorXd x = some_vector(parts->unknowns.count());
  const auto off = [&](const SystemMatrix::Matrix& lower) {
    return (lower.selfadjointView<Eigen::Lower>() * x - matrix.multiply(x)).lpNorm<Eigen::Infinity>();
  };
  EXPECT_LT(off(matrix.assemble()), 1e-13);
  EXPECT_TRUE(matrix.places_met().empty()) << "a bond has the entries of the penalty";
  const Eigen::MatrixXd with(matrix.assemble()), without(matrix.assemble_without_constraints());
  EXPECT_NEAR((with - without).trace(), 12, 1e-13);
  matrix.set_places_met({{2, 3}});
  EXPECT_LT(off(matrix.assemble()), 1e-13);
  EXPECT_EQ(matrix.places_met(), (PlacesMet{{2, 3}}));
}

TEST(RepeatableFactor, is_made_again_with_the_same_digits) {
  Chain chain;
  const auto first = parts_of(chain), second = parts_of(chain);
  const SystemMatrix first_matrix(*first), second_matrix(*second);
  RepeatableFactor factor(*first, first_matrix), again(*second, second_matrix);
  first->condense();
  factor.make();
  const StageChange broken{4, 1};
  MatrixChange change(first->unknowns, first->ties);
  change.add_term(first->terms, broken.term, -first->stages.stiffness()[4]);
  first->stages.enter({&broken, 1});
  factor.change(change);
  const bool follows = factor.is_current();  // with a backend that can update it
  const Eigen::VectorXd rhs = some_vector(first->unknowns.count()), solution = factor.solve(rhs);

  EXPECT_FALSE(again.origin());
  second->stages.enter({&broken, 1});
  again.set_origin(*factor.origin());
  EXPECT_EQ(second->counters.sparse_factorizations, 0) << "until it is needed";
  EXPECT_EQ(again.is_current(), follows);
  EXPECT_EQ(second->counters.sparse_factorizations, 1);
  EXPECT_EQ(second->counters.factor_updates, 1);
  EXPECT_EQ(again.solve(rhs), solution);
  EXPECT_LT((first_matrix.multiply(solution) - rhs).lpNorm<Eigen::Infinity>(), 1e-12);
}
