#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "geometry/boundary_mesh.hpp"
#include "geometry/subdomain_loops.hpp"

namespace bempd {

// Subdomain: a part of a body with a boundary mesh of its own.
struct Subdomain {
  BoundaryMesh mesh;
  std::vector<int> nodes;     // number of each node in the body's mesh, or behind these numbers on cuts
  std::vector<int> elements;  // number of each element in the body's mesh; -1 on a cut
  std::vector<int> cracks;    // numbers of the cracks in the subdomain
};

struct CutBody;

// Subdivision of a body by straight cuts through its material. The body's own mesh stays as it is.
struct Subdivision {
  std::vector<Point> cut_nodes;  // nodes on cuts, numbered behind those of the body's mesh
  std::vector<Subdomain> subdomains;
  std::vector<Stations> cuts;
  std::shared_ptr<const CutBody> joined;  // parts of a body with cracks between the given cuts

  std::size_t largest() const;  // number of elements of the largest subdomain
};

// Halves the body until no subdomain has more than `most_elements`, or no cut is found through a larger one. The result
// has one subdomain if the body cannot be cut.
Subdivision subdivide(const BoundaryMesh& body, std::size_t most_elements);

// Subdivides a body with cracks, whose mesh has short elements beside them. `cuts` are the cuts through the body
// without cracks; those of them that keep a distance from the cracks and end at nodes are made again. Where a subdomain
// is too large because a cut could not be made again, it is cut around the cracks, so that cracks change only the
// subdomains beside them. `before` is a subdivision of the same body with other cracks (null: none). Its parts between
// the repeated cuts are reused if the same cuts were repeated in the same mesh.
Subdivision subdivide(const BoundaryMesh& body, std::size_t most_elements, const std::vector<Stations>& cuts,
                      const std::vector<Stations>& cracks, const Subdivision* before = nullptr);

}  // namespace bempd
