#include "regions/lattice/scene_bonds.hpp"

namespace bempd::regions {

std::vector<std::uint8_t> SceneBonds::broken(const std::vector<char>& intact) const {
  std::vector<std::uint8_t> flags(all().size());
  for (std::size_t b = 0; b < flags.size(); ++b) flags[b] = intact[number(b)] ? 0 : 1;
  return flags;
}

pd::BondStates SceneBonds::states(const Solution& solution) const {
  const coupling::Terms& terms = solution.bonds;
  pd::BondStates states;
  for (std::size_t b = 0; b < all().size(); ++b) {
    const std::size_t term = number(b);
    const double share = !solution.intact[term] ? 0
                         : solution.stages      ? terms.law_of(term).stiffness_share((*solution.stages)[term])
                                                : 1;
    states.share.push_back(share);
    if (!terms.have_offsets()) continue;
    const double rest = terms.rest(term, 0) + solution.load_factor * terms.rest(term, 1);
    states.rest_stretch.push_back(rest / terms.length[term]);
  }
  return states;
}

std::vector<double> SceneBonds::damage(const std::vector<char>& intact, std::size_t points) const {
  std::vector<int> there(points + far_points.size(), 0), left(there.size(), 0);
  for (std::size_t b = 0; b < all().size(); ++b) {
    for (const int point : {all()[b].first, all()[b].second}) {
      ++there[static_cast<std::size_t>(point)];
      left[static_cast<std::size_t>(point)] += intact[number(b)];
    }
  }
  std::vector<double> values(points, 0.0);
  for (std::size_t i = 0; i < points; ++i)
    if (there[i] > 0) values[i] = 1 - static_cast<double>(left[i]) / there[i];
  return values;
}

std::vector<double> SceneBonds::stretch(const Solution& solution) const {
  std::vector<double> values;
  for (std::size_t b = first; b < first + listed; ++b)
    values.push_back(solution.bonds.elastic_elongation(b, solution.displacement.data(), solution.load_factor) /
                     solution.bonds.length[b]);
  return values;
}

}  // namespace bempd::regions
