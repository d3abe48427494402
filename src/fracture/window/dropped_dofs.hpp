#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/affine.hpp"
#include "fracture/window/linear_forms.hpp"
#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

// No bond that a window does not watch may reach `limit` (a stretch over the critical one) at this load factor in this
// state.
struct OutsideCheck {
  int state;
  double load_factor;
  double limit;

  // The limit with a margin for the rounding in which plain and condensed equations differ.
  double bound() const { return limit * (1 - WindowSettings::certificate_margin); }
};

// The displacements that a window no longer follows from event to event because nothing breaks there any more.
//
// Let K and F be stiffness and flexibility when they were left behind. With the stiffnesses k_e that terms have lost
// since, the displacements obey K u = f + sum of k_e b_e e_e, as if what is lost still pulled as the terms' elongations
// e_e ask for; all these terms end on what is still followed. So u = u_then + F sum of k_e b_e e_e, for many states at
// once.
class DroppedDofs {
 public:
  // Linear forms of the window's displacements, by their degrees of freedom, and what prescribed displacements make of
  // each.
  struct Forms {
    LinearForms of_displacements;
    std::vector<Eigen::RowVector2d> fixed;
  };

  // A state of the window, in which what is left behind is not filled in yet.
  struct State {
    coupling::Affine displacement;
    std::size_t narrowings, breaks;  // until then
  };

  // Leaves the degrees of freedom `left` for good and goes on following others; `response` is the displacement of the
  // left (rows) to forces on the followed ones (columns), `ratios` the stretch ratios of the bonds that end on the
  // left.
  void narrow(std::vector<int> left, const std::vector<int>& followed, Eigen::MatrixXd response,
              const coupling::Affine& displacement, const Forms& ratios);
  void note_losses(const Forms& elongations, const std::vector<double>& stiffnesses);

  std::size_t narrowings() const { return levels_.size(); }
  std::size_t breaks() const { return lost_.size(); }

  // The displacements of states, with what was left behind in them.
  std::vector<coupling::Affine> complete(const std::vector<State>& states, bool has_constant_part) const;

  // Adds to the forces on degrees of freedom followed what those left behind hand over: after it the displacements
  // followed answer to `force` on them alone, besides `answer`.
  void hand_over(coupling::Affine& force, coupling::Affine& answer) const;

  // The first state with a check that a bond left behind fails, or the number of states. Of completed states.
  int first_violation(const std::vector<coupling::Affine>& states, const std::vector<OutsideCheck>& checks) const;

 private:
  struct Level {
    std::vector<int> left, column_of;  // column_of[dof]: in `response`
    Eigen::MatrixXd response;
    coupling::Affine start;
    std::size_t breaks_before;
  };
  std::vector<Level> levels_;
  Forms broken_;              // elongations
  std::vector<double> lost_;  // the stiffness of each
  Forms ratios_;
};

}  // namespace bempd::fracture
