// A body whose bonds all want to be longer by the same share, and whose boundary element regions want to swell by it,
// expands freely: the displacement is eps x and nothing carries a force, up to faces, holes and interfaces. Held at its
// ends it cracks while it shrinks with the load factor, and its energies stay in balance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "coupling/equilibrium_system.hpp"
#include "fracture/crack_evolution.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/discretization.hpp"
#include "regions/lattice/peridynamic_description.hpp"

namespace free_expansion_test {
namespace {

using namespace bempd;
using regions::add_boundary_region;
using regions::add_peridynamic_region;
using regions::Discretization;
using scene::Scene;

constexpr double eps = 1e-3;

std::vector<Point> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

int add_material(Scene& scene) {
  scene::Material material;
  material.elasticity = {30e9, bond_based_poisson_ratio(PlaneState::stress), PlaneState::stress, 0.02};
  return scene.add_material(material);
}

Scene lattice_with_hole() {
  Scene scene;
  const int region = add_peridynamic_region(scene, add_material(scene), rectangle(0, 0, 20, 14), 1.0, 3);
  scene.shape_of(region).add_hole({{8, 5}, {8, 9}, {13, 9}, {13, 5}});
  return scene;
}

Scene two_lattices() {
  Scene scene;
  const int id = add_material(scene);
  add_peridynamic_region(scene, id, rectangle(0, 0, 10, 12), 1.0, 4);
  add_peridynamic_region(scene, id, rectangle(10, 0, 22, 12), 1.0, 3);
  return scene;
}

Scene lattice_between_boundary_regions() {
  Scene scene;
  const int id = add_material(scene);
  add_boundary_region(scene, id, rectangle(0, 0, 4, 8), 2.0);
  add_peridynamic_region(scene, id, rectangle(4, 0, 16, 8), 1.0, 3);
  add_boundary_region(scene, id, rectangle(16, 0, 20, 8), 4.0);
  return scene;
}

Scene lattice_in_a_plate() {
  Scene scene;
  const int id = add_material(scene);
  const int plate = add_boundary_region(scene, id, rectangle(0, 0, 24, 20), 4.0);
  scene.shape_of(plate).add_hole({{6, 5}, {6, 15}, {16, 15}, {16, 5}});
  add_peridynamic_region(scene, id, rectangle(6, 5, 16, 15), 1.0, 4);
  return scene;
}

// Two elements meet twelve spacings: the lattice points between are tied.
Scene lattice_tied_to_a_boundary_region() {
  Scene scene;
  const int id = add_material(scene);
  const int left = add_boundary_region(scene, id, rectangle(0, 0, 6, 12), 3.0);
  scene.shape_of(left).set_mesh(2, {3, 1});
  add_peridynamic_region(scene, id, rectangle(6, 0, 20, 12), 1.0, 3);
  return scene;
}

// Swelling by a strain at no load, and by one that grows with the load factor.
std::vector<coupling::DenseOperator> swell(Discretization& d, double constant, double proportional) {
  for (std::size_t b = 0; b < d.bonds.size(); ++b) {
    d.bonds.set_rest_elongation(static_cast<int>(b), constant * d.bonds.length[b], proportional * d.bonds.length[b]);
  }
  std::vector<coupling::DenseOperator> operators = d.dense_operators();
  for (coupling::DenseOperator& op : operators) {
    op.rest.setZero(2 * static_cast<Eigen::Index>(op.nodes.size()), 2);
    for (std::size_t i = 0; i < op.nodes.size(); ++i) {
      op.rest.block<2, 1>(2 * static_cast<Eigen::Index>(i), 0) = constant * d.positions[op.nodes[i]];
      op.rest.block<2, 1>(2 * static_cast<Eigen::Index>(i), 1) = proportional * d.positions[op.nodes[i]];
    }
  }
  return operators;
}

// Bonds across a vertical line between two heights.
std::vector<int> across(const Discretization& d, double x, double low, double high) {
  std::vector<int> found;
  for (std::size_t b = 0; b < d.bonds.size(); ++b) {
    const Point &a = d.positions[d.bonds.first[b]], &e = d.positions[d.bonds.second[b]];
    const double middle = 0.5 * (a.y() + e.y());
    if ((a.x() - x) * (e.x() - x) < 0 && middle > low && middle < high) found.push_back(static_cast<int>(b));
  }
  return found;
}

struct Case {
  const char* name;
  Scene (*scene)();
};

class FreeExpansion : public testing::TestWithParam<Case> {
 protected:
  FreeExpansion() : d(regions::discretize(GetParam().scene(), scene::Options())) {
    for (std::size_t b = 0; b < d.bonds.size(); ++b) {
      largest_force = std::max(largest_force, d.bonds.stiffness[b] * eps * d.bonds.length[b]);
    }
    operators = swell(d, eps, 0);
    // Held where it may turn and move, on points of its lower edge.
    std::vector<char> held(2 * d.positions.size(), 0);
    int corner = 0, other = 0;
    for (int n = 0; n < static_cast<int>(d.positions.size()); ++n) {
      if (d.positions[n].norm() < d.positions[corner].norm()) corner = n;
    }
    for (int n = 0; n < static_cast<int>(d.positions.size()); ++n) {
      const bool level = d.positions[n].y() == d.positions[corner].y() && d.ties.tie_of(n) < 0;
      if (level && d.positions[n].x() > d.positions[other].x()) other = n;
    }
    held[2 * corner] = held[2 * corner + 1] = held[2 * other + 1] = 1;
    origin = d.positions[corner];
    system = std::make_unique<coupling::EquilibriumSystem>(static_cast<int>(d.positions.size()), operators, d.bonds,
                                                           held, d.ties);
  }

