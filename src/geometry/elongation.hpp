#pragma once

namespace bempd {

// How much longer a line gets along its direction (cosine, sine) when its ends move apart by (x, y). All stretches of
// bonds come from here; directions may be scaled, and x and y may be numbers or arrays of them.
template <class X, class Y>
auto elongation_along(double cosine, double sine, const X& x, const Y& y) {
  return cosine * x + sine * y;
}

}  // namespace bempd
