// Similar scenes in other units: lengths times 1e-6, moduli times 1e6, thickness times 1e-3. Reference: dimensional
// analysis.
#include <gtest/gtest.h>

#include "fracture_scenes.hpp"

namespace fracture_scaling_test {
namespace {

using namespace host;

constexpr double length_factor = 1e-6, modulus_factor = 1e6, thickness_factor = 1e-3;
constexpr double energy_factor = modulus_factor * length_factor * length_factor * thickness_factor;
constexpr double force_factor = modulus_factor * length_factor * thickness_factor;

struct Plate {
  explicit Plate(const CentreCrack& s) : scene(s), ids(build(model, scene)) {}
  std::set<BondKey> parted() { return bond_sets(model, scene, ids).parted; }
  CentreCrack scene;
  BondModel model;
  CentreCrackIds ids;
};

CentreCrack scaled() {
  CentreCrack scene = CentreCrack::small();
  scene.unit *= length_factor, scene.young *= modulus_factor, scene.thickness *= thickness_factor;
  return scene;
}

TEST(Scaling, the_same_bonds_break_at_the_same_load_factors) {
  Plate plate(CentreCrack::small()), other(scaled());
  const double limit = 1e4;
  plate.model.run(limit), other.model.run(limit);
  EXPECT_EQ(plate.parted(), other.parted());
  const std::vector<Event> a = events(plate.model), b = events(other.model);
  ASSERT_EQ(a.size(), b.size());
  ASSERT_FALSE(a.empty());
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].broken, b[i].broken);
    worst = largest({worst, b[i].load_factor / a[i].load_factor - 1});
  }
  EXPECT_LE(report("load factors of the events", worst, 0, "dimensional analysis"), 1e-9);
}

TEST(Scaling, fields_forces_and_energies_scale) {
  Plate plate(CentreCrack::small()), other(scaled());
  const double first = plate.model.next_event(1e4).load_factor;
  const double at = 1.001 * first;
  const bempd_step_report a = plate.model.step(at), b = other.model.step(at);
  const std::vector<double> u = plate.model.displacements(), v = other.model.displacements();
  EXPECT_LE(report("displacements", largest_difference(v, u, length_factor) / largest(v), 0, "dimensional analysis"),
            1e-9);
  const double force = plate.model.reaction(plate.ids.right_end)[0],
               small = other.model.reaction(other.ids.right_end)[0];
  EXPECT_NEAR(report("force", small / force, force_factor, "dimensional analysis") / force_factor, 0, 1e-9);
  EXPECT_NEAR(
      report("stored energy", b.stored_energy / a.stored_energy, energy_factor, "dimensional analysis") / energy_factor,
      0, 1e-9);
  EXPECT_NEAR(report("released energy", b.released_energy / a.released_energy, energy_factor, "dimensional analysis") /
                  energy_factor,
              0, 1e-9);
}

}  // namespace
}  // namespace fracture_scaling_test
