#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/affine.hpp"
#include "fracture/window/linear_forms.hpp"
#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

// Check of bonds outside a window: in this state and at this load factor none of them may reach `limit`, the ratio of
// stretch to critical stretch.
struct OutsideCheck {
  int state;
  double load_factor;
  double limit;

  // Limit less a margin for rounding, because the window and the whole body solve different forms of the equations.
  double limit_less_rounding() const { return limit * (1 - WindowSettings::comparison_margin); }
};

// Degrees of freedom (dofs) that a window has dropped: it no longer follows their displacements from event to event,
// because nothing breaks there any more. They are completed afterwards, for many states at once.
//
// Let K and F be stiffness and flexibility at the time they were dropped. Terms have lost the stiffnesses k_e since.
// The displacements obey K u = f + sum of k_e b_e e_e, where b_e is the form and e_e the elongation of such a term.
// These terms end on followed dofs only, so u = u_then + F sum of k_e b_e e_e.
class DroppedDofs {
 public:
  // Linear forms of the window's displacements: their weights of degrees of freedom, and the constant that prescribed
  // displacements add to each (for both parts of the load).
  struct Forms {
    LinearForms of_displacements;
    std::vector<Eigen::RowVector2d> fixed;
  };

  // State of the window before the dropped degrees of freedom are completed in it. `narrowings` and `breaks` are the
  // numbers of those until this state.
  struct State {
    coupling::Affine displacement;
    std::size_t narrowings, breaks;  // until then
  };

  // Drops the degrees of freedom `left` for good; the window continues with `followed`. `response` holds the
  // displacements of the left ones (rows) due to unit forces on the followed ones (columns), `ratios` the stretch
  // ratios of the bonds that end on left ones.
  void narrow(std::vector<int> dropped, const std::vector<int>& followed, Eigen::MatrixXd response,
              const coupling::Affine& displacement, const Forms& ratios);
  void note_lost_stiffness(const Forms& elongations, const std::vector<double>& stiffnesses);

  std::size_t narrowings() const { return levels_.size(); }
  std::size_t breaks() const { return lost_.size(); }

  // Displacements of the given states, completed by the dropped degrees of freedom.
  std::vector<coupling::Affine> complete(const std::vector<State>& states, bool has_constant_part) const;

  // Replaces forces on dropped degrees of freedom by their effect on the followed ones. `answer` gains the followed
  // displacements that they cause with the stiffness at the time of dropping. `force` gains, on followed ones, the
  // forces that correct this for terms broken since. The followed displacements are then `answer` plus the response to
  // `force` on followed degrees of freedom.
  void transfer_forces(coupling::Affine& force, coupling::Affine& answer) const;

  // Index of the first state with a failed check of a bond on dropped degrees of freedom; the number of states if there
  // is none. The states must be completed.
  int first_violation(const std::vector<coupling::Affine>& states, const std::vector<OutsideCheck>& checks) const;

 private:
  struct Level {
    std::vector<int> dropped, column_of;  // column_of[dof]: in `response`
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
