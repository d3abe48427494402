#include "output/pvd.hpp"

#include <charconv>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

#include "output/file.hpp"
#include "output/number.hpp"
#include "output/utf8.hpp"
#include "output/xml.hpp"

namespace bempd::output {

namespace {

constexpr std::string_view entry_begin = "<DataSet ";

std::optional<std::string> attribute(std::string_view entry, std::string_view name) {
  std::string begin(1, ' ');
  begin.append(name).append("=\"");
  const std::size_t from = entry.find(begin);
  if (from == std::string_view::npos) return std::nullopt;
  entry.remove_prefix(from + begin.size());
  return xml_unescaped(entry.substr(0, entry.find('"')));
}

template <typename Number>
bool read_number(const std::optional<std::string>& text, Number& number) {
  if (!text) return false;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), number);
  return error == std::errc() && end == text->data() + text->size();
}

}  // namespace

void write_pvd(const std::filesystem::path& path, const std::vector<PvdEntry>& entries) {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"";
  text.append(vtk_byte_order()).append("\">\n<Collection>\n");
  for (const PvdEntry& entry : entries) {
    if (!fits_xml(entry.file)) {
      throw std::system_error(
          std::make_error_code(std::errc::invalid_argument),
          "cannot write " + printable(path.native()) + ": XML cannot hold the name " + printable(entry.file));
    }
    text.append(entry_begin).append("timestep=\"").append(to_text(entry.time));
    text.append("\" group=\"\" part=\"").append(to_text(std::int64_t{entry.part}));
    if (!entry.name.empty()) text.append("\" name=\"").append(xml_escaped(entry.name));
    text.append("\" file=\"").append(xml_escaped(entry.file)).append("\"/>\n");
  }
  write_file(path, text.append("</Collection>\n</VTKFile>\n"));
}

std::optional<std::vector<PvdEntry>> read_pvd(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string all{std::istreambuf_iterator<char>(file), {}};
  if (!file || all.find("</Collection>") == std::string::npos) return std::nullopt;
  std::vector<PvdEntry> entries;
  for (std::size_t at = all.find(entry_begin); at != std::string::npos; at = all.find(entry_begin, at + 1)) {
    const std::string_view entry = std::string_view(all).substr(at, all.find("/>", at) - at);
    PvdEntry read;
    const std::optional<std::string> name = attribute(entry, "name"), shown = attribute(entry, "file");
    if (!read_number(attribute(entry, "timestep"), read.time) || !read_number(attribute(entry, "part"), read.part) ||
        !shown)
      return std::nullopt;
    read.name = name.value_or("");
    read.file = *shown;
    entries.push_back(std::move(read));
  }
  return entries;
}

}  // namespace bempd::output
