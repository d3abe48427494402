#include "results/tip_table.hpp"

#include "output/csv.hpp"
#include "output/file.hpp"
#include "results/writing.hpp"

namespace bempd::results {

namespace {

// Columns of a file of tips.
std::vector<std::string> columns_of_tips() {
  return {"event",
          "total_broken_bonds",
          "load_factor",
          "crack",
          "end",
          "x",
          "y",
          "direction_x",
          "direction_y",
          "stress_intensity_1",
          "stress_intensity_2",
          "energy_release_rate",
          "t_stress",
          "error",
          "kink_angle",
          "critical_load_factor",
          "method",
          "contours",
          "grown",
          "branched",
          "contour_radius",
          "felt_ahead",
          "critical_load_factor_down",
          "critical_kink_angle",
          "straight_load_factor"};
}

}  // namespace

void write_tips(const std::string& path, const std::vector<TipRecord>& records) {
  output::CsvTable table(columns_of_tips());
  const auto whole = [](auto value) { return static_cast<std::int64_t>(value); };
  for (const TipRecord& r : records) {
    const regions::TipValues& t = r.tip;
    table.add_row(std::vector<output::CsvValue>{r.event,
                                                r.total_broken_bonds,
                                                r.load_factor,
                                                whole(t.crack),
                                                whole(t.end + 1),
                                                t.place.x(),
                                                t.place.y(),
                                                t.direction.x(),
                                                t.direction.y(),
                                                t.factors.x(),
                                                t.factors.y(),
                                                t.energy_release_rate,
                                                t.stress_along,
                                                t.error,
                                                t.kink_angle,
                                                t.critical_load_factor,
                                                whole(t.method),
                                                whole(t.contours),
                                                whole(t.grown),
                                                whole(t.branched),
                                                t.contour_radius,
                                                t.felt_ahead,
                                                t.critical_load_factor_down,
                                                t.critical_kink_angle,
                                                t.straight_load_factor});
  }
  writing([&] { table.save(output::path_from_utf8(path)); });
}

}  // namespace bempd::results
