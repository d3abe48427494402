// Pairs of elements that lie along each other at a distance far below their lengths. The inner integral is a smooth
// function of the position x on the outer element, except near the ends of the inner element, where it varies over
// lengths of this distance. Therefore the outer element is split towards the ends of the inner element, and for every
// outer point the inner element is split towards that point.

#include <algorithm>
#include <cassert>

#include "bem/kernel_sums.hpp"
#include "bem/pair_integrals.hpp"

namespace bempd::bem {

namespace {

// Makes `one` a set of the single point `p`. Its position is repeated, because the vector unit reads whole vectors; the
// repeated points have the weight 0.
void pick_point(const ElementPoints& points, int p, ElementPoints& one) {
  const auto repeat = [p](const ElementPoints::Values& from, ElementPoints::Values& to) { to.fill(from[p]); };
  const auto alone = [p](const ElementPoints::Values& from, ElementPoints::Values& to) {
    to.fill(0);
    to[0] = from[p];
  };
  one.count = 1;
  repeat(points.x, one.x);
  repeat(points.y, one.y);
  alone(points.normal_x, one.normal_x);
  alone(points.normal_y, one.normal_y);
  for (int k = 0; k < 3; ++k) {
    alone(points.shape[k], one.shape[k]);
    alone(points.mass[k], one.mass[k]);
    alone(points.derivative[k], one.derivative[k]);
  }
}

}  // namespace

// Splits a part of an element (`side`) into pieces that one Gauss rule can integrate: the length of a piece grows
// geometrically with its distance from the nearest of `singularities`.
void PairIntegrator::split(const Side& side, const Singularities* singularities, std::size_t count,
                           std::vector<Piece>& pieces) const {
  constexpr int largest = static_cast<int>(regular_point_counts.size()) - 1;
  constexpr double shortest = 1e-15;  // least difference of parameters
  const ElementGeometry& element = elements_[side.element];
  pieces.clear();
  for (double from = side.interval.from; from < side.interval.to;) {
    double length = side.interval.to - from;
    for (std::size_t k = 0; k < count; ++k)
      length = std::min(length, singularities[k].longest_interval(from, rules_.least_sum()));
    Interval piece{from, std::min(from + std::max(length, shortest), side.interval.to)};
    int shape_rule = 0;
    while ((shape_rule = regular_rule(shape_points_needed(element, piece, tolerance_))) > largest)
      piece.to = piece.mid();
    int rule = shape_rule;
    for (std::size_t k = 0; k < count; ++k)
      rule = std::max(rule, rules_.rule(singularities[k].sum_of_distances(piece)));
    pieces.push_back({piece, std::min(rule, largest)});
    from = piece.to;
  }
}

void PairIntegrator::integrate_alongside(const Side& outer, const Side& inner, PairPart part,
                                         PairMoments& moments) const {
  assert(outer.interval.from < outer.interval.to && inner.interval.from < inner.interval.to);
  const ElementGeometry &outer_element = elements_[outer.element], &inner_element = elements_[inner.element];
  const std::vector<Singularities> ends = singularities_of_integral(outer_element, inner_element, inner.interval);
  std::vector<Piece> outer_pieces, inner_pieces;
  split(outer, ends.data(), ends.size(), outer_pieces);
  ElementPoints x, one, y;
  for (const Piece& outer_piece : outer_pieces) {
    fill_points(outer_element, outer_piece.interval, regular_point_counts[outer_piece.rule], x);
    for (int p = 0; p < x.count; ++p) {
      pick_point(x, p, one);
      const Singularities nearest = singularities_from(inner_element, Point(x.x[p], x.y[p]));
      split(inner, &nearest, 1, inner_pieces);
      for (const Piece& inner_piece : inner_pieces) {
        fill_points(inner_element, inner_piece.interval, regular_point_counts[inner_piece.rule], y);
        add_kernel_sums(one, y, part, moments);
      }
    }
  }
}

}  // namespace bempd::bem
