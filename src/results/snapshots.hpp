#pragma once

#include <map>
#include <string>
#include <vector>

#include "regions/discretization.hpp"
#include "results/point_values.hpp"

namespace bempd::results {

// What a snapshot shows of cracks.
struct CracksShown {
  std::vector<regions::CrackPicture> faces;
  std::vector<regions::TipValues> tips;
};

// Series of VTK files, one file a block of regions and moment, with a collection for each series.
class Snapshots {
 public:
  // Adds a moment to the series of this prefix. Throws Error (io).
  void write(const std::string& prefix, double load_factor, const regions::Discretization& discretization,
             const FieldsOfScene& fields, const CracksShown& cracks);

 private:
  struct Moment {
    double load_factor;
    std::map<int, std::string> files;  // by number of the block
  };
  std::map<std::string, std::vector<Moment>> series_;  // by prefix
};

}  // namespace bempd::results
