#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace bempd::output {

using CsvValue = std::variant<double, std::int64_t, std::string>;

// Table as comma-separated text with one header line (RFC 4180, but lines end with \n). Doubles read back exactly.
class CsvTable {
 public:
  explicit CsvTable(const std::vector<std::string>& columns);

  void add_row(const std::vector<CsvValue>& values);

  // Writes the table to a file. Throws std::system_error if this fails.
  void save(const std::filesystem::path& path) const;

 private:
  std::size_t column_count_;
  std::string text_;
};

}  // namespace bempd::output
