#include "results/snapshots.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

#include "error.hpp"
#include "output/file.hpp"
#include "output/utf8.hpp"
#include "output/vtu.hpp"
#include "output/xml.hpp"
#include "results/writing.hpp"

namespace bempd::results {

namespace {

namespace fs = std::filesystem;
using output::PvdEntry;

const scene::OptionGroup snapshot_group(scene::OptionPlace::results, [] {
  return std::vector<scene::OptionDescription>{
      scene::text_option("snapshots.existing",
                         "What the first snapshot of a model with some prefix does with files of another run that have "
                         "this prefix. refuse: the call fails. continue: snapshots go on behind the last file, as for "
                         "a run that was restored from a state. replace: the files are written anew.",
                         "refuse | continue | replace", "refuse"),
      scene::number_option("snapshots.inside",
                           "Snapshots show the inside of BEM regions on triangles whose sides are the root of the "
                           "region's area over this number; 0: the boundary alone.",
                           12, 0, 1000, false)};
});

fs::path with_ending(const fs::path& base, const std::string& ending) {
  fs::path file = base;
  file += ending;
  return file;
}

bool is_there(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(file, ignored));
}

void require_name_for_series(const std::string& prefix) {
  require(output::fits_xml(output::path_from_utf8(prefix).filename().native()), "prefix is ", output::printable(prefix),
          ", and prefix.pvd cannot name such files: XML holds neither bytes that are not UTF-8 nor ",
          "control characters; give another name");
}

[[noreturn]] void refuse(const fs::path& file) {
  fail(Failure::io, output::printable(file.native()),
       " is there already, of another run; give another prefix, move the files away, or set the option "
       "snapshots.existing to continue, to go on behind them, or to replace");
}

// Number of the moment (point of the run that a snapshot shows) in a file name prefix_NNNN_part.vtu; -1 if the name has
// no such number.
int number_in(const std::string& file) {
  const std::size_t end = file.rfind('_'), begin = end == std::string::npos ? end : file.rfind('_', end - 1);
  int number = -1;
  if (begin != std::string::npos) std::from_chars(file.data() + begin + 1, file.data() + end, number);
  return number;
}

std::string text_of(int number) {
  char text[16];
  std::snprintf(text, sizeof text, "_%04d", number);
  return text;
}

// New files, which the destructor removes unless keep() was called after all files could be written.
class NewFiles {
 public:
  ~NewFiles() {
    std::error_code ignored;
    for (const fs::path& file : made_) fs::remove(file, ignored);
  }
  void write(const fs::path& file, const output::VtuGrid& grid) {
    if (!is_there(file)) made_.push_back(file);
    output::write_vtu(file, grid);
  }
  void keep() { made_.clear(); }

 private:
  std::vector<fs::path> made_;
};

}  // namespace

// Time of a moment of the run in a series of snapshots: the load factor at that moment. If the load factor has not
// grown, the time grows by so little that the same number is shown: viewers tell moments apart, and order them, by
// their times.
double Snapshots::Series::time_of(double load_factor) const {
  if (empty() || load_factor > entries.back().time) return load_factor;
  const double last = entries.back().time, step = 1e-9 * (last == 0 ? 1 : std::abs(last));
  return std::max(last + step, std::nextafter(last, std::numeric_limits<double>::infinity()));
}

Snapshots::Series Snapshots::begin(const fs::path& collection, const std::string& existing) {
  Series series;
  if (existing == "replace" || !is_there(collection)) return series;
  if (existing == "refuse") refuse(collection);
  auto read = output::read_pvd(collection);
  if (!read)
    fail(Failure::io, output::printable(collection.native()),
         " is no series of snapshots that could be continued; give another prefix, or move it away");
  series.entries = std::move(*read);
  for (const PvdEntry& entry : series.entries) series.next = std::max(series.next, number_in(entry.file) + 1);
  return series;
}

void Snapshots::write(const std::string& prefix, const Moment& moment, std::vector<PicturePart> parts,
                      const scene::Options& options) {
  require_name_for_series(prefix);
  const fs::path base = output::path_from_utf8(prefix), collection = with_ending(base, ".pvd");
  const std::string existing = options.text_value("snapshots.existing");
  const auto known = series_.find(prefix);
  Series series = known == series_.end() ? begin(collection, existing) : known->second;
  const auto file_of = [&](const PicturePart& part) {
    return with_ending(base, text_of(series.next) + "_" + part.name + ".vtu");
  };
  const auto in_the_way = [&] {
    return std::find_if(parts.begin(), parts.end(), [&](const PicturePart& part) { return is_there(file_of(part)); });
  };
  while (existing == "continue" && in_the_way() != parts.end()) ++series.next;
  if (const auto found = in_the_way(); existing == "refuse" && found != parts.end()) refuse(file_of(*found));
  const double time = series.time_of(moment.load_factor);
  NewFiles files;
  writing([&] {
    for (PicturePart& part : parts) {
      std::vector<output::VtuArray>& data = part.grid.field_data;
      data.insert(data.begin(), {{"TimeValue", 1, std::vector<double>{time}},
                                 {"load_factor", 1, std::vector<double>{moment.load_factor}},
                                 {"snapshot", 1, std::vector<std::int32_t>{series.next}},
                                 {"events", 1, std::vector<double>{static_cast<double>(moment.events)}}});
      files.write(file_of(part), part.grid);
      series.entries.push_back({time, part.number, file_of(part).filename().generic_string(), part.name});
    }
    output::write_pvd(collection, series.entries);
  });
  ++series.next;
  files.keep();
  series_[prefix] = std::move(series);
}

}  // namespace bempd::results
