#pragma once

#include <vector>

#include "bem/interior.hpp"
#include "regions/boundary/interior_of_pieces.hpp"
#include "regions/boundary/particular_solutions.hpp"

namespace bempd::regions {

// State of a boundary element region in a solution: displacements, tractions, and openings of cracks, from which values
// inside the region follow. Free swelling and the particular solution of the body force are subtracted from them.
class BoundaryStates {
 public:
  BoundaryStates(const Region& region, const NumberedMesh& mesh, const BoundaryParts& parts,
                 const BoundaryOperators& operators, const BoundarySwelling& swelling,
                 const ParticularSolutions& particulars)
      : region_(region),
        mesh_(mesh),
        parts_(parts),
        operators_(operators),
        swelling_(swelling),
        particulars_(particulars) {}

  // State (openings and tractions) of each part with cracks in a solution.
  std::vector<bem::CrackedState> of_cracked_parts(const Solution& solution) const;
  // State of each part with cracks for displacements of the scene's nodes. `constant` and `proportional` are factors of
  // the constant and of the proportional part of loads and swelling.
  std::vector<bem::CrackedState> of_cracked_parts(const Eigen::VectorXd& displacement, const Solution& solution,
                                                  double constant, double proportional) const;
  // Tractions at the traction nodes of the boundary, without those of the particular solution.
  Eigen::VectorXd tractions(const LinearBodyForce& particular, const Solution& solution) const;
  // Stress (xx, yy, xy) at the three nodes of each element of the boundary, without that of the particular solution.
  std::vector<double> element_stress(const LinearBodyForce& particular, const Solution& solution) const;
  // Evaluator of the region's interior, which has one evaluator for each piece into which cracks or cuts divide the
  // region.
  InteriorOfPieces inside(const LinearBodyForce& particular, const Solution& solution) const;

 private:
  // Displacements at NumberedMesh::places() without those of free swelling.
  Eigen::VectorXd elastic(const Eigen::VectorXd& displacement, double constant, double proportional) const;
  // Displacements at NumberedMesh::places() without those of free swelling and of the particular solution.
  Eigen::VectorXd displacement(const LinearBodyForce& particular, const Solution& solution) const;
  bem::InteriorEvaluator inside_of_one_piece(const LinearBodyForce& particular, const Solution& solution) const;

  const Region& region_;
  const NumberedMesh& mesh_;
  const BoundaryParts& parts_;
  const BoundaryOperators& operators_;
  const BoundarySwelling& swelling_;
  const ParticularSolutions& particulars_;
};

}  // namespace bempd::regions
