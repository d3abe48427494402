#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "output/vtu.hpp"
#include "regions/cell_splits.hpp"
#include "regions/fields.hpp"

namespace bempd::regions {

// Cells of a region: quadrilaterals between its nodes, or elements of its boundary.
struct Cells {
  int nodes_per_cell;
  std::vector<std::int32_t> nodes;  // in the region's own numbering
};

// Cells of a region as a picture shows them, split along cracks, with the points that are added where cells are split.
struct RegionPicture {
  std::vector<AddedPoint> added;  // numbered after the region's nodes
  Cells cells;
};

// Block of a snapshot file. All regions whose blocks have the same name are written to one block.
struct SnapshotBlock {
  std::string name;
  int number;  // blocks are written in this order
  output::VtuCell cell;
  struct Array {
    const char* name;
    Field field;
  };
  std::vector<Array> arrays;
};

// Results of a region: fields at its nodes or elements, values at places, and what pictures show.
class RegionResults {
 public:
  virtual ~RegionResults() = default;

  // Entry of each of the region's nodes in fields that are given at nodes; -1 for a node without an entry.
  virtual std::vector<int> entries_of_nodes() const = 0;
  // Scene node for each entry of a field given at nodes: the node with whose displacement the entry moves.
  virtual std::vector<int> nodes_of_entries() const = 0;
  // Size of a field. Throws Error (argument) if the region does not have the field.
  virtual FieldSize field_size(Field field) const = 0;
  virtual FieldValues field(Field field, const Solution& solution) const = 0;
  virtual std::int64_t cell_count() const = 0;
  virtual Cells cells() const = 0;
  virtual SnapshotBlock snapshot_block() const = 0;
  virtual RegionPicture picture(const Solution& /*solution*/) const { return {{}, cells()}; }
  // Whether the region's cells are boundary elements, so that its interior needs a picture of its own.
  virtual bool has_inside() const { return false; }
  // Field as written to snapshots, with one entry for each node.
  virtual FieldValues at_nodes(Field /*field*/, const FieldValues& values) const { return values; }
  // Creates an evaluator for places in the region. `fields` and `solution` must outlive the evaluator; stresses are
  // evaluated only if `with_stress`.
  virtual std::unique_ptr<Evaluator> evaluator(const Solution& solution, const FieldsOfRegion& fields,
                                               bool with_stress) const = 0;
  // Rank at interfaces: the region with the highest rank gives the values of places on an interface.
  virtual int rank_at_interfaces() const = 0;
};

}  // namespace bempd::regions
