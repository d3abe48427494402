// Writes the files that output_meshio_test.py reads back, into the folder given.
#include <cmath>
#include <iostream>
#include <limits>
#include <numbers>

#include "output/csv.hpp"
#include "output/file.hpp"
#include "output/pvd.hpp"
#include "output/vtu.hpp"

namespace {

using namespace bempd;
using namespace bempd::output;

VtuGrid all_cell_types() {
  VtuGrid grid;
  for (int i = 0; i < 9; ++i) grid.points.push_back({0.1 * (i % 3), std::numbers::pi * (i / 3)});
  grid.add_cell(VtuCell::vertex, {4});
  grid.add_cell(VtuCell::line, {0, 1});
  grid.add_cell(VtuCell::line, {1, 2});
  grid.add_cell(VtuCell::quadratic_edge, {6, 8, 7});
  grid.add_cell(VtuCell::quad, {0, 1, 4, 3});
  std::vector<double> scalar, vector, triple;
  std::vector<std::int32_t> number;
  for (int i = 0; i < 9; ++i) {
    scalar.push_back(i == 5 ? std::numeric_limits<double>::quiet_NaN() : i / 3.0);
    vector.insert(vector.end(), {i + 0.25, -1.0 * i});
    triple.insert(triple.end(), {1e-300 * i, 1e300, i == 2 ? -HUGE_VAL : 0.5});
    number.push_back(i - 4);
  }
  grid.point_data = {{"damage", 1, scalar}, {"displacement", 2, vector}, {"stress", 3, triple}, {"id", 1, number}};
  grid.field_data = {{"load_factor", 1, std::vector<double>{0.25}}, {"snapshot", 1, std::vector<std::int32_t>{3}}};
  grid.cell_data = {{"region", 1, std::vector<std::int32_t>{1, 2, 3, 4, 5}},
                    {"a < b & \"c\" \xC3\xA4", 2, std::vector<double>(10, 0.125)}};
  return grid;
}

void write_samples(const std::filesystem::path& folder) {
  write_vtu(folder / path_from_utf8("all \xC3\xBC.vtu"), all_cell_types());
  write_vtu(folder / "empty.vtu", VtuGrid{});
  write_pvd(folder / "series.pvd", {{0, 0, "a_0000_plate.vtu"}, {0, 1, "a_0000_box.vtu"}, {0.1, 0, "b & c.vtu"}});
  CsvTable table({"step", "load [N]", "note"});
  table.add_row(std::vector<CsvValue>{std::int64_t{1}, 0.1, "plain"});
  table.add_row(std::vector<CsvValue>{std::int64_t{2}, -1.0 / 3, "a \"quoted\", longer\nnote"});
  table.save(folder / "table.csv");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: output_samples FOLDER\n";
    return 2;
  }
  write_samples(path_from_utf8(argv[1]));
}
