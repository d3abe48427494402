// Prints what different criteria for the break of a bond make of bodies that are pulled and pressed, as tables: a
// lattice of unit spacing, horizon 4, Young's modulus 1, Poisson's ratio 1/3, plane stress, critical stretch 1.
//
// What a criterion sees of a bond: its own stretch a, and the mean stretch b of the bonds at right angles that begin or
// end where it does, by which the stress along it is E / (1 - nu^2) (a + nu b). Every criterion is a multiple of the
// load factor, so that an event lies where the largest one is 1.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "error.hpp"
#include "fracture/bonds_across.hpp"
#include "pd/cell_lattice.hpp"
#include "pd/crack.hpp"
#include "pd/network.hpp"

namespace {

using namespace bempd;
using Corners = std::vector<Eigen::Vector2i>;

constexpr double nu = 1.0 / 3;
const PlaneElasticity solid{1, nu, PlaneState::stress, 1};

struct Criterion {
  const char* name;
  double (*ratio)(double own, double across);
};

double stress(double own, double across) { return (own + nu * across) / (1 - nu * nu); }

const std::vector<Criterion> criteria{
    {"stretch", [](double own, double) { return own; }},
    {"stretch where the stress along the bond is tensile",
     [](double own, double across) { return stress(own, across) > 0 ? own : 0.0; }},
    {"stretch without what compression across adds",
     [](double own, double across) { return std::min(own, stress(own, across)); }},
    {"stress along the bond", [](double own, double across) { return stress(own, across); }},
    {"energy: root of stretch times stress", [](double own, double across) {
       return own > 0 && stress(own, across) > 0 ? std::sqrt(own * stress(own, across)) : 0.0;
     }}};

struct Body {
  std::string name;
  std::vector<Corners> loops;
  std::vector<Point> crack;
  double push = 0;  // of the upper and lower edge away from each other, at load factor 1
  bool clamped = false;
  int breaks = 0;  // to follow
};

struct Run {
  double first = 0, largest = 0;  // mean stretch of the body over the critical one
  std::vector<std::set<int>> events;
};

Corners box(int x0, int y0, int x1, int y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }
Corners hole(int x0, int y0, int x1, int y1) { return {{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}}; }

class Lattice {
 public:
  explicit Lattice(const Body& body) : cells_(body.loops), network_(pd::build_network(cells_, 4, solid, 1)) {
    for (int i = 0; i < cells_.point_count(); ++i) places_.push_back(cells_.point(i).cast<double>());
    height_ = cells_.upper().y() - cells_.lower().y();
    coupling::Terms terms;
    for (std::size_t b = 0; b < network_.bonds.size(); ++b) {
      const pd::Bond& bond = network_.bonds[b];
      const pd::BondOffset& offset = network_.offsets[network_.offset_of[b]];
      terms.add_bond(bond.first, bond.second, offset.direction, offset.length, bond.stiffness);
      terms.set_contraction(static_cast<int>(b), nu);
    }
    across_ = fracture::BondsAcross(terms);
    hold(body, std::move(terms));
    if (!body.crack.empty()) {
      const std::vector<int> cut = pd::bonds_cut_by(places_, network_.bonds, body.crack);
      system_->commit(system_->stages().breaking(cut), {});
    }
  }

  Run follow(const Criterion& criterion, int breaks) {
    Run run;
    for (int broken = 0; broken < breaks;) {
      coupling::Affine u;
      try {
        u = system_->solve();
      } catch (const Error&) {
        break;  // a point has come loose: what would follow is another question
      }
      const std::vector<double> ratio = ratios(criterion, u.col(1));
      const double largest = *std::max_element(ratio.begin(), ratio.end());
      if (!(largest > 1e-6)) break;
      std::set<int> event;
      for (std::size_t b = 0; b < ratio.size(); ++b)
        if (ratio[b] >= (1 - 1e-3) * largest) event.insert(static_cast<int>(b));
      const double load = 1 / (largest * height_);
      if (run.events.empty()) run.first = load;
      run.largest = std::max(run.largest, load);
      const std::vector<int> gone(event.begin(), event.end());
      broken += static_cast<int>(gone.size());
      run.events.push_back(std::move(event));
      system_->commit(system_->stages().breaking(gone), {});
    }
    return run;
  }

