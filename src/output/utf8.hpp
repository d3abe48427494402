#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace bempd::output {

// Character at the start of a text.
struct Character {
  char32_t code = 0;
  std::size_t bytes = 1;
  bool valid = false;  // false: the first byte begins no character of UTF-8
};

// Reads the first character of a text that is not empty. As RFC 3629 demands, forms longer than needed, halves of
// surrogate pairs and codes beyond 0x10ffff are invalid.
Character first_character(std::string_view text);

// Text in which U+FFFD replaces control characters and bytes that are not UTF-8, so that every host can show it.
std::string printable(std::string_view text);

}  // namespace bempd::output
