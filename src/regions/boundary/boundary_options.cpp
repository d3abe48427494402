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
          "Boundary elements of scheme symmetric near places where stress is singular: auto, smaller and smaller "
          "towards re-entrant corners and ends of supports on edges without bempd_set_edge_mesh(), on others near "
          "cracks; none.",
          "auto | none", "auto"))};
});

}  // namespace

}  // namespace bempd::regions
