// Contact of crack faces inside a condensed operator.
#include <algorithm>

#include "coupling/operator_schur_complement.hpp"

namespace bempd::coupling {

// Finds the faces that can close or open here. A mouth between nodes that are held or shared with other operators is
// not among them: its gap follows from these nodes.
void OperatorSchurComplement::find_free_faces() {
  const Eigen::MatrixXd &alone = openings_->of_forces, &of_displacements = openings_->of_displacements;
  for (Eigen::Index i = 0; i < alone.rows(); ++i) {
    const bool moves = !private_.empty() && !of_displacements(i, schur_->private_dofs()).isZero(0);
    free_faces_.push_back(alone(i, i) > 0 || moves ? 1 : 0);
  }
}

// Computes how contact forces q at the places act on the private unknowns, and the gaps as functions of the shared
// ones:
//   u_p = p_0 - X u_s + P q,   gaps = g_0 + (G_s - G_p X) u_s + (S + G_p P) q,   P = K_pp^-1 G_p^T.
void OperatorSchurComplement::reduce_faces() {
  if (gaps_by_faces_.size() > 0) return;
  const Eigen::MatrixXd& of_displacements = openings_->of_displacements;
  gaps_by_faces_ = openings_->of_forces;
  gaps_by_shared_ = of_displacements(Eigen::all, schur_->shared_dofs());
  private_by_faces_.resize(static_cast<Eigen::Index>(private_.size()), gaps_by_faces_.rows());
  if (private_.empty()) return;
  const Eigen::MatrixXd of_private = of_displacements(Eigen::all, schur_->private_dofs());
  for (Eigen::Index k = 0; k < of_private.rows(); k += 2) {
    const Eigen::Index count = std::min<Eigen::Index>(2, of_private.rows() - k);
    Affine pull = Affine::Zero(of_private.cols(), 2);
    pull.leftCols(count) = of_private.middleRows(k, count).transpose();
    private_by_faces_.middleCols(k, count) = schur_->solve_private(pull).leftCols(count);
  }
  gaps_by_faces_ += of_private * private_by_faces_;
  if (!shared_.empty()) gaps_by_shared_ -= of_private * schur_->transfer();
}

void OperatorSchurComplement::close_faces(const std::vector<char>& closed) {
  pressing_.clear();
  shut_.clear();
  for (std::size_t i = 0; i < closed.size(); ++i)
    if (closed[i]) pressing_.push_back(static_cast<Eigen::Index>(i));
  if (pressing_.empty()) return;
  reduce_faces();
  const Eigen::MatrixXd& alone = openings_->of_forces;
  for (const Eigen::Index i : pressing_)
    if (alone(i, i) > 0) shut_.push_back(i);
  held_.compute(gaps_by_faces_(pressing_, pressing_));
  held_shut_.compute(alone(shut_, shut_));
  schur_of_closed_ = schur_->matrix();
  if (shared_.empty()) return;
  const Eigen::MatrixXd by_shared = gaps_by_shared_(pressing_, Eigen::all);
  schur_of_closed_ += by_shared.transpose() * held_.solve(by_shared);
}

void OperatorSchurComplement::find_gaps_at_rest(const Affine& support) {
  gaps_at_rest_ = face_offsets_ + openings_->of_displacements * support;
  if (!private_.empty())
    gaps_at_rest_ += openings_->of_displacements(Eigen::all, schur_->private_dofs()) * private_load_;
}

Affine OperatorSchurComplement::pressing_forces(const Affine& displacement) const {
  Affine gaps = gaps_at_rest_(pressing_, Eigen::all);
  if (!shared_.empty()) gaps += gaps_by_shared_(pressing_, Eigen::all) * displacement(shared_, Eigen::all);
  return -held_.solve(gaps);
}

Eigen::VectorXd OperatorSchurComplement::face_forces(const Eigen::VectorXd& displacement, double load_factor) const {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(face_count()));
  if (pressing_.empty()) return forces;
  Eigen::VectorXd gaps = evaluate(gaps_at_rest_, load_factor)(pressing_);
  if (!shared_.empty()) gaps += gaps_by_shared_(pressing_, Eigen::all) * displacement(shared_);
  forces(pressing_) = -held_.solve(gaps);
  return forces;
}

Affine OperatorSchurComplement::face_gaps(const Affine& displacement) const {
  Affine own = displacement(all_, Eigen::all);
  if (rest_.rows() > 0) own -= rest_;
  Affine gaps = face_offsets_ + openings_->of_displacements * own;
  for (std::size_t i = 0; i < free_faces_.size(); ++i)
    if (!free_faces_[i]) gaps.row(static_cast<Eigen::Index>(i)).setZero();
  if (pressing_.empty()) return gaps;
  const Affine forces = pressing_forces(displacement);
  gaps += openings_->of_forces(Eigen::all, pressing_) * forces;
  for (std::size_t k = 0; k < pressing_.size(); ++k)
    gaps.row(pressing_[k]) = -gaps_by_faces_(pressing_[k], pressing_[k]) * forces.row(static_cast<Eigen::Index>(k));
  return gaps;
}

Eigen::VectorXd OperatorSchurComplement::open_gaps(const Eigen::VectorXd& displacement, double load_factor) const {
  return evaluate(face_offsets_, load_factor) + openings_->of_displacements * elastic(displacement, load_factor);
}

Eigen::VectorXd OperatorSchurComplement::shut_gaps(const Eigen::VectorXd& displacement, double load_factor) const {
  return open_gaps(displacement, load_factor)(shut_);
}

double OperatorSchurComplement::work_at_closed_faces(const Eigen::VectorXd& displacement, double load_factor) const {
  if (shut_.empty()) return 0;
  return -evaluate(face_offsets_, load_factor)(shut_).dot(held_shut_.solve(shut_gaps(displacement, load_factor)));
}

void OperatorSchurComplement::add_gap_function(std::size_t place, Eigen::Ref<Eigen::VectorXd> weights) const {
  const auto row = openings_->of_displacements.row(static_cast<Eigen::Index>(place));
  for (std::size_t i = 0; i < all_.size(); ++i) weights[all_[i]] += row[static_cast<Eigen::Index>(i)];
}

}  // namespace bempd::coupling
