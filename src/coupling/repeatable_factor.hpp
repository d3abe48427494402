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

// Factor of a system's matrix, with a record of how it was made, so that another run can make it again with the same
// digits. Nothing is factorized before make().
class RepeatableFactor {
 public:
  RepeatableFactor(SystemParts& parts, const SystemMatrix& matrix)
      : parts_(parts), matrix_(matrix), factor_(parts.method, parts.unknowns, parts.counters) {}

  // Sets the positions of the nodes. A symmetric system derives from them an order of elimination with less fill.
  void place_nodes(const std::vector<Point>& positions);
  // Takes over the substructures of the factor `before`, to use those again that are the same.
  void take_over(const RepeatableFactor& before) { substructures_.take_over(before.substructures_); }

  // Makes the next factorization eliminate the unknowns of these nodes last, and drops the present factor.
  void keep_last(std::vector<int> nodes);
  bool keeps_last(const std::vector<int>& nodes) const { return factor_.kept_nodes() == nodes; }
  void forget();
  void release() { factor_.release(); }  // and a forgotten factor, to which nothing refers any more

  // How the factor was made, empty without one; set_origin() has it made so again when it is first needed.
  std::optional<FactorOrigin> origin() const;
  void set_origin(FactorOrigin origin);

  bool exists();
  // Whether the factor belongs to the present matrix: made from it, or changed along with it since.
  bool is_current();
  // Whether the factor is a fresh one of the present matrix, not a changed one, with the unknowns of these nodes last.
  bool keeps(const std::vector<int>& nodes);
  // Whether all pivots are large enough to exclude that a motion has lost its resistance. The factor must be current.
  bool pivots_are_sound() const { return factor_.pivots_are_sound(); }

  // Makes the factor if there is none. Throws Error (unsolvable).
  void make();
  // Makes a Cholesky factor of the whole matrix if there is none. The system must be symmetric.
  const linalg::SparseCholesky& make_cholesky();
  int kept() const { return factor_.kept(); }  // unknowns that the Cholesky factor eliminates last
  // Changes an existing factor.
  void change(const MatrixChange& change);
  // Solves for the unknowns with the present matrix, by a factor that exists. Throws Error (unsolvable).
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
