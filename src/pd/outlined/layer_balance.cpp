#include "pd/outlined/layer_balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "cancellation.hpp"
#include "linalg/disjoint_sets.hpp"
#include "linalg/profile_cholesky.hpp"
#include "parallel.hpp"

namespace bempd::pd {

namespace {

using Eigen::Vector4d;
using Eigen::VectorXd;
using linalg::ProfileCholesky;

constexpr double balanced = 1e-14;  // for values and equations of order one

// Free bonds that share no point with others, and their points.
struct Part {
  std::vector<int> bonds, points;
};

struct Parts {
  std::vector<Part> parts;
  std::vector<int> number;  // of every point in its part
};

Parts parts_of(const OutlinedBonds& bonds, std::size_t point_count) {
  linalg::DisjointSets sets(static_cast<int>(point_count));
  for (const OutlinedBond& b : bonds.bonds)
    if (b.free) sets.join(b.first, b.second);
  Parts found;
  found.number.assign(point_count, -1);
  std::vector<int> part_of(point_count, -1);
  for (std::size_t b = 0; b < bonds.bonds.size(); ++b) {
    const OutlinedBond& bond = bonds.bonds[b];
    if (!bond.free) continue;
    int& part = part_of[sets.find(bond.first)];
    if (part < 0) {
      part = static_cast<int>(found.parts.size());
      found.parts.emplace_back();
    }
    Part& own = found.parts[part];
    own.bonds.push_back(static_cast<int>(b));
    for (const int point : {bond.first, bond.second}) {
      if (found.number[point] >= 0) continue;
      found.number[point] = static_cast<int>(own.points.size());
      own.points.push_back(point);
    }
  }
  return found;
}

// Primal-dual active sets (Hintermueller, Ito, Kunisch 2002) as in linalg::solve_long_least_change(), with the normal
// equations in an order in which points along the outline come one after the other.
class PartBalance {
 public:
  PartBalance(const OutlinedBonds& all, const Part& part, const std::vector<int>& number,
              const std::vector<Vector4d>& missing, double lower)
      : lower_(lower) {
    bonds_.reserve(part.bonds.size());
    for (const int b : part.bonds) {
      const OutlinedBond& bond = all.bonds[b];
      const BondOffset& offset = all.offsets[bond.offset];
      bonds_.push_back({number[bond.first], number[bond.second], offset.bulk_stiffness * offset.moment,
                        bond.stiffness / offset.bulk_stiffness, 0.0, false});
    }
    const std::vector<int> order = order_of(part.points.size());
    std::vector<int> place(order.size()), first(order.size());
    target_.resize(4 * static_cast<Eigen::Index>(order.size()));
    for (std::size_t k = 0; k < order.size(); ++k) {
      place[order[k]] = first[k] = static_cast<int>(k);
      target_.segment<4>(4 * static_cast<Eigen::Index>(k)) = missing[part.points[order[k]]];
    }
    for (Bond& b : bonds_) {
      b.first = place[b.first], b.second = place[b.second];
      int& earliest = first[std::max(b.first, b.second)];
      earliest = std::min({earliest, b.first, b.second});
      add_moment(b, b.start, target_);
    }
    normal_ = std::make_unique<ProfileCholesky>(first);
  }

  // Mostly the first digits of the multipliers tell which values are held at the bound.
  bool solve() {
    constexpr int most_rounds = 20;
    bool rough = true;
    for (int round = 0; round < most_rounds; ++round) {
      if (!factorize()) return false;
      start_over();
      if (rough) {
        const double before = target_.lpNorm<Eigen::Infinity>();
        if (approach(1, 1) > hopeless * before) return false;
        if (update_held()) continue;
      }
      rough = false;
      const double left = approach(8, 30);
      if (!hold_more()) return left < 1e-12;
    }
    return false;
  }

  double value(std::size_t bond) const { return bonds_[bond].value; }

 private:
  // Of what is missing after one step: the equations contradict each other.
  static constexpr double hopeless = 0.1;

  struct Bond {
    int first, second;
    Vector4d moment;      // of the kernel's stiffness
    double start, value;  // over the kernel's
    bool held;
  };

  static void add_moment(const Bond& b, double value, VectorXd& sum) {
    sum.segment<4>(4 * static_cast<Eigen::Index>(b.first)) += value * b.moment;
    sum.segment<4>(4 * static_cast<Eigen::Index>(b.second)) -= value * b.moment;
  }
  static double pull(const Bond& b, const VectorXd& lambda) {
    return b.moment.dot(lambda.segment<4>(4 * static_cast<Eigen::Index>(b.first)) -
                        lambda.segment<4>(4 * static_cast<Eigen::Index>(b.second)));
  }

