#include "fracture/bonds_across.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "linalg/adjacency.hpp"

namespace bempd::fracture {

namespace {

// Tolerance for the cosine of right angles between bonds, and relative tolerance for equal lengths of bonds.
constexpr double same = 1e-9;

// Largest sum of the squares of the weights with which two bonds give the strain across a third; estimates with larger
// weights are too inaccurate.
constexpr double most_weight = 16;

}  // namespace

BondsAcross::BondsAcross(const coupling::Terms& terms) {
  if (terms.contraction.empty()) return;
  const std::size_t count = terms.size();
  contraction_.resize(count);
  for (std::size_t t = 0; t < count; ++t) contraction_[t] = terms.contraction_of(t);
  int nodes = 0;
  for (std::size_t t = 0; t < count; ++t) nodes = std::max({nodes, terms.first[t] + 1, terms.second[t] + 1});
  const linalg::Adjacency bonds_of = linalg::make_adjacency(static_cast<std::size_t>(nodes), [&](const auto& add) {
    for (std::size_t t = 0; t < count; ++t) {
      if (terms.is_wide(t) || contraction_[t] == 0) continue;  // cell squares, and bonds without Poisson's effect
      add(terms.first[t], static_cast<int>(t));
      add(terms.second[t], static_cast<int>(t));
    }
  });
  for (std::size_t t = 0; t < count; ++t) {
    if (contraction_[t] > 0) {
      const int ends[] = {terms.first[t], terms.second[t]};
      for (const int node : ends) add_at_right_angles(terms, t, bonds_of.of(node));
      if (estimates_.size() == start_.back())
        for (const int node : ends) add_by_two(terms, t, bonds_of.of(node));
    }
    start_.push_back(estimates_.size());
  }
}

void BondsAcross::add_at_right_angles(const coupling::Terms& terms, std::size_t bond, std::span<const int> at_node) {
  for (const int other : at_node) {
    const auto o = static_cast<std::size_t>(other);
    const double cosine = terms.cosine[bond] * terms.cosine[o] + terms.sine[bond] * terms.sine[o];
    if (std::abs(cosine) < same && std::abs(terms.length[o] - terms.length[bond]) < same * terms.length[bond])
      estimates_.push_back({{other, other}, 0, {0.5, 0.5}});
  }
}

// Adds an estimate of the strain b across `bond`, from two other bonds at its node: the pair with the smallest weights.
// If a is the strain along `bond` and g the shear strain, a bond at the angle f to it has the strain a cos^2 f + b
// sin^2 f + g sin f cos f; a combination of two bonds eliminates g.
void BondsAcross::add_by_two(const coupling::Terms& terms, std::size_t bond, std::span<const int> at_node) {
  std::optional<Estimate> best;
  double least = most_weight;
  const auto angle = [&](int other) {
    const auto o = static_cast<std::size_t>(other);
    return std::pair(terms.cosine[bond] * terms.cosine[o] + terms.sine[bond] * terms.sine[o],
                     terms.cosine[bond] * terms.sine[o] - terms.sine[bond] * terms.cosine[o]);
  };
  for (const int one : at_node) {
    for (const int other : at_node) {
      if (other <= one) continue;
      const auto [c, s] = angle(one);
      const auto [d, t] = angle(other);
      const double area = s * t * (s * d - t * c);  // determinant of sin^2 and sin cos of the two bonds
      if (!(std::abs(area) > same)) continue;
      const double first = t * d / area, second = -s * c / area;
      const double weights = first * first + second * second;
      if (weights >= least) continue;
      least = weights;
      const double own = -(first * c * c + second * d * d);
      best = Estimate{{one, other},
                      own,
                      {first * terms.length[bond] / terms.length[static_cast<std::size_t>(one)],
                       second * terms.length[bond] / terms.length[static_cast<std::size_t>(other)]}};
    }
  }
  if (best) estimates_.push_back(*best);
}

BondsAcross BondsAcross::chosen(std::span<const int> number, const std::function<int(int)>& place_of,
                                const std::function<bool(int)>& counts) const {
  BondsAcross result;
  if (empty()) return result;
  for (const int bond : number) {
    bool known = is_known(static_cast<std::size_t>(bond));
    for (Estimate estimate : of(static_cast<std::size_t>(bond))) {
      if (!counts(estimate.bonds[0]) || !counts(estimate.bonds[1])) continue;
      for (int& other : estimate.bonds) {
        other = place_of(other);
        known = known && other >= 0;
      }
      result.estimates_.push_back(estimate);
    }
    if (!known) result.estimates_.resize(result.start_.back());
    result.contraction_.push_back(contraction_[static_cast<std::size_t>(bond)]);
    result.known_.push_back(known ? 1 : 0);
    result.start_.push_back(result.estimates_.size());
  }
  return result;
}

void BondsAcross::relieve(const std::vector<double>& constant, const std::vector<double>& proportional,
                          const std::vector<double>& scale, const std::vector<char>& present,
                          AffineRelief& relief) const {
  relief.constant.assign(contraction_.size(), 0.0);
  relief.proportional.assign(contraction_.size(), 0.0);
  for (std::size_t b = 0; b < contraction_.size(); ++b) {
    double sum[2] = {0, 0};
    int count = 0;
    if (!present[b]) continue;
    for (const Estimate& estimate : of(b)) {
      const auto first = static_cast<std::size_t>(estimate.bonds[0]),
                 second = static_cast<std::size_t>(estimate.bonds[1]);
      if (!present[first] || !present[second] || scale[first] == 0 || scale[second] == 0) continue;
      const double one = estimate.of[0] * scale[b] / scale[first], other = estimate.of[1] * scale[b] / scale[second];
      sum[0] += estimate.own * constant[b] + one * constant[first] + other * constant[second];
      sum[1] += estimate.own * proportional[b] + one * proportional[first] + other * proportional[second];
      ++count;
    }
    if (count == 0) continue;
    const double nu = contraction_[b], factor = -nu / (1 - nu * nu);
    relief.constant[b] = factor * (sum[0] / count + nu * constant[b]);
    relief.proportional[b] = factor * (sum[1] / count + nu * proportional[b]);
  }
}

}  // namespace bempd::fracture
