#include "fracture/line/trial_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "fracture/line/deep_points.hpp"
#include "fracture/line/whole_stiffness.hpp"
#include "geometry/turning.hpp"
#include "linalg/adjacency.hpp"

namespace bempd::fracture {

namespace {

// Largest length of a trial step (evaluated but not taken) in spacings. The bonds that a step happens to cut change the
// result by up to 13 % over one spacing, by 2 % over four. Near an edge or a face the step reaches half of the distance
// to it.
constexpr int longest_trial = 4;

// Number of directions that are tried on each side of a given direction.
constexpr int trials_on_each_side = 2;
// Angle between two directions that are tried [rad].
constexpr double angle_between_trials = 10 * std::numbers::pi / 180;

// Relative difference up to which the ratios mean_ratio() of two directions count as equal.
constexpr double ratio_of_ties = 1e-9;

// Least value of TrialGrowth::mean_ratio(), a root of released over taken energy. With a smaller value only rounding
// loads the bonds across a step, as in a piece that only a hinge holds, and the signs of their elongations mean
// nothing.
constexpr double least_ratio = 1e-9;

constexpr int rounds_for_load = 30;
constexpr double load_rounding = 1e-12;
// Relative distance to both sides of a load factor, between which the slope of ratio() over the load factor is
// measured.
constexpr double beside_load = 1e-5;

// Share of a tip's opening that depends on the last bonds that its crack cuts or weakens, measured on straight cracks
// with horizons of 3, 4 and 5 spacings.
constexpr double weakened_follows = 0.5;

// Difference in spacings below which bond vectors count as equal.
constexpr double same_vector = 1e-6;

}  // namespace

CutStiffness::CutStiffness(const coupling::Terms& terms, const pd::TipLaws& laws)
    : terms_(terms), laws_(laws), family_(laws.laws.size()) {
  const linalg::Adjacency bonds_at = linalg::make_adjacency(laws.of_node.size(), [&](const auto& add) {
    for (std::size_t t = 0; t < terms.size(); ++t) {
      if (terms.is_wide(t)) continue;
      add(terms.first[t], static_cast<int>(t));
      add(terms.second[t], static_cast<int>(t));
    }
  });
  const std::vector<double> stiffness = whole_stiffness(terms, laws.weakened);
  const std::vector<std::vector<int>> deep = deep_points(terms, laws);
  for (std::size_t law = 0; law < family_.size(); ++law)
    family_[law] = family_of(terms, stiffness, deep[law], bonds_at, same_vector * laws.laws[law].spacing);
}

// Bonds of a typical inner point: each bond vector with the median of its stiffnesses, because edges change the bonds
// of some of the points.
std::vector<CutStiffness::Bond> CutStiffness::family_of(const coupling::Terms& terms, const std::vector<double>& whole,
                                                        const std::vector<int>& points,
                                                        const linalg::Adjacency& bonds_at, double same) {
  std::map<std::pair<long, long>, std::pair<Point, std::vector<double>>> found;
  for (const int node : points)
    for (const int bond : bonds_at.of(node)) {
      const auto t = static_cast<std::size_t>(bond);
      const Point direction = Point(terms.cosine[t], terms.sine[t]) * (terms.first[t] == node ? 1 : -1);
      const Point vector = terms.length[t] * direction, rounded = vector / same;
      const std::pair key(std::lround(rounded.x()), std::lround(rounded.y()));
      found.try_emplace(key, vector, std::vector<double>()).first->second.second.push_back(whole[t]);
    }
  std::vector<Bond> family;
  for (auto& [key, bond] : found) {
    auto& [vector, stiffness] = bond;
    const auto middle = stiffness.begin() + static_cast<std::ptrdiff_t>(stiffness.size() / 2);
    std::nth_element(stiffness.begin(), middle, stiffness.end());
    // Rounding may give equal bond vectors different keys (rounded coordinates). So each key gets a part of the
    // stiffness, in proportion to the number of points at which it was found.
    family.push_back({vector, *middle * static_cast<double>(stiffness.size()) / static_cast<double>(points.size())});
  }
  return family;
}

// Stiffness across a straight crack that the crack cuts per unit of its length. It is a sum over the bonds of an inner
// point, half of each bond, because the other half belongs to the bond's other point.
double CutStiffness::per_length(int law, const Point& normal) const {
  double sum = 0;
  for (const Bond& bond : family_[static_cast<std::size_t>(law)]) {
    const double across = bond.vector.dot(normal);
    sum += 0.5 * std::abs(across) * bond.stiffness * across * across / bond.vector.squaredNorm();
  }
  const double spacing = laws_.laws[static_cast<std::size_t>(law)].spacing;
  return sum / (spacing * spacing);
}

double CutStiffness::effective_stiffness_of_weakened(std::size_t bond, double stiffness) const {
  const Point vector = terms_.length[bond] * Point(terms_.cosine[bond], terms_.sine[bond]);
  const int law = laws_.of_node[static_cast<std::size_t>(terms_.first[bond])];
  if (law < 0) return stiffness;
  const double same = 2 * same_vector * laws_.laws[static_cast<std::size_t>(law)].spacing;
  const std::vector<Bond>& family = family_[static_cast<std::size_t>(law)];
  const auto whole = std::ranges::find_if(family, [&](const Bond& b) { return (b.vector - vector).norm() < same; });
  if (whole == family.end() || !(stiffness < whole->stiffness)) return stiffness;
  const double gone = 1 - stiffness / whole->stiffness;
  return whole->stiffness * (1 - gone * (1 - weakened_follows) / (1 - weakened_follows * gone));
}

CutStiffness::Counted CutStiffness::of(std::size_t bond, double stiffness, const Point& normal) const {
  const Point along(terms_.cosine[bond], terms_.sine[bond]);
  const double weight = stiffness * std::pow(along.dot(normal), 2);
  std::array<int, 2> law{laws_.of_node[static_cast<std::size_t>(terms_.first[bond])],
                         laws_.of_node[static_cast<std::size_t>(terms_.second[bond])]};
  if (law[0] < 0) law[0] = law[1];
  if (law[1] < 0) law[1] = law[0];
  Counted counted;
  for (const std::size_t end : {0U, 1U}) {
    if (law[end] < 0) continue;
    const pd::TipLaw& its = laws_.laws[static_cast<std::size_t>(law[end])];
    const double length = 0.5 * weight / per_length(law[end], normal);
    const auto node = static_cast<std::size_t>(end == 0 ? terms_.first[bond] : terms_.second[bond]);
    counted.length += length;
    counted.energy +=
        length * its.thickness * its.toughness * its.toughness / its.modulus * laws_.energy_share_at(node);
  }
  return counted;
}

// Extrapolates the energy release rate to the tip. At the distance x along the path the rate is about g exp(c x) times
// the shape of a kink (KinkShape), with g and c from a fit, so its mean over the length s is about g exp(c s / 2) times
// the mean shape. The fracture energy for comparison is that of the first, shortest trial length.
TrialGrowth::AtTip TrialGrowth::at_tip(double load_factor) const {
  double weights = 0, x_mean = 0, y_mean = 0, xx = 0, xy = 0;
  const auto rate = [&](const Length& l) {
    return std::log(energy_.released(l.terms, load_factor) / (l.length * kink_.mean(l.length, load_factor)));
  };
  for (const Length& l : lengths_) weights += l.length, x_mean += l.length * l.length / 2, y_mean += l.length * rate(l);
  x_mean /= weights, y_mean /= weights;
  for (const Length& l : lengths_) {
    const double x = l.length / 2 - x_mean;
    xx += l.length * x * x, xy += l.length * x * (rate(l) - y_mean);
  }
  const double slope = lengths_.size() > 1 && xx > 0 ? xy / xx : 0;
  const double logarithm = y_mean - slope * x_mean, first = lengths_.front().length;
  double off = 0;
  for (const Length& l : lengths_) off += l.length * std::pow(rate(l) - logarithm - slope * l.length / 2, 2) / weights;
  const double taken = lengths_.front().energy / lengths_.front().length;
  const double here = std::sqrt(std::exp(logarithm) / taken);
  return {here, here * std::sqrt(kink_.at(first, load_factor) * std::exp(slope * first)), std::sqrt(off) / 2};
}

double TrialGrowth::mean_ratio(double load_factor) const {
  const Length& all = lengths_.back();
  return std::sqrt(energy_.released(all.terms, load_factor) / all.energy);
}

bool TrialGrowth::opens(double load_factor) const {
  const Eigen::Index terms = lengths_.back().terms;
  return opening_.head(terms).dot(energy_.elongations_without(terms, load_factor)) > 0;
}

// Finds the load factor at which ratio() is one, by the secant method. The last two points of the method nearly
// coincide, so that rounding dominates the slope between them; the slope at the result is computed anew. Without
// constant loads, ratio() is proportional to the load factor, and no iteration is needed.
std::optional<LineLoad> TrialGrowth::load(double nearby, double sense, bool proportional) const {
  LineLoad found;
  if (nearby == 0 || !(mean_ratio(nearby) > least_ratio) || !opens(nearby)) return std::nullopt;
  if (proportional) {
    const double slope = ratio(nearby) / std::abs(nearby);
    const std::optional<double> root = load_ratio(1, slope);
    if (!root) return std::nullopt;
    found.load_factor = std::copysign(*root, nearby), found.growing = std::copysign(slope, nearby);
    return found;
  }
  double before = nearby, here = nearby * (1 + 1e-3), value_before = ratio(before) - 1, slope = 0;
  for (int round = 0; round < rounds_for_load; ++round) {
    const double value = ratio(here) - 1;
    slope = (value - value_before) / (here - before);
    if (!(sense * slope > 0)) return std::nullopt;
    const double next = here - value / slope;
    before = here, value_before = value, here = next;
    if (!(std::abs(here - before) > load_rounding * std::abs(here))) break;
  }
  if (!std::isfinite(here) || !(std::abs(ratio(here) - 1) < 1e-6) || !opens(here)) return std::nullopt;
  const double aside = beside_load * here;
  slope = (ratio(here + aside) - ratio(here - aside)) / (2 * aside);
  if (!(sense * slope > 0)) return std::nullopt;
  found.load_factor = here, found.growing = slope, found.constant = 1 - here * slope;
  return found;
}

TrialSteps::TrialSteps(const coupling::EquilibriumSystem& system, const pd::TipLaws& laws, const LinePath& path)
    : system_(system), path_(path), cut_(system.terms(), laws) {}

// Crack length and fracture energy that the cut of a bond stands for. Bonds at the end of an initial crack may be
// weakened; the first step from there cuts them with their effective stiffness.
CutStiffness::Counted TrialSteps::counted(const GrowingTip& tip, int bond, const Point& normal) const {
  const auto b = static_cast<std::size_t>(bond);
  const double present = system_.stages().stiffness()[b];
  return cut_.of(b, tip.energy_ratios.empty() ? cut_.effective_stiffness_of_weakened(b, present) : present, normal);
}

double TrialSteps::energy_of_step(const GrowingTip& tip, const pd::TipLaw& law, const Point& direction) const {
  double energy = 0;
  for (const int bond : path_.across(tip.place, tip.place + law.spacing * direction, law.horizon))
    energy += counted(tip, bond, left_of(direction)).energy;
  return std::isfinite(energy) ? energy * law.energy_share(tip.grown, direction) : 0;
}

// Trial step in a direction: the terms (bonds and their followers, cell squares) that ever longer steps cut, in this
// order. Empty if no bond lies ahead, or if the body cannot give their flexibility.
std::optional<TrialGrowth> TrialSteps::along(const GrowingTip& tip, const pd::TipLaw& law, const Point& direction,
                                             const coupling::Affine& displacement, TrialBody& body) const {
  const coupling::Terms& terms = system_.terms();
  const int lengths =
      std::clamp(path_.clear_spacings(tip.place, direction, law, 2 * longest_trial) / 2, 1, longest_trial);
  const Point normal = left_of(direction);
  const double share = law.energy_share(tip.grown, direction);
  std::vector<int> order;
  std::vector<char> taken;
  std::vector<TrialGrowth::Length> found;
  CutStiffness::Counted all;
  for (int k = 1; k <= lengths; ++k) {
    std::vector<coupling::StageChange> changes;
    for (const int bond : path_.across(tip.place, tip.place + k * law.spacing * direction, law.horizon)) {
      if (std::find(order.begin(), order.end(), bond) != order.end()) continue;
      const CutStiffness::Counted own = counted(tip, bond, normal);
      all.length += own.length, all.energy += own.energy;
      changes.push_back(terms.breaking(bond));
    }
    for (const coupling::StageChange& c : system_.stages().with_followers(std::move(changes)))
      if (std::find(order.begin(), order.end(), c.term) == order.end()) order.push_back(c.term);
    if (all.length > 0 && std::isfinite(all.energy))
      found.push_back({static_cast<Eigen::Index>(order.size()), all.length, all.energy * share});
  }
  if (found.empty()) return std::nullopt;
  order.resize(static_cast<std::size_t>(found.back().terms));
  Eigen::VectorXd stiffness(found.back().terms), opening(found.back().terms);
  coupling::Affine elongation(found.back().terms, 2);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto t = static_cast<std::size_t>(order[k]);
    const auto row = static_cast<Eigen::Index>(k);
    stiffness[row] = system_.stages().stiffness()[t];
    opening[row] = stiffness[row] * std::pow(Point(terms.cosine[t], terms.sine[t]).dot(normal), 2);
    for (int part = 0; part < 2; ++part)
      elongation(row, part) = terms.elastic_elongation_part(t, displacement.col(part).data(), part);
  }
  const std::optional<Eigen::MatrixXd> flexibility = body.flexibility(order);
  if (!flexibility) return std::nullopt;
  TrialEnergy energy(stiffness, *flexibility, elongation);
  while (!found.empty() && found.back().terms > energy.count()) found.pop_back();
  return found.empty() ? std::nullopt
                       : std::optional(TrialGrowth(std::move(energy), std::move(found), std::move(opening)));
}

