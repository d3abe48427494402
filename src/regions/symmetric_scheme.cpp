#include "regions/symmetric_scheme.hpp"

#include "regions/boundary/boundary_region.hpp"
#include "regions/lattice/lattice_region.hpp"
#include "regions/outlined/outlined_region.hpp"

namespace bempd::regions {

namespace {

class SymmetricScheme final : public Scheme {
 public:
  std::unique_ptr<Region> boundary_region(int id, const scene::Material& material) const override {
    return std::make_unique<BoundaryRegion>(id, material, std::make_unique<GalerkinMethod>());
  }
  std::unique_ptr<Region> lattice_region(int id, const PeridynamicDescription& described,
                                         const scene::Material& material) const override {
    return std::make_unique<LatticeRegion>(id, described, material);
  }
  std::unique_ptr<Region> outlined_region(int id, const PeridynamicDescription& described,
                                          const scene::Material& material) const override {
    return std::make_unique<OutlinedRegion>(id, described, material);
  }
};

}  // namespace

std::unique_ptr<Scheme> make_symmetric_scheme() { return std::make_unique<SymmetricScheme>(); }

}  // namespace bempd::regions
