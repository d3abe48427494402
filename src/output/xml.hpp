#pragma once

#include <string>
#include <string_view>

namespace bempd::output {

// Text made fit for a quoted XML attribute. Control characters, which XML cannot hold, become spaces.
std::string xml_escaped(std::string_view text);

// Value of the byte_order attribute of VTK files written by this machine.
std::string_view vtk_byte_order();

}  // namespace bempd::output
