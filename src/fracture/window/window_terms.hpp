#pragma once

#include <vector>

#include "coupling/condensation.hpp"
#include "fracture/critical_events.hpp"
#include "fracture/window/linear_forms.hpp"

namespace bempd::fracture {

// Elongation of a term (bond or cell square) as a linear form of the values in the rows of a window.
using Pull = LinearForms::Form;

// Terms (bonds and cell squares) that a window (region around crack tips or bonds close to breaking that is solved
// alone) watches, with their stretch ratios.
class WindowTerms {
 public:
  // Takes all intact terms between degrees of freedom that are in the window or prescribed. The row of a degree of
  // freedom in the window is its position in the condensation; prescribed ones have rows from `first_prescribed` on.
  WindowTerms(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
              const StretchRatios& ratios, int first_prescribed);

  // Prescribed degrees of freedom at ends of terms, in the order of their rows in the window.
  const std::vector<int>& prescribed_dofs() const { return prescribed_dofs_; }
  // Whether a term (given by its number in the system) was in the window from the beginning.
  bool contained(int number) const { return contained_[number] != 0; }

  std::size_t size() const { return numbers_.size(); }
  const std::vector<int>& numbers() const { return numbers_; }  // numbers in the system, ascending
  const std::vector<char>& intact() const { return intact_; }
  const AffineRatios& ratios() const { return ratios_; }
  Pull pull(std::size_t term) const { return pulls_[term]; }
  double stiffness(std::size_t term) const { return stiffness_[term]; }
  double ratio_per_elongation(std::size_t term) const { return scales_.per_elongation[term]; }

  // Whether the window watches all bonds on which the stretch ratio of a term depends; if not, the ratio is an
  // overestimate.
  bool ratio_is_known(std::size_t term) const { return across_.empty() || across_.is_known(term); }

  // Position of a term of the system in the window's list; -1 if the window does not watch the term.
  int place_of(int number) const;

  // Changes the damage stage of a term. Here and in the functions below, a term is called by its position in the list.
  void enter(const coupling::StageChange& change);
  double stiffness_after(const coupling::StageChange& change) const;
  void update_ratios(const coupling::Affine& rows, bool has_constant_part);

  // Keeps only the terms whose flag is set.
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
