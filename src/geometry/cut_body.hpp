#pragma once

#include <algorithm>
#include <set>
#include <vector>

#include "geometry/boundary_mesh.hpp"
#include "geometry/subdomain_loops.hpp"

namespace bempd {

// Body that the given cuts divide into parts, except the cuts too close to its cracks.
struct CutBody {
  BoundaryMesh body;
  std::vector<Stations> given;  // cuts through the body without cracks
  std::vector<char> keep_off;   // flag of each given cut that keeps off the cracks

  std::vector<SubdomainLoops> parts;
  std::vector<Point> positions;  // positions of the body's nodes, then of nodes on cuts
  std::vector<Stations> made;    // given cuts that were made
  std::set<int> left_out;        // nodes at the ends of given cuts that were not made
  int panels;                    // number of panels, with one for each cut

  bool is_of(const BoundaryMesh& other, const std::vector<Stations>& cuts, const std::vector<char>& flags) const {
    const auto same = [](const BoundaryElement& a, const BoundaryElement& b) {
      return a.nodes == b.nodes && a.panel == b.panel && a.sweep == b.sweep;
    };
    return keep_off == flags && body.nodes == other.nodes &&
           std::equal(body.elements.begin(), body.elements.end(), other.elements.begin(), other.elements.end(), same) &&
           given == cuts;
  }
};

}  // namespace bempd
