#include "output/file.hpp"

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

namespace bempd::output {

namespace {

std::string utf8(const std::filesystem::path& path) {
  const std::u8string text = path.u8string();
  return {text.begin(), text.end()};
}

[[noreturn]] void fail(const std::filesystem::path& path, std::error_code reason) {
  throw std::system_error(reason, "cannot write " + utf8(path));
}

// Streams do not promise to set errno.
std::error_code last_error() { return {errno != 0 ? errno : EIO, std::generic_category()}; }

}  // namespace

std::filesystem::path path_from_utf8(std::string_view utf8) {
  return std::filesystem::path(std::u8string(utf8.begin(), utf8.end()));
}

void write_file(const std::filesystem::path& path, std::string_view content) {
  std::filesystem::path unfinished = path;
  unfinished += ".part";
  errno = 0;
  std::ofstream file(unfinished, std::ios::binary | std::ios::trunc);
  if (!file) fail(path, last_error());
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  std::error_code reason;
  if (!file)
    reason = last_error();
  else
    std::filesystem::rename(unfinished, path, reason);
  if (!reason) return;
  std::error_code ignored;
  std::filesystem::remove(unfinished, ignored);
  fail(path, reason);
}

}  // namespace bempd::output
