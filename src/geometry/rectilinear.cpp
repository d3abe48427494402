#include "geometry/rectilinear.hpp"

#include <algorithm>
#include <cmath>

namespace bempd {

namespace {

// Largest number of cells along one side of the box. More cells are not intended, and too small for the tolerance.
constexpr double most_cells_along_a_side = 1e6;

struct Frame {
  Point first;  // vertex of the outer loop that lies on a lattice point
  double spacing;
  double tolerance;

  bool divides(double length) const { return std::abs(length - std::round(length / spacing) * spacing) <= tolerance; }
  LatticePoint steps_to(const Point& p) const { return ((p - first) / spacing).array().round().cast<int>().matrix(); }
};

bool usable_spacing(double spacing, const Box& box, double tolerance) {
  if (!(spacing > 0) || !std::isfinite(spacing)) return false;
  return spacing > 4 * tolerance && box.sizes().maxCoeff() / spacing <= most_cells_along_a_side;
}

// Lengths that must be whole numbers of spacings: those of edges, and the distances of holes from the first vertex.
std::vector<double> lengths_of(const Outline& outline) {
  std::vector<double> lengths;
  for (const Edge& edge : edges_of(outline)) lengths.push_back(edge.direction().cwiseAbs().maxCoeff());
  for (const auto& loop : outline.loops)
    for (int i = 0; i < 2; ++i) lengths.push_back(std::abs(loop[0][i] - outline.loops[0][0][i]));
  return lengths;
}

LatticeFit find_misfit(const Outline& outline, const Frame& frame) {
  const std::vector<Edge> edges = edges_of(outline);
  LatticeFit fit;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const Point size = edges[k].direction().cwiseAbs();
    fit.edge = static_cast<int>(k);
    fit.length = size.norm();
    if (size.minCoeff() > frame.tolerance) fit.misfit = LatticeMisfit::oblique_edge;
    if (!fit.fits()) return fit;
  }
  for (std::size_t k = 0; k < edges.size(); ++k) {
    fit.edge = static_cast<int>(k);
    fit.length = edges[k].direction().cwiseAbs().maxCoeff();
    if (!frame.divides(fit.length)) fit.misfit = LatticeMisfit::indivisible_edge;
    if (!fit.fits()) return fit;
  }
  int first_edge = 0;
  for (std::size_t l = 0; l < outline.loops.size(); ++l) {
    for (int i = 0; i < 2; ++i) {
      fit.edge = first_edge;
      fit.loop = static_cast<int>(l);
      fit.length = std::abs(outline.loops[l][0][i] - frame.first[i]);
      if (!frame.divides(fit.length)) fit.misfit = LatticeMisfit::shifted_hole;
      if (!fit.fits()) return fit;
    }
    first_edge += static_cast<int>(outline.loops[l].size());
  }
  return {};
}

std::vector<LatticePoint> without_collinear(const std::vector<LatticePoint>& loop) {
  std::vector<LatticePoint> corners;
  const std::size_t n = loop.size();
  for (std::size_t k = 0; k < n; ++k) {
    const LatticePoint before = loop[k] - loop[(k + n - 1) % n], after = loop[(k + 1) % n] - loop[k];
    const bool straight = (before.x() == 0 && after.x() == 0) || (before.y() == 0 && after.y() == 0);
    if (!straight) corners.push_back(loop[k]);
  }
  return corners;
}

LatticeOutline to_lattice(const Outline& outline, const Frame& frame) {
  LatticePoint lowest = LatticePoint::Zero();
  for (const Point& p : outline.loops[0]) lowest = lowest.cwiseMin(frame.steps_to(p));
  LatticeOutline result;
  result.spacing = frame.spacing;
  result.origin = frame.first + frame.spacing * lowest.cast<double>();
  for (const auto& loop : outline.loops) {
    std::vector<LatticePoint> points;
    points.reserve(loop.size());
    for (const Point& p : loop) points.push_back(frame.steps_to(p) - lowest);
    for (std::size_t k = 0; k < points.size(); ++k)
      result.edges.push_back({points[k], points[(k + 1) % points.size()]});
    result.loops.push_back(without_collinear(points));
  }
  return result;
}

// Largest common measure of lengths by Euclid's algorithm, where remainders below the tolerance count as zero; 0 if the
// measure is close to the tolerance.
double common_measure(const std::vector<double>& lengths, double tolerance) {
  double measure = 0;
  for (double length : lengths) {
    double a = measure, b = length;
    while (b > tolerance) {
      const double rest = std::abs(a - std::round(a / b) * b);
      a = b;
      b = rest;
    }
    measure = a;
  }
  return measure > 1000 * tolerance ? measure : 0;
}

bool divides_all(double spacing, const std::vector<double>& lengths, double tolerance) {
  const Frame frame{Point::Zero(), spacing, tolerance};
  return std::all_of(lengths.begin(), lengths.end(), [&](double length) { return frame.divides(length); });
}

double rounded_to_digits(double value, int digits) {
  const int exponent = digits - 1 - static_cast<int>(std::floor(std::log10(value)));
  const double scale = std::pow(10.0, std::abs(exponent));
  return exponent >= 0 ? std::round(value * scale) / scale : std::round(value / scale) * scale;
}

// Decimal number equal to the spacing `exact` up to 1e-6 of it, with as few digits as still divide all lengths; 0 if
// four digits are not enough.
double short_spacing(double exact, const std::vector<double>& lengths, double tolerance) {
  for (int digits = 1; digits <= 4; ++digits) {
    const double rounded = rounded_to_digits(exact, digits);
    if (std::abs(rounded - exact) < 1e-6 * exact && divides_all(rounded, lengths, tolerance)) return rounded;
  }
  return 0;
}

// First of the spacings measure / parts, with parts = first, first + step, ..., that is a short decimal number; else
// measure / first if that divides all lengths; else 0. Only spacings within a factor three of `wanted` count.
double nearest_spacing(double wanted, double measure, double first, double step, const std::vector<double>& lengths,
                       double tolerance) {
  const auto within_reach = [&](double parts) {
    return parts >= 1 && measure / parts <= 3 * wanted && measure / parts >= wanted / 3;
  };
  constexpr int most_tries = 10000;
  double parts = first;
  for (int tries = 0; within_reach(parts) && tries < most_tries; ++tries, parts += step)
    if (const double spacing = short_spacing(measure / parts, lengths, tolerance)) return spacing;
  return within_reach(first) && divides_all(measure / first, lengths, tolerance) ? measure / first : 0;
}

}  // namespace