  std::vector<int> order_of(std::size_t count) const {
    std::vector<int> start(count + 1, 0);
    for (const Bond& b : bonds_) ++start[b.first + 1], ++start[b.second + 1];
    for (std::size_t i = 0; i < count; ++i) start[i + 1] += start[i];
    std::vector<int> at(start.begin(), start.end() - 1), neighbours(2 * bonds_.size());
    for (const Bond& b : bonds_) {
      neighbours[at[b.first]++] = b.second;
      neighbours[at[b.second]++] = b.first;
    }
    return linalg::close_order(start, neighbours);
  }

  // Rows depend on each other, so the diagonal takes a shift near rounding.
  bool factorize() {
    for (double shift = 3e-17; shift < 1e-11; shift *= 10) {
      normal_->clear();
      for (const Bond& b : bonds_) {
        if (b.held) continue;
        const Eigen::Matrix4d square = b.moment * b.moment.transpose();
        normal_->at(b.first, b.first) += square;
        normal_->at(b.second, b.second) += square;
        normal_->at(std::max(b.first, b.second), std::min(b.first, b.second)) -= square;
      }
      if (normal_->factorize(shift * normal_->largest_diagonal())) return true;
    }
    return false;
  }

  void start_over() {
    lambda_ = VectorXd::Zero(target_.size());
    for (Bond& b : bonds_) b.value = b.held ? lower_ : b.start;
    is_rough_ = true;
  }

  // Conjugate gradients for the multipliers, the values of free bonds following them; returns what is missing.
  double approach(int most_rounds, int most_steps) {
    double left = 0, before = HUGE_VAL;
    for (int round = 0; round <= most_rounds; ++round) {
      VectorXd r = target_;
      for (const Bond& b : bonds_) add_moment(b, -b.value, r);
      left = r.lpNorm<Eigen::Infinity>();
      if (round == most_rounds || left <= balanced || left > 0.5 * before) break;
      before = left;
      descend(std::move(r), std::max(1e-13 * left, balanced), most_steps);
      is_rough_ = false;
    }
    return left;
  }
  void descend(VectorXd r, double goal, int most_steps) {
    VectorXd z = precondition(r), p = z;
    double rz = r.dot(z);
    for (int step = 0; step < most_steps && rz > 0; ++step) {
      check_cancelled();
      const VectorXd q = product(p);
      const double curvature = p.dot(q);
      if (!(curvature > 0) || rz / std::numeric_limits<double>::max() >= curvature) break;
      const double alpha = rz / curvature;
      lambda_ += alpha * p;
      for (Bond& b : bonds_)
        if (!b.held) b.value += alpha * pull(b, p);
      r -= alpha * q;
      if (r.lpNorm<Eigen::Infinity>() <= goal) break;
      z = precondition(r);
      const double next = r.dot(z);
      p = z + next / rz * p;
      rz = next;
    }
  }
  // With the normal matrix N.
  VectorXd product(const VectorXd& p) const {
    VectorXd q = VectorXd::Zero(target_.size());
    for (const Bond& b : bonds_)
      if (!b.held) add_moment(b, pull(b, p), q);
    return q;
  }
  // F^-1 with the factor F, and F^-1 N F^-1 once what is missing is so small that its rounding in the kernel of N would
  // drown the rest (linalg/minimum_norm.hpp).
  VectorXd precondition(VectorXd r) const {
    normal_->solve_in_place(r);
    if (is_rough_) return r;
    r = product(r);
    normal_->solve_in_place(r);
    return r;
  }

  // Those that the multipliers would take below the bound; whether they have changed.
  bool update_held() {
    bool changed = false;
    for (Bond& b : bonds_) {
      // A margin keeps rounding from letting a value change sides for ever.
      const bool next = b.start + pull(b, lambda_) < lower_ + (b.held ? 1e-12 : -1e-12);
      changed = changed || next != b.held;
      b.held = next;
    }
    return changed;
  }

  // Those that are below the bound.
  bool hold_more() {
    bool changed = false;
    for (Bond& b : bonds_) {
      if (b.value >= lower_ - 1e-12) continue;
      b.held = changed = true;
    }
    return changed;
  }

  double lower_;
  std::vector<Bond> bonds_;
  VectorXd target_, lambda_;
  std::unique_ptr<ProfileCholesky> normal_;
  bool is_rough_ = true;
};

}  // namespace

bool balance_layer(const std::vector<Point>& surface, double lower, int threads, OutlinedBonds& bonds) {
  const std::vector<Vector4d> missing = missing_moments(surface, bonds);
  const Parts all = parts_of(bonds, surface.size());
  std::vector<char> done(all.parts.size(), 0);
  parallel_for(all.parts.size(), threads, [&](std::size_t p) {
    const Part& part = all.parts[p];
    PartBalance balance(bonds, part, all.number, missing, lower);
    if (!balance.solve()) return;
    done[p] = 1;
    for (std::size_t k = 0; k < part.bonds.size(); ++k) {
      OutlinedBond& b = bonds.bonds[part.bonds[k]];
      b.stiffness = balance.value(k) * bonds.offsets[b.offset].bulk_stiffness;
    }
  });
  return std::all_of(done.begin(), done.end(), [](char one) { return one != 0; });
}

}  // namespace bempd::pd
