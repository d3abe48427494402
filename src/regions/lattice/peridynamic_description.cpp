#include "regions/lattice/peridynamic_description.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "error.hpp"
#include "pd/bond_family.hpp"
#include "pd/cell_squares.hpp"
#include "regions/scheme.hpp"
#include "scene/outline_rules.hpp"

namespace bempd::regions {

namespace {

// Largest number of bonds in a region, because int numbers them.
constexpr double most_bonds = std::numeric_limits<int>::max();

// Memory per bond, for all lists that exist at the same time [B]. Measured were 142 to 150 with 1.4 and 5.9 million
// bonds.
constexpr double bytes_per_bond = 140;
// Memory estimate for each cell square (extra energy term of a lattice cell) [B].
constexpr double bytes_per_square = 320;

double cells_of(const Outline& outline, double spacing) { return area(outline) / (spacing * spacing); }

double bonds_of(double cells, int horizon_ratio) {
  return cells * static_cast<double>(pd::bond_family(horizon_ratio).size());
}

double squares_per_cell_of(const scene::Material& material) {
  return static_cast<double>(pd::cell_squares(material.elasticity).size());
}

void add_size_of(double cells, int horizon_ratio, double squares_per_cell, scene::SizeEstimate& size) {
  const double bonds = bonds_of(cells, horizon_ratio);
  size.bonds += bonds;
  size.bytes += bytes_per_bond * bonds + bytes_per_square * squares_per_cell * cells;
}

// Range of Poisson's ratio in peridynamic regions. Below the smallest ratio, bonds would be so much softer than cell
// squares (extra energy terms of lattice cells) that cracks start too early. Above the largest ratio, hydrostatic
// tension hardly stretches bonds (docs/materials.md).
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
      require(false, "edge ", fit.edge + 1, " is parallel to neither axis");
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
  const double bonds = bonds_of(cells, horizon_ratio);
  require(bonds <= most_bonds, "spacing ", spacing, " would need ", cells, " cells with ", bonds, " bonds, about ",
          bonds * bytes_per_bond / 1e9, " GB; the limit is ", most_bonds, " bonds: choose a larger one");
  return outline;
}

bool is_rectilinear(const Outline& outline) {
  if (!outline.curved.empty()) return false;
  const double tolerance = geometric_tolerance(bounding_box(outline));
  const std::vector<Edge> edges = edges_of(outline);
  return std::all_of(edges.begin(), edges.end(),
                     [&](const Edge& edge) { return edge.direction().cwiseAbs().minCoeff() <= tolerance; });
}

// Throws Error (argument) for a horizon of less than three spacings: points on an outline need more bonds than those to
// their nearest neighbours.
void require_horizon(int horizon_ratio) {
  require(horizon_ratio >= 3, "horizon_ratio is ", horizon_ratio,
          "; a peridynamic region with slanted or round edges needs at least 3");
}

}  // namespace

PeridynamicDescription::PeridynamicDescription(int material_id, const scene::Material& material, Outline outline,
                                               double spacing, int horizon_ratio, const PointChoice& choice)
    : Region(material_id, checked_outline(material_id, material, std::move(outline), spacing, horizon_ratio)),
      spacing_(spacing),
      horizon_ratio_(horizon_ratio),
      choice_(choice),
      squares_per_cell_(squares_per_cell_of(material)),
      lattice_(lattice_along(this->outline())) {}

std::optional<LatticeOutline> PeridynamicDescription::lattice_along(const Outline& outline) const {
  if (choice_.is_default() && is_rectilinear(outline)) return require_lattice(outline, spacing_);
  require_horizon(horizon_ratio_);
  return std::nullopt;
}

bool PeridynamicDescription::has_lattice_of(const PeridynamicDescription& other) const {
  return std::abs(spacing_ / other.spacing_ - 1) < 1e-9 && horizon_ratio_ == other.horizon_ratio_ &&
         choice_.angle == other.choice_.angle;
}

void PeridynamicDescription::set_outline(Outline changed) {
  lattice_ = lattice_along(changed);
  take_outline(std::move(changed));
}

std::optional<scene::NodeGrid> PeridynamicDescription::node_grid() const {
  if (!lattice_) return std::nullopt;
  return scene::NodeGrid{lattice_->origin, lattice_->spacing};
}

void PeridynamicDescription::add_size(scene::SizeEstimate& size) const {
  add_size_of(cells_of(outline(), spacing_), horizon_ratio_, squares_per_cell_, size);
}

void add_size_of_cells(const scene::Material& material, double cells, int horizon_ratio, scene::SizeEstimate& size) {
  add_size_of(cells, horizon_ratio, squares_per_cell_of(material), size);
}

void PeridynamicDescription::identify(Hash& hash) const {
  Region::identify(hash);
  hash.add(horizon_ratio_);
  hash.add(spacing_);
  if (choice_.is_default()) return;
  hash.add(choice_.on_outline ? 1 : 0);
  hash.add(choice_.angle);
}

std::unique_ptr<regions::Region> PeridynamicDescription::build(int id, const Preparation& preparation) const {
  const scene::Material& own = preparation.scene.material(material());
  return lattice_ && !preparation.leaves_rows(id) ? preparation.scheme.lattice_region(id, *this, own)
                                                  : preparation.scheme.outlined_region(id, *this, own);
}

int add_peridynamic_region(scene::Scene& scene, int material, const std::vector<Point>& vertices, double spacing,
                           int horizon_ratio, const PointChoice& choice, const std::vector<double>& bulges) {
  Outline outline;
  scene::append_loop(outline, vertices, bulges);
  return scene.add_region(std::make_unique<PeridynamicDescription>(material, scene.material(material),
                                                                   std::move(outline), spacing, horizon_ratio, choice));
}

}  // namespace bempd::regions
