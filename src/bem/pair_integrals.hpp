#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "bem/boundary_elements.hpp"
#include "bem/smoothness.hpp"

namespace bempd::bem {

// Length of rows that have a number for each of the three nodes of an element, padded to whole vectors of the
// processor.
inline constexpr int padded_nodes = 4;

// Double integrals over a pair of elements, with x on the outer and y on the inner element and r = y - x, from which
// the blocks of all Galerkin matrices follow. With e = r / |r| and the normal n at y the kernels are
//   weakly singular:  ln r,  (e_x^2 - e_y^2) / 2,  e_x e_y   (the last two: e e^T without its trace part),
//   double layer:     (e . n) / r,  (n x e) / r,  and (e . n) / r times the last two weakly singular kernels.
struct PairMoments {
  using Column = std::array<double, padded_nodes>;  // outer nodes
  using Block = std::array<Column, 3>;              // inner nodes
  using WideBlock = std::array<Column, 6>;          // inner nodes, then outer nodes
  std::array<Block, 3> mass{};                      // times N_a(x) N_b(y), per length
  std::array<Block, 3> derivative{};                // times N_a'(xi) N_b'(eta), per parameter
  std::array<WideBlock, 4> double_layer{};  // times N_a(x) (N_b(y) - N_b(x)); the second half holds the terms in N_b(x)
  std::int64_t evaluations = 0;             // point pairs at which kernels were evaluated
};

// Integrals that a pair of elements needs. The weakly singular kernels are symmetric, so one order of the pair is
// enough for them. An inner crack element has no tractions and needs no `mass`; a pair of crack elements needs only
// `derivative`.
enum class PairPart { everything, without_mass, double_layer_only, derivative_only };

// Points of one Gauss rule on a whole element, computed by the first thread that asks for them, because few rules are
// ever used.
class PointTable {
 public:
  PointTable() = default;
  ~PointTable() { delete points_.load(std::memory_order_relaxed); }
  PointTable(const PointTable&) = delete;
  PointTable& operator=(const PointTable&) = delete;

  const ElementPoints& of(const ElementGeometry& element, int count) const {
    if (const ElementPoints* known = points_.load(std::memory_order_acquire)) return *known;
    auto own = std::make_unique_for_overwrite<ElementPoints>();
    fill_points(element, {}, count, *own);
    const ElementPoints* first = nullptr;
    return points_.compare_exchange_strong(first, own.get(), std::memory_order_acq_rel) ? *own.release() : *first;
  }

 private:
  mutable std::atomic<const ElementPoints*> points_{nullptr};
};

// Contact of two elements. `end_to_start`: the end of the outer element is the start of the inner element.
enum class Contact { none, same, end_to_start, start_to_end, both_ends };

// Integrates over pairs of elements, each with the relative error `tolerance`. Separate pairs use products of Gauss
// rules on intervals, which are halved until they are short enough for the distance. Pairs that lie along each other at
// a small distance, as on both sides of a slit, would need too many intervals: their number grows with the ratio of
// length to distance. For such pairs the inner integral is split anew for every outer point, and the work grows with
// the square of the logarithm of this ratio. Touching pairs use polar-like coordinates around the common point, in
// which only a factor ln(radius) is singular.
class PairIntegrator {
 public:
  PairIntegrator(const std::vector<ElementGeometry>& elements, double tolerance);

  PairMoments integrate(int outer, int inner, Contact contact, PairPart part) const;

  // Integrals over two elements whose ends (0: start, 1: end) are at one place but have different nodes, as at a mouth.
  // The double layer's terms with the shape functions N_b(y) and N_b(x) can then be integrated separately.
  PairMoments integrate_meeting(int outer, int outer_end, int inner, int inner_end, PairPart part) const;

 private:
  struct Side {
    int element;
    Interval interval;
  };
  // Part of an element, with the quantities from which the Gauss rule for this part is chosen.
  struct Stretch {
    Side side;
    std::array<Point, 3> sample;  // ends and middle
    double half_length;
    int shape_rule;  // smallest rule that integrates the element's own functions
    bool straight;
  };
  Stretch stretch(const Side& side) const;
  // Parts of two elements, each short enough for a Gauss rule at the distance between them, with the indices of the
  // rules.
  struct ShortPair {
    Side outer, inner;
    int outer_rule, inner_rule;
  };
  // Piece of an element on which one Gauss rule is enough.
  struct Piece {
    Interval interval;
    int rule;
  };
  void integrate_separate(const Stretch& outer, const Stretch& inner, PairPart part, PairMoments& moments) const;
  // Sum of the distances from the nearest singularity to both ends of a part of an element (see ellipse_size()); and
  // index of the Gauss rule that the part needs, larger than that of any rule if the part is too long.
  struct Nearness {
    double sum;
    int rule;
  };
  struct Closeness {
    Nearness outer, inner;
  };
  // Nearness to `own` of the singularity that points of `other` cause in the integrand over `own`. `sums` has, for each
  // sample point of `other`, the sum of its distances from both ends of `own`.
  Nearness nearness(const Stretch& own, const std::array<double, 3>& sums, const Stretch& other) const;
  Closeness closeness(const Stretch& outer, const Stretch& inner) const;
  class ShortPairs;
  bool halve(const Stretch& outer, const Stretch& inner, int depth, ShortPairs& pairs) const;
  void add(const ShortPair& pair, PairPart part, PairMoments& moments) const;
  void integrate_alongside(const Side& outer, const Side& inner, PairPart part, PairMoments& moments) const;
  void split(const Side& side, const Singularities* singularities, std::size_t count, std::vector<Piece>& pieces) const;
  void integrate_touching(const Side& outer, const Side& inner, bool common_node, PairPart part,
                          PairMoments& moments) const;
  void integrate_with_itself(int element, PairPart part, PairMoments& moments) const;
  void integrate_tip_with_itself(int element, PairMoments& moments) const;
  const ElementPoints& points(const Side& side, int rule, ElementPoints& scratch) const;

  std::vector<ElementGeometry> elements_;
  double tolerance_;
  RegularRules rules_;
  std::vector<Stretch> whole_stretches_;
  std::vector<std::optional<ArcParameters>> arcs_;
  std::vector<std::array<PointTable, regular_point_counts.size()>> whole_;
};

}  // namespace bempd::bem
