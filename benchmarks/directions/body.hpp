#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace directions {

using Point = Eigen::Vector2d;

// A network of bonds between points one spacing apart, C1111 = 1, Young's modulus 8/9 and Poisson's ratio 1/3, plane
// stress. Lengths in spacings.
struct Bond {
  int first = 0, second = 0;
  double stiffness = 0, length = 0;
  Point direction = {0, 0};
};

struct Body {
  std::vector<Point> points;
  std::vector<char> held;  // displacement given, by `given` at load factor one
  std::vector<Point> given;
  std::vector<Bond> bonds;           // whole ones only
  std::vector<std::vector<int>> of;  // bonds of a point
  double horizon = 0;
  double critical_stretch = 0;  // a straight cut costs G0 = 1, on average over its directions
  double release = 0;           // energy released per length of crack at load factor one
  Point crack_begin = {-1e4, 0}, tip = {0, 0};
  std::vector<char> in_window;  // points between which bonds may break
};

struct Layout {
  int horizon = 3;      // in spacings
  double angle = 0;     // of the lattice's rows against the crack, in degrees
  unsigned seed = 1;    // of the lattice's origin and of random points
  double jitter = 0;    // points moved at random by up to this much in each direction
  int relaxation = -1;  // random points after so many of Lloyd's steps
  std::string kernel = "quartic";
  bool cracked = true;
  double width = 14;  // of the window to either side of a strip's middle
};

// A strip between clamps that move apart, the crack along its middle: G does not depend on where the crack ends.
Body strip(const Layout& layout, double half_height, double growth);

// A disc about the tip of a crack whose rim moves as the field of stress intensity factors cos(mode) and sin(mode).
Body disc(const Layout& layout, double radius, double mode_degrees);

// A square plate of this width whose left edge a crack meets at the middle, inclined and a fifth of the width long; its
// upper and lower edges are clamped and move apart.
Body plate(const Layout& layout, double width, double incline_degrees);

// Whether the segments a-b and c-d meet.
bool crosses(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace directions
