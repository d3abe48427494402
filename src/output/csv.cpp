#include "output/csv.hpp"

#include <cassert>

#include "output/file.hpp"
#include "output/number.hpp"

namespace bempd::output {

namespace {

std::string quoted_if_needed(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted += '"';
}

std::string field_text(const std::string& value) { return quoted_if_needed(value); }
std::string field_text(const CsvValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return quoted_if_needed(*text);
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return to_text(*whole);
  return to_text(std::get<double>(value));
}

template <typename Value>
void append_line(std::string& text, const std::vector<Value>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += ',';
    text += field_text(values[i]);
  }
  text += '\n';
}

}  // namespace

CsvTable::CsvTable(const std::vector<std::string>& columns) : column_count_(columns.size()) {
  append_line(text_, columns);
}

void CsvTable::add_row(const std::vector<CsvValue>& values) {
  assert(values.size() == column_count_);
  append_line(text_, values);
}

void CsvTable::save(const std::filesystem::path& path) const { write_file(path, text_); }

}  // namespace bempd::output
