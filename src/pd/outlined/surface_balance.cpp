#include "pd/outlined/surface_balance.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "linalg/least_squares.hpp"

namespace bempd::pd {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double negligible_number = 1e-15;  // of an imbalance, with lengths in units of the loop's size
constexpr double largest_factor_change = 0.02;

// Trace of the symmetric product T of three vectors, times 3. Its scalar product with a surface vector N is 3 T_kkl N_l
// (surface_balance.hpp).
Point trace_of(const Point& u, const Point& v, const Point& w) { return u * v.dot(w) + v * u.dot(w) + w * u.dot(v); }

class LoopBalance {
 public:
  LoopBalance(const Chords& chords, int loop)
      : chords_(chords), first_(chords.loop_start[loop]), count_(chords.loop_start[loop + 1] - first_) {
    for (int i = 0; i < count_; ++i) centre_ += chords.nodes[first_ + i] / count_;
    for (int i = 0; i < count_; ++i) size_ = std::max(size_, (chords.nodes[first_ + i] - centre_).norm());
  }

  // Contribution of node `i`, with the surface vector N, to three sums of T_kkl N_l, times 3, that have to vanish for a
  // loop (surface_balance.hpp). The Killing tensor fields T of these sums are e_x r r, e_y r r and r r r: symmetric
  // products of the unit vectors e_x and e_y with the rotation r about the loop's centre. Lengths are in units of the
  // loop's size.
  std::array<double, 3> numbers(int i) const {
    const Point x = place(i), r(-x.y(), x.x()), n = vector(i);
    return {trace_of({1, 0}, r, r).dot(n), trace_of({0, 1}, r, r).dot(n), trace_of(r, r, r).dot(n)};
  }
  Eigen::Vector3d sums(const std::vector<double>& factors) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int i = 0; i < count_; ++i)
      for (int k = 0; k < 3; ++k) sum[k] += factors[first_ + i] * numbers(i)[k];
    return sum;
  }

  // Makes all chords of the loop count as if they had one length, by factors of the two nodes next to each end of every
  // piece with four or more chords. Let the piece be straight, with n chords of the length l, and let N be the size of
  // a node's surface vector and s the node's place along the piece. Changes a (1, -1, .., -1, 1) of the factors keep
  // resultant and moment of the piece, and add a l^3 (2 n - 6) to the sum of N s^2. This sum lacks n l (w - l^2) / 6,
  // where w is wanted_square().
  void equalize_chord_lengths(std::vector<double>& factors) const {
    const std::vector<int> pieces = own_pieces();
    const double wanted = wanted_square(pieces);
    for (const int piece : pieces) {
      const int start = chords_.piece_start[piece], count = chords_.piece_start[piece + 1] - start;
      if (count < 4) continue;
      const double square = chords_.along(start).squaredNorm();
      const double change = (wanted - square) / square * count / (12.0 * (count - 3));
      const std::array<int, 4> nodes{start + 1, start + 2, start + count - 2, start + count - 1};
      const auto is_kept = [&](int node) { return !chords_.kept.empty() && chords_.kept[node]; };
      if (std::abs(change) > largest_factor_change || std::any_of(nodes.begin(), nodes.end(), is_kept)) continue;
      for (int k = 0; k < 4; ++k) factors[nodes[k]] += k == 0 || k == 3 ? change : -change;
    }
  }

  // Changes the factors so that the loop is balanced; returns false if that takes too large changes. `moments_a_piece`
  // is the number of moments of a constant load that every piece keeps: 0, 1 (the resultant) or 2 (the first moment as
  // well).
  bool change_factors(int moments_a_piece, std::vector<double>& factors) const {
    const std::vector<int> pieces = own_pieces();
    const Eigen::Index rows = 9 + static_cast<Eigen::Index>(pieces.size()) * moments_a_piece;
    MatrixXd equations = MatrixXd::Zero(rows, count_);
    for (int i = 0; i < count_; ++i) {
      const Point n = vector(i), x = place(i);
      const std::array<double, 3> three = numbers(i);
      equations.col(i).head<9>() << n.x(), n.y(), n.x() * x.x(), n.x() * x.y(), n.y() * x.x(), n.y() * x.y(), three[0],
          three[1], three[2];
    }
    for (std::size_t p = 0; p < pieces.size(); ++p)
      add_piece(pieces[p], 9 + p * moments_a_piece, moments_a_piece, equations);
    for (int i = 0; i < count_ && !chords_.kept.empty(); ++i)
      if (chords_.kept[first_ + i]) equations.col(i).setZero();
    VectorXd changed(count_), wanted = VectorXd::Zero(rows);
    for (int i = 0; i < count_; ++i) changed[i] = factors[first_ + i] - 1;
    if (!changed.isZero(0)) wanted = -equations * changed;
    wanted.segment<3>(6) = -sums(factors);
    const linalg::LeastSquares solver(equations, 1e-12);
    VectorXd a = solver.solve(wanted);
    a += solver.solve(wanted - equations * a);
    if ((equations * a - wanted).lpNorm<Eigen::Infinity>() > 1e-14 ||
        a.lpNorm<Eigen::Infinity>() > largest_factor_change)
      return false;
    for (int i = 0; i < count_; ++i) factors[first_ + i] += a[i];
    return true;
  }

 private:
  Point place(int i) const { return (chords_.nodes[first_ + i] - centre_) / size_; }
  Point vector(int i) const { return chords_.surface_vector(first_ + i) / size_; }

  std::vector<int> own_pieces() const {
    std::vector<int> pieces;
    for (int i = 0; i < count_; ++i) {
      const int piece = chords_.chords[first_ + i].piece;
      if (pieces.empty() || pieces.back() != piece) pieces.push_back(piece);
    }
    return pieces;
  }
  // Square of the length that all chords are to count as. It is the mean over the pieces with fewer than four chords,
  // whose factors cannot be changed, or over all pieces if there are none of these.
  double wanted_square(const std::vector<int>& pieces) const {
    double sum = 0, of_short = 0, length = 0, length_of_short = 0;
    for (const int piece : pieces) {
      const int start = chords_.piece_start[piece], count = chords_.piece_start[piece + 1] - start;
      const double own = count * chords_.length(start), square = chords_.along(start).squaredNorm();
      (count < 4 ? of_short : sum) += own * square;
      (count < 4 ? length_of_short : length) += own;
    }
    return length_of_short > 0 ? of_short / length_of_short : sum / length;
  }
  void add_piece(int piece, std::size_t row, int moments, MatrixXd& equations) const {
    for (int c = chords_.piece_start[piece]; moments > 0 && c < chords_.piece_start[piece + 1]; ++c) {
      for (const int node : {chords_.chords[c].first, chords_.chords[c].second}) {
        const double half = 0.5 * chords_.length(c) / size_;
        const double along = (chords_.nodes[node] - chords_.nodes[chords_.piece_start[piece]]).norm() / size_;
        const auto at = static_cast<Eigen::Index>(row);
        equations(at, node - first_) += half;
        if (moments > 1) equations(at + 1, node - first_) += half * along;
      }
    }
  }

  const Chords& chords_;
  int first_, count_;
  Point centre_ = Point::Zero();
  double size_ = 0;
};

}  // namespace

std::vector<double> balancing_factors(const Chords& chords, bool by_piece) {
  std::vector<double> factors(chords.nodes.size(), 1.0);
  for (int loop = 0; loop < chords.loop_count(); ++loop) {
    const LoopBalance balance(chords, loop);
    if (balance.sums(factors).lpNorm<Eigen::Infinity>() <= negligible_number) continue;
    if (by_piece) balance.equalize_chord_lengths(factors);
    for (int moments = 2; moments >= 0; --moments)
      if (balance.change_factors(moments, factors)) break;
  }
  return factors;
}

double imbalance(const Chords& chords, const std::vector<double>& factors) {
  double largest = 0;
  for (int loop = 0; loop < chords.loop_count(); ++loop)
    largest = std::max(largest, LoopBalance(chords, loop).sums(factors).lpNorm<Eigen::Infinity>());
  return largest;
}

}  // namespace bempd::pd
