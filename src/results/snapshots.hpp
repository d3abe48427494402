#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "output/pvd.hpp"
#include "results/pictures.hpp"
#include "scene/options.hpp"

namespace bempd::results {

// Moment of a run: load factor and number of events.
struct Moment {
  double load_factor;
  std::int64_t events;
};

// Series of VTK files, one file for each part and moment, with a collection for each series.
class Snapshots {
 public:
  // Adds a moment to the series of this prefix. Throws Error (io), also where files of another run exist and the
  // options do not say what to do with them.
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

  std::map<std::string, Series> series_;  // by prefix
};

}  // namespace bempd::results
