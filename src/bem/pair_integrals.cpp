#include "bem/pair_integrals.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <new>

#include "bem/kernel_sums.hpp"

namespace bempd::bem {

namespace {

using Distances = std::array<std::array<double, 3>, 3>;

Distances distances_between(const std::array<Point, 3>& outer, const std::array<Point, 3>& inner) {
  Distances distances;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) distances[i][j] = (inner[j] - outer[i]).norm();
  return distances;
}

constexpr int largest_rule = static_cast<int>(regular_point_counts.size()) - 1;
// Largest number of pairs of intervals into which a pair of elements is split. A pair of elements that would need more
// goes to integrate_alongside(), which costs about as much.
constexpr std::size_t most_short_pairs = 256;

double closest_singularity(const ElementGeometry& element, const Interval& interval,
                           const std::array<Point, 3>& other) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Point& y : other) smallest = std::min(smallest, singularities_from(element, y).sum_of_distances(interval));
  return smallest;
}

}  // namespace

PairIntegrator::PairIntegrator(const std::vector<ElementGeometry>& elements, double tolerance)
    : elements_(elements), tolerance_(tolerance), rules_(tolerance), whole_(elements.size()) {
  for (std::size_t e = 0; e < elements.size(); ++e) {
    whole_stretches_.push_back(stretch({static_cast<int>(e), {}}));
    arcs_.emplace_back();
    if (!elements[e].straight() && !elements[e].basis.powers()) arcs_.back().emplace(elements[e]);
  }
}

PairIntegrator::Stretch PairIntegrator::stretch(const Side& side) const {
  const ElementGeometry& element = elements_[side.element];
  const Interval& i = side.interval;
  const std::array<Point, 3> sample{element.at(i.from), element.at(i.mid()), element.at(i.to)};
  return {side, sample, 0.5 * ((sample[1] - sample[0]).norm() + (sample[2] - sample[1]).norm()),
          regular_rule(shape_points_needed(element, i, tolerance_)), element.straight()};
}

const ElementPoints& PairIntegrator::points(const Side& side, int rule, ElementPoints& scratch) const {
  if (side.interval.from == -1 && side.interval.to == 1)
    return whole_[side.element][rule].of(elements_[side.element], regular_point_counts[rule]);
  fill_points(elements_[side.element], side.interval, regular_point_counts[rule], scratch);
  return scratch;
}

// List of up to most_short_pairs + 1 pairs of intervals, on the stack. Thread-local memory would need a registered
// destructor, and the C library ends the process if there is no memory for the registration.
class PairIntegrator::ShortPairs {
 public:
  void add(const ShortPair& pair) { new (memory_ + sizeof(ShortPair) * size_++) ShortPair(pair); }
  std::size_t size() const { return size_; }
  const ShortPair* begin() const { return std::launder(reinterpret_cast<const ShortPair*>(memory_)); }
  const ShortPair* end() const { return begin() + size_; }

 private:
  std::size_t size_ = 0;
  alignas(ShortPair) std::byte memory_[sizeof(ShortPair) * (most_short_pairs + 1)];
};

// Nearness to the part `own` of an element of the singularity that sample points of the part `other` cause. The kernels
// are analytic up to the complex parameter at which the distance r vanishes. On a straight part this parameter is as
// far from both ends as the sample point is in the plane.
PairIntegrator::Nearness PairIntegrator::nearness(const Stretch& own, const std::array<double, 3>& sums,
                                                  const Stretch& other) const {
  const Side& side = own.side;
  const auto of_sum = [&](double sum) { return Nearness{sum, std::max(rules_.rule(sum), own.shape_rule)}; };
  if (own.straight) return of_sum(std::min({sums[0], sums[1], sums[2]}) / own.half_length);
  if (const std::optional<ArcParameters>& arc = arcs_[side.element]) {
    const Nearness near = of_sum(arc->sum_of_distances(other.sample[1], side.interval));
    const double least = near.sum - arc->largest_change(other.sample, side.interval);
    if (near.rule <= largest_rule && least > 2 && rules_.rule(least) <= near.rule) return near;
    return of_sum(std::min({near.sum, arc->sum_of_distances(other.sample[0], side.interval),
                            arc->sum_of_distances(other.sample[2], side.interval)}));
  }
  return of_sum(closest_singularity(elements_[side.element], side.interval, other.sample));
}

