#pragma once

#include <string>
#include <string_view>

namespace bempd::output {

// Whether XML can contain the text: valid UTF-8 without control characters other than tabs and line ends (XML 1.0,
// production 2, Char).
bool fits_xml(std::string_view text);

// Text escaped for a quoted attribute, so that readers get the same characters back; fits_xml() must hold for it.
std::string xml_escaped(std::string_view text);

// Text whose escaped form, by xml_escaped(), is `escaped`.
std::string xml_unescaped(std::string_view escaped);

// Value of the byte_order attribute of VTK files written by this machine.
std::string_view vtk_byte_order();

}  // namespace bempd::output
