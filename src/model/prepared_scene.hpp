#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/crack_evolution.hpp"
#include "fracture/interface_bonds.hpp"
#include "model/fingerprint.hpp"
#include "regions/boundary_conditions.hpp"
#include "regions/discretization.hpp"
#include "regions/initial_cracks.hpp"
#include "regions/singular_places.hpp"

namespace bempd::model {

// Prepared scene: all that is built from the host's finished scene.
struct PreparedScene {
  SceneFingerprint fingerprint;
  regions::Discretization discretization;
  regions::DofConditions conditions;
  regions::LatticeCracks in_lattices;
  std::vector<int> cut_bonds;
  std::unique_ptr<coupling::EquilibriumSystem> system;
  std::unique_ptr<fracture::CrackEvolution> evolution;
  std::optional<fracture::InterfaceBonds> interface_bonds;
  // Number of the initial tips of crack lines (first_tips), and number of the laws by which tips of crack lines grow
  // (tip_laws).
  std::size_t first_tips = 0, tip_laws = 0;
  int anchored_pieces = 0;  // number of pieces with a support or a load before any growth
  std::int64_t interior_kernel_evaluations = 0;
  // Places where the elastic stress is unbounded; empty until results ask for them.
  std::optional<std::vector<regions::SingularPlace>> singular_places;
};

// Sum of the fluid pressures in each crack under given conditions.
fracture::CrackPressures pressures_of(const regions::DofConditions& conditions);

}  // namespace bempd::model
