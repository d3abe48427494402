#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "model/element_tips.hpp"
#include "regions/region.hpp"
#include "scene/scene.hpp"
#include "scene/scene_values.hpp"

namespace bempd::model {

struct PreparedScene;

// Prepared scene with longer cracks, in whose history the growth is entered, and its tips.
struct Grown {
  std::unique_ptr<PreparedScene> scene;
  std::vector<regions::TipValues> tips;
  fracture::Growth growth;
};

// Time that a scene has taken so far, by kinds of work [s].
struct Seconds {
  double solve = 0, update = 0, search = 0;
};
Seconds seconds_of(const PreparedScene& prepared);

// One run of a host in which cracks with elements may grow, and what is needed to return to its start.
struct DrivenRun {
  double target = 0;
  fracture::Goal goal = fracture::Goal::load_factor;
  fracture::SteppingOptions stepping;
  const scene::SceneValues* on_way = nullptr;  // values that act; null: those that were set
  std::function<void(const fracture::EvolutionState&)> on_event;
  std::function<void()> on_end;

  std::unique_ptr<PreparedScene> start;  // null: no crack has grown yet
  std::vector<scene::Crack> cracks;      // as they were
  bool crack_stopped = false;            // by the last growth
  std::size_t extensions_seen = 0;
  std::vector<crack::TipId> stopped_lines;  // among bonds, at the border of their lattice
  Seconds seconds;                          // of the present scene before the run, less those of scenes before it
};

// Whether a crack line has come to the border of a boundary element region, or so close that it can continue there
// (border_crossing.cpp).
bool leaves_lattice(const fracture::CrackExtension& extension, const scene::Scene& scene,
                    const regions::Discretization& discretization);

}  // namespace bempd::model
