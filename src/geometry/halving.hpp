#pragma once

#include <algorithm>
#include <vector>

namespace bempd {

// Halves an interval, at most `most_halvings` times, until the `length` of each part is at most limit() at its ends and
// its middle; appends the ends of the parts to `ends`.
template <class Limit>
void halve(double from, double to, double length, const Limit& limit, int most_halvings, std::vector<double>& ends) {
  const double middle = 0.5 * (from + to);
  // The limit has slack, so that rounding cannot divide only one of two equal elements.
  constexpr double slack = 1 + 1e-9;
  if (most_halvings > 0 && length > slack * std::min({limit(from), limit(middle), limit(to)})) {
    halve(from, middle, 0.5 * length, limit, most_halvings - 1, ends);
    halve(middle, to, 0.5 * length, limit, most_halvings - 1, ends);
    return;
  }
  ends.push_back(to);
}

// Ends of elements after `halvings` halvings of each element. For a negative number, neighbours are merged in pairs
// that many times; if the number of elements is odd, the last element is not merged.
std::vector<double> halved(std::vector<double> stations, int halvings);

}  // namespace bempd