std::vector<double> spacings_near(double wanted, const std::vector<double>& lengths, double tolerance) {
  if (divides_all(wanted, lengths, tolerance)) return {wanted};
  const double measure = common_measure(lengths, tolerance);
  if (measure == 0) return {};
  const double parts = std::floor(measure / wanted);
  std::vector<double> found;
  for (double spacing : {nearest_spacing(wanted, measure, parts + 1, 1, lengths, tolerance),
                         nearest_spacing(wanted, measure, parts, -1, lengths, tolerance)})
    if (spacing > 0) found.push_back(spacing);
  return found;
}

LatticeFit fit_lattice(const Outline& outline, double spacing) {
  const Box box = bounding_box(outline);
  const double tolerance = geometric_tolerance(box);
  LatticeFit fit;
  if (!usable_spacing(spacing, box, tolerance)) {
    fit.misfit = LatticeMisfit::bad_spacing;
    return fit;
  }
  const Frame frame{outline.loops[0][0], spacing, tolerance};
  fit = find_misfit(outline, frame);
  if (fit.fits())
    fit.outline = to_lattice(outline, frame);
  else if (fit.misfit != LatticeMisfit::oblique_edge)
    fit.suggestions = spacings_near(spacing, lengths_of(outline), tolerance);
  return fit;
}

}  // namespace bempd
