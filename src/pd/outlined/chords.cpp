#include "pd/outlined/chords.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bempd::pd {

namespace {

// Round pieces turn by this at most from chord to chord [rad].
constexpr double largest_turn = std::numbers::pi / 3;

int chord_count(const Arc& piece) {
  const double by_length = std::round(piece.length()), by_turn = std::ceil(std::abs(piece.sweep) / largest_turn - 1e-9);
  return std::max(1, static_cast<int>(std::max(by_length, by_turn)));
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

Chords make_chords(const std::vector<std::vector<Arc>>& loops) {
  Chords made;
  int piece = 0;
  for (const std::vector<Arc>& loop : loops) {
    const int start = made.count();
    made.loop_start.push_back(start);
    for (const Arc& arc : loop) {
      const int count = chord_count(arc);
      made.piece_start.push_back(made.count());
      for (int k = 0; k < count; ++k) {
        const double from = static_cast<double>(k) / count, to = static_cast<double>(k + 1) / count;
        made.chords.push_back({made.count(), made.count() + 1, piece, from, to});
        made.nodes.push_back(arc.at(from));
      }
      ++piece;
    }
    made.chords.back().second = start;
  }
  made.loop_start.push_back(made.count());
  made.piece_start.push_back(made.count());
  return made;
}

}  // namespace bempd::pd
