#include "pd/outlined/layer_balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "cancellation.hpp"
#include "linalg/profile_cholesky.hpp"
#include "parallel.hpp"
#include "pd/outlined/killing_tensors.hpp"

namespace bempd::pd {

namespace {

using Eigen::Vector4d;
using Eigen::VectorXd;
using linalg::ProfileCholesky;

constexpr double balanced = 1e-14;  // for values and equations of order one

// Missing odd and even moments of every point, and the weights of the even ones; empty without even moments.
struct Missing {
  std::vector<Vector4d> odd, even;
  std::vector<double> evenness;
};

// Least change of the stiffnesses in one part of a layer, by primal-dual active sets (Hintermueller, Ito, Kunisch 2002)
// as in solve_long_least_change() of linalg, with the normal equations in the order of points along the outline.
class PartBalance {
 public:
  PartBalance(const OutlinedBonds& all, const LayerParts::Part& part, const std::vector<int>& number,
              const Missing& missing, double lower)
      : lower_(lower), groups_(missing.evenness.empty() ? 1 : 2) {
    bonds_.reserve(part.bonds.size());
    for (const int b : part.bonds) {
      const OutlinedBond& bond = all.bonds[b];
      const BondOffset& offset = all.offsets[bond.offset];
      bonds_.push_back({number[bond.first],
                        number[bond.second],
                        offset.bulk_stiffness * offset.moment,
                        {Vector4d::Zero(), Vector4d::Zero()},
                        bond.stiffness / offset.bulk_stiffness,
                        0.0,
                        false});
      if (groups_ == 1) continue;
      const Vector4d even = offset.bulk_stiffness * even_moment(offset);
      if (missing.evenness[bond.first] > 0) bonds_.back().even[0] = even;
      if (missing.evenness[bond.second] > 0) bonds_.back().even[1] = even;
    }
    order_ = order_of(all, part, number);
    const std::vector<int>& order = order_;
    std::vector<int> place(order.size()), first(order.size());
    target_.resize(size_of(order.size()));
    slack_ = VectorXd::Zero(target_.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
      const int point = part.points[order[k]];
      place[order[k]] = first[k] = static_cast<int>(k);
      target_.segment<4>(row(static_cast<int>(k), 0)) = missing.odd[point];
      if (groups_ == 1) continue;
      const double weight = missing.evenness[point];
      target_.segment<4>(row(static_cast<int>(k), 1)) = weight > 0 ? missing.even[point] : Vector4d::Zero();
      slack_.segment<4>(row(static_cast<int>(k), 1)).setConstant(weight > 0 ? 1 / weight : 1);
    }
    for (Bond& b : bonds_) {
      b.first = place[b.first], b.second = place[b.second];
      int& earliest = first[std::max(b.first, b.second)];
      earliest = std::min({earliest, b.first, b.second});
      add_moment(b, b.start, target_);
    }
    std::vector<int> first_group;
    for (const int f : first) first_group.insert(first_group.end(), static_cast<std::size_t>(groups_), groups_ * f);
    normal_ = std::make_unique<ProfileCholesky>(first_group);
  }

  // Sets the null space of the normal equations (Killing tensor fields), to which multipliers are made orthogonal.
  // Rounding errors in it would exceed multipliers that vary slowly along the outline, whose eigenvalues are tiny, too.
  void set_kernel(const std::vector<int>& points, const std::vector<Point>& places) {
    std::vector<Point> ordered;
    for (const int k : order_) ordered.push_back(places[points[k]]);
    const Eigen::MatrixXd fields = killing_tensors(ordered);
    kernel_ = Eigen::MatrixXd::Zero(target_.size(), fields.cols());
    for (std::size_t k = 0; k < order_.size(); ++k)
      kernel_.middleRows<4>(row(static_cast<int>(k), 0)) = fields.middleRows<4>(4 * static_cast<Eigen::Index>(k));
  }

