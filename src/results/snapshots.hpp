#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "output/pvd.hpp"
#include "results/pictures.hpp"
#include "scene/options.hpp"

namespace bempd::results {

// Moment of a run: its load factor and the number of events so far.
struct Moment {
  double load_factor;
  std::int64_t events;
};

// Series of snapshots as VTK files: one file for each part at each moment of a run, and a ParaView collection for each
// series.
class Snapshots {
 public:
  // Adds a moment of the run to the series with this prefix. Throws Error (io) if writing fails, or if there are files
  // of another run that the option snapshots.existing does not allow to continue or to replace.
  void write(const std::string& prefix, const Moment& moment, std::vector<PicturePart> parts,
             const scene::Options& options);

 private:
  struct Series {
    std::vector<output::PvdEntry> entries;
    int next = 0;  // number of the next moment

    bool empty() const { return entries.empty(); }
    double time_of(double load_factor) const;
  };

  static Series begin(const std::filesystem::path& collection, const std::string& existing);

  std::map<std::string, Series> series_;  // series by prefix
};

}  // namespace bempd::results
