#include "model/mesh_errors.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "geometry/turning.hpp"
#include "model/growth_options.hpp"

namespace bempd::model {

namespace {

// Factors by which estimated errors are increased, because differences between meshes vary around what the order of
// convergence says: for a series of meshes (caution), and for a mesh and a finer one, where differences vary less
// (caution_by_finer).
constexpr double caution = 1.6, caution_by_finer = 1.3;

// Order of convergence: the exponent of the length of elements with which an error falls. Two meshes do not show the
// order, so the usual order is taken; from three meshes on, the measured order is taken within limits.
struct Order {
  double usual, least, largest;

  double of(const std::vector<double>& differences) const {
    if (differences.size() < 2) return usual;
    const double last = differences.back(), before = differences[differences.size() - 2];
    if (!(last > 0) || !(before > 0) || !std::isfinite(before)) return usual;
    return std::clamp(std::log2(before / last), least, largest);
  }
};

// Orders of convergence by kinds of results. Quadratic elements have the order 3 for displacements once they resolve
// the field, and more for reactions, which are energies. The length of a tip's (K_I, K_II) (of_size) comes from the
// energy of a virtual extension and has an order between 4 and 5; its direction (of_turn) comes from the openings of
// the tip's elements and has the order 2. In random bodies, the difference of two meshes was 15 to 40 times the
// difference of the next two meshes for the length, and 4 times for the direction (docs/bodies.md). Where several
// supports hold the same node, the reaction of each support is no energy, and converges like the tractions at that node
// (of_shared_reaction). Beside singular places displacements converge with the order 1 to 2, which two meshes do not
// show (of_slow_displacement).
constexpr Order of_displacement{2.3, 0.5, 2.7}, of_slow_displacement{1.5, 0.5, 2.7}, of_reaction{3, 0.5, 3},
    of_shared_reaction{2, 0.5, 3}, of_size{4, 0.5, 4}, of_turn{2, 1, 2};

// Rule that estimates an error from the differences of successive meshes: the error of the finest mesh (of_finest), of
// a mesh with the finest elements halved once more (of_next), or of the coarser one of the last two meshes
// (of_coarser).
using Rule = double (*)(const Order&, const std::vector<double>&);

double of_finest(const Order& order, const std::vector<double>& differences) {
  return caution * differences.back() / (std::exp2(order.of(differences)) - 1);
}

double of_next(const Order& order, const std::vector<double>& differences) {
  return of_finest(order, differences) / std::exp2(order.of(differences));
}

double of_coarser(const Order& order, const std::vector<double>& differences) {
  return caution_by_finer * differences.back() / (1 - std::exp2(-order.of(differences)));
}

// Index of the place that equals x up to the tolerance; -1 if there is none.
int find_place(const std::vector<Point>& places, const Point& x, double tolerance) {
  const double left = x.x() - tolerance;
  const auto begin = std::lower_bound(places.begin(), places.end(), left,
                                      [](const Point& place, double bound) { return place.x() < bound; });
  for (auto at = begin; at != places.end() && at->x() <= x.x() + tolerance; ++at)
    if (std::abs(at->y() - x.y()) <= tolerance) return static_cast<int>(at - places.begin());
  return -1;
}

// Length of a vector, without overflow if its square is beyond the range of numbers.
double far_length_of(const Point& v) { return std::hypot(v.x(), v.y()); }

// Ratio of an error to the scale of its results; at most `largest`, also if the results are zero.
double relative(double error, double scale) {
  constexpr double largest = 1e300;
  if (!(error > 0)) return 0;
  const double ratio = error / scale;
  return ratio < largest ? ratio : largest;
}

double displacement_difference(const MeshAnswers& fine, const MeshAnswers& coarse, double tolerance) {
  double error = 0, scale = 0;
  for (const Eigen::Vector2d& u : fine.displacements) scale = std::max(scale, far_length_of(u));
  for (std::size_t i = 0; i < coarse.places.size(); ++i) {
    const int same = find_place(fine.places, coarse.places[i], tolerance);
    if (same < 0) continue;
    const Point& other = fine.displacements[static_cast<std::size_t>(same)];
    error = std::max(error, far_length_of(other - coarse.displacements[i]));
  }
  return relative(error, scale);
}

// Largest difference of reactions between two meshes, relative to the largest reaction or, if that is larger, to a
// tenth of the force that the body carries: where loads balance each other, reactions are only rounding errors.
double reaction_difference(const MeshAnswers& fine, const MeshAnswers& coarse) {
  double error = 0, scale = 0.1 * fine.carried;
  for (std::size_t s = 0; s < fine.reactions.size(); ++s) {
    scale = std::max(scale, far_length_of(fine.reactions[s]));
    error = std::max(error, far_length_of(fine.reactions[s] - coarse.reactions[s]));
  }
  return relative(error, scale);
}

// Difference between a tip's factors in two meshes. The difference of directions is 0 if one of the factors vanishes.
TipErrors tip_difference(const regions::TipValues& fine, const regions::TipValues& coarse) {
  const double size = far_length_of(fine.factors), other = far_length_of(coarse.factors);
  TipErrors errors{fine.id(), fine.place, relative(std::abs(size - other), size), 0};
  if (!(size > 0) || !(other > 0)) return errors;
  const Point a = fine.factors / size, b = coarse.factors / other;
  errors.turn = std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
  return errors;
}

MeshErrors difference(const MeshAnswers& fine, const MeshAnswers& coarse, double tolerance) {
  MeshErrors errors{displacement_difference(fine, coarse, tolerance), reaction_difference(fine, coarse), 0, 0, {}};
  if (std::isfinite(fine.growth_load))
    errors.growth_load = relative(std::abs(fine.growth_load - coarse.growth_load), std::abs(fine.growth_load));
  for (const regions::TipValues& tip : fine.tips)
    if (const regions::TipValues* other = crack::tip_in(coarse.tips, tip.id()))
      errors.tips.push_back(tip_difference(tip, *other));
  return errors;
}

// Error of the load factor at which a tip grows while the load factor rises, caused by errors of the tip's stress
// intensity factors.
double load_change(const regions::TipValues& tip, const TipErrors& errors, const scene::Options& options) {
  const crack::GrowthLaw law{tip.toughness, tip.plane_modulus, growth_criterion(options), tip.directions,
                             heading_of(tip.direction)};
  const auto load = [&](double size, double turn) {
    return law.range({size * turned(tip.constant_factors, turn), size * turned(tip.proportional_factors, turn)})
        .highest;
  };
  const double present = load(1, 0), turn = std::min(errors.turn, 1.0);
  if (!std::isfinite(present)) return 0;
  const double by_size = std::abs(load(1 + errors.size, 0) - present);
  const double by_turn = std::max(std::abs(load(1, turn) - present), std::abs(load(1, -turn) - present));
  return std::hypot(by_size, by_turn);
}

// Errors of `answers`: `rule` gives the error of each kind of result from its differences between successive meshes.
MeshErrors errors_by(Rule rule, const MeshAnswers& answers, const std::vector<MeshErrors>& differences,
                     const scene::Options& options) {
  const auto of = [&](const Order& order, const std::function<double(const MeshErrors&)>& kind) {
    std::vector<double> values;
    for (const MeshErrors& one : differences) values.push_back(kind(one));
    return rule(order, values);
  };
  MeshErrors errors;
  errors.displacement = of(of_displacement, [](const MeshErrors& d) { return d.displacement; });
  errors.reaction =
      of(answers.supports_share ? of_shared_reaction : of_reaction, [](const MeshErrors& d) { return d.reaction; });
  errors.growth_load = of(of_displacement, [](const MeshErrors& d) { return d.growth_load; });
  double largest = 0, scale = 0;
  for (TipErrors tip : differences.back().tips) {
    const auto of_tip = [&](const Order& order, double TipErrors::*part) {
      return of(order, [&](const MeshErrors& d) {
        for (const TipErrors& one : d.tips)
          if (one.tip == tip.tip) return one.*part;
        return 0.0;
      });
    };
    tip.size = of_tip(of_size, &TipErrors::size), tip.turn = of_tip(of_turn, &TipErrors::turn);
    errors.tips.push_back(tip);
    const regions::TipValues& values = *crack::tip_in(answers.tips, tip.tip);
    scale = std::max(scale, far_length_of(values.factors));
    largest = std::max(largest, tip.relative() * far_length_of(values.factors));
    const bool is_first = answers.first == tip.tip && std::isfinite(answers.growth_load);
    if (is_first) errors.growth_load = relative(load_change(values, tip, options), std::abs(answers.growth_load));
  }
  errors.intensity = relative(largest, scale);
  return errors;
}

std::vector<MeshErrors> differences_of(const std::vector<const MeshAnswers*>& meshes, double tolerance) {
  std::vector<MeshErrors> all;
  for (std::size_t k = 1; k < meshes.size(); ++k) all.push_back(difference(*meshes[k], *meshes[k - 1], tolerance));
  return all;
}

}  // namespace

double TipErrors::relative() const { return std::hypot(size, turn); }

double MeshErrors::largest() const { return std::max({displacement, reaction, intensity}); }

MeshErrors operator*(double factor, MeshErrors errors) {
  for (double* error : {&errors.displacement, &errors.reaction, &errors.intensity, &errors.growth_load})
    *error *= factor;
  for (TipErrors& tip : errors.tips) tip.size *= factor, tip.turn *= factor;
  return errors;
}

MeshErrors estimated(const std::vector<const MeshAnswers*>& meshes, double tolerance, const scene::Options& options) {
  return errors_by(of_finest, *meshes.back(), differences_of(meshes, tolerance), options);
}

MeshErrors estimated_by_finer(const MeshAnswers& finer, const MeshAnswers& mesh, double tolerance,
                              const scene::Options& options) {
  const std::vector<MeshErrors> differences{difference(finer, mesh, tolerance)};
  MeshErrors errors = errors_by(of_coarser, finer, differences, options);
  errors.displacement = of_coarser(of_slow_displacement, {differences.front().displacement});
  // The error of the load factor of growth comes from the difference of this load factor between the meshes. Half of
  // the error that follows from the tip's stress intensity factors is the least value, because errors of their length
  // and direction, which have different orders, can cancel in the load factor.
  constexpr double share_of_tip = 0.5;
  errors.growth_load =
      std::max(share_of_tip * errors.growth_load, of_coarser(of_slow_displacement, {differences.front().growth_load}));
  return errors;
}

double expected_reduction(const std::vector<const MeshAnswers*>& meshes, double tolerance,
                          const scene::Options& options) {
  const std::vector<MeshErrors> differences = differences_of(meshes, tolerance);
  const double now = errors_by(of_finest, *meshes.back(), differences, options).largest();
  const double next = errors_by(of_next, *meshes.back(), differences, options).largest();
  return next > 0 ? now / next : std::exp2(of_displacement.usual);
}

}  // namespace bempd::model
