#include "regions/boundary/boundary_method.hpp"

#include "bem/galerkin_operator.hpp"

namespace bempd::regions {

MeshingRules GalerkinMethod::meshing_rules(const scene::Options& options) const {
  return {false, options.text_value("bem.grading") == "auto"};
}

std::shared_ptr<const bem::BoundaryOperator> GalerkinMethod::make_operator(const ElementsOfRegion& elements,
                                                                           const bem::AssemblyOptions& assembly) const {
  return std::make_shared<const bem::GalerkinOperator>(elements.mesh, elements.elasticity, assembly);
}

}  // namespace bempd::regions
