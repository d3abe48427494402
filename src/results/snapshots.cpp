#include "results/snapshots.hpp"

#include <cstdio>
#include <filesystem>

#include "error.hpp"
#include "output/file.hpp"
#include "output/pvd.hpp"
#include "output/utf8.hpp"
#include "output/vtu.hpp"
#include "output/xml.hpp"
#include "results/writing.hpp"

namespace bempd::results {

namespace {

using regions::Field;
using regions::FieldValues;
using regions::SnapshotBlock;

// Fields of several regions, one after the other.
class GridBuilder {
 public:
  explicit GridBuilder(SnapshotBlock block) : block_(std::move(block)) {
    for (const SnapshotBlock::Array& array : block_.arrays)
      grid_.point_data.push_back({array.name, regions::components_of(array.field), std::vector<double>()});
    grid_.cell_data.push_back({"region", 1, std::vector<std::int32_t>()});
  }

  void add_region(const regions::Region& region, const FieldsOfScene& fields) {
    const auto first = static_cast<std::int64_t>(grid_.points.size());
    const FieldValues& positions = fields(region.id(), Field::position);
    for (std::size_t i = 0; i < positions.values.size(); i += 2)
      grid_.points.emplace_back(positions.values[i], positions.values[i + 1]);
    for (std::size_t f = 0; f < block_.arrays.size(); ++f) {
      const Field field = block_.arrays[f].field;
      const FieldValues at_nodes = region.at_nodes(field, fields(region.id(), field));
      auto& values = std::get<std::vector<double>>(grid_.point_data[f].values);
      values.insert(values.end(), at_nodes.values.begin(), at_nodes.values.end());
    }
    const regions::Cells cells = region.cells();
    for (std::size_t e = 0; e < cells.nodes.size(); e += cells.nodes_per_cell) {
      std::vector<std::int64_t> nodes;
      nodes.reserve(static_cast<std::size_t>(cells.nodes_per_cell));
      for (int k = 0; k < cells.nodes_per_cell; ++k) nodes.push_back(first + cells.nodes[e + k]);
      // VTK lists the ends of a quadratic edge before its middle.
      if (block_.cell == output::VtuCell::quadratic_edge) std::swap(nodes[1], nodes[2]);
      // The last corner of a triangle among quadrangles stands there twice.
      const bool triangle = block_.cell == output::VtuCell::quad && nodes[2] == nodes[3];
      if (triangle) nodes.pop_back();
      grid_.add_cell(triangle ? output::VtuCell::triangle : block_.cell, nodes);
      std::get<std::vector<std::int32_t>>(grid_.cell_data[0].values).push_back(region.id());
    }
  }

  const output::VtuGrid& grid() const { return grid_; }
  const std::string& name() const { return block_.name; }

