#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "geometry/point.hpp"

namespace bempd::output {

// Cell types of the VTK file format.
enum class VtuCell : std::uint8_t {
  vertex = 1,
  line = 3,
  polyline = 4,
  triangle = 5,        // corners counter-clockwise
  quad = 9,            // corners counter-clockwise
  quadratic_edge = 21  // both ends, then the middle
};

// Values of a point or cell field, entry by entry with all components of each. Plane vectors (2 components) get a third
// component 0 in the file, because viewers take only three components as a vector.
struct VtuArray {
  std::string name;
  int components = 1;
  std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<std::string>> values;
};

struct VtuGrid {
  std::vector<Point> points;
  std::vector<std::int64_t> connectivity;  // points of all cells, one cell after the other
  std::vector<std::int64_t> offsets;       // end of each cell in `connectivity`
  std::vector<VtuCell> types;
  std::vector<VtuArray> point_data;
  std::vector<VtuArray> cell_data;
  std::vector<VtuArray> field_data;  // data of the whole grid

  void add_cell(VtuCell type, const std::vector<std::int64_t>& cell_points);
};

// Writes a VTK XML file (UnstructuredGrid) with its numbers in binary form, NaN included. Throws std::system_error.
void write_vtu(const std::filesystem::path& path, const VtuGrid& grid);

}  // namespace bempd::output
