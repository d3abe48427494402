// A further kind of region is its own two classes: a lattice with bonds between nearest neighbours only, added to a
// scene and run like any other.
#include <gtest/gtest.h>

#include <filesystem>

#include "error.hpp"
#include "model/model.hpp"
#include "pd/network.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/lattice/lattice_region.hpp"
#include "regions/places/edge_part.hpp"
#include "regions/places/single_point.hpp"

namespace regions_second_kind_test {
namespace {

using namespace bempd;
using model::Model;
using regions::Field;

// --- The kind

class NeighbourLattice final : public regions::LatticeRegion {
 public:
  using LatticeRegion::LatticeRegion;
  pd::Network make_network(const pd::CellLattice& cells, int threads) const override {
    return pd::build_network(cells, 2, elasticity(), threads);
  }
};

class NeighbourDescription final : public regions::PeridynamicDescription {
 public:
  using PeridynamicDescription::PeridynamicDescription;
  const char* adjective() const override { return "nearest-neighbour"; }
  bool may_be_curved() const override { return false; }
  std::unique_ptr<regions::Region> build(int id, const regions::Preparation& preparation) const override {
    return std::make_unique<NeighbourLattice>(id, *this, preparation.scene.material(material()));
  }
};

int add_neighbour_region(scene::Scene& scene, int material, const std::vector<Point>& vertices, double spacing) {
  constexpr int ratio = 3;  // of the horizon that the critical stretch is for
  return scene.add_region(
      std::make_unique<NeighbourDescription>(material, scene.material(material), Outline{{vertices}}, spacing, ratio));
}

// --- A strip of all three kinds, pulled along x

std::vector<Point> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

constexpr double young = 2e9, spacing = 0.1;

scene::SampledValues values(double constant, double proportional) { return {{constant}, {proportional}}; }

void build_strip(scene::Scene& scene) {
  const PlaneElasticity elasticity{young, 1.0 / 3, PlaneState::stress, 0.01};
  const int lasting = scene.add_material({elasticity}), brittle = scene.add_material({elasticity, 1e-3});
  regions::add_boundary_region(scene, lasting, rectangle(0, 0, 1, 1), 0.25);
  regions::add_peridynamic_region(scene, lasting, rectangle(1, 0, 2, 1), spacing, 3);
  add_neighbour_region(scene, brittle, rectangle(2, 0, 3, 1), spacing);
  scene.add_support({std::make_shared<const regions::EdgePart>(1, 4, 0, 1), 1, values(0, 0)});
  scene.add_support({std::make_shared<const regions::SinglePoint>(Point(0, 0)), 2, values(0, 0)});
  scene.add_support({std::make_shared<const regions::EdgePart>(3, 2, 0, 1), 1, values(0, 1e-3)});
}

TEST(SecondLatticeKind, has_bonds_of_its_own_next_to_those_of_the_first) {
  Model m;
  build_strip(m.editable_scene());
  m.prepare();
  // Two along the axes and two diagonals a point, fewer at the edges.
  EXPECT_EQ(m.results().bonds(3).size(), 2u * 10 * 11 + 2u * 10 * 10);
  EXPECT_GT(m.results().bonds(2).size(), 2 * m.results().bonds(3).size());
  EXPECT_EQ(m.results().region(3).bonds()->first_bond(), m.results().bonds(2).size());
}

TEST(SecondLatticeKind, takes_part_in_uniform_tension) {
  Model m;
  build_strip(m.editable_scene());
  m.driver().advance(0.5, fracture::Goal::load_factor);
  const double strain = 0.5e-3 / 3;
  for (const regions::PointValue& value : m.results().evaluate({{0.3, 0.4}, {1.33, 0.4}, {2.71, 0.4}}, true)) {
    SCOPED_TRACE(value.region);
    EXPECT_NEAR(value.stress[0], young * strain, 1e-8 * young * strain);
    EXPECT_NEAR(value.stress[1], 0, 1e-8 * young * strain);
  }
  EXPECT_NEAR(m.results().reaction(3).x(), young * strain * 0.01, 1e-9 * young * strain * 0.01);
  EXPECT_EQ(m.results().field(3, Field::damage).count(), 121);
}

TEST(SecondLatticeKind, breaks_in_two_along_a_notch) {
  Model m;
  build_strip(m.editable_scene());
  m.editable_scene().add_crack({{2.45, 0}, {2.45, 0.35}});
  const model::StepResult result = m.driver().advance(100, fracture::Goal::separation);
  EXPECT_EQ(result.reason, fracture::StopReason::separated);
  EXPECT_GT(result.broken_bonds, 0);
  int broken = 0, cut = 0;
  for (const regions::BondState state : m.results().bond_states(3)) {
    broken += state == regions::BondState::broken;
    cut += state == regions::BondState::cut;
  }
  EXPECT_EQ(broken, result.broken_bonds);
  // Cut bonds are those along x of the rows at 0, 0.1 and 0.2, and the diagonals between the rows up to the one at 0.3,
  // whose bond is weakened so that the crack is felt at its end.
  EXPECT_EQ(cut, 3 + 2 * 3);
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "second_lattice_kind";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  m.files().write_snapshot((folder / "strip").string());
  EXPECT_TRUE(std::filesystem::exists(folder / "strip_0000_lattice.vtu"));
  EXPECT_TRUE(std::filesystem::exists(folder / "strip_0000_boundary.vtu"));
}

TEST(SecondLatticeKind, is_named_in_sentences) {
  Model m;
  build_strip(m.editable_scene());
  try {
    m.editable_scene().shape_of(3).add_circular_hole({2.5, 0.5}, 0.1);
    FAIL() << "a lattice took a circular hole";
  } catch (const Error& e) {
    EXPECT_STREQ(e.what(), "region 3 is nearest-neighbour; its holes are rectilinear");
  }
}

}  // namespace
}  // namespace regions_second_kind_test
