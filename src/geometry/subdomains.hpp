#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "geometry/boundary_mesh.hpp"
#include "geometry/subdomain_loops.hpp"

namespace bempd {

// Subdomain of a body: a part of it, with a boundary mesh of its own.
struct Subdomain {
  BoundaryMesh mesh;
  std::vector<int> nodes;     // of each of its nodes: the number in the body's mesh, or behind that on cuts
  std::vector<int> elements;  // of each of its elements: the number in the body's mesh; -1 on a cut
  std::vector<int> cracks;    // numbers of the cracks in it
};

struct CutBody;

// Subdivision of a body by straight cuts through its material. The body's own mesh stays as it is.
struct Subdivision {
  std::vector<Point> cut_nodes;  // nodes on cuts, numbered behind those of the body's mesh
  std::vector<Subdomain> subdomains;
  std::vector<Stations> cuts;
  std::shared_ptr<const CutBody> joined;  // of a body with cracks: its parts between the given cuts

  std::size_t largest() const;  // number of elements of the largest subdomain
};

// Halves the body until no subdomain has more than `most_elements`, or no cut is found through a larger one. The result
// has one subdomain if the body cannot be cut.
Subdivision subdivide(const BoundaryMesh& body, std::size_t most_elements);

// Subdivides a body with cracks, whose mesh has short elements beside them. Of the `cuts` through the body without
// cracks all are made that keep off the cracks and end at nodes. Subdomains that are too large without the others are
// cut anew, around the cracks. So cracks change the subdomains beside them only. The parts between the given cuts are
// taken from `before` (null: none), such a subdivision with other cracks, if the same cuts were made there in the same
// mesh.
Subdivision subdivide(const BoundaryMesh& body, std::size_t most_elements, const std::vector<Stations>& cuts,
                      const std::vector<Stations>& cracks, const Subdivision* before = nullptr);

}  // namespace bempd
