// Stress intensity factors that are fitted ahead of a tip in a lattice, in fields that are known: every material point
// has the displacement of a term of Williams' series about the tip. The other terms must not be taken for K.
#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <cstdio>
#include <memory>
#include <numbers>

#include "coupling/equilibrium_system.hpp"
#include "elasticity/crack_tip_field.hpp"
#include "elasticity/griffith.hpp"
#include "fracture/line/deep_points.hpp"
#include "fracture/line/line_path.hpp"
#include "fracture/line/tip_stress.hpp"
#include "geometry/turning.hpp"
#include "regions/discretization.hpp"
#include "regions/initial_cracks.hpp"
#include "regions/lattice/peridynamic_description.hpp"
#include "regions/tips/tip_rings.hpp"

namespace regions_tip_fit_test {
namespace {

using namespace bempd;
using fracture::AffineIntensity;

// A lattice of spacing 1 with cracks; the field lies about the end of the first one.
struct Lattice {
  Lattice(const std::vector<Point>& outline, const std::vector<std::vector<Point>>& cracks, int horizon_ratio,
          double turned = 0) {
    scene::Material material;
    material.elasticity = elasticity;
    material.fracture_energy = 1;
    const int id = scene.add_material(material);
    regions::add_peridynamic_region(scene, id, outline, 1, horizon_ratio, {false, turned});
    for (const std::vector<Point>& points : cracks) scene.add_crack(points);
    d = regions::discretize(scene, options);
    const regions::LatticeCracks parted = regions::cracks_in_lattices(scene, d, options);
    const std::vector<int> cut = regions::bonds_cut_by_cracks(parted.cracks, d, d.warnings);
    system = std::make_unique<coupling::EquilibriumSystem>(static_cast<int>(d.positions.size()),
                                                           std::vector<coupling::DenseOperator>(), std::move(d.bonds),
                                                           std::vector<char>(2 * d.positions.size(), 0));
    system->stages().mark(system->stages().breaking(cut));
    const std::vector<Point>& first = parted.cracks.front().points;
    tip.place = first.back();
    tip.direction = (first.back() - first[first.size() - 2]).normalized();
    law = {1, static_cast<double>(horizon_ratio), elasticity.thickness, plane_modulus(elasticity), 1};
    laws.laws = {law};
    laws.of_node.assign(d.positions.size(), 0);
    laws.share_of_node.assign(d.positions.size(), 0);
    const std::vector<double> shares = d.regions.front()->bonds()->cell_shares();
    for (std::size_t k = 0; k < shares.size(); ++k)
      laws.share_of_node[static_cast<std::size_t>(d.regions.front()->nodes()[k])] = shares[k];
    stress = std::make_unique<fracture::TipStress>(*system, d.positions, laws);
    way = std::make_unique<fracture::LinePath>(*system, d.positions, *stress);
  }

  // What is fitted in the field of z^power with the complex factor of its potential.
  Point factors(double power, std::complex<double> factor) const {
    const CrackTipField field(elasticity, power, factor);
    coupling::Affine displacement = coupling::Affine::Zero(2 * static_cast<Eigen::Index>(d.positions.size()), 2);
    for (std::size_t n = 0; n < d.positions.size(); ++n) {
      const Point step = d.positions[n] - tip.place;
      const TipPolar polar{step.norm(), std::atan2(cross(tip.direction, step), tip.direction.dot(step))};
      const Point own = field.displacement(polar);
      const Point moved = own.x() * tip.direction + own.y() * left_of(tip.direction);
      displacement.block<2, 1>(2 * static_cast<Eigen::Index>(n), 1) = moved;
    }
    const AffineIntensity found =
        stress->fitted(tip, law, displacement, Eigen::RowVector2d::Zero()).factors(law.horizon);
    return {found.one[1], found.two[1]};
  }

