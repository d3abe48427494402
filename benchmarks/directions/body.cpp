#include "body.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include "points.hpp"

namespace directions {
namespace {

double turn_of(const Point& a, const Point& b, const Point& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Displacement of the field of intensity one in each mode, C1111 = 1.
Point field(const Point& p, double mode) {
  constexpr double shear = 1.0 / 3, kappa = 2;  // (3 - nu) / (1 + nu)
  const double r = p.norm(), t = std::atan2(p.y(), p.x());
  const double scale = std::sqrt(r / (2 * std::numbers::pi)) / (2 * shear);
  const double c = std::cos(t / 2), s = std::sin(t / 2);
  const Point one(c * (kappa - 1 + 2 * s * s), s * (kappa + 1 - 2 * c * c));
  const Point two(s * (kappa + 1 + 2 * c * c), -c * (kappa - 1 - 2 * s * s));
  return scale * (std::cos(mode) * one + std::sin(mode) * two);
}

void connect(Body& body, const Layout& layout) {
  std::vector<Bond> bonds = make_bonds(layout, body.points);
  std::vector<Bond> inner;
  double inner_points = 0;
  for (const char in : body.in_window) inner_points += in;
  for (const Bond& bond : bonds) {
    const auto a = static_cast<std::size_t>(bond.first), b = static_cast<std::size_t>(bond.second);
    for (const std::size_t end : {a, b})
      if (body.in_window[end]) inner.push_back(bond);
    if (body.held[a] && body.held[b]) continue;
    if (!layout.cracked || !crosses(body.points[a], body.points[b], body.crack_begin, body.tip))
      body.bonds.push_back(bond);
  }
  for (Bond& bond : inner) bond.stiffness /= 2;
  body.critical_stretch = mean_critical_stretch(inner, inner_points);
  body.of.assign(body.points.size(), {});
  for (std::size_t k = 0; k < body.bonds.size(); ++k) {
    body.of[static_cast<std::size_t>(body.bonds[k].first)].push_back(static_cast<int>(k));
    body.of[static_cast<std::size_t>(body.bonds[k].second)].push_back(static_cast<int>(k));
  }
}

void place(Body& body, const Layout& layout, const Point& centre, const Point& half,
           const std::function<bool(const Point&)>& inside) {
  for (const Point& p : make_points(layout, centre, half))
    if (inside(p)) body.points.push_back(p);
  body.horizon = layout.horizon;
  body.held.assign(body.points.size(), 0);
  body.given.assign(body.points.size(), Point::Zero());
  body.in_window.assign(body.points.size(), 0);
}

}  // namespace

bool crosses(const Point& a, const Point& b, const Point& c, const Point& d) {
  return (turn_of(a, b, c) > 0) != (turn_of(a, b, d) > 0) && (turn_of(c, d, a) > 0) != (turn_of(c, d, b) > 0);
}

Body strip(const Layout& layout, double half_height, double growth) {
  Body body;
  const double behind = 0.75 * 2 * half_height, ahead = growth + 0.75 * 2 * half_height;
  place(body, layout, Point((ahead - behind) / 2, 0), Point((ahead + behind) / 2, half_height + layout.horizon),
        [](const Point&) { return true; });
  for (std::size_t k = 0; k < body.points.size(); ++k) {
    const Point p = body.points[k];
    body.held[k] = std::abs(p.y()) > half_height;
    body.given[k] = Point(0, p.y() > 0 ? 1 : -1);
    body.in_window[k] =
        p.x() > -3 - layout.horizon && p.x() < growth + layout.horizon + 2 && std::abs(p.y()) < layout.width;
  }
  connect(body, layout);
  return body;
}

Body disc(const Layout& layout, double radius, double mode_degrees) {
  Body body;
  const double whole = radius + layout.horizon;
  place(body, layout, Point(0, 0), Point(whole, whole), [whole](const Point& p) { return p.norm() < whole; });
  const double mode = mode_degrees * std::numbers::pi / 180;
  for (std::size_t k = 0; k < body.points.size(); ++k) {
    body.held[k] = body.points[k].norm() > radius;
    body.given[k] = field(body.points[k], mode);
    body.in_window[k] = body.points[k].norm() < 21;
  }
  connect(body, layout);
  body.release = 9.0 / 8;  // K^2 / E
  return body;
}

Body plate(const Layout& layout, double width, double incline_degrees) {
  Body body;
  const double half = width / 2, incline = incline_degrees * std::numbers::pi / 180;
  const Point along(std::cos(incline), std::sin(incline));
  place(body, layout, Point(half, 0), Point(half, half + layout.horizon), [](const Point&) { return true; });
  body.tip = width / 5 * along;
  body.crack_begin = -width * along;
  for (std::size_t k = 0; k < body.points.size(); ++k) {
    const Point p = body.points[k], ahead = p - body.tip;
    body.held[k] = std::abs(p.y()) > half;
    body.given[k] = Point(0, p.y() > 0 ? 1 : -1);
    body.in_window[k] = ahead.x() > -4 - layout.horizon && p.x() < width - 2 && std::abs(ahead.y()) < layout.width;
  }
  connect(body, layout);
  body.release = 1;  // not known
  return body;
}

}  // namespace directions
