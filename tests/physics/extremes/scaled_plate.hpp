// A coupled plate in any units: a strip of peridynamics between two blocks of boundary elements, clamped at the left
// end, with a traction and a point force on the right one.
#pragma once

#include "../host.hpp"

namespace host {

struct ScaledPlate {
  double length = 1, modulus = 1, thickness = 1, load = 1;
  Vector origin{0, 0};  // of the plate, in units of its height
  int horizon_ratio = 3;
  double critical_stretch = 0;
};

struct ScaledPlateIds {
  int32_t left, strip, right, support;
};

inline ScaledPlateIds build(Model& model, const ScaledPlate& s) {
  const double l = s.length;
  const auto block = [&](double x0, double x1) {
    const double x = s.origin[0], y = s.origin[1];
    return rectangle((x + x0) * l, y * l, (x + x1) * l, (y + 1) * l);
  };
  const int32_t id = model.add(material(s.modulus, 1.0 / 3, BEMPD_PLANE_STRESS, s.thickness, s.critical_stretch));
  ScaledPlateIds ids{};
  ids.left = model.bem(id, block(0, 1), 0.25 * l);
  ids.strip = model.pd(id, block(1, 2), 0.125 * l, s.horizon_ratio);
  ids.right = model.bem(id, block(2, 3), 0.25 * l);
  ids.support = model.fix(ids.left, 4, BEMPD_BOTH);
  const double stress = s.load * s.modulus;  // load is a strain
  model.traction(ids.right, 2, 0, 1, BEMPD_X, 0.25 * stress, stress);
  model.traction(ids.right, 3, 0, 0.5, BEMPD_Y, 0, 0.125 * stress);
  model.point_force({(s.origin[0] + 3) * l, (s.origin[1] + 1) * l}, BEMPD_Y, 0, -0.25 * stress * l * s.thickness);
  return ids;
}

struct Outcome {
  std::vector<double> displacement, stress;  // in units of load * length, load * modulus
  Vector reaction;                           // in units of load * modulus * length * thickness
  double stored_energy, work, residual, balance;
};

inline Outcome outcome(const ScaledPlate& s) {
  Model model;
  const ScaledPlateIds ids = build(model, s);
  const bempd_step_report report = model.step(1);
  Outcome result{};
  result.displacement = model.displacements();
  for (double& u : result.displacement) u /= s.load * s.length;
  for (int32_t region : {ids.left, ids.strip, ids.right}) {
    for (double value : model.field(region, BEMPD_STRESS)) result.stress.push_back(value / (s.load * s.modulus));
  }
  const Vector force = model.reaction(ids.support);
  for (std::size_t k = 0; k < 2; ++k) result.reaction[k] = force[k] / (s.load * s.modulus) / (s.length * s.thickness);
  const double energy = s.modulus * s.length * s.length * s.thickness * s.load * s.load;
  result.stored_energy = report.stored_energy / energy;
  result.work = report.work / energy;
  result.residual = report.residual;
  result.balance = report.energy_balance_error;
  return result;
}

}  // namespace host
