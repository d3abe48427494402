#pragma once

#include <cstddef>
#include <vector>

#include "geometry/boundary_mesh.hpp"

namespace bempd {

// Subdomain of a body: a part of it, with a boundary mesh of its own.
struct Subdomain {
  BoundaryMesh mesh;
  std::vector<int> nodes;     // of each of its nodes: the number in the body's mesh, or behind that on cuts
  std::vector<int> elements;  // of each of its elements: the number in the body's mesh; -1 on a cut
};

// Subdivision of a body by straight cuts through its material. The body's own mesh stays as it is.
struct Subdivision {
  std::vector<Point> cut_nodes;  // nodes on cuts, numbered behind those of the body's mesh
  std::vector<Subdomain> subdomains;

  std::size_t largest() const;  // number of elements of the largest subdomain
};

// Halves the body until no subdomain has more than `most_elements`, or no cut is found through a larger one. The result
// has one subdomain if the body cannot be cut.
Subdivision subdivide(const BoundaryMesh& body, std::size_t most_elements);

}  // namespace bempd
