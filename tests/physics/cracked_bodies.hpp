#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "bem/crack_grading.hpp"
#include "bem/crack_tips.hpp"
#include "physics/bem_bodies.hpp"

// Bodies with cracks, loaded by tractions.
namespace bempd::crack_test {

using bem_test::Body;

inline std::vector<Edge> edges_of_loops(const std::vector<std::vector<Panel>>& loops) {
  std::vector<Edge> edges;
  for (const auto& loop : loops)
    for (const Panel& panel : loop) edges.emplace_back(panel.arc());
  return edges;
}

// Ends panels where cracks reach them.
inline std::vector<std::vector<Panel>> parted_at_mouths(const std::vector<std::vector<Panel>>& loops,
                                                        const CrackLines& cracks, double target) {
  std::vector<std::vector<Panel>> result;
  for (const auto& loop : loops) {
    result.emplace_back();
    for (const Panel& panel : loop) {
      std::vector<double> breaks{0.0, 1.0};
      for (const CrackJoint& joint : cracks.joints) {
        const double at = closest_fraction(panel.arc(), joint.place);
        if (joint.mouth && (panel.arc().at(at) - joint.place).norm() < 1e-9 && at > 1e-9 && at < 1 - 1e-9)
          breaks.push_back(at);
      }
      std::sort(breaks.begin(), breaks.end());
      for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const Arc part = breaks.size() == 2 ? panel.arc() : panel.arc().part(breaks[i], breaks[i + 1]);
        const auto stations =
            breaks.size() == 2 ? panel.stations : element_stations(part.length(), target, 1, part.sweep);
        result.back().push_back({part.start, part.end, stations, part.sweep});
      }
    }
  }
  return result;
}

struct CrackedBody {
  std::vector<std::vector<Panel>> loops;
  CrackLines lines;
  BoundaryMesh mesh;
  bem::CrackMesh cracks;
  std::unique_ptr<bem::CrackedOperator> op;

  CrackedBody(const std::vector<std::vector<Panel>>& outline, const std::vector<std::vector<Point>>& paths,
              const PlaneElasticity& elasticity, double target, const bem::CrackGrading& grading = {},
              double tolerance = 1e-10)
      : CrackedBody(outline, as_given(paths), elasticity, target, grading, tolerance) {}

  CrackedBody(const std::vector<std::vector<Panel>>& outline, const std::vector<CrackPath>& given,
              const PlaneElasticity& elasticity, double target, const bem::CrackGrading& grading = {},
              double tolerance = 1e-10) {
    const std::vector<Edge> edges = edges_of_loops(outline);
    lines = crack_lines(given, edges, tolerance);
    loops = parted_at_mouths(outline, lines, target);
    const bem::CrackSizes sizes(lines, edges, tolerance, grading);
    for (auto& loop : loops)
      for (Panel& panel : loop) panel.stations = sizes.refined(panel.arc(), panel.stations);
    mesh = mesh_boundary(loops);
    cracks = bem::mesh_cracks(lines, sizes.stations(), mesh, tolerance);
    op = std::make_unique<bem::CrackedOperator>(mesh, cracks, elasticity);
  }

  static std::vector<CrackPath> as_given(const std::vector<std::vector<Point>>& paths) {
    std::vector<CrackPath> given;
    for (const auto& points : paths) given.push_back({static_cast<int>(given.size()) + 1, points});
    return given;
  }

  // State under the tractions of a stress on the whole boundary, and tractions on crack faces.
  bem::CrackedState solve(const std::function<Eigen::Matrix2d(const Point&)>& stress,
                          const bem::FaceTraction& faces = {}) const {
    const double thickness = op->elasticity().thickness;
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(op->stiffness().rows());
    int p = 0;
    for (const auto& loop : loops)
      for (const Panel& panel : loop) {
        bem::add_traction_forces(
            mesh, p++,
            [&](const Point& x) -> Point {
              const double at = closest_fraction(panel.arc(), x);
              const Point tangent = panel.arc().tangent(at);
              return stress(x) * Point(tangent.y(), -tangent.x());
            },
            thickness, forces);
      }
    Eigen::VectorXd openings = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(cracks.nodes.size()));
    if (faces) openings = bem::crack_forces(cracks, faces, thickness);
    forces += op->forces_on_boundary(openings);
    bem::CrackedState state;
    state.displacements = bem_test::solve_supported(op->stiffness(), forces, bem_test::fixed_rigid_motions(mesh),
                                                    Eigen::VectorXd::Zero(forces.size()));
    state.openings = op->openings(state.displacements, openings);
    state.tractions = op->tractions(state.displacements, state.openings);
    state.face_traction = faces;
    return state;
  }

  std::vector<bem::StressIntensity> tips(const bem::CrackedState& state) const {
    std::vector<bem::StressIntensity> values;
    for (const auto& of_tip : bem::stress_intensities(*op, {state})) values.push_back(of_tip[0]);
    return values;
  }
};

inline std::function<Eigen::Matrix2d(const Point&)> constant_stress(double xx, double yy, double xy) {
  Eigen::Matrix2d s;
  s << xx, xy, xy, yy;
  return [s](const Point&) { return s; };
}

// Only on the sides with the given outward normals.
inline std::vector<Panel> plate(double half_width, double half_height, double target) {
  return bem_test::rectangle(2 * half_width, 2 * half_height, target, 1, {-half_width, -half_height});
}

}  // namespace bempd::crack_test
