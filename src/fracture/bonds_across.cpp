#include "fracture/bonds_across.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bempd::fracture {

namespace {

// Up to which directions are at right angles and lengths equal.
constexpr double same = 1e-9;

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
      if (terms.is_wide(t)) continue;
      add(terms.first[t], static_cast<int>(t));
      add(terms.second[t], static_cast<int>(t));
    }
  });
  const auto is_across = [&](std::size_t bond, int other) {
    const auto o = static_cast<std::size_t>(other);
    const double cosine = terms.cosine[bond] * terms.cosine[o] + terms.sine[bond] * terms.sine[o];
    return std::abs(cosine) < same && std::abs(terms.length[o] - terms.length[bond]) < same * terms.length[bond];
  };
  across_.offset.assign(1, 0);
  for (std::size_t t = 0; t < count; ++t) {
    if (contraction_[t] > 0) {
      for (const int node : {terms.first[t], terms.second[t]}) {
        for (const int other : bonds_of.of(node))
          if (is_across(t, other)) across_.value.push_back(other);
      }
    }
    across_.offset.push_back(static_cast<int>(across_.value.size()));
  }
}

BondsAcross BondsAcross::chosen(std::span<const int> number, const std::function<int(int)>& place_of,
                                const std::function<bool(int)>& counts) const {
  BondsAcross result;
  if (empty()) return result;
  for (const int bond : number) {
    const auto begin = static_cast<std::ptrdiff_t>(result.across_.value.size());
    bool known = is_known(static_cast<std::size_t>(bond));
    for (const int other : of(static_cast<std::size_t>(bond))) {
      if (!counts(other)) continue;
      result.across_.value.push_back(place_of(other));
      known = known && result.across_.value.back() >= 0;
    }
    if (!known) result.across_.value.erase(result.across_.value.begin() + begin, result.across_.value.end());
    result.contraction_.push_back(contraction_[static_cast<std::size_t>(bond)]);
    result.known_.push_back(known ? 1 : 0);
    result.across_.offset.push_back(static_cast<int>(result.across_.value.size()));
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
    for (const int other : of(b)) {
      const auto o = static_cast<std::size_t>(other);
      if (!present[o] || scale[o] == 0) continue;
      const double to_own = scale[b] / scale[o];
      sum[0] += constant[o] * to_own;
      sum[1] += proportional[o] * to_own;
      ++count;
    }
    if (count == 0) continue;
    const double nu = contraction_[b], factor = -nu / (1 - nu * nu);
    relief.constant[b] = factor * (sum[0] / count + nu * constant[b]);
    relief.proportional[b] = factor * (sum[1] / count + nu * proportional[b]);
  }
}

}  // namespace bempd::fracture
