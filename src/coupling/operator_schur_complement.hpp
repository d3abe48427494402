#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/operators.hpp"
#include "coupling/schur_complement.hpp"

namespace bempd::coupling {

// Dense operator whose private unknowns are eliminated once, so that only the unknowns that it shares with others enter
// the sparse system.
class OperatorSchurComplement {
 public:
  // `kind` tells for each global degree of freedom what it is. The Schur complement is taken over from one of those
  // built before if it is the same. Throws Error (unsolvable) if the private part is singular.
  OperatorSchurComplement(const DenseOperator& source, const std::vector<DofKind>& kind,
                          const std::vector<OperatorSchurComplement>& built);

  const std::vector<int>& shared_dofs() const { return shared_; }
  const Eigen::MatrixXd& schur_complement() const { return pressing_.empty() ? schur_->matrix() : schur_of_closed_; }
  // Whether the operator is on these nodes, in this order.
  bool is_on(const std::vector<int>& nodes) const;
  const Affine& rest() const { return rest_; }
  void exchange_rest(Affine& other) noexcept { rest_.swap(other); }  // condense_load() has to follow
  bool has_factorized() const { return has_factorized_; }            // itself, not one before
  double reciprocal_condition() const { return schur_->reciprocal_condition(); }

  // Condenses loads: adds the effect of private forces and of prescribed displacements on the shared unknowns to `load`
  // (global), and keeps the private part for recover().
  void condense_load(const Affine& force, const Affine& prescribed, Affine& load);

  // Computes private displacements from the shared ones.
  void recover(Affine& displacement) const;

  // Moves the weights of a function of displacements from the private ones to the shared ones, and to the constants
  // that the present loads contribute.
  void condense_function(Eigen::VectorXd& weights, Eigen::RowVector2d& constant) const;

  // Adds stiffness * (displacement - rest) to the force, on all of the operator's nodes.
  void add_internal_force(const Eigen::VectorXd& displacement, double load_factor, Eigen::VectorXd& force) const;

  // Strain energy, half the work of these forces on (displacement - rest); then its derivative by the load factor
  // alone, and the energy of the proportional parts.
  double energy(const Eigen::VectorXd& displacement, double load_factor) const;
  double energy_slope(const Eigen::VectorXd& displacement, double load_factor) const;
  double unit_energy(const Eigen::VectorXd& proportional) const;

  // --- Faces of cracks inside that are closed (operator_faces.cpp); all are open at first.

  std::size_t face_count() const { return openings_ ? static_cast<std::size_t>(openings_->of_forces.rows()) : 0; }
  // Sets the gaps that loads inside the body cause; condense_load() has to follow, as it has to after close_faces().
  void set_face_offsets(const Eigen::Ref<const Affine>& offsets) { face_offsets_ = offsets; }
  void close_faces(const std::vector<char>& closed);
  // Gaps of open places. A closed place has the overlap that it would have without its contact force, negative while
  // its faces press.
  Affine face_gaps(const Affine& displacement) const;
  // Gaps that displacements and loads cause without contact forces; and the contact forces [N].
  Eigen::VectorXd open_gaps(const Eigen::VectorXd& displacement, double load_factor) const;
  Eigen::VectorXd face_forces(const Eigen::VectorXd& displacement, double load_factor) const;
  // Work that loads inside the body do on the displacements due to contact forces.
  double work_at_closed_faces(const Eigen::VectorXd& displacement, double load_factor) const;
  // Adds the gap of a place as a function of displacements, 2 * node + component; the gap of an open place is this and
  // its offset.
  void add_gap_function(std::size_t place, Eigen::Ref<Eigen::VectorXd> weights) const;
  const Affine& face_offsets() const { return face_offsets_; }

 private:
  void find_free_faces();
  void reduce_faces();
  void find_gaps_at_rest(const Affine& support);
  Affine pressing_forces(const Affine& displacement) const;
  // Gaps, without contact forces, of closed places that have openings of their own.
  Eigen::VectorXd shut_gaps(const Eigen::VectorXd& displacement, double load_factor) const;

  Eigen::VectorXd elastic(const Eigen::VectorXd& displacement, double load_factor) const;  // displacement - rest

  std::shared_ptr<const SchurComplement> schur_;
  Affine rest_;  // of all its degrees of freedom, or empty
  bool has_factorized_ = false;
  std::vector<int> all_, private_, shared_;  // global degrees of freedom
  Affine private_load_;                      // private displacements with the shared unknowns held at 0

  std::shared_ptr<const FaceOpenings> openings_;
  Affine face_offsets_;                        // of all places
  std::vector<char> free_faces_;               // faces that private displacements or their own openings can close
  std::vector<Eigen::Index> pressing_, shut_;  // closed places; those of them that have openings of their own
  // Private displacements and gaps per contact force, and gaps per shared displacement; computed when first needed.
  Eigen::MatrixXd private_by_faces_, gaps_by_faces_, gaps_by_shared_;
  Eigen::LDLT<Eigen::MatrixXd> held_, held_shut_;  // of the closed places: with everything private, with openings alone
  Eigen::MatrixXd schur_of_closed_;
  Affine gaps_at_rest_;  // with the shared unknowns held at 0 and nothing that presses
};

}  // namespace bempd::coupling