  void expect_free_expansion(const char* when) const {
    const coupling::Affine u = system->solve();
    EXPECT_EQ(u.col(1).norm(), 0);
    double displacement = 0, size = 0, bond_force = 0;
    for (std::size_t n = 0; n < d.positions.size(); ++n) {
      const Point wanted = eps * (d.positions[n] - origin);
      size = std::max(size, wanted.norm());
      displacement = std::max(displacement, (u.block<2, 1>(2 * static_cast<Eigen::Index>(n), 0) - wanted).norm());
    }
    for (std::size_t b = 0; b < d.bonds.size(); ++b) {
      const double tension = d.bonds.tension(b, system->stages().stiffness()[b], u.col(0).data(), 0);
      bond_force = std::max(bond_force, std::abs(tension));
    }
    const double node_force = system->response().internal_force(u.col(0)).cwiseAbs().maxCoeff();
    const double energy = system->response().energy(u.col(0)) / (largest_force * eps);
    std::printf(
        "%s, %s, %zu nodes tied: error of displacement %.1e, bond force %.1e, nodal force %.1e, energy %.1e "
        "(reference: 0)\n",
        GetParam().name, when, d.ties.nodes().size(), displacement / size, bond_force / largest_force,
        node_force / largest_force, energy);
    EXPECT_LE(displacement, 1e-12 * size);
    EXPECT_LE(bond_force, 1e-12 * largest_force);
    EXPECT_LE(node_force, 1e-12 * largest_force);
    EXPECT_LE(energy, 1e-20);
    expect_no_stress(u);
  }

  // Stress is zero in the fields of lattices; those of boundary elements do not include swelling.
  void expect_no_stress(const coupling::Affine& u) const {
    const Eigen::VectorXd displacement = u.col(0);
    const regions::Solution solution{displacement, d.bonds, system->stages().intact(),  {}, nullptr,
                                     nullptr,      0,       &system->stages().numbers()};
    for (const auto& region : d.regions) {
      if (!region->bonds()) continue;
      for (const double stress : region->results().field(regions::Field::stress, solution).values)
        EXPECT_LE(std::abs(stress), 1e-11 * eps * region->elasticity().young_modulus);
    }
  }

