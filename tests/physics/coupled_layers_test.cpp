// Regions of different materials that touch: displacement and traction pass the interface.
// References: closed forms of bars in series and of two half bodies with constant stress on either side.
#include <gtest/gtest.h>

#include "coupled_scene.hpp"

namespace coupled_layers_test {
namespace {

using namespace host;

// Traction of a BEM region at the middle of its elements on the line x = place.
std::vector<Vector> middle_tractions(Model& model, int32_t region, double place) {
  const auto x = model.vectors(region, BEMPD_POSITION), t = model.vectors(region, BEMPD_TRACTION);
  const auto elements = model.elements(region);
  std::vector<std::pair<double, Vector>> found;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const auto node = [&](std::size_t k) { return x[static_cast<std::size_t>(elements[e][k])]; };
    if (std::abs(node(0)[0] - place) < 1e-9 && std::abs(node(2)[0] - place) < 1e-9)
      found.push_back({node(1)[1], t[3 * e + 1]});
  }
  std::sort(found.begin(), found.end());
  std::vector<Vector> tractions;
  for (const auto& [y, traction] : found) tractions.push_back(traction);
  return tractions;
}

TEST(Layers, bars_in_series_without_poisson_effect_are_exact) {
  const double first = 70e9, second = 210e9, pull = 3e6, l1 = 0.7, l2 = 0.5, height = 0.2;
  Model model;
  const int32_t soft = model.bem(model.add(material(first, 0)), rectangle(0, 0, l1, height), 0.1);
  const int32_t stiff = model.bem(model.add(material(second, 0)), rectangle(l1, 0, l1 + l2, height), 0.06);
  model.fix(soft, 4, BEMPD_BOTH);
  model.traction(stiff, 2, 0, 1, BEMPD_X, 0, pull);
  model.step(1);
  const double reference = pull * (l1 / first + l2 / second);
  for (double y : {0.0, 0.1, 0.2}) {
    const double value = model.evaluate({l1 + l2, y}).displacement[0];
    EXPECT_LE(std::abs(report("end displacement", value, reference, "closed form")), 1e-10 * reference);
  }
}

// A bar between smooth walls does not get thinner: its end moves by stress / C11 times the length of every part.
TEST(Layers, four_materials_in_series_between_smooth_walls_are_exact) {
  const double pull = 3e6, height = 0.2, length = 0.3;
  const Method methods[] = {Method::boundary_elements, Method::peridynamics, Method::peridynamics,
                            Method::boundary_elements};
  const double young[] = {70e9, 210e9, 3e9, 110e9}, poisson[] = {0.2, 1.0 / 3, 1.0 / 3, -0.3};
  Model model;
  double reference = 0;
  int32_t last = 0;
  for (int k = 0; k < 4; ++k) {
    const Outline outline = rectangle(k * length, 0, (k + 1) * length, height);
    const int32_t id = model.add(material(young[k], poisson[k]));
    last = methods[k] == Method::peridynamics ? model.pd(id, outline, 0.02, 3 + k % 2) : model.bem(id, outline, 0.05);
    model.fix(last, 1, BEMPD_Y);
    model.fix(last, 3, BEMPD_Y);
    if (k == 0) model.fix(last, 4, BEMPD_X);
    reference += pull * length * (1 - poisson[k] * poisson[k]) / young[k];
  }
  model.traction(last, 2, 0, 1, BEMPD_X, 0, pull);
  model.step(1);
  for (double y : {0.0, 0.1, 0.2}) {
    const double value = model.evaluate({4 * length, y}).displacement[0];
    EXPECT_LE(std::abs(report("end displacement", value, reference, "closed form")), 1e-10 * reference);
  }
}

// sigma_xx, sigma_xy and the stretch along the interface x = place are common to both sides; sigma_yy jumps.
struct Side {
  double young, poisson, sxx, sxy, eyy, place, rotation;
  double syy() const { return young * eyy + poisson * sxx; }
  double exx() const { return (sxx - poisson * syy()) / young; }
  double shear_angle() const { return 2 * (1 + poisson) / young * sxy; }
  Vector operator()(double x, double y) const {
    return {exx() * (x - place) + rotation * y, (shear_angle() - rotation) * (x - place) + eyy * y};
  }
  Vector traction(Vector n) const { return {sxx * n[0] + sxy * n[1], sxy * n[0] + syy() * n[1]}; }
};

struct TwoSides {
  const char* name;
  Method left, right;
  double left_poisson, right_poisson;
};

class TwoMaterials : public testing::TestWithParam<TwoSides> {};

TEST_P(TwoMaterials, stress_that_jumps_at_the_interface_is_exact) {
  const double place = 0.5;
  const Side left{70e9, GetParam().left_poisson, 3e6, 2e6, 4e-5, place, 3e-5};
  Side right = left;
  right.young = 210e9, right.poisson = GetParam().right_poisson;
  const std::vector<Piece> pieces{{GetParam().left, rectangle(0, 0, place, 0.4)},
                                  {GetParam().right, rectangle(place, 0, 1.2, 0.4)}};
  const Side* sides[2] = {&left, &right};

  Model model;
  std::vector<int32_t> regions;
  for (std::size_t k = 0; k < 2; ++k) {
    const int32_t id = model.add(material(sides[k]->young, sides[k]->poisson));
    regions.push_back(add_pieces(model, {pieces[k]}, id, 0.05, 4, k == 0 ? 0.1 : 0.07)[0]);
  }
  for (const EdgePart& part : free_parts(pieces)) {
    const Side& side = *sides[part.piece];
    if (part.piece == 0 && part.edge == 4)
      model.prescribe(regions[0], 4, 0, 1, side);
    else
      for (std::size_t k = 0; k < 2; ++k)
        model.traction(regions[part.piece], part.edge, part.from, part.to, k == 0 ? BEMPD_X : BEMPD_Y, 0,
                       side.traction(part.normal())[k]);
  }
  model.step(1);

  double error = 0, scale = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto x = model.vectors(regions[k], BEMPD_POSITION), u = model.vectors(regions[k], BEMPD_DISPLACEMENT);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Vector e = (*sides[k])(x[i][0], x[i][1]);
      scale = largest({scale, e[0], e[1]});
      error = largest({error, u[i][0] - e[0], u[i][1] - e[1]});
    }
  }
  EXPECT_LE(report("largest displacement error", error / scale, 0, "closed form"), 1e-10);

  double jump = 0;
  const Vector expected = left.traction({1, 0});
  for (std::size_t k = 0; k < 2; ++k)
    if (pieces[k].method == Method::boundary_elements)
      for (const Vector& t : middle_tractions(model, regions[k], place))
        for (std::size_t c = 0; c < 2; ++c)
          jump = largest({jump, (t[c] - (k == 0 ? 1 : -1) * expected[c]) / expected[0]});
  EXPECT_LE(report("interface traction error", jump, 0, "closed form"), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
    Pairs, TwoMaterials,
    testing::Values(TwoSides{"bem_bem", Method::boundary_elements, Method::boundary_elements, 0.2, 0.4},
                    TwoSides{"bem_pd", Method::boundary_elements, Method::peridynamics, 0.2, 1.0 / 3},
                    TwoSides{"pd_bem", Method::peridynamics, Method::boundary_elements, 1.0 / 3, 0},
                    TwoSides{"pd_pd", Method::peridynamics, Method::peridynamics, 1.0 / 3, 1.0 / 3}),
    [](const auto& test) { return test.param.name; });

