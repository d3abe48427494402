// Writes the files of a run as a host would find them, with invented fields: a plate that is pulled along x at both
// ends, a lattice between two boundary-element regions, and a crack at x = 0.025 that grows and opens.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "output/csv.hpp"
#include "output/file.hpp"
#include "output/pvd.hpp"
#include "output/vtu.hpp"

namespace {

using namespace bempd;
using namespace bempd::output;

constexpr double height = 0.05, width = 0.05, middle = 0.025;
constexpr double increment = 2e-8;

// Half length of the crack at a load factor: starts at 5 mm, has cut the plate at load factor 400.
double half_length(double load) { return std::clamp(0.005 + (load - 280) / 120 * 0.0201, 0.005, 0.0251); }

Point displacement(const Point& p, double load) {
  const double end = increment * load, a = half_length(load), from_middle = p.y() - height / 2;
  const double share = a >= height / 2 ? 1.0 : std::sqrt(std::max(0.0, 1 - from_middle * from_middle / (a * a)));
  const double distance = p.x() - middle;
  const double jump = end * share * std::exp(a >= height / 2 ? 0 : -std::abs(distance) / a);
  return {(distance < 0 ? -1 : 1) * (jump + (end - jump) * std::abs(distance) / middle),
          -0.2 * end * from_middle / middle};
}

double damage(const Point& p, double load) {
  const double across = std::abs(p.x() - middle) / 0.002, along = half_length(load) - std::abs(p.y() - height / 2);
  return across < 1 && along > 0 ? 0.45 * (1 - across) * std::min(1.0, along / 0.002) : 0.0;
}

VtuGrid lattice(double load) {
  VtuGrid grid;
  // Points lie half a spacing beside the crack.
  constexpr int columns = 30, rows = 101;
  constexpr double spacing = 0.0005, left = middle - (columns - 1) * spacing / 2;
  std::vector<double> u, d;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const Point p(left + i * spacing, j * spacing), up = displacement(p, load);
      grid.points.push_back(p);
      u.insert(u.end(), {up.x(), up.y()});
      d.push_back(damage(p, load));
      const int k = j * columns + i;
      if (i + 1 < columns && j + 1 < rows) grid.add_cell(VtuCell::quad, {k, k + 1, k + 1 + columns, k + columns});
    }
  grid.point_data = {{"displacement", 2, u}, {"damage", 1, d}};
  return grid;
}

void add_box(VtuGrid& grid, double x0, double x1, double load, int region, std::vector<double>& u,
             std::vector<std::int32_t>& regions) {
  const Point corner[4] = {{x0, 0}, {x1, 0}, {x1, height}, {x0, height}};
  const auto first = static_cast<std::int64_t>(grid.points.size());
  constexpr int elements = 10, nodes = 4 * 2 * elements;
  for (int n = 0; n < nodes; ++n) {
    const int side = n / (2 * elements);
    const double t = double(n % (2 * elements)) / (2 * elements);
    const Point p = (1 - t) * corner[side] + t * corner[(side + 1) % 4], up = displacement(p, load);
    grid.points.push_back(p);
    u.insert(u.end(), {up.x(), up.y()});
    if (n % 2 == 0) grid.add_cell(VtuCell::quadratic_edge, {first + n, first + (n + 2) % nodes, first + n + 1});
    if (n % 2 == 0) regions.push_back(region);
  }
}

VtuGrid boundary(double load) {
  VtuGrid grid;
  std::vector<double> u;
  std::vector<std::int32_t> regions;
  add_box(grid, 0, middle - 0.00725, load, 1, u, regions);
  add_box(grid, middle + 0.00725, width, load, 2, u, regions);
  grid.point_data = {{"displacement", 2, u}};
  grid.cell_data = {{"region", 1, regions}};
  return grid;
}

void write_run(const std::filesystem::path& folder) {
  std::vector<PvdEntry> series;
  for (int n = 0; n <= 20; ++n) {
    const double load = n == 0 ? 0 : 270 + 7.0 * n;
    std::string stem = std::to_string(10000 + n);
    stem.replace(0, 1, "crack_");
    write_vtu(folder / (stem + "_lattice.vtu"), lattice(load));
    write_vtu(folder / (stem + "_boundary.vtu"), boundary(load));
    series.push_back({load, 0, stem + "_lattice.vtu"});
    series.push_back({load, 1, stem + "_boundary.vtu"});
  }
  write_pvd(folder / "crack.pvd", series);
  CsvTable history({"event", "load_factor", "total_broken_bonds", "reaction_x_1", "reaction_x_2"});
  for (int load = 1; load <= 410; ++load) {
    const double grown = (half_length(load) - 0.005) / 0.0201;
    const double reaction = 30e9 * 2 * increment * load / width * height * 0.9 * (1 - std::pow(grown, 1.5));
    history.add_row(std::vector<CsvValue>{std::int64_t{0}, double(load), std::int64_t(std::lround(900 * grown)),
                                          -reaction, reaction});
  }
  history.save(folder / "history.csv");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: output_crack_samples FOLDER\n";
    return 2;
  }
  write_run(path_from_utf8(argv[1]));
}
