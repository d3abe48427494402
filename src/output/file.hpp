#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace bempd::output {

// Path from a UTF-8 text of the host, whatever the encoding of the system.
std::filesystem::path path_from_utf8(std::string_view utf8);

// Writes a file as a whole: readers see the old content or the new one, never a part, and a failure leaves the old file
// as it was. Symbolic links are followed. A file that is replaced keeps its mode; one without write permission is not
// replaced. Terminals and other character devices, FIFOs (after waiting for a reader) and files the process has open
// (/dev/stdout) are written to; folders, sockets and disks are refused. Throws std::system_error with the path and the
// reason. With `to_disk` the new file is flushed to the disk before it replaces the old one, so that one of the two
// survives if the machine stops.
void write_file(const std::filesystem::path& path, std::string_view content, bool to_disk = false);

// Reads all bytes of a file. Throws std::system_error with the path and the reason.
std::vector<std::uint8_t> read_file(const std::filesystem::path& path);

}  // namespace bempd::output
