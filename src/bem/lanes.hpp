#pragma once

#include <cstdint>
#include <cstring>
#include <numbers>

namespace bempd::bem {

// Types of vectors with `count` numbers, on which the processor's vector unit works at once. Functions with vector
// arguments must always be inlined, because the calling convention for vectors depends on the instruction set that a
// function is compiled for.
template <int count>
struct Lanes;

template <>
struct Lanes<2> {
  using Values [[gnu::vector_size(2 * sizeof(double))]] = double;
  using Bits [[gnu::vector_size(2 * sizeof(double))]] = std::uint64_t;
};

template <>
struct Lanes<4> {
  using Values [[gnu::vector_size(4 * sizeof(double))]] = double;
  using Bits [[gnu::vector_size(4 * sizeof(double))]] = std::uint64_t;
};

template <class Values>
[[gnu::always_inline]] inline Values load(const double* from) {
  Values values;
  std::memcpy(&values, from, sizeof values);
  return values;
}

template <class Values>
[[gnu::always_inline]] inline void store(const Values& values, double* to) {
  std::memcpy(to, &values, sizeof values);
}

template <class Values>
struct LogarithmAndInverse {
  Values half_logarithm, inverse;
};

// ln(x) / 2 and 1 / x of normal positive numbers, to a few units of the last place, with one division for both. With x
// = 2^e m, where m lies in [sqrt(1/2), sqrt(2)), ln(m) / 2 = artanh(s) for s = (m - 1) / (m + 1), |s| < 0.172. Ten
// terms of the series of artanh leave an error of 1e-17 of the value.
template <int count>
[[gnu::always_inline]] inline LogarithmAndInverse<typename Lanes<count>::Values> half_logarithm_and_inverse(
    const typename Lanes<count>::Values& x) {
  using Values = typename Lanes<count>::Values;
  using Bits = typename Lanes<count>::Bits;
  constexpr std::uint64_t one = 0x3FF0000000000000, root_of_half = 0x3FE6A09E667F3BCD, mantissa = 0x000FFFFFFFFFFFFF;
  // The integer exponent is converted to a double by writing it into the mantissa of 2^52, which adds it to 2^52.
  constexpr std::uint64_t two_to_52 = 0x4330000000000000;
  constexpr double exponent_offset = 4503599627370496.0 + 1023;
  const Bits shifted = reinterpret_cast<Bits>(x) + (one - root_of_half);
  const Values exponent = reinterpret_cast<Values>(shifted >> 52 | two_to_52) - exponent_offset;
  const Values m = reinterpret_cast<Values>((shifted & mantissa) + root_of_half);
  const Values above = m + 1, both = 1 / (x * above);
  const Values s = (m - 1) * (x * both), square = s * s;
  // Odd and even powers are summed separately, so that one sum does not wait for the other.
  const Values fourth = square * square;
  const Values odd = 1.0 / 3 + fourth * (1.0 / 7 + fourth * (1.0 / 11 + fourth * (1.0 / 15 + fourth * (1.0 / 19))));
  const Values even = 1.0 / 5 + fourth * (1.0 / 9 + fourth * (1.0 / 13 + fourth * (1.0 / 17)));
  const Values series = square * (odd + square * even);
  return {0.5 * std::numbers::ln2 * exponent + (s + s * series), above * both};
}

}  // namespace bempd::bem
