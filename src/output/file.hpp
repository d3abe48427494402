#pragma once

#include <filesystem>
#include <string_view>

namespace bempd::output {

// Paths come from hosts as UTF-8, whatever the system's own encoding is.
std::filesystem::path path_from_utf8(std::string_view utf8);

// Writes a file as a whole: readers see the old content or the new one, never a part, and a failure leaves the old file
// as it was. Symbolic links are followed; a file that is replaced keeps its mode, and one that may not be written
// stays. What is no file is never replaced: terminals and other character devices, FIFOs (waiting for a reader) and
// files the process has open (/dev/stdout) are written to; folders, sockets and disks are refused. Throws
// std::system_error with the path and the reason.
void write_file(const std::filesystem::path& path, std::string_view content);

}  // namespace bempd::output
