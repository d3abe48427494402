#include "results/tip_table.hpp"

#include "output/csv.hpp"
#include "output/file.hpp"
#include "results/writing.hpp"

namespace bempd::results {

namespace {

// Calls column(name, value) for each column of a file of tips, in the order of bempd_crack_tip.
template <class Column>
void for_each_column(const TipRecord& r, const Column& column) {
  const auto whole = [](auto value) { return output::CsvValue(static_cast<std::int64_t>(value)); };
  const auto real = [](double value) { return output::CsvValue(value); };
  const regions::TipValues& t = r.tip;
  column("event", whole(r.event)), column("total_broken_bonds", whole(r.total_broken_bonds));
  column("load_factor", real(r.load_factor));
  column("crack", whole(t.crack)), column("end", whole(t.end + 1));
  column("x", real(t.place.x())), column("y", real(t.place.y()));
  column("direction_x", real(t.direction.x())), column("direction_y", real(t.direction.y()));
  column("stress_intensity_1", real(t.factors.x())), column("stress_intensity_2", real(t.factors.y()));
  column("energy_release_rate", real(t.energy_release_rate)), column("t_stress", real(t.stress_along));
  column("error", real(t.error)), column("kink_angle", real(t.kink_angle));
  column("critical_load_factor", real(t.critical_load_factor));
  column("method", whole(t.method)), column("contours", whole(t.contours));
  column("grown", whole(t.grown)), column("branched", whole(t.branched));
  column("contour_radius", real(t.contour_radius)), column("felt_ahead", real(t.felt_ahead));
  column("critical_load_factor_down", real(t.critical_load_factor_down));
  column("critical_kink_angle", real(t.critical_kink_angle));
  column("straight_load_factor", real(t.straight_load_factor));
  column("load_rule", whole(t.load_rule)), column("closed", whole(t.closed));
  column("load_error", real(t.load_error)), column("valid_radius", real(t.valid_radius));
}

}  // namespace

void write_tips(const std::string& path, const std::vector<TipRecord>& records) {
  std::vector<std::string> names;
  for_each_column({}, [&](const char* name, const output::CsvValue&) { names.emplace_back(name); });
  output::CsvTable table(names);
  for (const TipRecord& record : records) {
    std::vector<output::CsvValue> row;
    for_each_column(record, [&](const char*, const output::CsvValue& value) { row.push_back(value); });
    table.add_row(row);
  }
  writing([&] { table.save(output::path_from_utf8(path)); });
}

}  // namespace bempd::results
