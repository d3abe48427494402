// Solver of the sparse systems of a model.
#include <utility>

#include "error.hpp"
#include "model/model.hpp"

namespace bempd::model {

namespace {

const scene::OptionGroup solver_group(scene::OptionPlace::general, [] {
  return std::vector<scene::OptionDescription>{scene::any_text_option(
      "linalg.scratch",
      "Folder for the sparse factor, which then needs little memory: a solver that bempd_mpi_attach() has attached "
      "works out of core there. Empty: in memory.")};
});

const scene::OptionGroup solver_hooks(scene::OptionPlace::test_hooks, [] {
  return std::vector<scene::OptionDescription>{
      scene::text_option("test.indices", "Indices of the sparse factor: of 64 bits where 32 are not enough, or always.",
                         "chosen | wide", "chosen")};
});

}  // namespace

linalg::SolverChoice AttachedSolver::choice() const {
  const scene::Options& options = model_.options();
  return {solver_, options.text_value("linalg.scratch"), options.text_value("test.indices") == "wide"};
}

void AttachedSolver::attach(std::shared_ptr<linalg::ExternalSolver> solver) {
  const PreparedScene* const prepared = model_.prepared_or_null();
  if (solver && prepared)
    fail(Failure::order, "the model is prepared already; attach a solver before the first step or result");
  if (solver && solver_) fail(Failure::order, "the model has an attached solver already; detach that one first");
  if (prepared && solver_) {
    prepared->evolution->synchronize();
    prepared->system->factor().release();
  }
  if (solver_) solver_->end();
  solver_ = std::move(solver);
}

}  // namespace bempd::model
