#include <string_view>
#include <system_error>

#include "error.hpp"
#include "model/saved_state.hpp"
#include "output/file.hpp"
#include "results/writing.hpp"

namespace bempd::model {

void write_state(const SavedState& state, const std::string& path) {
  const std::vector<std::uint8_t> bytes = to_bytes(state);
  const std::string_view content(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  results::writing([&] { output::write_file(output::path_from_utf8(path), content, true); });
}

SavedState read_state(const std::string& path) {
  std::vector<std::uint8_t> bytes;
  try {
    bytes = output::read_file(output::path_from_utf8(path));
  } catch (const std::system_error& e) {
    fail(Failure::io, e.what(), "; give the file that bempd_state_write() wrote");
  }
  return from_bytes(bytes.data(), bytes.size());
}

}  // namespace bempd::model
