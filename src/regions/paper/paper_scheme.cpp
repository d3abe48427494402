#include "regions/paper/paper_scheme.hpp"

#include "error.hpp"
#include "regions/paper/cell_centred_lattice.hpp"
#include "regions/paper/collocation_region.hpp"

namespace bempd::regions {

namespace {

class PaperScheme final : public Scheme {
 public:
  explicit PaperScheme(const scene::Options& options)
      : cell_centred_(options.text_value("paper.lattice") == "cell_centred"),
        rules_{options.text_value("paper.interface") == "traction",
               options.text_value("paper.corner_tractions") == "one" ? CornerTractions::one : CornerTractions::two} {}

  std::unique_ptr<Region> boundary_region(int id, const BoundaryDescription& described,
                                          const scene::Material& material) const override {
    return std::make_unique<CollocationRegion>(id, described, material, rules_);
  }

  std::unique_ptr<Region> lattice_region(int id, const LatticeDescription& described,
                                         const scene::Material& material) const override {
    if (cell_centred_) return std::make_unique<CellCentredLattice>(id, described, material);
    return std::make_unique<UncorrectedLattice>(id, described, material);
  }

  void require_grids_can_touch(int region, int other_region) const override {
    require(false, "peridynamic regions ", region, " and ", other_region,
            " touch; scheme paper couples peridynamic regions to boundary elements only: make them one region");
  }

 private:
  bool cell_centred_;
  CollocationRules rules_;
};

}  // namespace

std::unique_ptr<Scheme> make_paper_scheme(const scene::Options& options) {
  return std::make_unique<PaperScheme>(options);
}

}  // namespace bempd::regions
