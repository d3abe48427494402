#include "output/vtu.hpp"

#include <cassert>
#include <string_view>
#include <type_traits>

#include "output/file.hpp"
#include "output/number.hpp"
#include "output/xml.hpp"

namespace bempd::output {

namespace {

std::string count_text(std::size_t count) { return to_text(static_cast<std::int64_t>(count)); }

template <typename Number>
constexpr std::string_view vtk_type() {
  if constexpr (std::is_same_v<Number, double>) return "Float64";
  if constexpr (std::is_same_v<Number, std::int32_t>) return "Int32";
  if constexpr (std::is_same_v<Number, std::int64_t>) return "Int64";
  if constexpr (std::is_same_v<Number, std::uint8_t>) return "UInt8";
}

// Text of a VTU file: XML elements that describe the arrays, followed by one block with their numbers. In the block,
// each array is its size in bytes (UInt64) and its bytes; the element gives the array's offset in the block.
class VtuFile {
 public:
  void open(std::string_view element) { text_.append("<").append(element).append(">\n"); }
  void close(std::string_view element) { text_.append("</").append(element).append(">\n"); }

  template <typename Number>
  void add_array(std::string_view name, int components, const std::vector<Number>& values, bool counted = false) {
    add_element(vtk_type<Number>(), name, components, values.size(), counted);
    add_bytes(values.data(), values.size() * sizeof(Number));
  }
  // Texts follow one another in the block, each with a zero at its end.
  void add_array(std::string_view name, int components, const std::vector<std::string>& values, bool counted = false) {
    add_element("String", name, components, values.size(), counted);
    std::string bytes;
    for (const std::string& value : values) bytes.append(value).push_back('\0');
    add_bytes(bytes.data(), bytes.size());
  }

  std::string finish() {
    std::string file = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"";
    file.append(vtk_byte_order()).append("\" header_type=\"UInt64\">\n").append(text_);
    file.append("<AppendedData encoding=\"raw\">\n_").append(block_);
    return file.append("\n</AppendedData>\n</VTKFile>\n");
  }

 private:
  void add_element(std::string_view type, std::string_view name, int components, std::size_t size, bool counted) {
    text_.append("<DataArray type=\"").append(type);
    text_.append("\" Name=\"").append(xml_escaped(name));
    // The number of components is left out if it is 1, the default: some readers make a matrix of a scalar field
    // otherwise.
    if (components != 1) text_.append("\" NumberOfComponents=\"").append(to_text(std::int64_t{components}));
    // The number of entries is given for data of the whole grid only: readers know the numbers of points and cells.
    if (counted) text_.append("\" NumberOfTuples=\"").append(count_text(size / static_cast<std::size_t>(components)));
    text_.append("\" format=\"appended\" offset=\"").append(count_text(block_.size())).append("\"/>\n");
  }
  void add_bytes(const void* bytes, std::uint64_t size) {
    block_.append(reinterpret_cast<const char*>(&size), sizeof size);
    if (size > 0) block_.append(static_cast<const char*>(bytes), size);
  }

  std::string text_, block_;
};

template <typename Number>
std::vector<Number> padded_to_three(const std::vector<Number>& pairs) {
  std::vector<Number> triples(pairs.size() / 2 * 3, Number{});
  for (std::size_t i = 0; i < pairs.size() / 2; ++i) {
    triples[3 * i] = pairs[2 * i];
    triples[3 * i + 1] = pairs[2 * i + 1];
  }
  return triples;
}

void add_data(VtuFile& file, std::string_view element, const std::vector<VtuArray>& arrays,
              [[maybe_unused]] std::size_t entry_count) {
  file.open(element);
  for (const VtuArray& array : arrays) {
    std::visit(
        [&](const auto& values) {
          assert(values.size() == entry_count * static_cast<std::size_t>(array.components));
          if (array.components == 2)
            file.add_array(array.name, 3, padded_to_three(values));
          else
            file.add_array(array.name, array.components, values);
        },
        array.values);
  }
  file.close(element);
}

void add_field_data(VtuFile& file, const std::vector<VtuArray>& arrays) {
  if (arrays.empty()) return;
  file.open("FieldData");
  for (const VtuArray& array : arrays)
    std::visit([&](const auto& values) { file.add_array(array.name, array.components, values, true); }, array.values);
  file.close("FieldData");
}

std::vector<double> coordinates(const std::vector<Point>& points) {
  std::vector<double> all;
  all.reserve(3 * points.size());
  for (const Point& p : points) all.insert(all.end(), {p.x(), p.y(), 0.0});
  return all;
}

std::vector<std::uint8_t> type_numbers(const std::vector<VtuCell>& types) {
  std::vector<std::uint8_t> numbers;
  numbers.reserve(types.size());
  for (VtuCell type : types) numbers.push_back(static_cast<std::uint8_t>(type));
  return numbers;
}

}  // namespace

void VtuGrid::add_cell(VtuCell type, const std::vector<std::int64_t>& cell_points) {
  connectivity.insert(connectivity.end(), cell_points.begin(), cell_points.end());
  offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  types.push_back(type);
}

void write_vtu(const std::filesystem::path& path, const VtuGrid& grid) {
  assert(grid.offsets.size() == grid.types.size());
  assert(grid.offsets.empty() || grid.offsets.back() == static_cast<std::int64_t>(grid.connectivity.size()));
  VtuFile file;
  file.open("UnstructuredGrid");
  add_field_data(file, grid.field_data);
  file.open("Piece NumberOfPoints=\"" + count_text(grid.points.size()) + "\" NumberOfCells=\"" +
            count_text(grid.types.size()) + "\"");
  add_data(file, "PointData", grid.point_data, grid.points.size());
  add_data(file, "CellData", grid.cell_data, grid.types.size());
  file.open("Points");
  file.add_array("Points", 3, coordinates(grid.points));
  file.close("Points");
  file.open("Cells");
  file.add_array("connectivity", 1, grid.connectivity);
  file.add_array("offsets", 1, grid.offsets);
  file.add_array("types", 1, type_numbers(grid.types));
  file.close("Cells");
  file.close("Piece");
  file.close("UnstructuredGrid");
  write_file(path, file.finish());
}

}  // namespace bempd::output
