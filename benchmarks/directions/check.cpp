#include "check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "even_cuts.hpp"
#include "window.hpp"

namespace directions {
namespace {

// Largest relative difference over bonds spread over the window, before and after some have been broken.
double difference_of_releases(int horizon) {
  Layout layout;
  layout.horizon = horizon;
  layout.angle = 20;
  layout.width = 6;
  Body body = strip(layout, 10, 12);
  Window window(body);
  window.keep_compliances();
  std::vector<char> out(body.bonds.size(), 0);
  double largest = 0;
  const std::size_t stride = window.bonds().size() / 12;
  for (int round = 0; round < 2; ++round) {
    const double whole = elastic_energy(body, out);
    for (std::size_t k = 1; k < window.bonds().size(); k += stride) {
      const int bond = window.bonds()[k];
      if (out[static_cast<std::size_t>(bond)]) continue;
      out[static_cast<std::size_t>(bond)] = 1;
      const double direct = whole - elastic_energy(body, out);
      out[static_cast<std::size_t>(bond)] = 0;
      largest = std::max(largest, std::abs(window.release_of(bond) / direct - 1));
    }
    for (std::size_t k = 3; k < window.bonds().size(); k += stride / 2) {
      const int bond = window.bonds()[k];
      if (window.soften(bond, window.stiffness(bond)) >= 0) out[static_cast<std::size_t>(bond)] = 1;
    }
  }
  return largest;
}

}  // namespace

int check() {
  bool right = true;
  for (const int m : {3, 4}) {
    const double difference = difference_of_releases(m);
    right &= difference < 1e-6;
    std::fprintf(stderr, "m = %d: energy released by a bond, closed form against a solution without it: %.1e\n", m,
                 difference);
  }
  for (int m = 2; m <= 6; ++m) {
    Layout layout;
    layout.horizon = m;
    const Body body = disc(layout, 30, 0);
    const std::vector<double> same(body.bonds.size(), 1), even = even_stretches(body);
    const Cuts now = cost_of_cuts(body, same), then = cost_of_cuts(body, even);
    const auto [least, largest] = std::minmax_element(even.begin(), even.end());
    std::printf("%d,%.4f,%.4f,%.4f,%.4f,%.3f,%.3f\n", m, now.least, now.largest, then.least, then.largest, *least,
                *largest);
  }
  return right ? 0 : 1;
}

}  // namespace directions
