#include "regions/lattice/lattice_description.hpp"

#include <cmath>
#include <limits>

#include "error.hpp"
#include "pd/bond_family.hpp"
#include "pd/cell_squares.hpp"
#include "regions/scheme.hpp"
#include "scene/outline_rules.hpp"

namespace bempd::regions {

namespace {

// Largest number of bonds in a region: they are numbered by int.
constexpr double most_bonds = std::numeric_limits<int>::max();

// Memory estimate for each bond, by the lists that exist at the same time [B]: measured as 142 to 150 with 1.4 and 5.9
// million bonds.
constexpr double bytes_per_bond = 140;
// Memory estimate for each square of a cell [B].
constexpr double bytes_per_square = 320;

double cells_of(const Outline& outline, double spacing) { return area(outline) / (spacing * spacing); }

double bonds_of(const Outline& outline, double spacing, int horizon_ratio) {
  return cells_of(outline, spacing) * static_cast<double>(pd::bond_family(horizon_ratio).size());
}

// Range of Poisson's ratio for regions with squares of cells. Below it bonds become soft compared with the squares, and
// cracks start too early. Above it hydrostatic tension hardly stretches bonds (docs/materials.md).
constexpr double least_ratio = -0.2, largest_ratio = 0.49;

std::string list_of(const std::vector<double>& values) {
  std::string list;
  for (std::size_t i = 0; i < values.size(); ++i) list += text(i == 0 ? "" : " or ", values[i]);
  return list;
}

LatticeOutline require_lattice(const Outline& outline, double spacing) {
  LatticeFit fit = fit_lattice(outline, spacing);
  const std::string advice = fit.suggestions.empty()
                                 ? std::string("; choose one that divides all edges and offsets of holes")
                                 : "; try " + list_of(fit.suggestions);
  switch (fit.misfit) {
    case LatticeMisfit::none:
      break;
    case LatticeMisfit::bad_spacing:
      require(false, "spacing ", spacing,
              " is not a usable lattice spacing for this outline; it must be positive, and large enough for cells to "
              "be counted");
      break;
    case LatticeMisfit::oblique_edge:
      require(false, "edge ", fit.edge + 1,
              " is parallel to neither axis; the outline of a peridynamic region must be rectilinear");
      break;
    case LatticeMisfit::indivisible_edge:
      require(false, "spacing ", spacing, " does not divide edge ", fit.edge + 1, " of length ", fit.length, advice);
      break;
    case LatticeMisfit::shifted_hole:
      require(false, "the hole is ", fit.length,
              " away from the first vertex along an axis, which is not a whole number of spacings ", spacing, advice);
      break;
  }
  return fit.outline;
}

void require_ratio(int material_id, const PlaneElasticity& elasticity) {
  const double given = elasticity.poisson_ratio;
  require(given >= least_ratio && given <= largest_ratio, "material ", material_id, " has Poisson's ratio ", given,
          "; peridynamic regions take ", least_ratio, " to ", largest_ratio,
          ": choose one in this range, or make the region a BEM region");
}

Outline checked_outline(int material_id, const scene::Material& material, Outline outline, double spacing,
                        int horizon_ratio) {
  require_ratio(material_id, material.elasticity);
  require(horizon_ratio >= 2 && horizon_ratio <= 8, "horizon_ratio is ", horizon_ratio, "; it must be 2 .. 8");
  require(std::isfinite(spacing) && spacing > 0, "spacing is ", spacing, "; it must be > 0");
  scene::require_sound(outline);
  const double cells = cells_of(outline, spacing);
  const double bonds = bonds_of(outline, spacing, horizon_ratio);
  require(bonds <= most_bonds, "spacing ", spacing, " would need ", cells, " cells with ", bonds, " bonds, about ",
          bonds * bytes_per_bond / 1e9, " GB; the limit is ", most_bonds, " bonds: choose a larger one");
  return outline;
}

}  // namespace

LatticeDescription::LatticeDescription(int material_id, const scene::Material& material, Outline outline,
                                       double spacing, int horizon_ratio)
    : LatticeDescription(material_id, material, std::move(outline), spacing, horizon_ratio, true) {}

LatticeDescription::LatticeDescription(int material_id, const scene::Material& material, Outline outline,
                                       double spacing, int horizon_ratio, bool on_rows)
    : Region(material_id, checked_outline(material_id, material, std::move(outline), spacing, horizon_ratio)),
      horizon_ratio_(horizon_ratio),
      squares_per_cell_(static_cast<double>(pd::cell_squares(material.elasticity).size())) {
  lattice_.spacing = spacing;
  if (on_rows) lattice_ = require_lattice(this->outline(), spacing);
}

void LatticeDescription::set_outline(Outline changed) {
  lattice_ = require_lattice(changed, lattice_.spacing);
  take_outline(std::move(changed));
}

void LatticeDescription::add_size(scene::SizeEstimate& size) const {
  const double bonds = bonds_of(outline(), lattice_.spacing, horizon_ratio_);
  size.bonds += bonds;
  size.bytes += bytes_per_bond * bonds + bytes_per_square * squares_per_cell_ * cells_of(outline(), lattice_.spacing);
}

void LatticeDescription::identify(Hash& hash) const {
  Region::identify(hash);
  hash.add(horizon_ratio_);
  hash.add(lattice_.spacing);
}

std::unique_ptr<regions::Region> LatticeDescription::build(int id, const Preparation& preparation) const {
  return preparation.scheme.lattice_region(id, *this, preparation.scene.material(material()));
}

int add_lattice_region(scene::Scene& scene, int material, const std::vector<Point>& vertices, double spacing,
                       int horizon_ratio) {
  scene::require_points(vertices, "vertex");
  return scene.add_region(std::make_unique<LatticeDescription>(material, scene.material(material), Outline{{vertices}},
                                                               spacing, horizon_ratio));
}

}  // namespace bempd::regions
