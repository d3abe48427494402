#pragma once

#include <memory>

#include "linalg/external_solver.hpp"

namespace bempd::model {

class Model;

// Solver of the sparse systems in calls of a model: the library's own solver, or a solver of the host.
class AttachedSolver {
 public:
  explicit AttachedSolver(Model& model) : model_(model) {}

  linalg::SolverChoice choice() const;
  // Attaches a solver; throws Error (order) once the model is prepared. Null detaches the present solver, with all that
  // it has factorized.
  void attach(std::shared_ptr<linalg::ExternalSolver> solver);

 private:
  Model& model_;
  std::shared_ptr<linalg::ExternalSolver> solver_;
};

}  // namespace bempd::model
