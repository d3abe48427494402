#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace bempd::output {

using CsvValue = std::variant<double, std::int64_t, std::string>;

// Table with one header line, comma separated (RFC 4180, lines end with \n). Doubles read back exactly.
class CsvTable {
 public:
  explicit CsvTable(const std::vector<std::string>& columns);

  void add_row(const std::vector<double>& values);
  void add_row(const std::vector<CsvValue>& values);

  const std::string& text() const { return text_; }

  // Writes the table. Throws std::system_error.
  void save(const std::filesystem::path& path) const;

 private:
  std::size_t column_count_;
  std::string text_;
};

}  // namespace bempd::output
