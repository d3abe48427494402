// A cantilever under a parabolic end shear, left half BEM, right half peridynamics, against the exact plane-stress
// field. Reference: S. P. Timoshenko and J. N. Goodier, Theory of Elasticity, 3rd ed., art. 21; errors of an
// independent prototype of the same discretisation: 1.8e-4, at the interface 1.6e-5 for dx = H / 20.
#include <gtest/gtest.h>

#include <claims.hpp>

#include "cantilever.hpp"

namespace coupled_cantilever_test {
namespace {

using namespace host;
using namespace host::cantilever;

Errors solve(int cells_over_height) {
  const double dx = height / cells_over_height;
  Model model;
  const int32_t id = model.add(material(young, poisson));
  const int32_t left = model.bem(id, rectangle(0, 0, length / 2, height), dx);
  const int32_t right = model.pd(id, rectangle(length / 2, 0, length, height), dx, 4);
  model.prescribe(left, 4, 0, 1, exact);
  model.traction(right, 2, end_traction);
  model.step(1);
  return errors(model, {left, right}, length / 2);
}

TEST(Cantilever, boundary_elements_and_peridynamics_converge_at_second_order) {
  std::vector<double> errors;
  for (int cells : {10, 20, 40}) {
    const Errors e = solve(cells);
    std::printf("dx = H/%d: ", cells);
    report("error, anywhere", e.everywhere, cells == 20 ? 1.8e-4 : 0, "closed form; prototype at H/20");
    std::printf("dx = H/%d: ", cells);
    report("error, interface", e.interface, cells == 20 ? 1.6e-5 : 0, "closed form; prototype at H/20");
    if (!errors.empty()) {
      const double order = std::log2(errors.back() / e.everywhere);
      report("order", order, 2, "theory of the network");
      EXPECT_PRED1([](double value) { return claims::cantilever_order.holds(value); }, order);
    }
    errors.push_back(e.everywhere);
  }
  EXPECT_LE(errors[1], claims::cantilever);
}

}  // namespace
}  // namespace coupled_cantilever_test
