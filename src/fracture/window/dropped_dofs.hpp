#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/affine.hpp"
#include "fracture/window/linear_forms.hpp"
#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

// Check of the bonds outside a window (region around crack tips or bonds close to breaking that is solved alone): in a
// state of the window, at a load factor, their ratios of stretch to critical stretch must stay below `limit`.
struct OutsideCheck {
  int state;
  double load_factor;
  double limit;

  // Limit of the check, less a margin for rounding, because window and whole body solve different forms of the
  // equations.
  double limit_less_rounding() const { return limit * (1 - WindowSettings::comparison_margin); }
};

// Degrees of freedom (dofs) that a window has dropped: the window no longer follows their displacements from event to
// event, because nothing breaks near them any more. Their displacements are completed afterwards, for many states at
// once.
//
// Let u_0 be the displacements when the dofs were dropped, K and F stiffness and flexibility at that time, and f the
// loads. Terms have lost the stiffnesses k_e since. The displacements u obey K u = f + sum of k_e b_e e_e, where e_e =
// b_e.u is the elongation of such a term. These terms end on followed dofs only, so u = u_0 + F sum of k_e b_e e_e.
class DroppedDofs {
 public:
  // Linear forms of the window's displacements: the weights of degrees of freedom, and the constant that prescribed
  // displacements add to each form (for the constant and the proportional part of the load).
  struct Forms {
    LinearForms of_displacements;
    std::vector<Eigen::RowVector2d> fixed;
  };

  // State of the window before the displacements of dropped degrees of freedom are completed. `narrowings` and `breaks`
  // are the numbers of narrowings, and of losses of stiffness, until this state.
  struct State {
    coupling::Affine displacement;
    std::size_t narrowings, breaks;
  };

  // Drops the degrees of freedom `dropped` for good; the window continues with `followed`. `response` holds the
  // displacements of dropped degrees of freedom (rows) due to unit forces on followed ones (columns). `ratios` are the
  // stretch ratios, as linear forms, of the bonds that end on dropped degrees of freedom.
  void narrow(std::vector<int> dropped, const std::vector<int>& followed, Eigen::MatrixXd response,
              const coupling::Affine& displacement, const Forms& ratios);
  // Notes terms or contact constraints that have lost stiffness, with their elongations as linear forms.
  void note_lost_stiffness(const Forms& elongations, const std::vector<double>& stiffnesses);

  std::size_t narrowings() const { return levels_.size(); }
  std::size_t breaks() const { return lost_.size(); }

  // Displacements of the given states, completed by those of the dropped degrees of freedom.
  std::vector<coupling::Affine> complete(const std::vector<State>& states, bool has_constant_part) const;

  // Replaces forces on dropped degrees of freedom by their effect on the followed ones. The displacements of followed
  // ones due to these forces are then `answer` plus the response to `force`: `answer` gains their part with the
  // stiffness at the drop, and `force` gains forces on followed ones that correct this part for the terms that have
  // lost stiffness since.
  void transfer_forces(coupling::Affine& force, coupling::Affine& answer) const;

  // Index of the first state in which a bond that ends on dropped degrees of freedom fails a check; the number of
  // states if there is none. The states must be completed.
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
