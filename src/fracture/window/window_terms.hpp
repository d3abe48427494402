#pragma once

#include <vector>

#include "coupling/condensation.hpp"
#include "fracture/critical_events.hpp"
#include "fracture/window/linear_forms.hpp"

namespace bempd::fracture {

// The elongation of a term as a linear form of the rows of a window.
using Pull = LinearForms::Form;

// The terms of the energy that a window watches, with their ratios to critical values.
class WindowTerms {
 public:
  // All intact terms between kept degrees of freedom and prescribed ones. A row of a kept degree of
  // freedom is its place in the condensation; prescribed ones have rows from `first_prescribed` on.
  WindowTerms(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
              const StretchRatios& ratios, int first_prescribed);

  // Prescribed degrees of freedom at ends of terms, in the order of their rows.
  const std::vector<int>& prescribed_dofs() const { return prescribed_dofs_; }
  // Whether a term was there from the beginning, by its number in the system.
  bool contained(int number) const { return contained_[number] != 0; }

  std::size_t size() const { return numbers_.size(); }
  const std::vector<int>& numbers() const { return numbers_; }  // in the system, ascending
  const std::vector<char>& intact() const { return intact_; }
  const AffineRatios& ratios() const { return ratios_; }
  Pull pull(std::size_t term) const { return pulls_[term]; }
  double stiffness(std::size_t term) const { return stiffness_[term]; }
  double ratio_per_elongation(std::size_t term) const { return scales_.per_elongation[term]; }

  // Whether all that its ratio depends on is watched; otherwise the ratio is too large rather than too small.
  bool ratio_is_known(std::size_t term) const { return across_.empty() || across_.is_known(term); }

  // The place of a term of the system in this list; -1: it is not watched.
  int place_of(int number) const;

  // Terms are named by their places in the list, also in `change`.
  void enter(const coupling::StageChange& change);
  int stage(std::size_t term) const { return stages_[term]; }
  double stiffness_after(const coupling::StageChange& change) const;
  void update_ratios(const coupling::Affine& rows, bool has_constant_part);

  // Goes on with these terms only.
  void keep(const std::vector<char>& watched);
  void renumber_rows(const std::vector<int>& row_after);

 private:
  void add(int number, const coupling::EquilibriumSystem& system);
  void relieve();

  const StretchRatios& of_all_;
  std::vector<int> numbers_;
  LinearForms pulls_;
  std::vector<double> stiffness_;
  std::vector<std::uint8_t> stages_;
  coupling::CriticalScales scales_;
  std::vector<char> intact_;
  AffineRatios ratios_;
  BondsAcross across_;
  std::vector<char> contained_;
  std::vector<int> prescribed_dofs_;
};

}  // namespace bempd::fracture
