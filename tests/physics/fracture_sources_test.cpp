// Whether events come from a window or from the whole body, and whether fields are asked for in between, must not show
// in what is reported: history, reactions of the history, saved bytes.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

#include "fracture_scenes.hpp"

namespace fracture_sources_test {
namespace {

using namespace host;

// A strip with an edge crack between two blocks of boundary elements, the right end pulled. Both parts stay supported,
// so that a window can perform the last break too.
void edge_cracked_strip(Model& model) {
  const int32_t id = model.add(material(3e9, 1.0 / 3, BEMPD_PLANE_STRESS, 0.005, 0.01));
  const int32_t left = model.bem(id, rectangle(0, 0, 0.02, 0.02), 0.005);
  model.pd(id, rectangle(0.02, 0, 0.04, 0.02), 0.001, 4);
  const int32_t right = model.bem(id, rectangle(0.04, 0, 0.06, 0.02), 0.005);
  model.crack({{0.0295, 0}, {0.0295, 0.0045}});
  model.fix(left, 4, BEMPD_BOTH);
  model.prescribe(right, 2, BEMPD_X, 0, 1e-6);
  model.prescribe(right, 2, BEMPD_Y, 0, 0);
}

// A plate with a central crack, its ends pulled apart: a window that reaches its edges runs to the end.
void centre_cracked_plate(Model& model) {
  const int32_t id = model.add(material(1, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 1e-3));
  const int32_t region = model.pd(id, rectangle(0, 0, 39, 39), 1, 4);
  model.crack({{19.5, 15.5001}, {19.5, 23.4999}});
  for (const int32_t component : {BEMPD_X, BEMPD_Y}) {
    model.prescribe(region, 4, component, 0, component == BEMPD_X ? -1 : 0);
    model.prescribe(region, 2, component, 0, component == BEMPD_X ? 1 : 0);
  }
}

// The supports hold and pull the interfaces, where the lattice points follow longer boundary elements.
void pulled_at_tied_interfaces(Model& model) {
  CentreCrack scene = CentreCrack::small();
  const double u = scene.unit, x0 = (scene.width - scene.strip) / 2 * u, x1 = (scene.width + scene.strip) / 2 * u;
  const double height = scene.height * u, width = scene.width * u, middle = scene.height / 2;
  const int32_t id =
      model.add(material(scene.young, 1.0 / 3, BEMPD_PLANE_STRESS, scene.thickness, scene.critical_stretch));
  const int32_t left = model.bem(id, rectangle(0, 0, x0, height), 2.5e-3);
  model.pd(id, rectangle(x0, 0, x1, height), scene.spacing * u, 4);
  const int32_t right = model.bem(id, rectangle(x1, 0, width, height), 2.5e-3);
  model.mesh(left, 2, 2e-3, 1);
  model.mesh(right, 4, 2e-3, 1);
  model.crack({{scene.width / 2 * u, (middle - 2) * u}, {scene.width / 2 * u, (middle + 2) * u}});
  model.fix(left, 2, BEMPD_BOTH);
  model.prescribe(right, 4, BEMPD_X, 0, 1e-8);
  model.prescribe(right, 4, BEMPD_Y, 1e-9, 0);
}

// What the library writes where a support leaves a component free, so that rows can be compared.
constexpr double not_known = -1e300;

// Rows of the history as the library writes it.
std::vector<std::vector<double>> written_history(Model& model, const std::string& name) {
  const std::string path = testing::TempDir() + name + ".csv";
  model.check(bempd_write_history(model.get(), path.c_str()));
  std::ifstream file(path);
  std::vector<std::vector<double>> rows;
  std::string line, cell;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::vector<double>& row = rows.emplace_back();
    while (std::getline(cells, cell, ',')) {
      const double value = std::stod(cell);
      row.push_back(std::isnan(value) ? not_known : value);
    }
  }
  std::remove(path.c_str());
  return rows;
}

struct Lines {
  std::vector<bempd_history_entry> history;
  std::vector<std::vector<double>> written;
  std::vector<std::uint8_t> bytes;  // of the saved state
};

constexpr int until_separation = 0;  // in one call

enum class Looks { never, always };

Lines run(void (*build)(Model&), const char* solver, Looks looks, int events) {
  BondModel model;
  build(model);
  model.set_text("test.solver", solver);
  if (events == until_separation) model.run(1e9);
  for (int e = 0; e < events; ++e) {
    const bempd_step_report report = model.next_event(1e9);
    if (report.events == 0 || report.separated) break;
    if (looks == Looks::always) model.displacements();
  }
  model.step(1.01 * model.load_factor());
  Lines result;
  result.history = model.history();
  result.written = written_history(model, std::string("bempd_sources_") + solver);
  const SavedState saved = model.save();
  int64_t size = 0;
  bempd_state_to_bytes(saved.get(), 0, nullptr, &size);
  result.bytes.resize(static_cast<std::size_t>(size));
  model.check(bempd_state_to_bytes(saved.get(), size, result.bytes.data(), nullptr));
  return result;
}

double worst_residual(const Lines& lines) {
  double worst = 0;
  for (const bempd_history_entry& line : lines.history) worst = std::max(worst, line.residual);
  return worst;
}

TEST(Sources, looking_at_fields_changes_nothing_later) {
  for (const int events : {40, 300}) {
    const Lines blind = run(edge_cracked_strip, "window", Looks::never, events);
    const Lines seeing = run(edge_cracked_strip, "window", Looks::always, events);
    ASSERT_GT(blind.history.size(), 40);
    EXPECT_EQ(blind.written, seeing.written);
    EXPECT_EQ(blind.bytes, seeing.bytes);
  }
}

TEST(Sources, residuals_of_windows_are_measured_as_those_of_the_whole_body) {
  const Lines window = run(centre_cracked_plate, "window", Looks::never, until_separation);
  const Lines plain = run(centre_cracked_plate, "plain", Looks::never, until_separation);
  ASSERT_EQ(window.history.size(), plain.history.size());
  EXPECT_LE(report("worst residual", worst_residual(window), worst_residual(plain), "plain"),
            20 * worst_residual(plain));
  EXPECT_LE(report("last residual", window.history.back().residual, plain.history.back().residual, "plain"),
            20 * plain.history.back().residual);
}

TEST(Sources, supports_that_move_tied_points_feel_the_same_with_windows) {
  const Lines window = run(pulled_at_tied_interfaces, "window", Looks::never, 200);
  const Lines plain = run(pulled_at_tied_interfaces, "plain", Looks::never, 200);
  ASSERT_GT(plain.written.size(), 100);
  ASSERT_EQ(window.written.size(), plain.written.size());
  const std::size_t columns = plain.written.front().size();
  constexpr std::size_t balance_error = 7, residual = 8;
  for (std::size_t c = 0; c < columns; ++c) {
    if (c == balance_error || c == residual) continue;
    double scale = 0, worst = 0;
    for (std::size_t i = 0; i < plain.written.size(); ++i) {
      scale = std::max(scale, std::abs(plain.written[i][c]));
      worst = std::max(worst, std::abs(window.written[i][c] - plain.written[i][c]));
    }
    EXPECT_LE(worst, 1e-9 * scale) << "column " << c;
  }
}

}  // namespace
}  // namespace fracture_sources_test
