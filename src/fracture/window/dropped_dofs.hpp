#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/affine.hpp"
#include "fracture/window/linear_forms.hpp"
#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

// Check of the bonds outside a window (region around crack tips or bonds close to breaking that is solved alone): at a
// load factor in a state of the window, their ratios of stretch to critical stretch must stay below `limit`.
struct OutsideCheck {
  int state;
  double load_factor;
  double limit;

  // Limit less a margin for rounding, because window and whole body solve different forms of the equations.
  double limit_less_rounding() const { return limit * (1 - WindowSettings::comparison_margin); }
};

// Degrees of freedom (dofs) that a window has dropped: the window no longer follows their displacements from event to
// event, because nothing breaks near them any more. Their displacements are completed afterwards, for many states at
// once.
//
// Let K and F be stiffness and flexibility, and u_0 the displacements, when the dofs were dropped. Terms have lost the
// stiffnesses k_e since. The displacements obey K u = f + sum of k_e b_e e_e, where b_e is the form and e_e the
// elongation of such a term. These terms end on followed dofs only, so u = u_0 + F sum of k_e b_e e_e.
class DroppedDofs {
 public:
  // Linear forms of the window's displacements: the weights of degrees of freedom, and the constant that prescribed
  // displacements add to each form (for both parts of the load).
  struct Forms {
    LinearForms of_displacements;
    std::vector<Eigen::RowVector2d> fixed;
  };

  // State of the window before the dropped degrees of freedom are completed in it. `narrowings` and `breaks` are the
  // numbers of narrowings and of losses of stiffness until this state.
  struct State {
    coupling::Affine displacement;
    std::size_t narrowings, breaks;
  };

  // Drops the degrees of freedom `dropped` for good; the window continues with `followed`. `response` holds the
  // displacements of the dropped ones (rows) due to unit forces on the followed ones (columns), `ratios` the stretch
  // ratios of the bonds that end on dropped ones.
  void narrow(std::vector<int> dropped, const std::vector<int>& followed, Eigen::MatrixXd response,
              const coupling::Affine& displacement, const Forms& ratios);
  // Notes terms or constraints that have lost stiffness, by the forms of their elongations.
  void note_lost_stiffness(const Forms& elongations, const std::vector<double>& stiffnesses);

  std::size_t narrowings() const { return levels_.size(); }
  std::size_t breaks() const { return lost_.size(); }

  // Displacements of the given states, completed by those of the dropped degrees of freedom.
  std::vector<coupling::Affine> complete(const std::vector<State>& states, bool has_constant_part) const;

  // Replaces forces on dropped degrees of freedom by their effect on the followed ones. `answer` gains the
  // displacements of followed ones that these forces cause with the stiffness at the time of dropping. `force` gains
  // forces on followed ones that correct this for terms broken since. The displacements of followed ones are `answer`
  // plus the response to `force`.
  void transfer_forces(coupling::Affine& force, coupling::Affine& answer) const;

  // Index of the first state with a failed check of a bond on dropped degrees of freedom; the number of states if there
  // is none. The states must be completed.
  int first_violation(const std::vector<coupling::Affine>& states, const std::vector<OutsideCheck>& checks) const;

 private:
  struct Level {
    std::vector<int> dropped, column_of;  // column_of[dof]: column of a followed dof in `response`
    Eigen::MatrixXd response;
    coupling::Affine start;
    std::size_t breaks_before;
  };
  std::vector<Level> levels_;
  Forms broken_;              // elongations of terms that have lost stiffness
  std::vector<double> lost_;  // stiffness that each of these terms has lost
  Forms ratios_;
};

}  // namespace bempd::fracture
