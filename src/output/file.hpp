#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace bempd::output {

// Path from a host's UTF-8 text, whatever the system's own encoding is.
std::filesystem::path path_from_utf8(std::string_view utf8);

// Writes a file as a whole: readers see the old content or the new one, never a part, and a failure leaves the old file
// as it was. Symbolic links are followed; a file that is replaced keeps its mode, and one that may not be written
// stays. Only files are replaced: terminals and other character devices, FIFOs (waiting for a reader) and files the
// process has open (/dev/stdout) are written to; folders, sockets and disks are refused. Throws std::system_error with
// the path and the reason. With `to_disk` a file lies on the disk before it takes the place of the old one, so that a
// machine that stops leaves one of both.
void write_file(const std::filesystem::path& path, std::string_view content, bool to_disk = false);

// Reads all bytes of a file. Throws std::system_error with the path and the reason.
std::vector<std::uint8_t> read_file(const std::filesystem::path& path);

}  // namespace bempd::output
