#pragma once

#include "fracture/event_sources.hpp"
#include "fracture/inner_work.hpp"
#include "fracture/run_records.hpp"

namespace bempd::fracture {

// Loads of a run: forces, prescribed displacements, heat and pressures. Changes can be undone: restore() undoes set()
// with the loads that present() returned before, restore_rest_lengths() undoes heat(), and unload_faces() undoes
// load_faces(). After each change find_equilibrium() has to be called.
class RunLoads {
 public:
  RunLoads(EvolutionState& state, LoadedBody& body, EventSources& sources, InnerWork& inner_work, RunRecords& records)
      : system_(body.system()),
        state_(state),
        body_(body),
        sources_(sources),
        inner_work_(inner_work),
        records_(records) {}

  // Sets new loads and prescribed displacements. `work_within` is the matrix W of InnerWork (work of loads inside
  // boundary element regions).
  void set(const coupling::Affine& force, const coupling::Affine& prescribed,
           const Eigen::Matrix2d& work_within = Eigen::Matrix2d::Zero(), const CrackPressures& pressures = {});

  // Replaces the loads by others that are equal at the present load factor, so that nothing moves
  // (LoadedBody::take_over()).
  void take_over(const coupling::Affine& force, const coupling::Affine& prescribed, const Eigen::Matrix2d& work_within,
                 const CrackPressures& pressures = {});

  // Loads that set() replaces, to be given to restore().
  struct SavedLoads {
    ActingLoads acting;
    Eigen::Matrix2d work_within;
    Continuation continuation;
  };
  SavedLoads present();
  void restore(SavedLoads loads) noexcept;

  // Data with which restore_rest_lengths() undoes heat().
  struct Heat {
    coupling::Rests rests;
    Eigen::VectorXd total_force;
    double work;
  };
  // Changes the rest lengths of terms and operators (heat, swelling). The change of the stored energy at unchanged
  // displacements counts as work; find_equilibrium() has to follow.
  Heat heat(coupling::Rests rests);
  void restore_rest_lengths(Heat heat) noexcept;

  // Data with which unload_faces() undoes load_faces().
  struct FaceLoads {
    coupling::Affine offsets;
    double work;
  };
  // Changes the gaps of contact constraints due to loads inside operators (body forces, tractions on cracks). The
  // change of the stored energy at unchanged displacements counts as work; set() or take_over() has to follow.
  FaceLoads load_faces(coupling::Affine offsets);
  void unload_faces(FaceLoads loads) noexcept;

  // Finds the equilibrium under the present loads at the present load factor.
  void find_equilibrium();

 private:
  coupling::EquilibriumSystem& system_;
  EvolutionState& state_;
  LoadedBody& body_;
  EventSources& sources_;
  InnerWork& inner_work_;
  RunRecords& records_;
};

}  // namespace bempd::fracture
