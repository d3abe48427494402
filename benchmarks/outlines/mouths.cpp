#include "mouths.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "unit/pd_outlines.hpp"

namespace {

using namespace bempd::pd;
using namespace bempd::pd::test;

constexpr int plates = 60;
constexpr std::array<const char*, 3> kinds{"whole spacings", "slanted, any lengths", "round holes"};

struct Mouth {
  int edge;
  double at;  // fraction
};

// Edges end half a spacing beside each mouth, as in regions.
std::vector<bempd::Arc> divided(const std::vector<bempd::Arc>& loop, const std::vector<Mouth>& mouths) {
  std::vector<bempd::Arc> pieces;
  for (std::size_t e = 0; e < loop.size(); ++e) {
    const double length = loop[e].length(), room = 0.75 / length;
    std::vector<double> stations{0, 1};
    for (const Mouth& mouth : mouths) {
      for (const double aside : {-0.5, 0.5}) {
        const double f = mouth.at + aside / length;
        const auto after = std::lower_bound(stations.begin(), stations.end(), f);
        if (mouth.edge == static_cast<int>(e) && f - after[-1] >= room && *after - f >= room) stations.insert(after, f);
      }
    }
    for (std::size_t s = 0; s + 1 < stations.size(); ++s)
      pieces.push_back({loop[e].at(stations[s]), loop[e].at(stations[s + 1]), 0});
  }
  return pieces;
}

// 100 to 300 spacings wide and high, one to three mouths anywhere but at the corners.
Loops some_plate(std::size_t kind, std::mt19937& random) {
  std::uniform_real_distribution<double> part(0, 1);
  double width = 100 + 200 * part(random), height = 100 + 200 * part(random);
  if (kind != 1) width = std::round(width), height = std::round(height);
  std::vector<bempd::Point> corners = box(width, height);
  if (kind == 1) {
    corners[2].x() += 0.3 * height * (part(random) - 0.5);
    corners = turned(corners, 45 * degree * part(random));
  }
  std::vector<Mouth> mouths(1 + static_cast<std::size_t>(3 * part(random)));
  for (Mouth& mouth : mouths) {
    mouth.edge = static_cast<int>(4 * part(random));
    mouth.at = 0.05 + 0.9 * part(random);
  }
  Loops loops{divided(polygon(corners), mouths)};
  for (int hole = 0; kind == 2 && hole < 2; ++hole) {
    const bempd::Point centre((0.3 + 0.4 * hole) * width, (0.4 + 0.2 * part(random)) * height);
    loops.push_back(circle(centre, 5 + 0.07 * width * part(random), true));
  }
  return loops;
}

struct Counts {
  int tried = 0, plain = 0, careful = 0;
  double patch = 0, change = 0;
};

}  // namespace

void print_mouths() {
  std::printf(
      "| plates | m | networks without care | with care | forces of constant stress | factors of surface vectors |\n");
  std::printf("|---|---|---|---|---|---|\n");
  std::array<std::array<Counts, 2>, 3> all;
  for (int k = 0; k < plates; ++k) {
    std::mt19937 random(1000 + static_cast<unsigned>(k));
    std::uniform_real_distribution<double> part(0, 1);
    const std::size_t kind = static_cast<std::size_t>(k / 2) % 3, longer = k % 2;
    const Loops loops = some_plate(kind, random);
    const double angle = 45 * degree * part(random), x = part(random), y = part(random);
    const OutlinedBody body =
        build_outlined_body(make_chords(loops), {{x, y}, angle, true}, 3 + static_cast<int>(longer), bonds_alone, 1);
    Counts& counts = all[kind][longer];
    ++counts.tried;
    if (!body.is_exact()) continue;
    ++(body.is_balanced_by_piece ? counts.careful : counts.plain);
    counts.patch = std::max(counts.patch, patch_error(body));
    for (const double factor : body.factors) counts.change = std::max(counts.change, std::abs(factor - 1));
    std::fprintf(stderr, "plate %d of %d\n", k + 1, plates);
  }
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    for (int longer = 0; longer < 2; ++longer) {
      const Counts& c = all[kind][longer];
      std::printf("| %s | %d | %d of %d | %d of %d | %.0e | %.1e |\n", kinds[kind], 3 + longer, c.plain, c.tried,
                  c.plain + c.careful, c.tried, c.patch, c.change);
    }
  }
}
