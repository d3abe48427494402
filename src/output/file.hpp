#pragma once

#include <filesystem>
#include <string_view>

namespace bempd::output {

// Paths come from hosts as UTF-8, whatever the system's own encoding is.
std::filesystem::path path_from_utf8(std::string_view utf8);

// Replaces the file as a whole: readers see the old content or the new one, never a part, and a failure leaves the old
// file as it was. Throws std::system_error with the path and the system's reason.
void write_file(const std::filesystem::path& path, std::string_view content);

}  // namespace bempd::output
