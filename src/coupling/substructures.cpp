#include "coupling/substructures.hpp"

#include <cmath>
#include <utility>

#include "coupling/stiffness_assembly.hpp"
#include "coupling/substructure_factor.hpp"
#include "linalg/conjugate_gradient.hpp"
#include "linalg/external_solver.hpp"
#include "phase.hpp"

namespace bempd::coupling {

namespace {

constexpr std::size_t fewest_operators = 8;
constexpr int most_iterations = 40;

// List of the parts of a matrix (condensed operators and holding springs), each placed by the positions of its nodes.
class PartList {
 public:
  PartList(const Unknowns& unknowns, const std::vector<Point>& positions)
      : unknowns_(unknowns), positions_(positions) {}

  void add(const OperatorSchurComplement& op) {
    if (op.shared_dofs().empty()) return;
    const bool is_open = op.active().empty();
    MatrixPart part{op.schur(), is_open ? nullptr : op.constraints(), op.active(), {}, &op.schur_complement(), {},
                    {},         op.constraints() != nullptr};
    Point least = place_of(op.shared_dofs().front()), most = least;
    for (const int dof : op.shared_dofs()) {
      part.unknowns.push_back(unknowns_.unknown_of[dof]);
      least = least.cwiseMin(place_of(dof)), most = most.cwiseMax(place_of(dof));
    }
    part.centre = 0.5 * (least + most);
    parts_.push_back(std::move(part));
  }

  void add(const HoldingSpring& s, const NodeTies& ties) {
    std::vector<UnknownEntry> pull;
    append_pull(unknowns_.unknown_of, ties, s.node, s.cosine, s.sine, std::sqrt(s.stiffness), pull);
    if (pull.empty()) return;
    MatrixPart part{nullptr, nullptr, {}, {}, nullptr, {}, place_of(2 * s.node), true};
    Eigen::VectorXd weights(static_cast<Eigen::Index>(pull.size()));
    for (std::size_t k = 0; k < pull.size(); ++k) {
      weights[static_cast<Eigen::Index>(k)] = pull[k].weight;
      part.unknowns.push_back(pull[k].unknown);
    }
    part.own = weights * weights.transpose();
    parts_.push_back(std::move(part));
  }

  std::vector<MatrixPart> take() { return std::move(parts_); }

 private:
  const Point& place_of(int dof) const { return positions_[static_cast<std::size_t>(dof / 2)]; }

  const Unknowns& unknowns_;
  const std::vector<Point>& positions_;
  std::vector<MatrixPart> parts_;
};

// Solver that uses a factor by substructures.
class SubstructureSolver final : public SystemSolver {
 public:
  explicit SubstructureSolver(std::shared_ptr<SubstructureFactor> factor) : factor_(std::move(factor)) {}

  linalg::SparseFactorization& factorization() override { return *factor_; }

  linalg::KrylovResult iterate(const Apply& apply, const Eigen::VectorXd& rhs, double tolerance,
                               Eigen::VectorXd& x) const override {
    const auto precondition = [this](Eigen::VectorXd& r) { factor_->solve_in_place(r); };
    return linalg::conjugate_gradient(apply, precondition, rhs, x, {tolerance, most_iterations});
  }

  Eigen::VectorXd multiply(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& x) const override {
    return matrix.selfadjointView<Eigen::Lower>() * x;
  }

 private:
  std::shared_ptr<SubstructureFactor> factor_;
};

}  // namespace

bool Substructures::disable() {
  is_disabled_ = true;
  return std::exchange(has_served_, false);
}

bool Substructures::suits(const MatrixSources& sources) const {
  const linalg::SolverChoice* const choice = linalg::SolverScope::current();
  const bool is_own = !choice || (!choice->external && choice->scratch.empty());
  return is_own && !is_disabled_ && !positions_.empty() && sources.operators.list().size() >= fewest_operators &&
         sources.terms.size() == 0 && sources.ties.empty() &&
         sources.constraints.size() == sources.constraints.exact_count();
}

std::unique_ptr<SystemSolver> Substructures::solver_of(const MatrixSources& sources, const Unknowns& unknowns) {
  if (!suits(sources)) return nullptr;
  const Phase phase("sparse factorization");
  PartList parts(unknowns, positions_);
  for (const OperatorSchurComplement& op : sources.operators.list()) parts.add(op);
  for (const HoldingSpring& spring : sources.springs) parts.add(spring, sources.ties);
  std::array<Point, 2> box = {positions_.front(), positions_.front()};
  for (const Point& p : positions_) box = {box[0].cwiseMin(p), box[1].cwiseMax(p)};
  std::shared_ptr<SubstructureFactor> made = SubstructureFactor::of(parts.take(), box, unknowns.count(), last_.get());
  if (!made) return nullptr;
  last_ = made;
  has_served_ = true;
  return std::make_unique<SubstructureSolver>(std::move(made));
}

}  // namespace bempd::coupling