 private:
  SnapshotBlock block_;
  output::VtuGrid grid_;
};

// Cracks, piece by piece.
output::VtuGrid grid_of(const std::vector<regions::CrackPicture>& cracks) {
  output::VtuGrid grid;
  std::vector<double> openings;
  std::vector<std::int32_t> numbers;
  for (const regions::CrackPicture& crack : cracks) {
    for (std::size_t i = 0; i < crack.places.size(); i += 3) {
      const auto first = static_cast<std::int64_t>(grid.points.size());
      grid.add_cell(output::VtuCell::quadratic_edge, {first, first + 2, first + 1});
      numbers.push_back(crack.crack);
      for (std::size_t k = i; k < i + 3; ++k) {
        grid.points.push_back(crack.places[k]);
        openings.insert(openings.end(), {crack.openings[k].x(), crack.openings[k].y()});
      }
    }
  }
  grid.point_data.push_back({"opening", 2, std::move(openings)});
  grid.cell_data.push_back({"crack", 1, std::move(numbers)});
  return grid;
}

// A point for each.
output::VtuGrid grid_of(const std::vector<regions::TipValues>& tips) {
  output::VtuGrid grid;
  std::vector<double> directions;
  std::vector<std::int32_t> cracks, ends, methods;
  for (const regions::TipValues& tip : tips) {
    grid.add_cell(output::VtuCell::vertex, {static_cast<std::int64_t>(grid.points.size())});
    grid.points.push_back(tip.place);
    directions.insert(directions.end(), {tip.direction.x(), tip.direction.y()});
    cracks.push_back(tip.crack), ends.push_back(tip.end + 1), methods.push_back(static_cast<std::int32_t>(tip.method));
  }
  const auto add = [&](const char* name, const auto& number_of) {
    std::vector<double> values;
    for (const regions::TipValues& tip : tips) values.push_back(number_of(tip));
    grid.point_data.push_back({name, 1, std::move(values)});
  };
  using Tip = regions::TipValues;
  add("stress_intensity_1", [](const Tip& tip) { return tip.factors.x(); });
  add("stress_intensity_2", [](const Tip& tip) { return tip.factors.y(); });
  add("energy_release_rate", [](const Tip& tip) { return tip.energy_release_rate; });
  add("t_stress", [](const Tip& tip) { return tip.stress_along; });
  add("error", [](const Tip& tip) { return tip.error; });
  add("kink_angle", [](const Tip& tip) { return tip.kink_angle; });
  add("critical_load_factor", [](const Tip& tip) { return tip.critical_load_factor; });
  add("felt_ahead", [](const Tip& tip) { return tip.felt_ahead; });
  grid.point_data.push_back({"direction", 2, std::move(directions)});
  grid.point_data.push_back({"crack", 1, std::move(cracks)});
  grid.point_data.push_back({"end", 1, std::move(ends)});
  grid.point_data.push_back({"method", 1, std::move(methods)});
  return grid;
}

void require_name_for_series(const std::string& prefix) {
  require(output::fits_xml(output::path_from_utf8(prefix).filename().native()), "prefix is ", output::printable(prefix),
          ", and prefix.pvd cannot name such files: XML holds neither bytes that are not UTF-8 nor ",
          "control characters; give another name");
}

}  // namespace

void Snapshots::write(const std::string& prefix, double load_factor, const regions::Discretization& d,
                      const FieldsOfScene& fields, const CracksShown& cracks) {
  require_name_for_series(prefix);
  const std::filesystem::path base = output::path_from_utf8(prefix);
  std::vector<Moment>& series = series_[prefix];
  char number[16];
  std::snprintf(number, sizeof number, "_%04zu", series.size());
  std::map<int, GridBuilder> blocks;
  for (const auto& region : d.regions) {
    SnapshotBlock block = region->snapshot_block();
    const int at = block.number;
    blocks.try_emplace(at, std::move(block)).first->second.add_region(*region, fields);
  }
  std::vector<Moment> all = series;
  all.push_back({load_factor, {}});
  writing([&] {
    const auto write_block = [&](int at, const std::string& name, const output::VtuGrid& grid) {
      std::filesystem::path file = base;
      file += std::string(number) + "_" + name + ".vtu";
      output::write_vtu(file, grid);
      all.back().files.emplace(at, file.filename().generic_string());
    };
    for (const auto& [at, builder] : blocks) write_block(at, builder.name(), builder.grid());
    constexpr int behind_regions = 100;
    if (!cracks.faces.empty()) write_block(behind_regions, "cracks", grid_of(cracks.faces));
    if (!cracks.tips.empty()) write_block(behind_regions + 1, "tips", grid_of(cracks.tips));
    std::vector<output::PvdEntry> entries;
    for (const Moment& moment : all) {
      for (const auto& [block, file] : moment.files) entries.push_back({moment.load_factor, block, file});
    }
    std::filesystem::path collection = base;
    collection += ".pvd";
    output::write_pvd(collection, entries);
  });
  series = std::move(all);
}

}  // namespace bempd::results
