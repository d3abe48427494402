// A cantilever whose boundary elements do not match the lattice at the interface: the error against the exact
// plane-stress field must be no worse than with a lattice that matches the same boundary mesh. Reference: S. P.
// Timoshenko and J. N. Goodier, Theory of Elasticity, 3rd ed., art. 21.
#include <gtest/gtest.h>

#include "cantilever.hpp"

namespace coupled_interface_test {
namespace {

using namespace host;

using cantilever::Errors;

// Elements of `element` on all edges of the left half, the interface included; 0: the interface follows the lattice.
Errors solve(double element, double on_interface, double spacing) {
  Model model;
  const int32_t id = model.add(material(cantilever::young, cantilever::poisson));
  const int32_t left = model.bem(id, rectangle(0, 0, 0.5, cantilever::height), element);
  if (on_interface > 0) model.mesh(left, 2, on_interface, 1);
  const int32_t right = model.pd(id, rectangle(0.5, 0, cantilever::length, cantilever::height), spacing, 4);
  model.prescribe(left, 4, 0, 1, cantilever::exact);
  model.traction(right, 2, cantilever::end_traction);
  model.step(1);
  return cantilever::errors(model, {left, right}, 0.5);
}

// The boundary mesh has a node every 0.05. The lattice that matches it is coarse; the finer ones meet no node of it or
// some of them.
TEST(InterfaceThatDoesNotMatch, cantilever_is_no_worse_than_with_the_lattice_that_matches_the_boundary_mesh) {
  const Errors matching = solve(0.1, 0, 0.05);
  std::printf("matching, nodes and lattice every 0.05: anywhere %.3g  interface %.3g\n", matching.everywhere,
              matching.interface);
  for (double spacing : {0.025, 0.02, 0.1 / 6, 0.0125, 0.01}) {
    const Errors e = solve(0.1, 0.1, spacing);
    std::printf("lattice every %.4f: ", spacing);
    report("error, anywhere", e.everywhere, matching.everywhere, "error of the lattice that matches");
    EXPECT_LE(e.everywhere, 1.2 * matching.everywhere);
    EXPECT_LE(e.interface, 1.2 * matching.interface);
  }
}

TEST(InterfaceThatDoesNotMatch, cantilever_converges_as_both_meshes_are_refined) {
  std::vector<double> errors;
  for (int n : {2, 4, 8}) {
    const Errors e = solve(0.1 / n, 0.07 / n, 0.025 / n);
    report("error, anywhere", e.everywhere, 0, "closed form");
    if (!errors.empty()) {
      EXPECT_GE(report("order", std::log2(errors.back() / e.everywhere), 2, "theory of the network"), 1.8 - 2);
    }
    errors.push_back(e.everywhere);
  }
}

// Compares boundary elements that do not match the lattice beside them with elements that follow it.
TEST(InterfaceThatDoesNotMatch, any_ratio_of_element_and_spacing_is_as_good_as_matching) {
  const double spacing = 0.01;
  const Errors matching = solve(0.1, 0, spacing);
  for (double element : {0.004, 0.007, 0.01, 0.015, 0.02, 0.027, 0.05, 0.066}) {
    const Errors e = solve(0.1, element, spacing);
    std::printf("element %.3f, lattice %.3f: ", element, spacing);
    report("error, anywhere", e.everywhere, matching.everywhere, "elements that follow the lattice");
    EXPECT_LE(e.everywhere, 1.2 * matching.everywhere);
  }
}

}  // namespace
}  // namespace coupled_interface_test
