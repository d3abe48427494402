#pragma once

#include "window.hpp"

namespace directions {

// Stress intensity factors of a straight crack that ends at `tip` in `direction`, by least squares of the first terms
// of Williams' series to displacements of points between two radii about the tip.
struct Intensity {
  double one = 0, two = 0;
};
Intensity fit_williams(const Body& body, const Window& window, const Point& tip, const Point& direction, double inner,
                       double outer);

// The same from stresses at points ahead of the tip, none of which is beside the crack.
class MeanStress;
Intensity fit_stresses(const Body& body, const Window& window, const MeanStress& stress, const Point& tip,
                       const Point& direction, double inner, double outer);

// Angle of a kink by the largest hoop stress (Erdogan and Sih 1963), and the intensity that it compares with toughness.
double hoop_angle(const Intensity& k);
double hoop_intensity(const Intensity& k);

}  // namespace directions
