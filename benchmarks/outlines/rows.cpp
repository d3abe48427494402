#include "rows.hpp"

#include <cstdio>
#include <ctime>
#include <functional>
#include <map>

#include "unit/pd_bodies.hpp"
#include "unit/pd_outlines.hpp"

namespace {

using namespace bempd::pd;
using namespace bempd::pd::test;

// Least processor time of some runs [s].
double least_time(const std::function<void()>& run) {
  double least = 1e300;
  for (int k = 0; k < 5; ++k) {
    const std::clock_t start = std::clock();
    run();
    least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return least;
}

Chords chords_of(const test::Body& body) {
  Loops loops;
  for (const Loop& loop : body.loops) {
    std::vector<bempd::Point> corners;
    for (const Vector2i& corner : loop) corners.push_back(corner.cast<double>());
    loops.push_back(polygon(corners));
  }
  return make_chords(loops);
}

// Prints the largest difference of a weight over the bulk's, and for rows and then the other builder the smallest
// weight over the bulk's and the largest missing moment; last the time of the other builder over that of rows.
void print_difference(const test::Body& body, int m) {
  const CellLattice lattice(body.loops);
  Network rows = build_network(lattice, m, bonds_alone, 1);  // computes the templates, too
  const double rows_time = least_time([&] { rows = build_network(lattice, m, bonds_alone, 1); });
  OutlinedBody other;
  const double time = least_time([&] {
    other = build_outlined_body(chords_of(body), {{0, 0}, 0, true}, m, bonds_alone, 1);
  });
  std::map<std::pair<int, int>, double> stiffness;
  for (const Bond& b : rows.bonds) stiffness[{b.first, b.second}] = b.stiffness;
  double largest = 0;
  bool has_all = rows.bonds.size() == other.network.bonds.size();
  for (std::size_t k = 0; k < other.network.bonds.size() && has_all; ++k) {
    const Bond& b = other.network.bonds[k];
    const auto point = [&](int i) {
      return lattice.find_point(Vector2i(other.points[i].array().round().cast<int>().matrix()));
    };
    const auto found = stiffness.find(std::minmax(point(b.first), point(b.second)));
    has_all = found != stiffness.end();
    if (!has_all) break;
    const double bulk = other.network.offsets[other.network.offset_of[k]].bulk_stiffness;
    largest = std::max(largest, std::abs(b.stiffness - found->second) / bulk);
  }
  std::printf(has_all ? " %.2f, %.2f and %.2f, %.0e and %.0e, %.1f |" : " other bonds |", largest,
              rows.min_weight_ratio, other.network.min_weight_ratio, rows.max_residual, other.network.max_residual,
              time / rows_time);
}

}  // namespace

void print_rows() {
  std::printf(
      "| body, in spacings: largest difference of weights, least weight with and without templates, largest missing "
      "moment "
      "with and without, time without over with | m = 3 | m = 4 | m = 5 |\n|---|---|---|---|\n");
  std::vector<test::Body> list;
  for (const int side : {20, 40, 80, 160})
    list.push_back({"square of " + std::to_string(side), {rectangle(0, 0, side, side)}});
  list.push_back({"L of 24 and 26", {{{0, 0}, {24, 0}, {24, 11}, {10, 11}, {10, 26}, {0, 26}}}});
  list.push_back({"plate with a rectangular hole", {rectangle(0, 0, 120, 90), hole(50, 40, 12, 8)}});
  list.push_back({"plate with a slit from its edge",
                  {{{0, 0}, {80, 0}, {80, 80}, {0, 80}, {0, 41}, {32, 41}, {32, 40}, {0, 40}}}});
  for (const test::Body& body : list) {
    std::printf("| %s |", body.name.c_str());
    for (const int m : {3, 4, 5}) print_difference(body, m);
    std::printf("\n");
    std::fflush(stdout);
  }
}
