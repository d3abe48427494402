#pragma once

#include <optional>
#include <vector>

#include "coupling/factor_origin.hpp"
#include "coupling/matrix_change.hpp"
#include "coupling/substructures.hpp"
#include "coupling/system_factor.hpp"
#include "coupling/system_matrix.hpp"
#include "coupling/system_parts.hpp"
#include "geometry/point.hpp"

namespace bempd::coupling {

// Factor of a system's matrix, with a record of how it was made, so that another run can make a factor with the same
// digits. Nothing is factorized before make().
class RepeatableFactor {
 public:
  RepeatableFactor(SystemParts& parts, const SystemMatrix& matrix)
      : parts_(parts), matrix_(matrix), factor_(parts.method, parts.unknowns, parts.counters) {}

  // Sets the positions of the nodes, from which a symmetric system derives an order of elimination with less fill.
  void place_nodes(const std::vector<Point>& positions);
  // Copies the substructures of the factor `before`, so that unchanged substructures need not be eliminated again.
  void take_over(const RepeatableFactor& before) { substructures_.take_over(before.substructures_); }

  // Makes the next factorization eliminate the unknowns of these nodes last, and drops the present factor.
  void keep_last(std::vector<int> nodes);
  bool keeps_last(const std::vector<int>& nodes) const { return factor_.kept_nodes() == nodes; }
  void forget();
  void release() { factor_.release(); }  // frees its memory

  // Record of how the factor was made; empty if there is no factor.
  std::optional<FactorOrigin> origin() const;
  void set_origin(FactorOrigin origin);  // the factor is made from this record when it is first needed

  bool exists();
  // Whether the factor belongs to the present matrix, because it was made from this matrix or changed along with it.
  bool is_current();
  // Whether the factor was made from the present matrix (not changed since), with the unknowns of these nodes last.
  bool keeps(const std::vector<int>& nodes);
  // Whether all pivots are so large that no motion can have lost its resistance. The factor must be current.
  bool pivots_are_sound() const { return factor_.pivots_are_sound(); }

  // Makes the factor if there is none. Throws Error (unsolvable).
  void make();
  // Makes a Cholesky factor of the whole matrix if there is none. The system must be symmetric.
  const linalg::SparseCholesky& make_cholesky();
  int kept() const { return factor_.kept(); }  // number of unknowns that are eliminated last
  // Changes the factor, if there is one, along with the matrix.
  void change(const MatrixChange& change);
  // Solves for the unknowns with the present matrix, by a factor that exists already. Throws Error (unsolvable).
  Eigen::VectorXd solve(const Eigen::VectorXd& rhs);

 private:
  void repeat();
  void change(const MatrixChange::Columns& columns, linalg::Change change);
  const SystemMatrix::Matrix& matrix_to_factorize();
  FactorSource present_source() const;
  bool factorize_by_substructures(const Constraints& constraints, const std::vector<HoldingSpring>& springs);

  SystemParts& parts_;
  const SystemMatrix& matrix_;
  SystemFactor factor_;
  FactorSource source_;
  Substructures substructures_;
};

}  // namespace bempd::coupling
