#pragma once

#include <string>
#include <string_view>

namespace bempd::output {

// Whether XML can hold the text: valid UTF-8 whose control characters are tabs and line ends only (XML 1.0, production
// 2, Char).
bool fits_xml(std::string_view text);

// Text that fits, escaped for a quoted attribute so that readers get the same characters back.
std::string xml_escaped(std::string_view text);

// Text from which xml_escaped() made this one.
std::string xml_unescaped(std::string_view escaped);

// Value of the byte_order attribute of VTK files written by this machine.
std::string_view vtk_byte_order();

}  // namespace bempd::output