  // Solves the part, or returns false. A rough solution usually tells which values are held at the bound.
  bool solve() {
    constexpr int most_rounds = 20;
    bool rough = true;
    std::vector<std::vector<char>> known;  // sets of values held before
    for (int round = 0; round < most_rounds; ++round) {
      if (!factorize()) return false;
      start_over();
      if (rough) {
        const double before = target_.lpNorm<Eigen::Infinity>();
        if (approach(1, kernel_.size() > 0 ? 30 : 1) > hopeless * before) return false;
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
  // Limit on the missing moments after one step, over those before: above it the equations contradict each other.
  static constexpr double hopeless = 0.1;

  struct Bond {
    int first, second;
    Vector4d moment;      // of the kernel's stiffness
    Vector4d even[2];     // contribution to the even moments of either end
    double start, value;  // over the kernel's
    bool held;
  };

  Eigen::Index size_of(std::size_t points) const { return 4 * groups_ * static_cast<Eigen::Index>(points); }
  Eigen::Index row(int place, int group) const { return 4 * (groups_ * static_cast<Eigen::Index>(place) + group); }

  void add_moment(const Bond& b, double value, VectorXd& sum) const {
    sum.segment<4>(row(b.first, 0)) += value * b.moment;
    sum.segment<4>(row(b.second, 0)) -= value * b.moment;
    if (groups_ == 1) return;
    sum.segment<4>(row(b.first, 1)) += value * b.even[0];
    sum.segment<4>(row(b.second, 1)) += value * b.even[1];
  }
  double pull(const Bond& b, const VectorXd& lambda) const {
    const double odd = b.moment.dot(lambda.segment<4>(row(b.first, 0)) - lambda.segment<4>(row(b.second, 0)));
    if (groups_ == 1) return odd;
    return odd + b.even[0].dot(lambda.segment<4>(row(b.first, 1))) + b.even[1].dot(lambda.segment<4>(row(b.second, 1)));
  }
  void add_square(const Bond& b) {
    const Eigen::Matrix4d square = b.moment * b.moment.transpose();
    const int low = std::min(b.first, b.second), high = std::max(b.first, b.second);
    normal_->at(groups_ * b.first, groups_ * b.first) += square;
    normal_->at(groups_ * b.second, groups_ * b.second) += square;
    normal_->at(groups_ * high, groups_ * low) -= square;
    if (groups_ == 1) return;
    const Vector4d &of_low = b.even[low == b.first ? 0 : 1], &of_high = b.even[low == b.first ? 1 : 0];
    const Vector4d odd = low == b.first ? b.moment : Vector4d(-b.moment);
    normal_->at(2 * low + 1, 2 * low) += of_low * odd.transpose();
    normal_->at(2 * low + 1, 2 * low + 1) += of_low * of_low.transpose();
    normal_->at(2 * high, 2 * low + 1) -= odd * of_low.transpose();
    normal_->at(2 * high + 1, 2 * low) += of_high * odd.transpose();
    normal_->at(2 * high + 1, 2 * low + 1) += of_high * of_low.transpose();
    normal_->at(2 * high + 1, 2 * high) -= of_high * odd.transpose();
    normal_->at(2 * high + 1, 2 * high + 1) += of_high * of_high.transpose();
  }

  // Factorizes the normal matrix, shifted by about its rounding error, because rows depend on each other.
  bool factorize() {
    for (double shift = 3e-17; shift < 1e-11; shift *= 10) {
      normal_->clear();
      for (const Bond& b : bonds_)
        if (!b.held) add_square(b);
      for (int k = 1; groups_ == 2 && row(k / 2, 1) < slack_.size(); k += 2)
        normal_->at(k, k) += slack_.segment<4>(row(k / 2, 1)).asDiagonal();
      if (normal_->factorize(shift * normal_->largest_diagonal())) return true;
    }
    return false;
  }

  void start_over() {
    lambda_ = VectorXd::Zero(target_.size());
    for (Bond& b : bonds_) b.value = b.held ? lower_ : b.start;
    is_rough_ = true;
  }

  // Improves multipliers and free values by conjugate gradients; returns the largest missing moment.
  double approach(int most_rounds, int most_steps) {
    double left = 0, before = HUGE_VAL;
    for (int round = 0; round <= most_rounds; ++round) {
      VectorXd r = target_;
      for (const Bond& b : bonds_) add_moment(b, -b.value, r);
      if (groups_ == 2) r -= slack_.cwiseProduct(lambda_);
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
  // Product of the normal matrix N with the vector p.
  VectorXd product(const VectorXd& p) const {
    VectorXd q = VectorXd::Zero(target_.size());
    for (const Bond& b : bonds_)
      if (!b.held) add_moment(b, pull(b, p), q);
    if (groups_ == 2) q += slack_.cwiseProduct(p);
    return q;
  }
  void project_off_kernel(VectorXd& x) const {
    if (kernel_.size() == 0) return;
    const VectorXd along = kernel_.transpose() * x;
    x -= kernel_ * along;
  }
  // Preconditioner F^-1, or F^-1 N F^-1 against rounding in the kernel of N (linalg/minimum_norm.hpp); F factorizes N.
  VectorXd precondition(VectorXd r) const {
    project_off_kernel(r);
    normal_->solve_in_place(r);
    project_off_kernel(r);
    if (is_rough_ || kernel_.size() > 0) return r;
    r = product(r);
    normal_->solve_in_place(r);
    return r;
  }

  // Holds values that the multipliers would take below the bound; returns whether the set of held values changed.
  bool update_held() {
    bool changed = false;
    for (Bond& b : bonds_) {
      // A margin prevents rounding from moving a value in and out of the set for ever.
      const bool next = b.start + pull(b, lambda_) < lower_ + (b.held ? 1e-12 : -1e-12);
      changed = changed || next != b.held;
      b.held = next;
    }
    return changed;
  }

  // Adds the set of values held at the bound to `known`; false if it is there already, so that the rounds repeat.
  bool is_new(std::vector<std::vector<char>>& known) const {
    std::vector<char> held;
    for (const Bond& b : bonds_) held.push_back(b.held);
    if (std::find(known.begin(), known.end(), held) != known.end()) return false;
    known.push_back(std::move(held));
    return true;
  }

  // Holds at the bound the values that are below it; returns whether there were any.
  bool hold_more() {
    bool changed = false;
    for (Bond& b : bonds_) {
      if (b.value >= lower_ - 1e-12) continue;
      b.held = changed = true;
    }
    return changed;
  }

  double lower_;
  int groups_;  // of four equations a point: odd moments, and even ones up to a slack
  std::vector<Bond> bonds_;
  std::vector<int> order_;  // of the part's points
  VectorXd target_, lambda_, slack_;
  Eigen::MatrixXd kernel_;  // orthonormal; empty if it is not projected out
  std::unique_ptr<ProfileCholesky> normal_;
  bool is_rough_ = true;
};

}  // namespace

bool balance_layer(const std::vector<Point>& surface, const std::vector<double>& evenness, double lower, int threads,
                   OutlinedBonds& bonds, const std::vector<Point>& places) {
  const Missing missing{missing_moments(surface, bonds),
                        evenness.empty() ? std::vector<Vector4d>() : missing_even_moments(surface.size(), bonds),
                        evenness};
  const LayerParts all = parts_of_layer(bonds, surface.size());
  std::vector<char> done(all.parts.size(), 0);
  parallel_for(all.parts.size(), threads, [&](std::size_t p) {
    const LayerParts::Part& part = all.parts[p];
    PartBalance balance(bonds, part, all.number, missing, lower);
    if (!places.empty()) balance.set_kernel(part.points, places);
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
