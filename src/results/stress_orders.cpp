#include "results/stress_orders.hpp"

namespace bempd::results {

StressOrders::StressOrders(const std::vector<regions::SingularPlace>& places, double tolerance)
    : places_(places), reach_(10 * tolerance) {
  std::vector<Box> boxes;
  boxes.reserve(places.size());
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

double StressOrders::order_at(const Point& place) const {
  const regions::SingularPlace* const singular = at(place);
  return singular ? 1 - singular->exponent.real() : 0;
}

regions::FieldValues StressOrders::at_nodes(const regions::FieldValues& positions) const {
  regions::FieldValues orders{{}, 1};
  for (std::size_t i = 0; i < positions.values.size(); i += 2)
    orders.values.push_back(order_at(Point(positions.values[i], positions.values[i + 1])));
  return orders;
}

}  // namespace bempd::results
