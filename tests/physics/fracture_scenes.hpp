// The centre-cracked plate pulled apart at its ends, in the size of the published example and in a small one, and what
// the fracture tests ask about its bonds.
#pragma once

#include <algorithm>
#include <set>

#include "host.hpp"

namespace host {

// Lengths in mm; `unit` turns them into the model's unit of length. At load factor n the ends move by n * opening
// outward.
struct CentreCrack {
  double width = 50, height = 49.5, half_crack = 5, strip = 8.5, spacing = 0.5, element_length = 5;
  double opening = 2e-5, constant_openings = 0;
  double young = 30e9, critical_stretch = 8e-4, thickness = 1, unit = 1e-3;
  int horizon_ratio = 4;

  // A strip of 17 x 29 cells between two blocks, for tests that run many times.
  static CentreCrack small() {
    CentreCrack scene;
    scene.width = 20, scene.height = 14.5, scene.half_crack = 2, scene.element_length = 2.5;
    return scene;
  }
};

struct CentreCrackIds {
  int32_t left, strip, right, left_end, right_end;
};

inline CentreCrackIds build(Model& model, const CentreCrack& s) {
  const double u = s.unit, x0 = (s.width - s.strip) / 2, x1 = (s.width + s.strip) / 2;
  const double middle = s.height / 2;
  const int32_t id = model.add(material(s.young, 1.0 / 3, BEMPD_PLANE_STRESS, s.thickness, s.critical_stretch));
  CentreCrackIds ids{};
  ids.left = model.bem(id, rectangle(0, 0, x0 * u, s.height * u), s.element_length * u);
  ids.strip = model.pd(id, rectangle(x0 * u, 0, x1 * u, s.height * u), s.spacing * u, s.horizon_ratio);
  ids.right = model.bem(id, rectangle(x1 * u, 0, s.width * u, s.height * u), s.element_length * u);
  model.crack({{s.width / 2 * u, (middle - s.half_crack) * u}, {s.width / 2 * u, (middle + s.half_crack) * u}});
  const double constant = s.constant_openings * s.opening * u, proportional = s.opening * u;
  ids.left_end = model.prescribe(ids.left, 4, BEMPD_X, -constant, -proportional);
  ids.right_end = model.prescribe(ids.right, 2, BEMPD_X, constant, proportional);
  model.fix_point({0, middle * u}, BEMPD_Y);
  return ids;
}

// The two ends of a bond in half lattice spacings from a centre, the lower end first.
using BondKey = std::array<int, 4>;

inline BondKey ordered(BondKey b) {
  return std::array{b[0], b[1]} <= std::array{b[2], b[3]} ? b : BondKey{b[2], b[3], b[0], b[1]};
}

struct BondSets {
  std::set<BondKey> parted, intact;  // parted: broken or cut
};

inline BondSets bond_sets(Model& model, int32_t region, Vector centre, double spacing) {
  const auto x = model.vectors(region, BEMPD_POSITION);
  const Bonds bonds = model.bonds(region);
  const auto place = [&](int32_t point, std::size_t k) {
    return static_cast<int>(std::lround((x[static_cast<std::size_t>(point)][k] - centre[k]) / (spacing / 2)));
  };
  BondSets sets;
  for (std::size_t i = 0; i < bonds.states.size(); ++i) {
    const auto [a, b] = bonds.points[i];
    (bonds.states[i] == BEMPD_BOND_INTACT ? sets.intact : sets.parted)
        .insert(ordered({place(a, 0), place(a, 1), place(b, 0), place(b, 1)}));
  }
  return sets;
}

inline BondSets bond_sets(Model& model, const CentreCrack& s, const CentreCrackIds& ids) {
  return bond_sets(model, ids.strip, {s.width / 2 * s.unit, s.height / 2 * s.unit}, s.spacing * s.unit);
}

inline std::set<BondKey> mirrored(const std::set<BondKey>& bonds, bool in_x) {
  std::set<BondKey> result;
  const int sx = in_x ? -1 : 1, sy = in_x ? 1 : -1;
  for (const BondKey& b : bonds) result.insert(ordered({sx * b[0], sy * b[1], sx * b[2], sy * b[3]}));
  return result;
}

inline bool symmetric(const std::set<BondKey>& bonds) {
  return bonds == mirrored(bonds, true) && bonds == mirrored(bonds, false);
}

inline bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

struct Event {
  double load_factor;
  int64_t broken;
};

inline std::vector<Event> events(const Model& model) {
  std::vector<Event> result;
  for (const bempd_history_entry& line : model.history())
    if (line.event > 0) result.push_back({line.load_factor, line.total_broken_bonds});
  return result;
}

inline double worst_energy_balance(const Model& model) {
  double worst = 0;
  for (const bempd_history_entry& line : model.history()) worst = largest({worst, line.energy_balance_error});
  return worst;
}

}  // namespace host
