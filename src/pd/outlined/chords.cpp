#include "pd/outlined/chords.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bempd::pd {

namespace {

// Largest angle between neighbouring chords of a round piece [rad].
constexpr double largest_turn = std::numbers::pi / 3;

int chord_count(const Arc& piece) {
  const double by_length = std::round(piece.length()), by_turn = std::ceil(std::abs(piece.sweep) / largest_turn - 1e-9);
  return std::max(1, static_cast<int>(std::max(by_length, by_turn)));
}

// Fraction of a piece of the outline at which node number `node` lies. With a `swing` that is not 0, the distances
// between nodes vary along the piece (x from 0 to 1) as 1 + swing (cos 2 pi x - cos 4 pi x), which is 1 at the ends of
// the piece, because corners need equal chords.
double node_fraction(int node, int count, double swing) {
  if (node == 0 || node == count) return node == 0 ? 0 : 1;
  const double x = static_cast<double>(node) / count, turn = 2 * std::numbers::pi;
  return x + swing / turn * (std::sin(turn * x) - 0.5 * std::sin(2 * turn * x));
}

// Mean square of the lengths l of a piece's chords: sum of l^2 times the chord vectors, over the sum of the chord
// vectors. (By symmetry both sums point from the start of the piece to its end.) A loop is balanced if all of its
// pieces have the same mean square.
double mean_square(const Arc& piece, double swing) {
  const int count = chord_count(piece);
  Point sum = Point::Zero();
  for (int k = 0; k < count; ++k) {
    const Point along = piece.at(node_fraction(k + 1, count, swing)) - piece.at(node_fraction(k, count, swing));
    sum += along.squaredNorm() * along;
  }
  const Point whole = piece.end - piece.start;
  return sum.dot(whole) / whole.squaredNorm();
}

// Swing (node_fraction()) with which the mean square of a piece's chord lengths is `wanted`, which is larger than that
// of equal chords; negative if the largest swing allowed is not enough.
double swing_for(const Arc& piece, double wanted) {
  double low = 0, high = 0.3;
  if (mean_square(piece, high) < wanted) return -1;
  for (int round = 0; round < 60; ++round) {
    const double middle = 0.5 * (low + high);
    (mean_square(piece, middle) < wanted ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// Swings (node_fraction()) with which all pieces of a loop have the same mean square of chord lengths; zeros if no such
// swings exist. Only pieces marked in `may_vary` can have a swing.
std::vector<double> swings_of(const std::vector<Arc>& loop, const char* may_vary, bool any) {
  std::vector<double> swings(loop.size(), 0.0), squares;
  if (!any || std::none_of(may_vary, may_vary + loop.size(), [](char one) { return one != 0; })) return swings;
  for (const Arc& piece : loop) squares.push_back(mean_square(piece, 0));
  const double largest = *std::max_element(squares.begin(), squares.end());
  for (std::size_t a = 0; a < loop.size(); ++a) {
    if (squares[a] > largest * (1 - 1e-12)) continue;
    swings[a] = may_vary[a] ? swing_for(loop[a], largest) : -1;
    if (swings[a] < 0) return std::vector<double>(loop.size(), 0.0);
  }
  return swings;
}

}  // namespace

int Chords::chord_before(int node) const {
  const auto after = std::upper_bound(loop_start.begin(), loop_start.end(), node);
  return node == after[-1] ? *after - 1 : node - 1;
}

double Chords::angle(int node) const {
  const Point before = -along(chord_before(node)), after = along(node);
  const double turned = std::atan2(cross(after, before), after.dot(before));
  return turned > 0 ? turned : turned + 2 * std::numbers::pi;
}

Chords make_chords(const std::vector<std::vector<Arc>>& loops, const std::vector<char>& may_vary) {
  Chords made;
  int piece = 0;
  for (const std::vector<Arc>& loop : loops) {
    const int start = made.count();
    made.loop_start.push_back(start);
    const std::vector<double> swings =
        swings_of(loop, may_vary.data() + std::min<std::size_t>(piece, may_vary.size()), !may_vary.empty());
    for (std::size_t a = 0; a < loop.size(); ++a, ++piece) {
      const int count = chord_count(loop[a]);
      made.piece_start.push_back(made.count());
      for (int k = 0; k < count; ++k) {
        const double from = node_fraction(k, count, swings[a]), to = node_fraction(k + 1, count, swings[a]);
        made.chords.push_back({made.count(), made.count() + 1, piece, from, to});
        made.nodes.push_back(loop[a].at(from));
      }
    }
    made.chords.back().second = start;
  }
  made.loop_start.push_back(made.count());
  made.piece_start.push_back(made.count());
  return made;
}

}  // namespace bempd::pd
