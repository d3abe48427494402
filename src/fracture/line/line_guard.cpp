#include "fracture/line/line_guard.hpp"

#include "fracture/line/on_limits.hpp"

namespace bempd::fracture {

namespace {

// Distance from a tip, in horizons, within which no bond breaks by itself.
constexpr double guarded_reach = 3;
// Distance from a tip that unloads, in horizons, within which overloaded bonds do not break. An overload farther away
// has another cause than the tip.
constexpr double relaxing_reach = 1;

Point middle_of(const coupling::Terms& terms, int term, const std::vector<Point>& positions) {
  const auto t = static_cast<std::size_t>(term);
  return (positions[static_cast<std::size_t>(terms.first[t])] + positions[static_cast<std::size_t>(terms.second[t])]) /
         2;
}

}  // namespace

// Whether a term (bond or cell square) is too close to a tip to break by itself. The middle of the term decides, so
// that the order of its ends does not matter.
bool LineGuard::is_guarded(int term, const GrowingTip& tip) const {
  const Point middle = middle_of(body_.system().terms(), term, body_.positions());
  return (middle - tip.place).norm() < (1 - rounding_of_places) * guarded_reach * fields_.law_of(tip).horizon;
}

void LineGuard::exempt(const GrowingTip& tip, std::vector<char>& intact, std::optional<double> overloaded_at) const {
  // Whether a guarded term stays in `intact`. It does only if `overloaded_at` is given, and the term is not overloaded
  // at this load factor or is so far from the tip that its overload has another cause.
  const auto stays_intact = [&](int term) {
    return overloaded_at && (!(body_.response().ratios().at(static_cast<std::size_t>(term), *overloaded_at) > 1) ||
                             (middle_of(body_.system().terms(), term, body_.positions()) - tip.place).norm() >
                                 relaxing_reach * fields_.law_of(tip).horizon);
  };
  for (const int node : fields_.stress().near().about(tip.place, (guarded_reach + 1) * fields_.law_of(tip).horizon)) {
    for (const int term : path_.terms_from().of(node))
      if (is_guarded(term, tip) && !stays_intact(term)) intact[static_cast<std::size_t>(term)] = 0;
  }
}

}  // namespace bempd::fracture
