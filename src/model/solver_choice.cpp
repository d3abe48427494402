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

linalg::SolverChoice Model::solver_choice() const {
  return {external_solver_, options_.text_value("linalg.scratch"), options_.text_value("test.indices") == "wide"};
}

void Model::set_external_solver(std::shared_ptr<linalg::ExternalSolver> solver) {
  if (solver && prepared_)
    fail(Failure::order, "the model is prepared already; attach a solver before the first step or result");
  if (solver && external_solver_)
    fail(Failure::order, "the model has an attached solver already; detach that one first");
  if (prepared_ && external_solver_) {
    prepared_->evolution->synchronize();
    prepared_->system->release_solver();
  }
  if (external_solver_) external_solver_->end();
  external_solver_ = std::move(solver);
}

}  // namespace bempd::model
