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

// Reads the first character; refuses what RFC 3629 refuses: longer forms than needed, halves of surrogate pairs, codes
// beyond 0x10ffff.
Character first_character(std::string_view text);

// Text with U+FFFD for control characters and for bytes that are not UTF-8, so that every host can show it.
std::string printable(std::string_view text);

}  // namespace bempd::output
