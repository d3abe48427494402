#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/term_law.hpp"
#include "geometry/elongation.hpp"

namespace bempd::coupling {

struct Terms;

// Factors that turn elastic elongations of terms into shares of the terms' critical elongations. The directions of
// bonds are stored with these factors included: their product with the difference of the end displacements is such a
// share.
struct CriticalScales {
  std::vector<double> per_elongation;  // [1/m]
  std::vector<double> cosine, sine;

  explicit CriticalScales(std::size_t count = 0) : per_elongation(count), cosine(count), sine(count) {}
  // Sets factor number `place` to that of term number `term`; an infinite critical stretch makes it 0.
  void set(std::size_t place, const Terms& terms, std::size_t term, double critical_stretch);
};

// Coefficients (x, y) with which the displacement of a node enters the elongation of a term.
struct TermEntry {
  int node;
  double x, y;
  bool operator==(const TermEntry&) const = default;
};

// Energy terms, which are squares of the displacements u: each is k/2 (c.u - e0)^2 with its coefficients c, elongation
// c.u [m], stiffness k [N/m] and rest elongation e0 [m], which has a constant part and a part that is proportional to
// the load factor.
//
// A bond is the term of two nodes with the coefficients -n and n, where n is the unit vector from the first to the
// second node. Stepping sweeps over all bonds at every event, hence the structure of arrays. Terms of any other shape
// are called wide, such as a cell square (term of a lattice cell that corrects Poisson's ratio). They are numbered
// together with the bonds: their `first` and `second` are the same node and their direction is 0, so that sweeps over
// the arrays of bonds add nothing for them.
struct Terms {
  std::vector<int> first, second;    // nodes
  std::vector<double> cosine, sine;  // unit vector from first to second
  std::vector<double> length;        // length [m] that turns an elongation into a strain
  std::vector<double> stiffness;     // force per elongation [N/m]

  // Rest elongations [m]: constant parts, then proportional parts. Terms beyond the end of an array have the rest
  // elongation 0; the arrays are empty if all rest elongations are 0.
  std::array<std::vector<double>, 2> rest_elongation;  // [m]

  // Poisson's ratio of bonds whose stretch also counts compression across them; 0 for other bonds, and for terms beyond
  // the end.
  std::vector<double> contraction;

  // Law of each term (its damage stages) as an index into `laws`; terms beyond the end are brittle.
  std::vector<std::uint8_t> law;
  std::vector<TermLaw> laws{TermLaw::brittle()};

  // Coefficients of the wide terms (energy terms that are not bonds).
  struct Wide {
    std::vector<int> term;  // numbers of the wide terms, ascending
    std::vector<std::size_t> start{0};
    std::vector<TermEntry> entry;

    std::span<const TermEntry> entries(std::size_t k) const {
      return {entry.data() + start[k], start[k + 1] - start[k]};
    }
  };
  Wide wide;

  // Pair of a term (leader) and its follower: when the leader breaks, the follower breaks, too. Followers do not break
  // by themselves. Pairs are sorted by leaders once all of them have been added.
  struct Following {
    int leader, follower;
    auto operator<=>(const Following&) const = default;
  };
  std::vector<Following> following;
  std::vector<int> followers;  // numbers of all followers, ascending
  std::size_t wide_followers = 0;

  std::size_t size() const { return first.size(); }
  std::size_t bond_count() const { return size() - wide.term.size(); }
  bool is_wide(std::size_t term) const { return first[term] == second[term]; }

  // Functions that add a term return its number.
  int add_bond(int from, int to, const Eigen::Vector2d& direction, double length_between, double its_stiffness);
  int add_wide(std::span<const TermEntry> entries_of_different_nodes, double its_length, double its_stiffness);

  // Makes the term `follower` break as soon as any of its leaders breaks. Leaders must have smaller numbers. Called
  // once for every follower, in the order of their numbers.
  void add_follower(int follower, std::span<const int> leaders);
  bool follows(int term) const { return std::binary_search(followers.begin(), followers.end(), term); }
  bool wide_terms_only_follow() const { return wide_followers == wide.term.size(); }

  void set_rest_elongation(int term, double constant, double proportional = 0);

  void set_contraction(int term, double ratio);
  double contraction_of(std::size_t term) const { return term < contraction.size() ? contraction[term] : 0; }

