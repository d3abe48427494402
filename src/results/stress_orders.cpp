#include "results/stress_orders.hpp"

#include "error.hpp"
#include "scene/options.hpp"

namespace bempd::results {

namespace {

const scene::OptionGroup stress_group(scene::OptionPlace::results, [] {
  return std::vector<scene::OptionDescription>{scene::text_option(
      "results.singular_stress",
      "Stress that bempd_evaluate() is asked for where it is unbounded (bempd_get_singularity()): number, the one that "
      "the elements there happen to give; refuse, an error. At tips of cracks it is an error always.",
      "number | refuse", "number")};
});

}  // namespace

StressOrders::StressOrders(const std::vector<regions::SingularPlace>& places, double tolerance)
    : places_(places), reach_(10 * tolerance) {
  std::vector<Box> boxes;
  for (const regions::SingularPlace& singular : places)
    boxes.emplace_back(singular.place - Point::Constant(reach_), singular.place + Point::Constant(reach_));
  tree_ = BoxTree(boxes);
}

const regions::SingularPlace* StressOrders::at(const Point& place) const {
  const regions::SingularPlace* found = nullptr;
  tree_.any([&](const Box& box) { return box.contains(place); },
            [&](int k) {
              found = &places_[static_cast<std::size_t>(k)];
              return true;
            });
  return found;
}

regions::FieldValues StressOrders::at_nodes(const regions::FieldValues& positions) const {
  regions::FieldValues orders{{}, 1};
  for (std::size_t i = 0; i < positions.values.size(); i += 2) {
    const regions::SingularPlace* singular = at(Point(positions.values[i], positions.values[i + 1]));
    orders.values.push_back(singular ? 1 - singular->exponent.real() : 0);
  }
  return orders;
}

void StressOrders::require_bounded(const std::vector<Point>& asked) const {
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const regions::SingularPlace* singular = at(asked[i]);
    require(!singular, "the stress at point ", i, ", (", asked[i].x(), ", ", asked[i].y(),
            "), is unbounded, it grows as r^-", singular ? 1 - singular->exponent.real() : 0,
            "; ask for it beside that place, or set the option results.singular_stress to number");
  }
}

}  // namespace bempd::results
