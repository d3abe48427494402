#include <cmath>

#include "rules.hpp"

namespace directions {
namespace {

// No crack line is kept: the point with the largest mean principal stress breaks all bonds across a facet through it.
class FacetRule final : public Rule {
 public:
  FacetRule(const Setting& setting, const Body& body, Window& window)
      : setting_(setting), body_(body), window_(window), mean_(body, window, setting.radius * body.horizon) {}

  Event next() override {
    mean_.update();
    std::vector<std::pair<double, int>> order;
    for (const int point : window_.points()) order.emplace_back(-principal(mean_.at(point)).value, point);
    std::partial_sort(order.begin(), order.begin() + 200, order.end());
    Event event;
    for (int k = 0; k < 200; ++k) {
      const int point = order[static_cast<std::size_t>(k)].second;
      collect(point, principal(mean_.at(point)).normal, event);
      if (event.losses.empty()) continue;
      event.load = body_.critical_stretch * 8 / 9 / -order[static_cast<std::size_t>(k)].first;
      return event;
    }
    event.finished = true;
    return event;
  }

 private:
  void collect(int point, const Point& normal, Event& event) const {
    const Point along(-normal.y(), normal.x()), centre = body_.points[static_cast<std::size_t>(point)] + 1e-6 * normal;
    const Point begin = centre - setting_.step / 2 * along, end = centre + setting_.step / 2 * along;
    for (const int k : window_.bonds()) {
      const Bond& bond = body_.bonds[static_cast<std::size_t>(k)];
      if (window_.stiffness(k) > 0 && window_.elongation(k) > 0 &&
          crosses(body_.points[static_cast<std::size_t>(bond.first)],
                  body_.points[static_cast<std::size_t>(bond.second)], begin, end))
        event.losses.push_back({k, window_.stiffness(k)});
    }
  }

  const Setting& setting_;
  const Body& body_;
  Window& window_;
  MeanStress mean_;
};

}  // namespace

std::unique_ptr<Rule> facet_rule(const Setting& setting, const Body& body, Window& window) {
  return std::make_unique<FacetRule>(setting, body, window);
}

}  // namespace directions