// Direction of the largest mean_ratio(): the best of the directions that are tried, refined by the top of a parabola
// through the values of that direction and its two neighbours.
Point TrialSteps::best_direction(const GrowingTip& tip, const pd::TipLaw& law, const Point& around, double load_factor,
                                 const coupling::Affine& displacement, TrialBody& body) const {
  std::array<double, 2 * trials_on_each_side + 1> ratio{};
  for (int k = -trials_on_each_side; k <= trials_on_each_side; ++k) {
    const auto growth = along(tip, law, turned(around, k * angle_between_trials), displacement, body);
    ratio[static_cast<std::size_t>(k + trials_on_each_side)] = growth ? growth->mean_ratio(load_factor) : 0;
  }
  // The direction nearest to `around` is chosen if the ratios of several directions are equal up to rounding.
  int best = trials_on_each_side;
  for (const int k : {-1, 1, -2, 2})
    if (ratio[static_cast<std::size_t>(trials_on_each_side + k)] >
        (1 + ratio_of_ties) * ratio[static_cast<std::size_t>(best)])
      best = trials_on_each_side + k;
  double aside = best - trials_on_each_side;
  if (best > 0 && best < 2 * trials_on_each_side) {
    const auto b = static_cast<std::size_t>(best);
    const double bend = ratio[b - 1] - 2 * ratio[b] + ratio[b + 1];
    if (bend < 0) aside += (ratio[b - 1] - ratio[b + 1]) / (2 * bend);
  }
  return turned(around, aside * angle_between_trials);
}

}  // namespace bempd::fracture