  Discretization d;
  std::vector<coupling::DenseOperator> operators;
  double largest_force = 0;  // of a bond that is kept from expanding
  Point origin;
  std::unique_ptr<coupling::EquilibriumSystem> system;
};

TEST_P(FreeExpansion, is_without_stress_also_along_a_crack) {
  EXPECT_EQ(d.ties.empty(), GetParam().scene != lattice_tied_to_a_boundary_region);
  expect_free_expansion("whole");
  // A crack across the fifth row of points.
  std::vector<int> cut;
  for (std::size_t b = 0; b < d.bonds.size(); ++b) {
    const Point &a = d.positions[d.bonds.first[b]], &e = d.positions[d.bonds.second[b]];
    const double middle = 0.5 * (a.x() + e.x());
    if ((a.y() - 6.5) * (e.y() - 6.5) < 0 && middle > 5 && middle < 9) cut.push_back(static_cast<int>(b));
  }
  ASSERT_FALSE(cut.empty());
  system->commit(system->stages().breaking(cut), {});
  expect_free_expansion("cracked");
}

INSTANTIATE_TEST_SUITE_P(Scenes, FreeExpansion,
                         testing::Values(Case{"lattice with a hole", lattice_with_hole},
                                         Case{"two lattices", two_lattices},
                                         Case{"lattice between boundary regions", lattice_between_boundary_regions},
                                         Case{"tied lattice", lattice_tied_to_a_boundary_region},
                                         Case{"lattice in a plate", lattice_in_a_plate}),
                         [](const auto& instance) {
                           std::string name = instance.param.name;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

// A strip with an edge crack, both of whose ends are held along it, shrinks with the load factor until it has parted.
struct Shrinkage {
  const char* name;
  double constant;      // share of lengths at no load
  double rest_stretch;  // of bonds ahead of the crack, as a share of the one at which they break, at no load and
  double growing_with;  // with the load factor
  bool softens;
};

class Shrinking : public testing::TestWithParam<Shrinkage> {
 protected:
  static constexpr double critical = 1e-3;
  static constexpr double parted = 10;  // load factor, with what is left shrinking freely

  Shrinking() : d(regions::discretize(lattice_between_boundary_regions(), scene::Options())) {
    const Shrinkage& given = GetParam();
    std::vector<coupling::DenseOperator> operators = swell(d, given.constant, -0.1 * critical);
    for (const int b : across(d, 9.5, 3, 5)) {
      const double longest = critical * d.bonds.length[b];
      d.bonds.set_rest_elongation(b, d.bonds.rest(b, 0) + given.rest_stretch * longest,
                                  d.bonds.rest(b, 1) + given.growing_with * longest);
    }
    if (given.softens) {
      const int law = d.bonds.add_law(coupling::TermLaw({{1, 1}, {0.5, 1.5}}));
      for (std::size_t b = 0; b < d.bonds.size(); ++b) d.bonds.set_law(static_cast<int>(b), law);
    }
    const int dofs = 2 * static_cast<int>(d.positions.size());
    std::vector<char> held(static_cast<std::size_t>(dofs), 0);
    std::vector<int> pulled;
    for (int n = 0; n < dofs / 2; ++n) {
      const double x = d.positions[n].x();
      if (x != 0 && x != 20) continue;
      held[2 * n] = 1;
      if (d.positions[n].y() == 0) held[2 * n + 1] = 1;
      if (x == 20) pulled.push_back(2 * n);
    }
    system = std::make_unique<coupling::EquilibriumSystem>(dofs / 2, operators, d.bonds, held, d.ties);
    evolution =
        std::make_unique<fracture::CrackEvolution>(*system, d.positions, std::vector<double>(d.bonds.size(), critical),
                                                   across(d, 9.5, -1, 2.1), coupling::SupportDofs{{pulled}, {}});
    coupling::Affine prescribed = coupling::Affine::Zero(dofs, 2);
    for (const int dof : pulled) prescribed.row(dof) << 1e-4, 2e-5;
    evolution->loads().set(coupling::Affine::Zero(dofs, 2), prescribed);
  }

  Discretization d;
  std::unique_ptr<coupling::EquilibriumSystem> system;
  std::unique_ptr<fracture::CrackEvolution> evolution;
};

TEST_P(Shrinking, cracks_with_its_energies_in_balance) {
  evolution->advance(parted, fracture::Goal::load_factor, {}, {}, {});
  const fracture::EvolutionState state = evolution->state();
  std::printf("%s: %lld events, %lld bonds, stored %.3g, released %.3g of %.3g, energy balance %.1e (reference: 0)\n",
              GetParam().name, static_cast<long long>(state.events), static_cast<long long>(state.broken_bonds),
              state.history.back().stored_energy, state.released_energy, state.largest_work,
              state.worst_energy_balance_error);
  EXPECT_GT(state.events, 20);
  EXPECT_GT(state.released_energy, 0.9 * state.largest_work);
  EXPECT_LE(state.worst_energy_balance_error, 1e-12);
  for (const fracture::HistoryEntry& line : state.history) EXPECT_LE(line.residual, 1e-12);
}

TEST_P(Shrinking, goes_on_from_a_saved_state_and_back_to_it) {
  for (int event = 0; event < 15; ++event) evolution->advance(1e6, fracture::Goal::next_event, {}, {}, {});
  evolution->synchronize();
  const fracture::EvolutionState saved = evolution->state();
  evolution->advance(parted, fracture::Goal::load_factor, {}, {}, {});
  const fracture::EvolutionState first = evolution->state();
  evolution->restore(saved);
  evolution->advance(parted, fracture::Goal::load_factor, {}, {}, {});
  EXPECT_EQ(evolution->state().work, first.work);
  EXPECT_EQ(evolution->state().stages, first.stages);
}

INSTANTIATE_TEST_SUITE_P(Bodies, Shrinking,
                         testing::Values(Shrinkage{"growing_with_the_load_factor", 0, 0, 0, false},
                                         Shrinkage{"swollen_at_first", 2e-4, 0, 0, false},
                                         Shrinkage{"with_bonds_of_other_lengths", -1e-4, -0.1, 0.005, false},
                                         Shrinkage{"softening", 1e-4, -0.1, 0, true}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace free_expansion_test