// Tractions on the two sides of an interface are computed by two systems; in bending they must still be opposite, the
// better the finer the mesh.
TEST(Layers, bending_tractions_of_two_boundary_element_regions_are_opposite) {
  double previous = 0;
  for (double length : {0.1, 0.05, 0.025}) {
    Model model;
    const int32_t id = model.add(material(100e9, 1.0 / 3));
    const int32_t left = model.bem(id, rectangle(0, 0, 0.5, 0.2), length);
    const int32_t right = model.bem(id, rectangle(0.5, 0, 1, 0.2), length);
    model.fix(left, 4, BEMPD_BOTH);
    model.traction(right, 2, 0, 1, BEMPD_Y, 0, -1e6);
    model.step(1);
    const auto a = middle_tractions(model, left, 0.5), b = middle_tractions(model, right, 0.5);
    ASSERT_EQ(a.size(), b.size());
    ASSERT_FALSE(a.empty());
    double jump = 0, size = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      size = largest({size, a[i][0], a[i][1]});
      jump = largest({jump, a[i][0] + b[i][0], a[i][1] + b[i][1]});
    }
    report("traction jump over largest traction", jump / size, 0, "equilibrium");
    if (previous > 0) {
      EXPECT_LT(jump / size, 0.5 * previous);
    }
    previous = jump / size;
  }
  EXPECT_LT(previous, 2e-2);
}

}  // namespace
}  // namespace coupled_layers_test
