// Prints how exact the networks of bodies with any outline are, as a table: three places and directions of the lattice
// for each. With the argument `mouths` those of long outlines on which cracks begin; with `rows` how networks along
// lattice rows differ from those made without templates.
#include <algorithm>
#include <cstdio>

#include "mouths.hpp"
#include "rows.hpp"
#include "unit/pd_outlines.hpp"

namespace {

using namespace bempd::pd;
using namespace bempd::pd::test;

struct Row {
  int exact = 0, tried = 0;
  double patch = 0, least = 1e300, most = 0;
};

Row try_places(const Loops& loops, int horizon_ratio, std::mt19937& random) {
  std::uniform_real_distribution<double> part(0, 1);
  Row row;
  for (; row.tried < 3; ++row.tried) {
    const double x = part(random), y = part(random);
    const OutlinedBody body = body_of(loops, {{x, y}, 1.5 * part(random)}, horizon_ratio);
    if (!body.is_exact()) continue;
    ++row.exact;
    row.patch = std::max(row.patch, patch_error(body));
    row.least = std::min(row.least, body.network.min_weight_ratio);
    for (std::size_t b = 0; b < body.network.bonds.size(); ++b) {
      const BondOffset& offset = body.network.offsets[body.network.offset_of[b]];
      row.most = std::max(row.most, body.network.bonds[b].stiffness / offset.bulk_stiffness);
    }
  }
  return row;
}

void print(const NamedOutline& outline, std::mt19937& random) {
  std::printf("| %s |", outline.name.c_str());
  for (const int m : {3, 4, 5}) {
    const Row row = try_places(outline.loops, m, random);
    if (row.exact == 0) {
      std::printf(" none |");
    } else {
      std::printf(" %d of %d, %.0e, %.2f to %.1f |", row.exact, row.tried, row.patch, row.least, row.most);
    }
  }
  std::printf("\n");
  std::fflush(stdout);
}

std::string name(const char* what, double value) {
  char text[80];
  std::snprintf(text, sizeof text, what, value);
  return text;
}

}  // namespace

int main(int count, char** arguments) {
  if (count > 1 && std::string(arguments[1]) == "mouths") {
    print_mouths();
    return 0;
  }
  if (count > 1 && std::string(arguments[1]) == "rows") {
    print_rows();
    return 0;
  }
  std::mt19937 random(2);
  std::printf("| outline, in spacings | m = 3 | m = 4 | m = 5 |\n|---|---|---|---|\n");
  for (const double radius : {1.0, 1.5, 2.0, 3.0, 5.0, 8.3})
    print({name("round hole, radius %g", radius), {polygon(box(22, 21)), circle({11.2, 10.7}, radius, true)}}, random);
  for (const double radius : {2.0, 3.0, 6.0, 12.0})
    print({name("disc, radius %g", radius), {circle({0.3, 0.1}, radius, false)}}, random);
  for (const double width : {2.0, 3.0, 4.0, 6.0})
    print({name("slanted strip, width %g", width), {polygon(turned(box(25.4, width), 23 * degree))}}, random);
  for (const double angle : {61.0, 62.0, 65.0, 70.0, 90.0, 120.0, 150.0, 170.0})
    print({name("corner of %g degrees", angle), {polygon(wedge(angle * degree, 14.3))}}, random);
  for (const double angle : {200.0, 270.0, 330.0, 350.0})
    print({name("re-entrant corner of %g degrees", angle), {polygon(notched(angle * degree))}}, random);
  std::uniform_real_distribution<double> part(0, 1);
  for (int curve = 0; curve < 3; ++curve) {
    std::vector<bempd::Point> points;
    for (int k = 0; k < 9; ++k) points.push_back(turned(bempd::Point(9 + 5 * part(random), 0), k * 40 * degree));
    print({"smooth closed curve through 9 random places", {smooth_loop(points)}}, random);
  }
}
