#include "output/xml.hpp"

#include <bit>
#include <cassert>

#include "output/utf8.hpp"

namespace bempd::output {

namespace {

// Reference that stands for a character in XML; empty if the character needs none. Tabs and line ends need a reference,
// because readers turn bare ones in attributes into spaces (XML 1.0, section 3.3.3).
std::string_view reference(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\t':
      return "&#9;";
    case '\n':
      return "&#10;";
    case '\r':
      return "&#13;";
    default:
      return {};
  }
}

}  // namespace

bool fits_xml(std::string_view text) {
  while (!text.empty()) {
    const Character c = first_character(text);
    const bool white = c.code == '\t' || c.code == '\n' || c.code == '\r';
    if (!c.valid || (c.code < 0x20 && !white) || c.code == 0xfffe || c.code == 0xffff) return false;
    text.remove_prefix(c.bytes);
  }
  return true;
}

std::string xml_escaped(std::string_view text) {
  assert(fits_xml(text));
  std::string escaped;
  for (const char c : text) {
    if (const std::string_view other = reference(c); !other.empty())
      escaped += other;
    else
      escaped += c;
  }
  return escaped;
}

std::string xml_unescaped(std::string_view escaped) {
  std::string text;
  while (!escaped.empty()) {
    std::string_view taken = escaped.substr(0, 1);
    char c = escaped.front();
    for (const char known : {'&', '<', '>', '"', '\t', '\n', '\r'}) {
      if (!escaped.starts_with(reference(known))) continue;
      taken = reference(known);
      c = known;
    }
    text += c;
    escaped.remove_prefix(taken.size());
  }
  return text;
}

std::string_view vtk_byte_order() { return std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian"; }

}  // namespace bempd::output
