#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace bempd {

// Hash by FNV-1a, 64 bits.
class Hash {
 public:
  void add_bytes(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    for (std::size_t i = 0; i < size; ++i) value_ = (value_ ^ bytes[i]) * 1099511628211ULL;
  }
  // Adds an integer, enumerator or flag as 64 bits, so that equal numbers of different types give the same hash.
  template <class T>
  requires std::is_integral_v<T> || std::is_enum_v<T>
  void add(T number) {
    const auto wide = static_cast<std::int64_t>(number);
    add_bytes(&wide, sizeof wide);
  }
  // Adds a floating-point number; 0 and -0 give the same hash.
  void add(double number) {
    const auto bits = std::bit_cast<std::uint64_t>(number + 0.0);
    add_bytes(&bits, sizeof bits);
  }
  void add(std::string_view words) {
    add(words.size());
    add_bytes(words.data(), words.size());
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

}  // namespace bempd