  int add_law(const TermLaw& its_law);  // returns the index of the law in `laws`
  void set_law(int term, int its_law);
  const TermLaw& law_of(std::size_t term) const { return term < law.size() ? laws[law[term]] : laws.front(); }

  bool is_broken(std::size_t term, int stage) const { return law_of(term).is_broken(stage); }
  // Stage change that breaks a term, whatever its present stage is.
  StageChange breaking(int term) const { return {term, law_of(static_cast<std::size_t>(term)).broken_stage()}; }
  // Numbers of the terms that `changes` break.
  std::vector<int> broken_by(std::span<const StageChange> changes) const;

  // Whether some term has a rest elongation, and so a force without elongation.
  bool have_offsets() const { return have_offsets(0) || have_offsets(1); }
  bool have_offsets(int part) const { return !rest_elongation[part].empty(); }

  // Rest elongation e0 of a term: its constant part (0) or its proportional part (1).
  double rest(std::size_t term, int part) const {
    const std::vector<double>& values = rest_elongation[part];
    return term < values.size() ? values[term] : 0;
  }

  // Calls visit(node, x, y) for every node of a term, where (x, y) are the node's coefficients.
  template <class Visit>
  void for_each_entry(std::size_t term, const Visit& visit) const {
    if (is_wide(term)) {
      for (const TermEntry& e : wide.entries(place_of_wide(term))) visit(e.node, e.x, e.y);
    } else {
      visit(first[term], -cosine[term], -sine[term]);
      visit(second[term], cosine[term], sine[term]);
    }
  }
  template <class Visit>
  void for_each_node(std::size_t term, const Visit& visit) const {
    for_each_entry(term, [&](int node, double, double) { visit(node); });
  }

  // Elongation c.u of a term; displacements are numbered 2 * node + component.
  double elongation(std::size_t term, const double* displacement) const {
    return is_wide(term) ? wide_elongation(place_of_wide(term), displacement) : bond_elongation(term, displacement);
  }

  // Elastic elongation c.u - e0 of a term, on which its stiffness acts, in the constant (0) or proportional (1) part of
  // a displacement.
  double elastic_elongation_part(std::size_t term, const double* displacement, int part) const {
    return elongation(term, displacement) - rest(term, part);
  }
  // Elastic elongation of a term for a displacement at a load factor.
  double elastic_elongation(std::size_t term, const double* displacement, double load_factor) const {
    return elongation(term, displacement) - (rest(term, 0) + load_factor * rest(term, 1));
  }

  // Force k (c.u - e0) of a term with the given stiffness k, which may be less than the virgin stiffness.
  double tension(std::size_t term, double present_stiffness, const double* displacement, double load_factor) const {
    return present_stiffness * elastic_elongation(term, displacement, load_factor);
  }

  // Energy k/2 (c.u - e0)^2 of a term with the given stiffness k, which may be less than the virgin stiffness.
  double energy(std::size_t term, double present_stiffness, const double* displacement, double load_factor) const {
    const double elastic = elastic_elongation(term, displacement, load_factor);
    return 0.5 * present_stiffness * elastic * elastic;
  }

  CriticalScales critical_scales(const std::vector<double>& critical_stretch) const;

  // Elastic elongations of all terms as shares of their critical elongations, separately for the constant and the
  // proportional part of a displacement.
  void critical_shares(const Affine& displacement, const CriticalScales& scales, std::vector<double>& constant_part,
                       std::vector<double>& proportional_part) const;

  // Adds to `force` the forces k (c.u) c of all terms with the stiffnesses k, coefficients c and displacements u; rest
  // elongations are left out.
  void add_forces(const std::vector<double>& present_stiffness, const double* displacement, double* force) const;

 private:
  std::size_t place_of_wide(std::size_t term) const {
    return static_cast<std::size_t>(std::lower_bound(wide.term.begin(), wide.term.end(), static_cast<int>(term)) -
                                    wide.term.begin());
  }
  double bond_elongation(std::size_t bond, const double* displacement) const {
    const double* a = displacement + 2 * first[bond];
    const double* b = displacement + 2 * second[bond];
    return elongation_along(cosine[bond], sine[bond], b[0] - a[0], b[1] - a[1]);
  }
  double wide_elongation(std::size_t place, const double* displacement) const {
    double sum = 0;
    for (const TermEntry& e : wide.entries(place))
      sum += e.x * displacement[2 * e.node] + e.y * displacement[2 * e.node + 1];
    return sum;
  }
};

}  // namespace bempd::coupling