PairIntegrator::Closeness PairIntegrator::closeness(const Stretch& outer, const Stretch& inner) const {
  const Distances d = distances_between(outer.sample, inner.sample);
  return {nearness(outer, {d[0][0] + d[2][0], d[0][1] + d[2][1], d[0][2] + d[2][2]}, inner),
          nearness(inner, {d[0][0] + d[0][2], d[1][0] + d[1][2], d[2][0] + d[2][2]}, outer)};
}

// Halves parts of two elements until there is a good enough Gauss rule for each pair of them, and collects these pairs.
// Returns false if there are more than most_short_pairs pairs.
bool PairIntegrator::halve(const Stretch& outer, const Stretch& inner, int depth, ShortPairs& pairs) const {
  constexpr int max_depth = 60;
  const Closeness close = closeness(outer, inner);
  if ((close.outer.rule <= largest_rule && close.inner.rule <= largest_rule) || depth == max_depth) {
    pairs.add(
        {outer.side, inner.side, std::min(close.outer.rule, largest_rule), std::min(close.inner.rule, largest_rule)});
    return pairs.size() <= most_short_pairs;
  }
  const bool halve_outer = close.outer.sum < close.inner.sum;
  const auto& [element, interval] = halve_outer ? outer.side : inner.side;
  const Stretch first = stretch({element, {interval.from, interval.mid()}});
  const Stretch second = stretch({element, {interval.mid(), interval.to}});
  return halve_outer ? halve(first, inner, depth + 1, pairs) && halve(second, inner, depth + 1, pairs)
                     : halve(outer, first, depth + 1, pairs) && halve(outer, second, depth + 1, pairs);
}

void PairIntegrator::add(const ShortPair& pair, PairPart part, PairMoments& moments) const {
  ElementPoints outer_scratch, inner_scratch;
  const ElementPoints& x = points(pair.outer, pair.outer_rule, outer_scratch);
  const ElementPoints& y = points(pair.inner, pair.inner_rule, inner_scratch);
  add_kernel_sums(x, y, part, moments);
}

void PairIntegrator::integrate_separate(const Stretch& outer, const Stretch& inner, PairPart part,
                                        PairMoments& moments) const {
  const Closeness close = closeness(outer, inner);
  if (close.outer.rule <= largest_rule && close.inner.rule <= largest_rule)
    return add({outer.side, inner.side, close.outer.rule, close.inner.rule}, part, moments);
  ShortPairs pairs;
  if (!halve(outer, inner, 0, pairs)) return integrate_alongside(outer.side, inner.side, part, moments);
  for (const ShortPair& pair : pairs) add(pair, part, moments);
}

PairMoments PairIntegrator::integrate(int outer, int inner, Contact contact, PairPart part) const {
  PairMoments moments;
  switch (contact) {
    case Contact::same:
      integrate_with_itself(outer, part, moments);
      break;
    case Contact::end_to_start:
      integrate_touching({outer, {1, -1}}, {inner, {-1, 1}}, true, part, moments);
      break;
    case Contact::start_to_end:
      integrate_touching({outer, {-1, 1}}, {inner, {1, -1}}, true, part, moments);
      break;
    case Contact::both_ends:
      // Two elements form a loop. Their halves touch if their parameters have opposite signs; else they are separate.
      integrate_touching({outer, {1, 0}}, {inner, {-1, 0}}, true, part, moments);
      integrate_touching({outer, {-1, 0}}, {inner, {1, 0}}, true, part, moments);
      integrate_separate(stretch({outer, {0, 1}}), stretch({inner, {0, 1}}), part, moments);
      integrate_separate(stretch({outer, {-1, 0}}), stretch({inner, {-1, 0}}), part, moments);
      break;
    case Contact::none:
      integrate_separate(whole_stretches_[outer], whole_stretches_[inner], part, moments);
      break;
  }
  return moments;
}

PairMoments PairIntegrator::integrate_meeting(int outer, int outer_end, int inner, int inner_end, PairPart part) const {
  const auto from_end = [](int end) { return end == 0 ? Interval{-1, 1} : Interval{1, -1}; };
  PairMoments moments;
  integrate_touching({outer, from_end(outer_end)}, {inner, from_end(inner_end)}, false, part, moments);
  return moments;
}

}  // namespace bempd::bem
