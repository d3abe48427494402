// Bytes read as choices and numbers; where they end, zeros follow.
#ifndef BEMPD_TESTS_FUZZ_BYTES_HPP
#define BEMPD_TESTS_FUZZ_BYTES_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace fuzz {

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  bool is_empty() const { return left_ == 0; }

  std::uint8_t byte() {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }

  // 0 .. count - 1.
  int pick(int count) { return byte() % count; }

  template <class T, std::size_t count>
  T of(const std::array<T, count>& values) {
    return values[byte() % count];
  }

  // A number as one finds it in scenes.
  double ordinary() {
    static constexpr std::array values = {1.0, 0.0, 1e-3, -1e-3, 2e-3, 0.3, -1.0, 4e-3, 0.02, 1e-6, 3.0, 10.0};
    return of(values);
  }

  // A number as one finds it at the ends of their range, or any eight bytes.
  double extreme() {
    using Limits = std::numeric_limits<double>;
    static constexpr std::array values = {0.0,
                                          -0.0,
                                          5e-324,
                                          1e-310,
                                          1e-300,
                                          1e-154,
                                          1e-30,
                                          1e-12,
                                          1e12,
                                          1e30,
                                          1e154,
                                          1e300,
                                          1e308,
                                          -1e308,
                                          -1.0,
                                          1e-8,
                                          Limits::infinity(),
                                          Limits::quiet_NaN()};
    const std::size_t choice = byte() % (values.size() + 2);
    if (choice < values.size()) return values[choice];
    std::array<std::uint8_t, sizeof(double)> raw;
    for (std::uint8_t& one : raw) one = byte();
    double number;
    std::memcpy(&number, raw.data(), sizeof number);
    return number;
  }

  // Mostly ordinary: with one extreme number in ten calls a scene seldom comes to its first step.
  double number() { return byte() < 248 ? ordinary() : extreme(); }

  // The given value but for a few.
  double mostly(double value) { return byte() < 252 ? value : extreme(); }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

}  // namespace fuzz

#endif
