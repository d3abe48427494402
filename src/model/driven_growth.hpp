#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "fracture/crack_evolution.hpp"
#include "model/answers.hpp"
#include "regions/tip_values.hpp"
#include "scene/scene.hpp"

namespace bempd::regions {
struct Discretization;
}

namespace bempd::model {

struct PreparedScene;

// Prepared scene with longer cracks, its tips, and the growth that is entered in the history of its run.
struct Grown {
  std::unique_ptr<PreparedScene> scene;
  std::vector<regions::TipValues> tips;
  fracture::Growth growth;
};

// Directions of extensions. given: as Growing has them; by_option: chords of a curved path, if the option
// crack.direction says so; chosen: the library chooses directions together with lengths, and shortens extensions where
// the path turns sharply.
enum class ExtensionDirections { given, by_option, chosen };

// Time that a scene has taken so far.
TimeSpent time_spent_in(const PreparedScene& prepared);

// Whether a crack line (crack that grows in a lattice by steps of a spacing) has reached the border of a boundary
// element region, or is so close to the border that it can continue behind it (border_crossing.cpp).
bool leaves_lattice(const fracture::CrackExtension& extension, const scene::Scene& scene,
                    const regions::Discretization& discretization);
// Place of a crack line's first tip in boundary elements behind the border; empty if the line cannot continue there.
std::optional<Point> place_behind_border(const fracture::CrackExtension& extension, const scene::Scene& scene,
                                         const regions::Discretization& discretization);
// Whether a crack line is at the border of a boundary element region, where it stops if it cannot continue behind it.
bool is_at_border(const fracture::CrackExtension& extension, const scene::Scene& scene,
                  const regions::Discretization& discretization);
// Last extension of one end of a crack; default values if that end has not grown.
fracture::CrackExtension last_extension_of(const crack::TipId& tip,
                                           std::span<const fracture::CrackExtension> extensions);
// Number of leading entries of a list of extensions that a crack of the scene already contains at a tip: up to the
// tip's last extension that ends at a point of the crack. The crack may have fewer points than extensions, because
// points are left out where boundary elements carry the crack.
std::size_t known_extensions(const scene::Crack& crack, const crack::TipId& tip,
                             std::span<const fracture::CrackExtension> extensions);
// Adds to a crack those extensions of its tip that it does not contain.
void add_extensions(scene::Crack& crack, const crack::TipId& tip, std::span<const fracture::CrackExtension> extensions);
// Crack of the list `cracks` that belongs to a crack line, after all places that the line has reached were added; at
// both ends if the line began in the run.
scene::Crack& crack_with_line(std::vector<scene::Crack>& cracks, const crack::TipId& line,
                              std::span<const fracture::CrackExtension> extensions, const scene::Scene& scene,
                              double tolerance);

}  // namespace bempd::model
