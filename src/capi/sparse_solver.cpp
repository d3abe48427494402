#include <stdexcept>
#include <string>

#include "capi/guard.hpp"
#include "linalg/external_solver.hpp"
#include "no_memory.hpp"

using namespace bempd;
using namespace bempd::capi;

namespace {

// Sparse solver that calls the function of a host.
class HostSolver final : public linalg::ExternalSolver {
 public:
  HostSolver(bempd_sparse_function function, void* user) : function_(function), user_(user) {}
  ~HostSolver() override { end(); }
  HostSolver(const HostSolver&) = delete;
  HostSolver& operator=(const HostSolver&) = delete;

  void analyse(std::int64_t factor, const Matrix& lower, const Plan& plan) override {
    bempd_sparse_task task = task_for(BEMPD_SPARSE_ANALYSE, factor);
    add_pattern(lower, plan.kept, task);
    task.order = plan.order.empty() ? nullptr : plan.order.data();
    task.scratch = plan.scratch.c_str();
    run(task);
  }

  bool factorize(std::int64_t factor, const Matrix& lower, int kept, Outcome& outcome) override {
    bempd_sparse_task task = task_for(BEMPD_SPARSE_FACTORIZE, factor);
    add_pattern(lower, kept, task);
    task.values = lower.valuePtr();
    outcome.schur.resize(kept, kept);
    task.schur = outcome.schur.data();
    if (ask(task) == BEMPD_ERROR_UNSOLVABLE) return false;
    outcome.smallest_pivot = task.smallest_pivot;
    outcome.entries = task.entries;
    return true;
  }

  void solve(std::int64_t factor, Eigen::MatrixXd& values) override {
    bempd_sparse_task task = task_for(BEMPD_SPARSE_SOLVE, factor);
    add_vectors(values, task);
    run(task);
  }

  void reduce(std::int64_t factor, Eigen::MatrixXd& values, Eigen::MatrixXd& kept) override {
    bempd_sparse_task task = task_for(BEMPD_SPARSE_REDUCE, factor);
    add_vectors(values, task);
    task.kept_count = static_cast<std::int32_t>(kept.rows());
    task.kept = kept.data();
    run(task);
  }

  void expand(std::int64_t factor, const Eigen::MatrixXd& kept, Eigen::MatrixXd& values) override {
    Eigen::MatrixXd given = kept;
    bempd_sparse_task task = task_for(BEMPD_SPARSE_EXPAND, factor);
    add_vectors(values, task);
    task.kept_count = static_cast<std::int32_t>(given.rows());
    task.kept = given.data();
    run(task);
  }

  void forget(std::int64_t factor) noexcept override {
    bempd_sparse_task task = task_for(BEMPD_SPARSE_FORGET, factor);
    if (function_) function_(&task, user_);
  }

  void end() noexcept override {
    bempd_sparse_task task = task_for(BEMPD_SPARSE_DETACH, 0);
    if (function_) function_(&task, user_);
    function_ = nullptr;
  }

 private:
  static bempd_sparse_task task_for(bempd_sparse_request request, std::int64_t factor) {
    bempd_sparse_task task{};
    task.struct_size = sizeof task;
    task.request = request;
    task.factor = factor;
    return task;
  }

  static void add_pattern(const Matrix& lower, int kept, bempd_sparse_task& task) {
    task.unknowns = lower.cols();
    task.kept_count = kept;
    task.column_start = lower.outerIndexPtr();
    task.rows = lower.innerIndexPtr();
  }

  static void add_vectors(Eigen::MatrixXd& values, bempd_sparse_task& task) {
    task.unknowns = values.rows();
    task.sides = values.cols();
    task.vectors = values.data();
  }

  // Sends a request to the host's solver. Returns its status if the request succeeded or met a matrix that is not
  // positive definite; else throws Error.
  bempd_status ask(bempd_sparse_task& task) {
    if (!function_) fail(Failure::order, "the solver of this factor was taken away");
    const std::int32_t status = function_(&task, user_);
    const std::string sentence = task.message ? task.message : "the attached solver gives no reason";
    switch (status) {
      case BEMPD_OK:
      case BEMPD_ERROR_UNSOLVABLE:
        return static_cast<bempd_status>(status);
      case BEMPD_ERROR_MEMORY:
        throw NoMemory(
            "not enough memory for the attached solver; use more processes, the option linalg.scratch, or a coarser "
            "lattice");
      case BEMPD_ERROR_IO:
        fail(Failure::io, sentence);
      case BEMPD_ERROR_ORDER:
        fail(Failure::order, sentence);
      case BEMPD_ERROR_CANCELLED:
        fail(Failure::cancelled, sentence);
      default:
        throw std::runtime_error(sentence);
    }
  }

  void run(bempd_sparse_task& task) {
    if (ask(task) != BEMPD_OK) throw std::runtime_error("the attached solver has lost its factor");
  }

  bempd_sparse_function function_;
  void* user_;
};

}  // namespace

bempd_status bempd_set_sparse_solver(bempd_model* model, bempd_sparse_function function, void* user) {
  return with_model(model, __func__, [&](model::Model& m) {
    m.solver().attach(function ? std::make_shared<HostSolver>(function, user) : nullptr);
  });
}
