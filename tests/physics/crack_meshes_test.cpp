// Elements near cracks where the host has chosen those of an edge, and scenes whose gaps take many elements.
#include <gtest/gtest.h>

#include <string>

#include "host.hpp"

namespace crack_meshes_test {
namespace {

using namespace host;

constexpr double pi = 3.14159265358979323846;

bempd_crack_tip tip(const Model& model, int64_t index) {
  bempd_crack_tip found;
  bempd_crack_tip_init(&found, sizeof found);
  model.check(bempd_tip(model.get(), index, &found));
  return found;
}

void hold(Model& model, const Vector& corner, const Vector& beside) {
  model.fix_point(corner, BEMPD_BOTH);
  model.fix_point(beside, BEMPD_Y);
}

// Intensity at a crack from the left edge of a plate of 5 by 10, over stress and root of pi a.
double edge_crack(double length, double element_length) {
  Model model;
  const int32_t plate = model.bem(model.add(material(1, 0.3)), rectangle(0, -5, 5, 5), 0.5);
  if (element_length > 0) model.mesh(plate, 4, element_length, 1);
  model.crack({{0, 0}, {length, 0}});
  hold(model, {0, -5}, {5, -5});
  model.traction(plate, 1, 0, 1, BEMPD_Y, 0, -1);
  model.traction(plate, 3, 0, 1, BEMPD_Y, 0, 1);
  model.step(1);
  return tip(model, 0).stress_intensity_1 / std::sqrt(pi * length);
}

TEST(CrackMeshes, short_cracks_from_an_edge_whose_elements_are_chosen) {
  for (const double length : {0.01, 0.05})
    for (const double chosen : {0.5, 2.0}) {
      const double value = edge_crack(length, chosen);
      EXPECT_LE(std::abs(report("K_I of a short edge crack", value, 1.12152, "H. Tada")), 4e-3);
      EXPECT_NEAR(value, edge_crack(length, 0), 1e-4 * value);
    }
}

// A crack that ends near a re-entrant corner between edges with elements as long as they are.
double beside_corner(double element_length) {
  Model model;
  const int32_t plate = model.bem(model.add(material(1, 0.3)), {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}, 0.25);
  if (element_length > 0)
    for (const int32_t edge : {3, 4}) model.mesh(plate, edge, element_length, 1);
  model.crack({{1.0, 1.9}, {1.9, 1.9}});
  hold(model, {0, 0}, {4, 0});
  model.traction(plate, 1, 0, 1, BEMPD_Y, 0, -0.5);
  model.traction(plate, 5, 0, 1, BEMPD_Y, 0, 1);
  model.step(1);
  return tip(model, 1).stress_intensity_1;
}

TEST(CrackMeshes, a_tip_beside_a_corner_whose_elements_are_chosen) {
  const double reference = beside_corner(0);
  for (const double chosen : {2.0, 0.5, 0.05})
    EXPECT_LE(
        std::abs(report("K_I beside a corner", beside_corner(chosen), reference, "elements graded by themselves")),
        2e-4 * reference);
}

class Listening : public Model {
 public:
  Listening() { check(bempd_set_log(get(), &hear, this)); }
  std::string heard;

 private:
  static void hear(int32_t level, const char* message, void* self) {
    if (level == 1) static_cast<Listening*>(self)->heard += std::string(message) + "\n";
  }
};

void two_cracks(Model& model, double gap) {
  const int32_t plate = model.bem(model.add(material(1, 0.3)), rectangle(-5, -5, 5, 5), 0.5);
  model.crack({{-3, 0}, {3, 0}});
  model.crack({{-3, gap}, {3, gap}});
  hold(model, {-5, -5}, {5, -5});
  model.traction(plate, 1, 0, 1, BEMPD_Y, 0, -1);
  model.traction(plate, 3, 0, 1, BEMPD_Y, 0, 1);
}

TEST(CrackMeshes, a_gap_that_takes_many_elements_is_told) {
  Listening model;
  two_cracks(model, 0.02);
  model.step(1);
  EXPECT_NE(model.heard.find("crack 1 lies 0.02 from crack 2"), std::string::npos) << model.heard;
}

TEST(CrackMeshes, a_gap_that_takes_more_memory_than_there_is_is_refused) {
  Model limited;
  limited.set("memory.limit", 0.5);
  two_cracks(limited, 0.001);
  EXPECT_EQ(bempd_prepare(limited.get()), BEMPD_ERROR_ARGUMENT);
  EXPECT_NE(std::string(bempd_last_error(limited.get())).find("crack 1 lies 0.001 from crack 2"), std::string::npos)
      << bempd_last_error(limited.get());
  for (const double gap : {1e-5, 1e-6}) {
    Model model;
    two_cracks(model, gap);
    EXPECT_EQ(bempd_prepare(model.get()), BEMPD_ERROR_ARGUMENT) << gap;
    EXPECT_NE(std::string(bempd_last_error(model.get())).find("widen"), std::string::npos)
        << bempd_last_error(model.get());
  }
}

}  // namespace
}  // namespace crack_meshes_test
