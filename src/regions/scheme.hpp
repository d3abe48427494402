#pragma once

#include <memory>

#include "regions/region.hpp"

namespace bempd::regions {

class BoundaryDescription;
class LatticeDescription;

// How the kinds of regions that schemes differ in become equations.
class Scheme {
 public:
  virtual ~Scheme() = default;

  virtual std::unique_ptr<Region> boundary_region(int id, const BoundaryDescription& described,
                                                  const scene::Material& material) const = 0;
  virtual std::unique_ptr<Region> lattice_region(int id, const LatticeDescription& described,
                                                 const scene::Material& material) const = 0;

  // Throws Error (argument) if two regions with grids of nodes cannot share an interface.
  virtual void require_grids_can_touch(int /*region*/, int /*other_region*/) const {}
};

// The one that the option `scheme` names.
std::unique_ptr<Scheme> make_scheme(const scene::Options& options);

}  // namespace bempd::regions
