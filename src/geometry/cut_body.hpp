#pragma once

#include <algorithm>
#include <set>
#include <vector>

#include "geometry/boundary_mesh.hpp"
#include "geometry/subdomain_loops.hpp"

namespace bempd {

// Parts of a body between cuts that are given and keep off its cracks.
struct CutBody {
  BoundaryMesh body;
  std::vector<Stations> given;
  std::vector<char> keep_off;  // of each given cut: whether it keeps off the cracks

  std::vector<SubdomainLoops> parts;
  std::vector<Point> positions;  // of the body's nodes and those on cuts
  std::vector<Stations> made;
  std::set<int> left_out;  // nodes at which cuts end that were not made
  int panels;

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
