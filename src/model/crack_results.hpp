#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "crack/path.hpp"
#include "model/prepared_scene.hpp"
#include "regions/region.hpp"
#include "results/tip_record.hpp"

namespace bempd::model {

class Model;

// Results of cracks: tips, paths, lengths, openings and pictures, and the record of tips over the run. Cracks are
// numbered: described ones first, then those that began in the run.
class CrackResults {
 public:
  explicit CrackResults(Model& model) : model_(model) {}

  // Tips of cracks with boundary elements, then tips in lattices, each group sorted by crack. Tips are computed once
  // for each generation (state of the body).
  const std::vector<regions::TipValues>& tips();
  int count() const;
  // Path of a crack; throws Error (argument) if the crack does not exist.
  std::vector<crack::PathVertex> path(int crack) const;
  double length(int crack) const;  // length of a crack (id); 0: sum over all cracks
  // Tangential and normal openings [m] of a crack at places given as fractions of the crack's length.
  std::vector<Point> openings(int crack, const std::vector<double>& fractions);
  // Extensions of all cracks in the order of the run.
  std::span<const fracture::CrackExtension> extensions() const;

  // Whether tips are recorded at events, as the option tips.record asks.
  bool are_recorded() const;
  // Adds the present tips to the record.
  void record();
  const std::vector<results::TipRecord>& history() const { return history_; }
  void set_history(std::vector<results::TipRecord> history) { history_ = std::move(history); }
  // Drops all records after the first `count`.
  void keep_records(std::size_t count) noexcept {
    history_.erase(history_.begin() + static_cast<std::ptrdiff_t>(count), history_.end());
  }

  // Tips of all cracks under the loads that act at present.
  std::vector<regions::TipValues> present_tips() const;
  // Tips of cracks with boundary elements in a prepared scene; `detail` says which values are computed.
  std::vector<regions::TipValues> tips_of(const PreparedScene& prepared, regions::TipDetail detail) const;
  // Tips of crack lines (cracks that grow in lattices by steps of a spacing). Places, directions and load factors of
  // growth are those of the run; stress intensity factors come from contours (rings) around the tips. Without
  // `with_loads` the load factors of growth, which may need trial steps, are left out.
  std::vector<regions::TipValues> tips_of_lines(bool with_loads = true) const;
  bool have_elements() const;
  std::vector<Point> openings_in_lattices(int crack, const std::vector<double>& fractions) const;
  std::vector<regions::CrackPicture> pictures() const;

 private:
  void take_growth_past_face_changes(std::vector<regions::TipValues>& tips);
  std::vector<regions::TipValues> tips_in_lattices() const;
  std::vector<std::vector<Point>> paths_in_lattices() const;  // empty for a crack with elements

  Model& model_;
  std::vector<regions::TipValues> tips_;
  std::int64_t tips_generation_ = 0;
  std::vector<results::TipRecord> history_;
};

}  // namespace bempd::model
