#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <locale>
#include <sstream>
#include <system_error>

#include "output/csv.hpp"
#include "output/file.hpp"
#include "output/number.hpp"
#include "output/pvd.hpp"
#include "output/utf8.hpp"
#include "output/vtu.hpp"
#include "output/xml.hpp"

namespace {

using namespace bempd;
using namespace bempd::output;
namespace fs = std::filesystem;

class OutputFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("bempd_output_") + info->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string content(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  fs::path folder_;
};

// Numbers of the named array, found through its offset as a reader of the format would.
template <typename Number>
std::vector<Number> numbers_of(const std::string& file, const std::string& name) {
  const std::size_t tag = file.find("Name=\"" + name + "\"");
  if (tag == std::string::npos) return {};
  const std::size_t offset = std::stoul(file.substr(file.find("offset=\"", tag) + 8));
  const std::string opening = "<AppendedData encoding=\"raw\">\n_";
  const char* block = file.data() + file.find(opening) + opening.size() + offset;
  std::uint64_t size = 0;
  std::memcpy(&size, block, sizeof size);
  std::vector<Number> numbers(size / sizeof(Number));
  std::memcpy(numbers.data(), block + sizeof size, size);
  return numbers;
}

TEST_F(OutputFiles, vtu_holds_the_numbers_bit_by_bit) {
  VtuGrid grid;
  grid.points = {{0, 0.1}, {1.0 / 3, -2}, {5, 6}};
  grid.add_cell(VtuCell::quadratic_edge, {0, 2, 1});
  grid.add_cell(VtuCell::vertex, {2});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  grid.point_data = {{"u", 2, std::vector<double>{1, 2, nan, 4, 5, 6}}};
  grid.cell_data = {{"part", 1, std::vector<std::int32_t>{7, -8}}};
  write_vtu(folder_ / "a.vtu", grid);
  const std::string file = content(folder_ / "a.vtu");
  EXPECT_NE(file.find("<Piece NumberOfPoints=\"3\" NumberOfCells=\"2\">"), std::string::npos);
  EXPECT_EQ(numbers_of<double>(file, "Points"), (std::vector<double>{0, 0.1, 0, 1.0 / 3, -2, 0, 5, 6, 0}));
  const auto u = numbers_of<double>(file, "u");
  ASSERT_EQ(u.size(), 9u);
  EXPECT_TRUE(std::isnan(u[3]));
  EXPECT_EQ(u[2], 0);
  EXPECT_EQ(u[7], 6);
  EXPECT_EQ(numbers_of<std::int32_t>(file, "part"), (std::vector<std::int32_t>{7, -8}));
  EXPECT_EQ(numbers_of<std::int64_t>(file, "connectivity"), (std::vector<std::int64_t>{0, 2, 1, 2}));
  EXPECT_EQ(numbers_of<std::int64_t>(file, "offsets"), (std::vector<std::int64_t>{3, 4}));
  EXPECT_EQ(numbers_of<std::uint8_t>(file, "types"), (std::vector<std::uint8_t>{21, 1}));
}

TEST_F(OutputFiles, paths_are_utf8_and_nothing_else_stays_in_the_folder) {
  const fs::path path = folder_ / path_from_utf8("R\xC3\xADss \xE2\x84\x96 1.pvd");
  write_pvd(path, {});
  ASSERT_TRUE(fs::exists(path));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(OutputFiles, series_is_read_back_as_it_was_written) {
  const std::vector<PvdEntry> series{{-1.0 / 3, 0, "a \"b\" & <c>\n_0000_x.vtu", "x"}, {2, 7, "d.vtu"}};
  write_pvd(folder_ / "a.pvd", series);
  const auto read = read_pvd(folder_ / "a.pvd");
  ASSERT_TRUE(read && read->size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ((*read)[k].time, series[k].time);
    EXPECT_EQ((*read)[k].part, series[k].part);
    EXPECT_EQ((*read)[k].file, series[k].file);
    EXPECT_EQ((*read)[k].name, series[k].name);
  }
  std::ofstream(folder_ / "cut.pvd") << "<DataSet timestep=\"0\" part=\"0\" file=\"a.vtu\"/>";
  std::ofstream(folder_ / "word.pvd") << "<DataSet timestep=\"soon\" part=\"0\" file=\"a.vtu\"/></Collection>";
  for (const char* bad : {"cut.pvd", "word.pvd", "none.pvd"}) EXPECT_FALSE(read_pvd(folder_ / bad)) << bad;
}

TEST_F(OutputFiles, failure_names_the_path_and_the_reason) {
  const fs::path path = folder_ / "missing" / "a.vtu";
  try {
    write_vtu(path, {});
    FAIL() << "wrote into a folder that does not exist";
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code(), std::errc::no_such_file_or_directory);
    EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
  }
}

TEST_F(OutputFiles, failure_leaves_what_was_there_and_no_unfinished_file) {
  // A folder in place of the file cannot be replaced.
  fs::create_directories(folder_ / "a.csv" / "inner");
  EXPECT_THROW(CsvTable({"x"}).save(folder_ / "a.csv"), std::system_error);
  EXPECT_TRUE(fs::exists(folder_ / "a.csv" / "inner"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(OutputFiles, existing_file_is_replaced_as_a_whole) {
  write_file(folder_ / "a", "a long first content");
  write_file(folder_ / "a", "short");
  EXPECT_EQ(content(folder_ / "a"), "short");
}

TEST(OutputText, doubles_read_back_exactly) {
  for (double value : {0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, -0.0, 123456789.125, 1e22}) {
    const double back = std::strtod(to_text(value).c_str(), nullptr);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(back), std::bit_cast<std::uint64_t>(value)) << to_text(value);
  }
  EXPECT_EQ(to_text(-std::nan("")), "nan");
  EXPECT_EQ(to_text(-HUGE_VAL), "-inf");
}

struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(OutputText, numbers_ignore_the_locale) {
  const std::locale before = std::locale::global(std::locale(std::locale(), new DecimalComma));
  const std::string value = to_text(1234.5), count = to_text(std::int64_t{12345678});
  std::ostringstream localized;
  localized << 1234.5;
  std::locale::global(before);
  ASSERT_EQ(localized.str(), "1.234,5") << "the locale was not in force";
  EXPECT_EQ(value, "1234.5");
  EXPECT_EQ(count, "12345678");
}

TEST_F(OutputFiles, csv_quotes_only_what_needs_it) {
  CsvTable table({"plain", "with, comma"});
  table.add_row(std::vector<CsvValue>{std::string("say \"no\""), std::int64_t{-7}});
  table.add_row(std::vector<CsvValue>{std::string("two\nlines"), 0.5});
  table.add_row(std::vector<CsvValue>{1.0, std::nan("")});
  table.save(folder_ / "table.csv");
  EXPECT_EQ(content(folder_ / "table.csv"),
            "plain,\"with, comma\"\n\"say \"\"no\"\"\",-7\n\"two\nlines\",0.5\n1,nan\n");
}

TEST(OutputText, xml_attributes_are_escaped) {
  EXPECT_EQ(xml_escaped("a<b>&\"\t\n"), "a&lt;b&gt;&amp;&quot;&#9;&#10;");
}

TEST(OutputText, xml_holds_utf8_without_control_characters) {
  for (const char* good : {"", "a b", "R\xC3\xADss \xE2\x84\x96", "\xF0\x9F\x99\x82", "two\nlines", "\x7F"})
    EXPECT_TRUE(fits_xml(good)) << good;
  for (const char* bad : {"\x01", "\x1B[2J", "\xFF", "\xC3", "\xC0\xAF", "\xE2\x84", "\xED\xA0\x80", "\xF4\x90\x80\x80",
                          "\xEF\xBF\xBF", "a\x80"})
    EXPECT_FALSE(fits_xml(bad)) << printable(bad);
  EXPECT_FALSE(fits_xml(std::string_view("a\0b", 3)));
}

TEST(OutputText, printable_text_shows_what_cannot_be_shown_as_one_mark) {
  EXPECT_EQ(printable("R\xC3\xADss"), "R\xC3\xADss");
  EXPECT_EQ(printable("a\xFF\nb\xE2\x84"),
            "a\xEF\xBF\xBD\xEF\xBF\xBD"
            "b\xEF\xBF\xBD\xEF\xBF\xBD");
}

}  // namespace
