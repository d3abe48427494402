#include "pd/layer_balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "cancellation.hpp"
#include "linalg/blas.hpp"
#include "linalg/profile_cholesky.hpp"
#include "parallel.hpp"
#include "pd/outlined/killing_tensors.hpp"

namespace bempd::pd {

namespace {

using Eigen::Vector4d;
using Eigen::VectorXd;
using linalg::ProfileCholesky;

constexpr double balance_tolerance = 1e-14;  // for values and equations of order one

// Least change of the bond stiffnesses in one part of a layer that balances the part's points. It is found by
// primal-dual active sets (Hintermueller, Ito, Kunisch 2002) as in solve_long_least_change() of linalg, with the normal
// equations in the order of points along the outline. Values are stiffnesses relative to the bulk stiffness.
class PartBalance {
 public:
  PartBalance(const DraftBonds& all, const LayerParts::Part& part, const std::vector<int>& number,
              const std::vector<Vector4d>& missing, double lower)
      : lower_(lower) {
    bonds_.reserve(part.bonds.size());
    for (const int b : part.bonds) {
      const DraftBond& bond = all.bonds[b];
      const BondOffset& offset = all.offsets[bond.offset];
      bonds_.push_back({number[bond.first], number[bond.second], offset.bulk_stiffness * offset.moment,
                        bond.stiffness / offset.bulk_stiffness, 0.0, false});
    }
    order_ = order_of(all, part, number);
    std::vector<int> place(order_.size()), first(order_.size());
    target_.resize(4 * static_cast<Eigen::Index>(order_.size()));
    for (std::size_t k = 0; k < order_.size(); ++k) {
      const int point = part.points[order_[k]];
      place[order_[k]] = first[k] = static_cast<int>(k);
      target_.segment<4>(4 * static_cast<Eigen::Index>(k)) = missing[point];
    }
    for (Bond& b : bonds_) {
      b.first = place[b.first], b.second = place[b.second];
      int& earliest = first[std::max(b.first, b.second)];
      earliest = std::min({earliest, b.first, b.second});
      add_moment(b, b.start, target_);
    }
    normal_ = std::make_unique<ProfileCholesky>(first);
  }

  // Sets the null space of the normal equations (Killing tensor fields), to which the Lagrange multipliers are made
  // orthogonal. Otherwise rounding errors in the null space would exceed those parts of the multipliers that vary
  // slowly along the outline, because the eigenvalues of these parts are almost 0, too.
  void set_kernel(const std::vector<int>& points, const std::vector<Point>& places) {
    std::vector<Point> ordered;
    for (const int k : order_) ordered.push_back(places[points[k]]);
    kernel_ = killing_tensors(ordered);
  }

  // Solves the part; returns false if that fails. A rough solution is computed first, because it usually shows which
  // stiffnesses are held at their lower bound.
  bool solve() {
    constexpr int most_rounds = 20;
    bool rough = true;
    std::vector<std::vector<char>> known;  // sets of values held before
    for (int round = 0; round < most_rounds; ++round) {
      if (!factorize()) return false;
      start_over();
      if (rough) {
        const double before = target_.lpNorm<Eigen::Infinity>();
        if (approach(1, kernel_.size() > 0 ? 30 : 1) > largest_remaining_part * before) return false;
        if (update_held()) {
          if (!is_new(known)) return false;
          continue;
        }
      }
      rough = false;
      const double left = approach(8, 30);
      if (!hold_more()) return left < 1e-12;
    }
    return false;
  }

  double value(std::size_t bond) const { return bonds_[bond].value; }

 private:
  // Largest missing third moment after one step, relative to that before the step, with which the iteration goes on. If
  // more is left, the equations contradict each other.
  static constexpr double largest_remaining_part = 0.1;

  struct Bond {
    int first, second;
    Vector4d moment;      // for the bulk stiffness
    double start, value;  // stiffness at first and now, relative to the bulk stiffness
    bool held;            // at the bound
  };

  static void add_moment(const Bond& b, double value, VectorXd& sum) {
    sum.segment<4>(4 * static_cast<Eigen::Index>(b.first)) += value * b.moment;
    sum.segment<4>(4 * static_cast<Eigen::Index>(b.second)) -= value * b.moment;
  }
  static double pull(const Bond& b, const VectorXd& lambda) {
    return b.moment.dot(lambda.segment<4>(4 * static_cast<Eigen::Index>(b.first)) -
                        lambda.segment<4>(4 * static_cast<Eigen::Index>(b.second)));
  }
  void add_square(const Bond& b) {
    const Eigen::Matrix4d square = b.moment * b.moment.transpose();
    normal_->at(b.first, b.first) += square;
    normal_->at(b.second, b.second) += square;
    normal_->at(std::max(b.first, b.second), std::min(b.first, b.second)) -= square;
  }

  // Factorizes the matrix of the normal equations. Its diagonal is increased by about the rounding error first, because
  // its rows depend on each other.
  bool factorize() {
    for (double shift = 3e-17; shift < 1e-11; shift *= 10) {
      normal_->clear();
      for (const Bond& b : bonds_)
        if (!b.held) add_square(b);
      if (normal_->factorize(shift * normal_->largest_diagonal())) return true;
    }
    return false;
  }

