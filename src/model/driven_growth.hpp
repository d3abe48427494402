#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "model/element_tips.hpp"
#include "scene/scene.hpp"
#include "scene/scene_values.hpp"

namespace bempd::model {

struct PreparedScene;

// That a scene has taken so far.
struct Seconds {
  double solve = 0, update = 0, search = 0;
};
Seconds seconds_of(const PreparedScene& prepared);

// One run of a host, in which cracks with elements may grow, and what it takes to be back at its start.
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

}  // namespace bempd::model
