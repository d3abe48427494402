#include "bem/pair_blocks.hpp"

namespace bempd::bem {

namespace {

std::vector<ElementGeometry> geometries(const std::vector<GalerkinElement>& elements) {
  std::vector<ElementGeometry> result;
  result.reserve(elements.size());
  for (const GalerkinElement& e : elements) result.push_back(e.geometry);
  return result;
}

std::array<double, 3> shape_integrals(const ElementGeometry& element) {
  ElementPoints points;
  fill_points(element, {}, max_regular_points, points);
  std::array<double, 3> sums{};
  for (int k = 0; k < 3; ++k)
    for (int p = 0; p < points.count; ++p) sums[k] += points.mass[k][p];
  return sums;
}

Contact contact_of(const GalerkinElement& outer, const GalerkinElement& inner) {
  const bool end_to_start = outer.nodes[2] == inner.nodes[0], start_to_end = outer.nodes[0] == inner.nodes[2];
  if (end_to_start && start_to_end) return Contact::both_ends;
  if (end_to_start) return Contact::end_to_start;
  return start_to_end ? Contact::start_to_end : Contact::none;
}

}  // namespace

PairBlocks::PairBlocks(const std::vector<GalerkinElement>& elements, double nu, double quadrature_tolerance)
    : elements_(elements), nu_(nu), integrator_(geometries(elements), quadrature_tolerance) {
  for (const GalerkinElement& e : elements) node_lengths_.push_back(shape_integrals(e.geometry));
}

PairMoments PairBlocks::moments(int outer, int inner, PairPart part) const {
  if (outer == inner) return integrator_.integrate(outer, inner, Contact::same, part);
  const GalerkinElement &x = elements_[outer], &y = elements_[inner];
  if (y.crack && part == PairPart::everything) part = PairPart::without_mass;
  // Pairs with crack elements are integrated as if they had no common node, because no constant is subtracted from
  // openings.
  const Contact contact = x.crack || y.crack ? Contact::none : contact_of(x, y);
  if (contact == Contact::none)
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        if (x.places[i] == y.places[j]) return integrator_.integrate_meeting(outer, i, inner, j, part);
  return integrator_.integrate(outer, inner, contact, part);
}

}  // namespace bempd::bem
