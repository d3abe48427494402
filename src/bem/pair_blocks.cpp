#include "bem/pair_blocks.hpp"

#include <numbers>

namespace bempd::bem {

namespace {

std::vector<ElementGeometry> geometries(const std::vector<GalerkinElement>& elements) {
  std::vector<ElementGeometry> result;
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

// Symmetric 2 x 2 blocks  isotropic * I + factor * (cosine, sine; sine, -cosine).
Eigen::Matrix2d symmetric_block(double isotropic, double cosine, double sine) {
  Eigen::Matrix2d block;
  block << isotropic + cosine, sine, sine, isotropic - cosine;
  return block;
}

}  // namespace

PairBlocks::PairBlocks(const std::vector<GalerkinElement>& elements, double nu, double quadrature_tolerance)
    : elements_(elements), nu_(nu), integrator_(geometries(elements), quadrature_tolerance) {
  for (const GalerkinElement& e : elements) node_lengths_.push_back(shape_integrals(e.geometry));
}

PairMoments PairBlocks::moments(int outer, int inner, PairPart part) const {
  if (outer == inner) return integrator_.integrate(outer, inner, Contact::same, part);
  const GalerkinElement &x = elements_[outer], &y = elements_[inner];
  // Openings have no common node in the sense that counts: nothing of theirs is subtracted.
  const Contact contact = x.crack || y.crack ? Contact::none : contact_of(x, y);
  if (contact == Contact::none)
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        if (x.places[i] == y.places[j]) return integrator_.integrate_meeting(outer, i, inner, j, part);
  return integrator_.integrate(outer, inner, contact, part);
}

Eigen::Matrix2d PairBlocks::single_layer(int outer, int inner, const PairMoments& m, int a, int b) const {
  const double half = outer == inner ? 0.5 : 1.0;
  const double single = half / (8 * std::numbers::pi * (1 - nu_));
  // Trace part 1/2 of e e^T: a product of integrals here, nothing in the closed loops of D.
  const double trace = 0.5 * node_lengths_[outer][a] * node_lengths_[inner][b];
  return single * symmetric_block(trace - (3 - 4 * nu_) * m.mass[0][b][a], m.mass[1][b][a], m.mass[2][b][a]);
}

Eigen::Matrix2d PairBlocks::hypersingular(int outer, int inner, const PairMoments& m, int a, int b) const {
  const double half = outer == inner ? 0.5 : 1.0;
  const double hyper = half / (2 * std::numbers::pi * (1 - nu_));
  return hyper * symmetric_block(-m.derivative[0][b][a], m.derivative[1][b][a], m.derivative[2][b][a]);
}

Eigen::Matrix2d PairBlocks::double_layer(const PairMoments& m, int a, int b) const {
  const double factor = -1 / (4 * std::numbers::pi * (1 - nu_));
  const auto& moment = m.double_layer;
  const double rotation = (1 - 2 * nu_) * moment[1][b][a];
  Eigen::Matrix2d transposed =
      symmetric_block((2 - 2 * nu_) * moment[0][b][a], 2 * moment[2][b][a], 2 * moment[3][b][a]);
  transposed(1, 0) += rotation;
  transposed(0, 1) -= rotation;
  return factor * transposed;
}

}  // namespace bempd::bem