  PlaneElasticity elasticity{2, 1.0 / 3, PlaneState::stress, 1};  // that of bonds alone
  scene::Scene scene;
  scene::Options options;
  regions::Discretization d;
  std::unique_ptr<coupling::EquilibriumSystem> system;
  std::unique_ptr<fracture::TipStress> stress;
  std::unique_ptr<fracture::LinePath> way;
  fracture::GrowingTip tip;
  pd::TipLaw law;
  pd::TipLaws laws;
};

// Largest error of K = 1 in either mode, and K in the terms without a singularity, each as large as K a horizon away.
struct Errors {
  double singular = 0, regular = 0;
};

Errors errors_of(const Lattice& lattice) {
  const double root = std::sqrt(2 * std::numbers::pi);
  Errors errors;
  for (const auto& [mode, known] : {std::pair(std::complex<double>(1, 0), Point(1, 0)), {{0, -1}, {0, 1}}}) {
    errors.singular = std::max(errors.singular, (lattice.factors(0.5, mode / root) - known).norm());
    for (const double power : {1.0, 1.5, 2.0, 2.5}) {
      const double same = std::pow(lattice.law.horizon, 0.5 - power) * 0.5 / power;
      errors.regular = std::max(errors.regular, lattice.factors(power, same * mode / root).norm());
    }
  }
  return errors;
}

std::vector<Point> square(double half) { return {{-half, -half}, {half, -half}, {half, half}, {-half, half}}; }

std::vector<Point> from_left(double half, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  const Point along(std::cos(angle), std::sin(angle)), tip(0.46, 0.48);
  return {tip - (half + tip.x()) / std::cos(angle) * along, tip};
}

TEST(TipFit, knows_all_its_terms_inside_a_lattice) {
  for (const int m : {3, 4, 5})
    for (const double degrees : {0.0, 17.0, 31.0, 40.0}) {
      const Lattice lattice(square(4.0 * m + 2), {from_left(4.0 * m + 2, degrees)}, m);
      const Errors errors = errors_of(lattice);
      std::printf("m %d, crack at %g degrees: K %.4f, other terms %.4f\n", m, degrees, errors.singular, errors.regular);
      EXPECT_LE(errors.singular, 0.03) << m << ", " << degrees;
      EXPECT_LE(errors.regular, 0.03) << m << ", " << degrees;
    }
}

TEST(TipFit, knows_all_its_terms_in_turned_lattices) {
  for (const int m : {3, 4})
    for (const double degrees : {10.0, 22.5, 45.0}) {
      const Lattice lattice(square(4.0 * m + 2), {from_left(4.0 * m + 2, 0)}, m, degrees * std::numbers::pi / 180);
      const Errors errors = errors_of(lattice);
      std::printf("m %d, lattice at %g degrees: K %.4f, other terms %.4f\n", m, degrees, errors.singular,
                  errors.regular);
      EXPECT_LE(errors.singular, 0.03) << m << ", " << degrees;
      EXPECT_LE(errors.regular, 0.03) << m << ", " << degrees;
    }
}

// The tip one to three horizons before an edge, and along one. The fields do not leave the edge free, so that points on
// it, where bonds are those of a free edge, have another stress: it is exact under uniform strain only, which the
// fields are not within a horizon of the tip.
TEST(TipFit, knows_all_its_terms_beside_an_edge) {
  constexpr int m = 4;
  for (const double horizons : {1.0, 1.5, 2.0, 3.0})
    for (const bool ahead : {true, false}) {
      const double near = std::round(horizons * m) + 1, far = 4.0 * m + 2;
      const std::vector<Point> outline = ahead
                                             ? std::vector<Point>{{-far, -far}, {near, -far}, {near, far}, {-far, far}}
                                             : std::vector<Point>{{-far, -far}, {far, -far}, {far, near}, {-far, near}};
      const Errors errors = errors_of(Lattice(outline, {from_left(far, 0)}, m));
      std::printf("%g horizons %s an edge: K %.4f, other terms %.4f\n", horizons, ahead ? "before" : "beside",
                  errors.singular, errors.regular);
      EXPECT_LE(errors.singular, horizons < 2 ? 0.095 : 0.04) << horizons << ahead;
      EXPECT_LE(errors.regular, horizons < 1.5 ? 0.27 : horizons < 2 ? 0.1 : 0.03) << horizons << ahead;
    }
}

// The face of another crack, behind which no point is asked: of few points only the first terms are fitted.
TEST(TipFit, before_a_face_counts_what_it_sees) {
  constexpr int m = 4;
  for (const double horizons : {1.0, 2.0, 3.5}) {
    const double far = 4.0 * m + 2, x = std::round(horizons * m) + 0.5;
    const Lattice lattice(square(far), {from_left(far, 0), {{x, -far}, {x, far}}}, m);
    const double root = std::sqrt(2 * std::numbers::pi);
    const Point one = lattice.factors(0.5, {1 / root, 0}), two = lattice.factors(0.5, {0, -1 / root});
    std::printf("%g horizons before a face: K_I %.4f, K_II %.4f\n", horizons, one.x(), two.y());
    EXPECT_NEAR(one.x(), 1, horizons < 2 ? 0.25 : 0.04) << horizons;
    EXPECT_NEAR(two.y(), 1, horizons < 2 ? 0.25 : 0.04) << horizons;
  }
}

// Points at corners stand for a quarter of a cell, or for three quarters at corners that point inwards. Halves of their
// bonds carry less than that under uniform stress, 0.64 at the former; with half a cell it was 0.32.
TEST(TipFit, corners_count_by_their_share_of_a_cell) {
  constexpr int m = 3;
  const double far = 4.0 * m + 2;
  const std::vector<Point> reentrant{{-far, -far}, {far, -far}, {far, 2}, {3, 2}, {3, far}, {-far, far}};
  const auto mean_ahead = [&](const std::vector<Point>& outline, const Point& tip, double degrees) {
    Lattice lattice(outline, {{{-far, 0.5}, {-far + 2, 0.5}}}, m);
    lattice.tip.place = tip;
    lattice.tip.direction = turned(Point(1, 0), degrees * std::numbers::pi / 180);
    coupling::Affine displacement =
        coupling::Affine::Zero(2 * static_cast<Eigen::Index>(lattice.d.positions.size()), 2);
    for (std::size_t n = 0; n < lattice.d.positions.size(); ++n)  // the same stretch in all directions
      displacement.block<2, 1>(2 * static_cast<Eigen::Index>(n), 1) = 1e-3 * lattice.d.positions[n];
    return lattice.stress->closely_ahead_of(lattice.tip, lattice.law, displacement, Eigen::RowVector2d::Zero()).one[1];
  };
  const double inside = mean_ahead(square(far), {0.5, 0.5}, 45);
  const double outer = mean_ahead(square(far), {far - 0.5, far - 0.5}, 45);
  const double inner = mean_ahead(reentrant, {2.5, 1.5}, 45);
  std::printf("mean stress ahead over the one inside: corner %.4f, corner inwards %.4f\n", outer / inside,
              inner / inside);
  EXPECT_NEAR(outer / inside, 1, 0.4);
  EXPECT_NEAR(inner / inside, 1, 0.2);
}

// A pressure across a crack midway between two rows is symmetric: it opens the tip and does not shear it.
TEST(TipFit, pressure_across_a_crack_has_no_shear) {
  const double far = 14;
  const Lattice lattice(square(far), {{{-far, 0.5}, {0.5, 0.5}}}, 3);
  const coupling::Affine at_rest = coupling::Affine::Zero(2 * static_cast<Eigen::Index>(lattice.d.positions.size()), 2);
  const Eigen::RowVector2d pressure(2, 5);
  const AffineIntensity fitted = lattice.stress->fitted(lattice.tip, lattice.law, at_rest, pressure).factors(3);
  const AffineIntensity ahead = lattice.stress->closely_ahead_of(lattice.tip, lattice.law, at_rest, pressure);
  for (const AffineIntensity& found : {fitted, ahead}) {
    EXPECT_GT(found.one[1], 0);
    EXPECT_NEAR(found.one[0] / found.one[1], 0.4, 1e-12);
    EXPECT_NEAR(found.two.norm(), 0, 1e-12 * found.one.norm());
  }
}

// Displacements in balance with those that are given at points farther from the tip than `radius`.
Eigen::VectorXd balanced(const Lattice& lattice, double radius, Eigen::VectorXd displacement) {
  const coupling::Terms& terms = lattice.system->terms();
  std::vector<int> unknown_of(lattice.d.positions.size(), -1);
  int count = 0;
  for (std::size_t n = 0; n < unknown_of.size(); ++n)
    if ((lattice.d.positions[n] - lattice.tip.place).norm() < radius) unknown_of[n] = count++;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(2 * count);
  for (std::size_t b = 0; b < terms.size(); ++b) {
    if (!lattice.system->stages().intact()[b]) continue;
    const double stiffness = lattice.system->stages().stiffness()[b];
    std::vector<std::pair<int, double>> pull;
    double given = 0;  // elongation by the given displacements
    terms.for_each_entry(b, [&](int node, double x, double y) {
      const int at = unknown_of[static_cast<std::size_t>(node)];
      if (at < 0) {
        given += Point(x, y).dot(displacement.segment<2>(2 * node));
        return;
      }
      pull.emplace_back(2 * at, x), pull.emplace_back(2 * at + 1, y);
    });
    for (const auto& [row, one] : pull) {
      forces[row] -= stiffness * given * one;
      for (const auto& [column, other] : pull) entries.emplace_back(row, column, stiffness * one * other);
    }
  }
  Eigen::SparseMatrix<double> matrix(2 * count, 2 * count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd found = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(forces);
  for (std::size_t n = 0; n < unknown_of.size(); ++n)
    if (unknown_of[n] >= 0)
      displacement.segment<2>(2 * static_cast<Eigen::Index>(n)) = found.segment<2>(2 * unknown_of[n]);
  return displacement;
}

// The field far from the tip is that of a continuum with a rigid motion; rings find its terms in the lattice's own
// field.
TEST(TipRings, find_the_terms_of_the_field_far_from_the_tip) {
  constexpr int m = 3;
  for (const double degrees : {0.0, 25.0}) {
    const double half = 10.0 * m, radius = 7.0 * m;
    const std::vector<Point> path = from_left(half, degrees);
    const Lattice lattice(square(half), {path}, m);
    const std::vector<scene::Crack> cracks;
    const std::vector<int> cut;
    const regions::BondedBody body{lattice.scene,
                                   lattice.d,
                                   lattice.system->terms(),
                                   lattice.system->stages().stiffness(),
                                   lattice.system->stages().intact(),
                                   cut,
                                   cracks,
                                   lattice.system->constraints(),
                                   {}};
    const regions::TipAxes axes{lattice.tip.place, lattice.tip.direction, path, 1, lattice.elasticity};
    const regions::TipRings rings(body, axes, radius + m);
    const std::complex<double> opening(0.7, -0.4);
    constexpr double along = 0.3;  // T
    const CrackTipField singular(lattice.elasticity, 0.5, opening), uniform(lattice.elasticity, 1, along / 4);
    Eigen::VectorXd displacement(2 * static_cast<Eigen::Index>(lattice.d.positions.size()));
    for (std::size_t n = 0; n < lattice.d.positions.size(); ++n) {
      const Point arm = lattice.d.positions[n] - axes.place, own = axes.into(arm);
      const TipPolar polar{own.norm(), std::atan2(own.y(), own.x())};
      displacement.segment<2>(2 * static_cast<Eigen::Index>(n)) =
          axes.out_of(singular.displacement(polar) + uniform.displacement(polar)) + Point(3, -2) +
          0.5 * Point(-arm.y(), arm.x());
    }
    const Eigen::VectorXd around = rings.around(balanced(lattice, radius + 2 * m, displacement));
    for (const double part : {1.0, 0.6}) {
      const regions::TipRings::Expansion found =
          rings.expansion(rings.about(0), 0.5 * part * radius, part * radius, around);
      std::printf("crack at %g degrees: %.4f %+.4fi, T %.4f, shift %.4f %+.4fi\n", degrees, found.opening.real(),
                  found.opening.imag(), found.uniform, found.shift.real(), found.shift.imag());
      EXPECT_NEAR(std::abs(found.opening - opening), 0, 0.03 * std::abs(opening));
      EXPECT_NEAR(found.uniform, along, 0.05 * along);
      EXPECT_NEAR(std::abs(found.shift), 0, 0.3 * std::abs(opening));  // 0.6 of a spacing
    }
  }
}

// Points that stand for an endless lattice lie deep inside, also where a turned lattice has points on its outline: some
// points beside it have more neighbours than those inside. With these, trial steps counted 4 % too much length.
TEST(DeepPoints, lie_away_from_outlines_of_turned_lattices) {
  constexpr int m = 3;
  const double far = 4.0 * m + 2;
  for (const double degrees : {0.0, 7.5, 20.0, 33.0, 45.0}) {
    const Lattice lattice(square(far), {{{-far, 0.5}, {-far + 2, 0.5}}}, m, degrees * std::numbers::pi / 180);
    const std::vector<int> deep = fracture::deep_points(lattice.system->terms(), lattice.laws).front();
    double nearest = far;
    for (const int node : deep)
      nearest = std::min(nearest, far - lattice.d.positions[static_cast<std::size_t>(node)].cwiseAbs().maxCoeff());
    std::printf("rows at %g degrees: %zu of %zu points, none nearer to the outline than %.2f\n", degrees, deep.size(),
                lattice.d.positions.size(), nearest);
    EXPECT_GT(deep.size(), lattice.d.positions.size() / 10) << degrees;
    EXPECT_GE(nearest, 2 * m) << degrees;
  }
}

TEST(LinePath, goes_on_by_a_spacing_and_arrives_at_faces_and_edges) {
  constexpr int m = 3;
  const double far = 14;
  const auto next = [&](double edge, double face) {
    std::vector<std::vector<Point>> cracks{from_left(far, 0)};
    if (face > 0) cracks.push_back({{face, -far}, {face, far}});
    const std::vector<Point> outline{{-far, -far}, {edge, -far}, {edge, far}, {-far, far}};
    const Lattice lattice(outline, cracks, m);
    return lattice.way->next(lattice.tip.place, lattice.tip.direction, lattice.law);
  };
  const fracture::LinePath::Step inside = next(far, 0);
  EXPECT_EQ(inside.length, 1);
  EXPECT_FALSE(inside.arrives());
  // Number of cut bonds: for each step (i, j) shorter than the horizon, j bonds cross one spacing of the path.
  int crossing = 0;
  for (int i = -m; i <= m; ++i)
    for (int j = 1; j <= m; ++j) crossing += i * i + j * j < m * m ? j : 0;
  EXPECT_EQ(static_cast<int>(inside.bonds.size()), crossing);
  // A ligament of a horizon and a spacing before a free edge is torn at one step; a longer one is not.
  const fracture::LinePath::Step last = next(m + 1, 0), before = next(m + 3, 0);
  EXPECT_TRUE(last.arrives());
  EXPECT_NEAR(last.length, m + 0.5, 1);
  EXPECT_FALSE(before.arrives());
  EXPECT_EQ(before.length, 1);
  // The step arrives at the face of a crack a spacing ahead.
  const fracture::LinePath::Step at_face = next(far, 1.5);
  EXPECT_TRUE(at_face.arrives());
  EXPECT_LE(at_face.length, 1.5);
}

}  // namespace
}  // namespace regions_tip_fit_test
