#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "fracture/crack_evolution.hpp"
#include "regions/region.hpp"
#include "scene/scene.hpp"

namespace bempd::regions {
struct Discretization;
}

namespace bempd::model {

struct PreparedScene;

// Prepared scene with longer cracks, in whose history the growth is entered, and its tips.
struct Grown {
  std::unique_ptr<PreparedScene> scene;
  std::vector<regions::TipValues> tips;
  fracture::Growth growth;
};

// Directions of extensions: as they are given; as chords of the path if the option crack.direction says so; or chosen
// with their lengths by the library, which shortens extensions where the path turns sharply.
enum class ExtensionDirections { given, by_option, chosen };

// Time that a scene has taken so far, by kinds of work [s].
struct TimeSpent {
  double solve = 0, update = 0, search = 0;

  void add(const TimeSpent& other) { solve += other.solve, update += other.update, search += other.search; }
};
TimeSpent time_spent_in(const PreparedScene& prepared);

// Whether a crack line has come to the border of a boundary element region, or so close that it can continue there
// (border_crossing.cpp).
bool leaves_lattice(const fracture::CrackExtension& extension, const scene::Scene& scene,
                    const regions::Discretization& discretization);
// Place of its first tip in boundary elements; empty if it cannot continue there.
std::optional<Point> place_behind_border(const fracture::CrackExtension& extension, const scene::Scene& scene,
                                         const regions::Discretization& discretization);
// Whether a crack line is at the border itself, where it stops if it cannot continue in boundary elements.
bool is_at_border(const fracture::CrackExtension& extension, const scene::Scene& scene,
                  const regions::Discretization& discretization);
// Last extension of one end of a crack; empty (default values) if it has not grown.
fracture::CrackExtension last_extension_of(const crack::TipId& tip,
                                           std::span<const fracture::CrackExtension> extensions);
// Number of extensions in a list up to the last one of a tip that a crack has as a point: it has all of them. Its path
// may have fewer points, where elements carry it.
std::size_t known_extensions(const scene::Crack& crack, const crack::TipId& tip,
                             std::span<const fracture::CrackExtension> extensions);
// Adds the extensions of a tip to its crack that it does not have.
void add_extensions(scene::Crack& crack, const crack::TipId& tip, std::span<const fracture::CrackExtension> extensions);
// The crack of a line with all places that the line has reached, at both ends if it has begun in the run.
scene::Crack& crack_with_line(std::vector<scene::Crack>& cracks, const crack::TipId& line,
                              std::span<const fracture::CrackExtension> extensions, const scene::Scene& scene,
                              double tolerance);

}  // namespace bempd::model
