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

// Length of rows for three nodes, padded to whole vectors.
inline constexpr int padded_nodes = 4;

// Double integrals over a pair of elements, x on `outer` and y on `inner`, r = y - x, from which the Galerkin blocks of
// every operator follow. With e = r / |r| = (cos, sin) the kernels are
//   weakly singular:  ln r,  (e_x^2 - e_y^2) / 2,  e_x e_y   (e e^T without its trace part),
//   double layer:     (e . n) / r, (n x e) / r, and the first one times the last two of the line above,
// where n is the normal at y.
struct PairMoments {
  using Column = std::array<double, padded_nodes>;  // outer nodes
  using Block = std::array<Column, 3>;              // inner nodes
  using WideBlock = std::array<Column, 6>;          // inner nodes, then outer nodes
  std::array<Block, 3> mass{};                      // times N_a(x) N_b(y), per length
  std::array<Block, 3> derivative{};                // times N_a'(xi) N_b'(eta), per parameter
  std::array<WideBlock, 4> double_layer{};  // times N_a(x) (N_b(y) - N_b(x)); the second half holds the terms in N_b(x)
  std::int64_t evaluations = 0;             // point pairs at which kernels were evaluated
};

// Selection of the integrals that a pair needs. The weakly singular kernels are symmetric, so one order of the pair is
// enough; an inner crack element has no tractions and needs no `mass`; a pair of crack elements needs `derivative`
// only.
enum class PairPart { everything, without_mass, double_layer_only, derivative_only };

// Points of a rule on a whole element, computed by the first thread that asks for them: few rules are used.
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

// How two elements meet; the outer element's end is named first.
enum class Contact { none, same, end_to_start, start_to_end, both_ends };

// Integrates over pairs of elements, each pair with the relative error `tolerance`. Pairs apart use products of Gauss
// rules on intervals halved until they are short enough for their distance. Pairs that lie along each other at a small
// distance, as on the two sides of a slit, would take as many halves as they are longer than that distance: there the
// inner integral is split anew for every outer point, and the work grows with the square of a logarithm. Touching pairs
// use polar-like coordinates around the common point, in which only a factor ln(radius) is singular.
class PairIntegrator {
 public:
  PairIntegrator(const std::vector<ElementGeometry>& elements, double tolerance);

  PairMoments integrate(int outer, int inner, Contact contact, PairPart part) const;

  // Integrals over two elements whose ends meet at a place (0: start, 1: end) where each has a node of its own, as at
  // the mouth of a crack. The terms of the double layer in N_b(y) and in N_b(x) are integrable separately.
  PairMoments integrate_meeting(int outer, int outer_end, int inner, int inner_end, PairPart part) const;

 private:
  struct Side {
    int element;
    Interval interval;
  };
  // A side (part of an element) with the quantities that its choice of rule depends on.
  struct Stretch {
    Side side;
    std::array<Point, 3> sample;  // ends and middle
    double half_length;
    int shape_rule;  // the least rule on account of the element's own functions
    bool straight;
  };
  Stretch stretch(const Side& side) const;
  // Two sides that are short enough for their distance, with their rules.
  struct ShortPair {
    Side outer, inner;
    int outer_rule, inner_rule;
  };
  // A piece of an element on which one rule is enough.
  struct Piece {
    Interval interval;
    int rule;
  };
  void apart(const Stretch& outer, const Stretch& inner, PairPart part, PairMoments& moments) const;
  // Sum of distances of the nearest singularity, and the rule that it needs; larger than the largest rule if a side is
  // too long.
  struct Nearness {
    double sum;
    int rule;
  };
  struct Closeness {
    Nearness outer, inner;
  };
  // `sums` are those of the distances of the other's sample from both ends.
  Nearness nearness(const Stretch& own, const std::array<double, 3>& sums, const Stretch& other) const;
  Closeness closeness(const Stretch& outer, const Stretch& inner) const;
  class ShortPairs;
  bool halve(const Stretch& outer, const Stretch& inner, int depth, ShortPairs& pairs) const;
  void add(const ShortPair& pair, PairPart part, PairMoments& moments) const;
  void alongside(const Side& outer, const Side& inner, PairPart part, PairMoments& moments) const;
  void split(const Side& side, const Singularities* singularities, std::size_t count, std::vector<Piece>& pieces) const;
  void touching(const Side& outer, const Side& inner, bool common_node, PairPart part, PairMoments& moments) const;
  void same(int element, PairPart part, PairMoments& moments) const;
  void same_tip(int element, PairMoments& moments) const;
  const ElementPoints& points(const Side& side, int rule, ElementPoints& scratch) const;

  std::vector<ElementGeometry> elements_;
  double tolerance_;
  RegularRules rules_;
  std::vector<Stretch> whole_stretches_;
  std::vector<std::optional<ArcParameters>> arcs_;
  std::vector<std::array<PointTable, regular_point_counts.size()>> whole_;
};

}  // namespace bempd::bem
