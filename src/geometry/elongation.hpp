#pragma once

namespace bempd {

// Elongation of a straight line along its direction (cosine, sine) if the displacements of its ends differ by (x, y).
// All bond stretches are computed by this function. The direction may be scaled; x and y may be numbers or arrays.
template <class X, class Y>
auto elongation_along(double cosine, double sine, const X& x, const Y& y) {
  return cosine * x + sine * y;
}

}  // namespace bempd