 private:
  void hold(const Body& body, coupling::Terms terms) {
    const Eigen::Index dofs = 2 * cells_.point_count();
    std::vector<char> held(static_cast<std::size_t>(dofs), 0);
    coupling::Affine moved = coupling::Affine::Zero(dofs, 2);
    for (int i = 0; i < cells_.point_count(); ++i) {
      const int y = cells_.point(i).y();
      const bool top = y == cells_.upper().y();
      if (!top && y != cells_.lower().y()) continue;
      held[static_cast<std::size_t>(2 * i + 1)] = 1;
      moved(2 * i + 1, 1) = top ? body.push : 0;
      const bool corner = cells_.point(i).x() == cells_.lower().x() && !top;
      if (body.clamped || corner) held[static_cast<std::size_t>(2 * i)] = 1;
    }
    system_ = std::make_unique<coupling::EquilibriumSystem>(
        cells_.point_count(), std::vector<coupling::DenseOperator>(), std::move(terms), held);
    system_->factor().place_nodes(places_);
    system_->set_load(coupling::Affine::Zero(dofs, 2), moved);
  }

  std::vector<double> ratios(const Criterion& criterion, const Eigen::VectorXd& u) const {
    const coupling::Terms& terms = system_->terms();
    const std::vector<double> none(terms.size(), 0.0);
    std::vector<double> stretch(terms.size()), scale(terms.size()), result(terms.size(), 0.0);
    for (std::size_t b = 0; b < terms.size(); ++b) {
      scale[b] = 1 / terms.length[b];
      stretch[b] = terms.elongation(b, u.data()) * scale[b];
    }
    fracture::AffineRelief relief;
    across_.relieve(none, stretch, scale, system_->stages().intact(), relief);
    for (std::size_t b = 0; b < terms.size(); ++b) {
      if (!system_->stages().intact()[b]) continue;
      // What the library takes off is -nu / (1 - nu^2) (across + nu own).
      const double across = -(1 - nu * nu) / nu * relief.proportional[b] - nu * stretch[b];
      result[b] = criterion.ratio(stretch[b], across);
    }
    return result;
  }

  pd::CellLattice cells_;
  pd::Network network_;
  std::vector<Point> places_;
  fracture::BondsAcross across_;
  std::unique_ptr<coupling::EquilibriumSystem> system_;
  double height_ = 1;
};

std::vector<Body> bodies() {
  const Corners plate = box(0, 0, 50, 70);
  const std::vector<Point> level{{16.5, 34.5}, {33.5, 34.5}}, slanted{{17.25, 27.75}, {32.75, 43.25}};
  return {
      {"plate with a crack across, pulled", {plate}, level, 1, false, 400},
      {"plate with a crack at 45 degrees, pulled", {plate}, slanted, 1, false, 400},
      {"plate with a square hole, pulled", {plate, hole(20, 30, 30, 40)}, {}, 1, false, 400},
      {"block, pulled between smooth plates", {box(0, 0, 30, 60)}, {}, 1, false, 1},
      {"block, pressed between smooth plates", {box(0, 0, 30, 60)}, {}, -1, false, 1},
      {"block, pressed between rough plates", {box(0, 0, 30, 60)}, {}, -1, true, 1},
      {"plate with a square hole, pressed", {plate, hole(20, 30, 30, 40)}, {}, -1, false, 200},
      {"plate with a slot at 45 degrees, pressed", {plate}, slanted, -1, false, 200},
  };
}

}  // namespace

int main() {
  std::printf("| body | criterion | first break | largest load | events as by stretch |\n|---|---|---|---|---|\n");
  for (const Body& body : bodies()) {
    std::vector<std::set<int>> by_stretch;
    for (const Criterion& criterion : criteria) {
      const Run run = Lattice(body).follow(criterion, body.breaks);
      if (by_stretch.empty()) by_stretch = run.events;
      std::size_t same = 0;
      while (same < std::min(by_stretch.size(), run.events.size()) && by_stretch[same] == run.events[same]) ++same;
      const auto number = [](double value) {
        char text[32];
        std::snprintf(text, sizeof text, "%.3f", value);
        return std::string(text);
      };
      const bool never = run.events.empty();
      std::printf("| %s | %s | %s | %s | %zu of %zu |\n", body.name.c_str(), criterion.name,
                  never ? "none" : number(run.first).c_str(), never ? "none" : number(run.largest).c_str(), same,
                  by_stretch.size());
      std::fflush(stdout);
    }
  }
}
