#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "coupling/condensation.hpp"
#include "fracture/window/window_terms.hpp"

namespace bempd::fracture {

// Flexibility F (displacements per force) of the whole body, on the degrees of freedom that a window (region around
// crack tips or bonds close to breaking that is solved alone) follows. Rows below F belong to functions of the
// displacements, which are treated like displacements on which no force acts. Changes of rank one are collected and
// added many at a time: F is the stored matrix plus, for each pending column c, its sign times c c^T.
class Flexibility {
 public:
  Flexibility(const coupling::Condensation& condensation, Eigen::Index functions);

  Eigen::Index size() const { return size_; }  // number of followed degrees of freedom
  // Sets the weights with which the functions depend on the followed degrees of freedom, one column for each function.
  void set_functions(const Eigen::MatrixXd& weights);

  // Responses F b to unit tensions in some terms, whose elongations are the linear forms b: one column for each term.
  Eigen::MatrixXd responses(std::span<const Pull> pulls) const;
  // Displacement of the followed degrees of freedom due to a force on them.
  Eigen::VectorXd answer(const Eigen::VectorXd& force) const;
  // Brings a response up to date that contains only the first `changes_known` pending changes: adds the effect of the
  // others.
  void update_response(const Pull& pull, Eigen::Index changes_known, Eigen::Ref<Eigen::VectorXd> response) const;

  Eigen::Index changes() const { return pending_count_; }
  void make_room(Eigen::Index count);  // makes room for changes that can be taken back
  // Adds a change of rank one to F: the column times its transpose, multiplied by `sign` (1 or -1).
  void add_change(const Eigen::Ref<const Eigen::VectorXd>& column, double sign) {
    signs_[pending_count_] = sign;
    pending_.col(pending_count_++) = column;
  }
  void take_back_changes(Eigen::Index count) { pending_count_ = count; }  // keeps the first `count` changes

  Eigen::MatrixXd function_rows() const { return matrix_.bottomRows(functions_); }
  void set_function_rows(const Eigen::MatrixXd& rows) { matrix_.bottomRows(functions_) = rows; }
  void subtract_from_function(Eigen::Index function, const Eigen::Ref<const Eigen::VectorXd>& values);

  // Block of F: displacements of the followed degrees of freedom `rows` due to unit forces on `columns`.
  Eigen::MatrixXd block(const std::vector<int>& rows, const std::vector<int>& columns) const;
  void keep(const std::vector<int>& followed);

 private:
  void flush();
  void add(const Eigen::Ref<const Eigen::MatrixXd>& columns, double sign);

  Eigen::Index size_, functions_;
  Eigen::MatrixXd matrix_;  // lower triangle of F, and the rows of functions below it
  Eigen::MatrixXd pending_;
  Eigen::VectorXd signs_;  // signs of the pending columns
  Eigen::Index pending_count_ = 0;
};

}  // namespace bempd::fracture
