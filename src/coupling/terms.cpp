#include "coupling/terms.hpp"

#include <cassert>

namespace bempd::coupling {

int Terms::add_bond(int from, int to, const Eigen::Vector2d& direction, double length_between, double its_stiffness) {
  assert(from != to);
  first.push_back(from);
  second.push_back(to);
  cosine.push_back(direction.x());
  sine.push_back(direction.y());
  length.push_back(length_between);
  stiffness.push_back(its_stiffness);
  return static_cast<int>(size()) - 1;
}

int Terms::add_wide(std::span<const TermEntry> entries, double its_length, double its_stiffness) {
  assert(!entries.empty());
  const int term = static_cast<int>(size());
  first.push_back(entries.front().node);
  second.push_back(entries.front().node);
  cosine.push_back(0);
  sine.push_back(0);
  length.push_back(its_length);
  stiffness.push_back(its_stiffness);
  wide.term.push_back(term);
  wide.entry.insert(wide.entry.end(), entries.begin(), entries.end());
  wide.start.push_back(wide.entry.size());
  return term;
}

void Terms::add_follower(int follower, std::span<const int> leaders) {
  assert(followers.empty() || followers.back() < follower);
  followers.push_back(follower);
  if (is_wide(static_cast<std::size_t>(follower))) ++wide_followers;
  for (int leader : leaders) {
    assert(leader < follower);
    following.push_back({leader, follower});
  }
}

void Terms::set_rest_elongation(int term, double constant, double proportional) {
  const double parts[2] = {constant, proportional};
  for (int part = 0; part < 2; ++part) {
    std::vector<double>& list = rest_elongation[part];
    const auto place = static_cast<std::size_t>(term);
    if (parts[part] == 0 && place >= list.size()) continue;
    if (list.size() <= place) list.resize(place + 1, 0.0);
    list[place] = parts[part];
  }
}

void Terms::set_contraction(int term, double ratio) {
  const auto place = static_cast<std::size_t>(term);
  if (contraction.size() <= place) contraction.resize(place + 1, 0.0);
  contraction[place] = ratio;
}

int Terms::add_law(const TermLaw& its_law) {
  const auto same = std::find(laws.begin(), laws.end(), its_law);
  if (same != laws.end()) return static_cast<int>(same - laws.begin());
  laws.push_back(its_law);
  assert(laws.size() <= 256);
  return static_cast<int>(laws.size()) - 1;
}

void Terms::set_law(int term, int its_law) {
  const auto place = static_cast<std::size_t>(term);
  if (law.size() <= place) law.resize(place + 1, 0);
  law[place] = static_cast<std::uint8_t>(its_law);
}

void CriticalScales::set(std::size_t place, const Terms& terms, std::size_t term, double critical_stretch) {
  const double scale = 1 / (terms.length[term] * critical_stretch);
  per_elongation[place] = scale;
  cosine[place] = terms.cosine[term] * scale;
  sine[place] = terms.sine[term] * scale;
}

CriticalScales Terms::critical_scales(const std::vector<double>& critical_stretch) const {
  CriticalScales scales(size());
  for (std::size_t t = 0; t < size(); ++t) scales.set(t, *this, t, critical_stretch[t]);
  return scales;
}

void Terms::critical_shares(const Affine& displacement, const CriticalScales& scales,
                            std::vector<double>& constant_part, std::vector<double>& proportional_part) const {
  const double* at_zero = displacement.col(0).data();
  const double* slope = displacement.col(1).data();
  for (std::size_t t = 0; t < size(); ++t) {
    const int i = 2 * first[t], j = 2 * second[t];
    const double c = scales.cosine[t], s = scales.sine[t];
    constant_part[t] = elongation_along(c, s, at_zero[j] - at_zero[i], at_zero[j + 1] - at_zero[i + 1]);
    proportional_part[t] = elongation_along(c, s, slope[j] - slope[i], slope[j + 1] - slope[i + 1]);
  }
  for (std::size_t k = 0; k < wide.term.size(); ++k) {
    const int t = wide.term[k];
    constant_part[t] = wide_elongation(k, at_zero) * scales.per_elongation[t];
    proportional_part[t] = wide_elongation(k, slope) * scales.per_elongation[t];
  }
  for (int part = 0; part < 2; ++part) {
    std::vector<double>& shares = part == 0 ? constant_part : proportional_part;
    for (std::size_t t = 0; t < rest_elongation[part].size(); ++t) {
      shares[t] -= rest_elongation[part][t] * scales.per_elongation[t];
    }
  }
}

void Terms::add_forces(const std::vector<double>& present_stiffness, const double* u, double* f) const {
  for (std::size_t b = 0; b < size(); ++b) {
    const double tension = present_stiffness[b] * bond_elongation(b, u);
    const double fx = tension * cosine[b], fy = tension * sine[b];
    f[2 * first[b]] -= fx;
    f[2 * first[b] + 1] -= fy;
    f[2 * second[b]] += fx;
    f[2 * second[b] + 1] += fy;
  }
  for (std::size_t k = 0; k < wide.term.size(); ++k) {
    const double tension = present_stiffness[wide.term[k]] * wide_elongation(k, u);
    for (const TermEntry& e : wide.entries(k)) {
      f[2 * e.node] += tension * e.x;
      f[2 * e.node + 1] += tension * e.y;
    }
  }
}

std::vector<int> Terms::broken_by(std::span<const StageChange> changes) const {
  std::vector<int> broken;
  for (const StageChange& c : changes) {
    if (is_broken(static_cast<std::size_t>(c.term), c.stage)) broken.push_back(c.term);
  }
  return broken;
}

}  // namespace bempd::coupling
