#include "model/line_factors.hpp"

#include <algorithm>

#include "coupling/affine.hpp"
#include "regions/tips/lattice_tips.hpp"

namespace bempd::model {

regions::BondedBody bonded_body(const scene::Scene& scene, const PreparedScene& prepared) {
  const coupling::EquilibriumSystem& system = *prepared.system;
  return {scene,
          prepared.discretization,
          system.terms(),
          system.stages().stiffness(),
          system.stages().intact(),
          prepared.cut_bonds,
          prepared.in_lattices.cracks,
          system.constraints(),
          pressures_of(prepared.conditions)};
}

std::vector<crack::PathVertex> path_in(const scene::Scene& scene, const PreparedScene& prepared, int crack) {
  const std::span<const fracture::CrackExtension> extensions = prepared.evolution->progress().extensions;
  const auto number = static_cast<std::size_t>(crack) - 1;
  const bool is_described = number < scene.cracks().size() && !scene.cracks()[number].has_begun;
  if (!is_described) return path_of(crack, {}, extensions);
  const scene::Crack& found = prepared.in_lattices.cracks[number];
  if (found.points.empty()) return {};
  const regions::PartedCrack& parted = prepared.discretization.cracks[number];
  std::vector<Point> given(found.given().begin(), found.given().end());
  for (const int end : {0, 1}) {
    Point& place = end == 0 ? given.front() : given.back();
    const auto first = std::ranges::find_if(extensions, [&](const auto& e) {
      return e.tip() == crack::TipId{crack, end};
    });
    if (first != extensions.end())
      place = {first->from_x, first->from_y};
    else if (parted.region_at(end) > 0)
      place = end == 0 ? parted.crack.given().front() : parted.crack.given().back();
    else
      place = prepared.in_lattices.ends[number][static_cast<std::size_t>(end)];
  }
  return path_of(crack, given, extensions);
}

std::optional<fracture::TipFactors> factors_around(const scene::Scene& scene, const scene::Options& options,
                                                   const PreparedScene& prepared, const fracture::GrowingTip& tip,
                                                   const coupling::Affine& displacement) {
  std::vector<Point> path = points_of_path(path_in(scene, prepared, tip.id.crack));
  if (tip.id.end == 0) std::reverse(path.begin(), path.end());
  if (path.size() < 2) return std::nullopt;
  // If nothing loads the body now, the field at the load factor 1 serves instead: it gives the relative error of the
  // stress intensity factors and the place of the effective tip.
  const double present = prepared.evolution->progress().load_factor;
  const double load_factor = present == 0 && displacement.col(0).isZero(0) ? 1 : present;
  const Eigen::VectorXd total = coupling::evaluate(displacement, load_factor);
  const regions::Solution solution{.displacement = total,
                                   .bonds = prepared.system->terms(),
                                   .intact = prepared.system->stages().intact(),
                                   .body_forces = {},
                                   .parts = &displacement,
                                   .load_factor = load_factor};
  const regions::BondedBody body = bonded_body(scene, prepared);
  const regions::KnownTip known{tip.id.crack, tip.id.end, tip.direction, std::move(path), tip.grown > 0};
  const regions::TipValues found =
      regions::lattice_tips(body, regions::lattice_tips_at(body, {known}), solution, options).front();
  if (found.contours == 0 || found.closed) return std::nullopt;
  const Point &constant = found.constant_factors, &proportional = found.proportional_factors;
  if (!constant.allFinite() || !proportional.allFinite()) return std::nullopt;
  return fracture::TipFactors{{{constant.x(), proportional.x()}, {constant.y(), proportional.y()}},
                              found.error / found.factors.norm()};
}

}  // namespace bempd::model
