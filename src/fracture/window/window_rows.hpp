#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/constraints.hpp"
#include "fracture/window/dropped_dofs.hpp"
#include "fracture/window/window_terms.hpp"

namespace bempd::fracture {

// Values that a window (region around crack tips or bonds close to breaking that is solved alone) follows, as affine
// functions of the load factor, each in a row: displacements, then functions of the displacements, then prescribed
// displacements at the ends of bonds. The places of a Pull (elongation as a linear form) are numbers of rows.
class WindowRows {
 public:
  // Rows of a new window, which follows all degrees of freedom of its nodes (`kept_dofs`). Values of functions are 0
  // until they are set.
  WindowRows(const std::vector<int>& kept_dofs, Eigen::Index functions, const std::vector<int>& prescribed_dofs,
             const coupling::Affine& displacement);

  Eigen::Index size() const { return static_cast<Eigen::Index>(followed_.size()); }  // number of followed displacements
  const std::vector<int>& followed() const { return followed_; }  // places among the kept degrees of freedom, ascending
  // -1 if the window does not follow the degree of freedom.
  int row_of(int dof) const { return row_of_[static_cast<std::size_t>(dof)]; }
  bool is_prescribed(int row) const { return row >= size(); }
  bool is_supported(const Pull& pull) const;
  coupling::Affine& values() { return values_; }
  const coupling::Affine& values() const { return values_; }
  auto displacements() const { return values_.topRows(size()); }
  auto functions() const { return values_.middleRows(size(), functions_); }

  Eigen::RowVector2d elongation(const Pull& pull) const;
  double elongation(const Pull& pull, double load_factor) const;
  // Whether the window follows all points of a contact constraint.
  bool follows(const coupling::Constraint& constraint) const;
  // Gap of a contact constraint whose points the window follows.
  double gap(const coupling::Constraint& constraint, double load_factor) const;
  // Gap of a contact constraint, whose points the window must follow, for other displacements `kept` of the window's
  // degrees of freedom.
  double gap(const coupling::Constraint& constraint, double load_factor, const coupling::Affine& kept) const;
  double largest_displacement(double load_factor) const;
  // Adds the elongation of a pull, times `scale`, to a list of linear forms of the window's displacements.
  void add_form(const Pull& pull, double scale, DroppedDofs::Forms& forms) const;

  // Continues with the displacements in the rows `kept_rows` only. Returns the new row number of every old row; -1 for
  // rows that are gone.
  std::vector<int> keep(const std::vector<int>& kept_rows);

 private:
  void number_rows();

  const std::vector<int>& kept_dofs_;
  Eigen::Index functions_;  // number of functions
  std::vector<int> followed_, row_of_;
  coupling::Affine values_;
};

}  // namespace bempd::fracture
