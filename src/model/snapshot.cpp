#include <cstdio>
#include <filesystem>
#include <system_error>

#include "error.hpp"
#include "model/model.hpp"
#include "output/csv.hpp"
#include "output/file.hpp"
#include "output/pvd.hpp"
#include "output/utf8.hpp"
#include "output/vtu.hpp"
#include "output/xml.hpp"

namespace bempd::model {

namespace {

// Files are the host's business: its reason and the path, as an error the host can act on.
template <class Body>
void writing(const Body& body) {
  try {
    body();
  } catch (const std::system_error& e) {
    fail(Failure::io, e.what(), "; check that the folder exists and can be written to");
  }
}

// Fields of several regions, one after the other.
class GridBuilder {
 public:
  explicit GridBuilder(const std::vector<std::pair<const char*, int>>& point_fields) {
    for (const auto& [name, components] : point_fields)
      grid_.point_data.push_back({name, components, std::vector<double>()});
    grid_.cell_data.push_back({"region", 1, std::vector<std::int32_t>()});
  }

  void add_region(int region, const FieldValues& positions, const std::vector<const FieldValues*>& fields,
                  const std::vector<std::int32_t>& elements, int nodes_per_element, output::VtuCell type) {
    const auto first = static_cast<std::int64_t>(grid_.points.size());
    for (std::size_t i = 0; i < positions.values.size(); i += 2) {
      grid_.points.emplace_back(positions.values[i], positions.values[i + 1]);
    }
    for (std::size_t f = 0; f < fields.size(); ++f) {
      auto& values = std::get<std::vector<double>>(grid_.point_data[f].values);
      values.insert(values.end(), fields[f]->values.begin(), fields[f]->values.end());
    }
    for (std::size_t e = 0; e < elements.size(); e += nodes_per_element) {
      std::vector<std::int64_t> nodes;
      for (int k = 0; k < nodes_per_element; ++k) nodes.push_back(first + elements[e + k]);
      // VTK lists the ends of a quadratic edge before its middle.
      if (type == output::VtuCell::quadratic_edge) std::swap(nodes[1], nodes[2]);
      grid_.add_cell(type, nodes);
      std::get<std::vector<std::int32_t>>(grid_.cell_data[0].values).push_back(region);
    }
  }

  const output::VtuGrid& grid() const { return grid_; }

 private:
  output::VtuGrid grid_;
};

// Tractions of the two elements at a node differ at corners: their mean is what a picture shows.
FieldValues node_tractions(const BoundaryMesh& mesh, const FieldValues& element_tractions) {
  FieldValues field{std::vector<double>(2 * mesh.nodes.size(), 0.0), 2};
  std::vector<int> count(mesh.nodes.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    for (int k = 0; k < 3; ++k) {
      const int node = mesh.elements[e].nodes[k];
      for (int c = 0; c < 2; ++c) field.values[2 * node + c] += element_tractions.values[2 * (3 * e + k) + c];
      ++count[node];
    }
  }
  for (std::size_t i = 0; i < field.values.size(); ++i) field.values[i] /= count[i / 2];
  return field;
}

void require_name_for_series(const std::string& prefix) {
  require(output::fits_xml(output::path_from_utf8(prefix).filename().native()), "prefix is ", output::printable(prefix),
          ", and prefix.pvd cannot name such files: XML holds neither bytes that are not UTF-8 nor ",
          "control characters; give another name");
}

}  // namespace

void Model::write_snapshot(const std::string& prefix) {
  require_name_for_series(prefix);
  ensure_equilibrium();
  const Discretization& d = prepared_->discretization;
  const std::filesystem::path base = output::path_from_utf8(prefix);
  std::vector<Snapshot>& series = snapshots_[prefix];
  char number[16];
  std::snprintf(number, sizeof number, "_%04zu", series.size());
  Snapshot snapshot{load_factor(), "", ""};
  const auto file = [&](const char* part) {
    std::filesystem::path path = base;
    path += std::string(number) + "_" + part + ".vtu";
    return path;
  };
  writing([&] {
    if (!d.lattices.empty()) {
      GridBuilder builder({{"displacement", 2}, {"damage", 1}, {"stress", 3}});
      for (const LatticePart& part : d.lattices) {
        builder.add_region(part.region, field(part.region, Field::position),
                           {&field(part.region, Field::displacement), &field(part.region, Field::damage),
                            &field(part.region, Field::stress)},
                           elements(part.region), 4, output::VtuCell::quad);
      }
      output::write_vtu(file("lattice"), builder.grid());
      snapshot.lattice_file = file("lattice").filename().generic_string();
    }
    if (!d.boundaries.empty()) {
      GridBuilder builder({{"displacement", 2}, {"traction", 2}, {"stress", 3}});
      for (const BoundaryPart& part : d.boundaries) {
        const FieldValues traction = node_tractions(part.mesh, field(part.region, Field::traction));
        builder.add_region(part.region, field(part.region, Field::position),
                           {&field(part.region, Field::displacement), &traction, &field(part.region, Field::stress)},
                           elements(part.region), 3, output::VtuCell::quadratic_edge);
      }
      output::write_vtu(file("boundary"), builder.grid());
      snapshot.boundary_file = file("boundary").filename().generic_string();
    }
    std::vector<output::PvdEntry> entries;
    std::vector<Snapshot> all = series;
    all.push_back(snapshot);
    for (const Snapshot& s : all) {
      if (!s.lattice_file.empty()) entries.push_back({s.load_factor, 0, s.lattice_file});
      if (!s.boundary_file.empty()) entries.push_back({s.load_factor, 1, s.boundary_file});
    }
    std::filesystem::path collection = base;
    collection += ".pvd";
    output::write_pvd(collection, entries);
  });
  series.push_back(snapshot);
}

void Model::write_history(const std::string& path) const {
  std::vector<std::string> columns{"event",         "load_factor",          "total_broken_bonds",
                                   "stretch_ratio", "stored_energy",        "released_energy",
                                   "work",          "energy_balance_error", "residual"};
  const std::size_t supports = scene_.supports().size();
  for (std::size_t s = 1; s <= supports; ++s) {
    columns.push_back(text("reaction_x_", s));
    columns.push_back(text("reaction_y_", s));
  }
  output::CsvTable table(columns);
  if (prepared_) {
    const fracture::EvolutionState& state = prepared_->evolution->progress();
    for (std::size_t i = 0; i < state.history.size(); ++i) {
      const fracture::HistoryEntry& h = state.history[i];
      std::vector<output::CsvValue> row{h.event,         h.load_factor,          h.total_broken_bonds,
                                        h.stretch_ratio, h.stored_energy,        h.released_energy,
                                        h.work,          h.energy_balance_error, h.residual};
      for (std::size_t r = 2 * supports * i; r < 2 * supports * (i + 1); ++r) row.emplace_back(state.reactions[r]);
      table.add_row(row);
    }
  }
  writing([&] { table.save(output::path_from_utf8(path)); });
}

}  // namespace bempd::model
