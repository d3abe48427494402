// Scheme of Yang and Liu, Int. J. Solids Struct. 2021: collocation, uncorrected bonds, and coupling by shared nodes.
#include "error.hpp"
#include "paper/cell_centred_lattice.hpp"
#include "paper/collocation_method.hpp"
#include "pd/cell_squares.hpp"
#include "regions/boundary/boundary_region.hpp"
#include "regions/scheme.hpp"

namespace bempd::paper {

namespace {

class PaperScheme final : public regions::Scheme {
 public:
  explicit PaperScheme(const scene::Options& options)
      : cell_centred_(options.text_value("paper.lattice") == "cell_centred"),
        rules_{options.text_value("paper.interface") == "traction",
               options.text_value("paper.corner_tractions") == "one"} {}

  std::unique_ptr<regions::Region> boundary_region(int id, const scene::Material& material) const override {
    return std::make_unique<regions::BoundaryRegion>(id, material, std::make_unique<CollocationMethod>(rules_));
  }

  std::unique_ptr<regions::Region> lattice_region(int id, const regions::PeridynamicDescription& described,
                                                  const scene::Material& material) const override {
    require(pd::is_bond_based(material.elasticity), "region ", id, " is peridynamic with Poisson's ratio ",
            material.elasticity.poisson_ratio, "; bonds as published, of scheme paper, need ",
            material.elasticity.state == PlaneState::stress ? "1/3 in plane stress" : "1/4 in plane strain",
            ": set it, or use scheme symmetric, which takes any");
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

const regions::SchemeRegistration registration({
    "paper",
    "collocation with uncorrected bonds as Yang and Liu 2021 have it",
    [](const scene::Options& options) -> std::unique_ptr<regions::Scheme> {
      return std::make_unique<PaperScheme>(options);
    },
    {scene::text_option(
         "paper.lattice",
         "Material points of scheme paper: cell_centred with points of their own on interfaces, or nodal.",
         "cell_centred | nodal", "cell_centred"),
     scene::text_option("paper.interface",
                        "What scheme paper balances at interfaces: nodal_force, tractions times the lengths of nodes "
                        "against bond forces, or traction, t = -b dx at every node (Eq. 27).",
                        "nodal_force | traction", "nodal_force"),
     scene::text_option("paper.corner_tractions", "Tractions at a corner of a boundary element region in scheme paper.",
                        "two | one", "two")},
});

}  // namespace

}  // namespace bempd::paper