  void start_over() {
    lambda_ = VectorXd::Zero(target_.size());
    for (Bond& b : bonds_) b.value = b.held ? lower_ : b.start;
    is_rough_ = true;
  }

  // Improves the multipliers and the stiffnesses that are not held at their lower bound by conjugate gradients; returns
  // the largest missing third moment that is left.
  double approach(int most_rounds, int most_steps) {
    double left = 0, before = HUGE_VAL;
    for (int round = 0; round <= most_rounds; ++round) {
      VectorXd r = target_;
      for (const Bond& b : bonds_) add_moment(b, -b.value, r);
      left = r.lpNorm<Eigen::Infinity>();
      if (round == most_rounds || left <= balance_tolerance || left > 0.5 * before) break;
      before = left;
      descend(std::move(r), std::max(1e-13 * left, balance_tolerance), most_steps);
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
  // Product of the matrix of the normal equations with the vector p.
  VectorXd product(const VectorXd& p) const {
    VectorXd q = VectorXd::Zero(target_.size());
    for (const Bond& b : bonds_)
      if (!b.held) add_moment(b, pull(b, p), q);
    return q;
  }
  void project_off_kernel(VectorXd& x) const {
    if (kernel_.size() == 0) return;
    const VectorXd along = kernel_.transpose() * x;
    x -= kernel_ * along;
  }
  // Applies the preconditioner: F^-1, where F is the factorized normal matrix N, or F^-1 N F^-1, which suppresses
  // rounding errors in the null space of N (linalg/minimum_norm.hpp).
  VectorXd precondition(VectorXd r) const {
    project_off_kernel(r);
    normal_->solve_in_place(r);
    project_off_kernel(r);
    if (is_rough_ || kernel_.size() > 0) return r;
    r = product(r);
    normal_->solve_in_place(r);
    return r;
  }

  // Holds those stiffnesses at their lower bound that the multipliers would take below it, and releases all others.
  // Returns whether the set of held stiffnesses changed.
  bool update_held() {
    bool changed = false;
    for (Bond& b : bonds_) {
      // A margin prevents that rounding moves a stiffness into the set and out of it for ever.
      const bool next = b.start + pull(b, lambda_) < lower_ + (b.held ? 1e-12 : -1e-12);
      changed = changed || next != b.held;
      b.held = next;
    }
    return changed;
  }

  // Adds the set of stiffnesses that are held at their lower bound to `known`; returns false if this set is there
  // already, so that the rounds would repeat.
  bool is_new(std::vector<std::vector<char>>& known) const {
    std::vector<char> held;
    for (const Bond& b : bonds_) held.push_back(b.held);
    if (std::find(known.begin(), known.end(), held) != known.end()) return false;
    known.push_back(std::move(held));
    return true;
  }

  // Holds all stiffnesses that are below their lower bound at this bound; returns whether there were any.
  bool hold_more() {
    bool changed = false;
    for (Bond& b : bonds_)
      if (b.value < lower_ - 1e-12) b.held = changed = true;
    return changed;
  }

  double lower_;
  std::vector<Bond> bonds_;
  std::vector<int> order_;  // of the part's points
  VectorXd target_, lambda_;
  Eigen::MatrixXd kernel_;  // orthonormal basis of the null space; empty if it is not projected out
  std::unique_ptr<ProfileCholesky> normal_;
  bool is_rough_ = true;
};

}  // namespace

bool balance_layer(const std::vector<Point>& surface, double lower, int threads, DraftBonds& bonds,
                   const std::vector<Point>& places) {
  const std::vector<Vector4d> missing = missing_moments(surface, bonds);
  const LayerParts all = parts_of_layer(bonds, surface.size());
  const std::vector<std::size_t> original = alike_parts(all, bonds, missing);
  std::vector<char> done(all.parts.size(), 1);
  parallel_for(all.parts.size(), linalg::threads_with_blas_buffers(threads), [&](std::size_t p) {
    if (original[p] != p) return;
    const auto& part = all.parts[p];
    PartBalance balance(bonds, part, all.number, missing, lower);
    if (!places.empty()) balance.set_kernel(part.points, places);
    done[p] = balance.solve();
    for (std::size_t k = 0; k < part.bonds.size() && done[p]; ++k) {
      DraftBond& b = bonds.bonds[part.bonds[k]];
      b.stiffness = balance.value(k) * bonds.offsets[b.offset].bulk_stiffness;
    }
  });
  for (std::size_t p = 0; p < all.parts.size(); ++p)
    for (std::size_t k = 0; k < all.parts[p].bonds.size() && original[p] != p; ++k)
      bonds.bonds[all.parts[p].bonds[k]].stiffness = bonds.bonds[all.parts[original[p]].bonds[k]].stiffness;
  return std::all_of(done.begin(), done.end(), [](char one) { return one != 0; });
}

}  // namespace bempd::pd
