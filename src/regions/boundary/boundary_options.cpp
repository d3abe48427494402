#include "scene/options.hpp"

namespace bempd::regions {

namespace {

const scene::OptionGroup boundary_group(scene::OptionPlace::boundaries, [] {
  return std::vector<scene::OptionDescription>{
      scene::shaping(scene::number_option(
          "bem.quadrature_tolerance",
          "Relative error of the boundary integrals of a pair of elements; a looser one is faster.", 1e-14, 1e-15, 1e-3,
          false)),
      scene::shaping(scene::text_option(
          "bem.grading",
          "Length of boundary elements near places where stress is singular, in scheme symmetric. auto: shorter and "
          "shorter towards re-entrant corners and ends of supports, on edges without bempd_set_edge_mesh(); on other "
          "edges near cracks only. none: as bempd_set_edge_mesh() or the region says.",
          "auto | none", "auto"))};
});

const scene::OptionGroup hooks(scene::OptionPlace::test_hooks, [] {
  return std::vector<scene::OptionDescription>{
      scene::shaping(scene::number_option("test.subdomain_elements",
                                          "Largest number of elements in a subdomain of a BEM region; 0: chosen, and "
                                          "small regions stay whole. With 1e9 all "
                                          "stay whole.",
                                          0, 0, 1e9, true))};
});

}  // namespace

}  // namespace bempd::regions
