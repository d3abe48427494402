#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/constraints.hpp"
#include "fracture/window/dropped_dofs.hpp"
#include "fracture/window/window_terms.hpp"

namespace bempd::fracture {

// Values that a window follows, as affine functions of the load factor, each in a row: displacements, then functions of
// them, then prescribed displacements at the ends of bonds. A pull names rows.
class WindowRows {
 public:
  // All kept degrees of freedom are followed at first. Values of functions are 0 until they are set.
  WindowRows(const std::vector<int>& kept_dofs, Eigen::Index functions, const std::vector<int>& prescribed_dofs,
             const coupling::Affine& displacement);

  Eigen::Index size() const { return static_cast<Eigen::Index>(followed_.size()); }  // of displacements
  const std::vector<int>& followed() const { return followed_; }                // which of the kept ones, ascending
  int row_of(int dof) const { return row_of_[static_cast<std::size_t>(dof)]; }  // -1: it is not followed
  bool is_prescribed(int row) const { return row >= size(); }
  bool is_supported(const Pull& pull) const;
  coupling::Affine& values() { return values_; }
  const coupling::Affine& values() const { return values_; }
  auto displacements() const { return values_.topRows(size()); }
  auto functions() const { return values_.middleRows(size(), functions_); }

  Eigen::RowVector2d elongation(const Pull& pull) const;
  double elongation(const Pull& pull, double load_factor) const;
  // Whether all points of a contact constraint are followed, and its gap; also for other displacements of the kept
  // degrees of freedom.
  bool follows(const coupling::Constraint& constraint) const;
  double gap(const coupling::Constraint& constraint, double load_factor) const;
  double gap(const coupling::Constraint& constraint, double load_factor, const coupling::Affine& kept) const;
  double largest_displacement(double load_factor) const;
  // Adds the scaled elongation of a pull as a form of kept displacements.
  void add_form(const Pull& pull, double scale, DroppedDofs::Forms& forms) const;

  // Follows only the displacements in the rows `kept_rows`. Returns the new place of every row; -1 where it has gone.
  std::vector<int> keep(const std::vector<int>& kept_rows);

 private:
  void number_rows();

  const std::vector<int>& kept_dofs_;
  Eigen::Index functions_;  // count
  std::vector<int> followed_, row_of_;
  coupling::Affine values_;
};

}  // namespace bempd::fracture
