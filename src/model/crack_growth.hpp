#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "crack/tip.hpp"
#include "model/answers.hpp"
#include "model/tip_factors.hpp"
#include "regions/patches.hpp"
#include "regions/tip_values.hpp"
#include "scene/scene.hpp"
#include "scene/scene_values.hpp"

namespace bempd::model {

class Model;
struct Growing;
struct Grown;
struct PreparedScene;
enum class ExtensionDirections;

// Growth of cracks with boundary elements: finds the tips that may grow, and prepares scenes with longer cracks, in
// which the run of the previous scene continues.
class CrackGrowth {
 public:
  explicit CrackGrowth(Model& model) : model_(model) {}

  // Extends by a length, at their critical load factor, the tips that reach their toughness first. Operators that do
  // not change are reused. Throws Error and changes nothing if no tip can grow.
  GrowthResult grow(double length);

  // Freezes a tip, so that it does not grow, or releases it.
  void set_frozen(int crack, int end, bool frozen);
  bool is_frozen(const crack::TipId& tip) const { return frozen_.contains(tip); }
  const std::set<crack::TipId>& frozen() const { return frozen_; }
  void set_all_frozen(std::set<crack::TipId> frozen) noexcept { frozen_ = std::move(frozen); }

  // Whether cracks with boundary elements grow during steps of the load factor with these options. Cracks in a material
  // without a fracture energy are stationary.
  bool is_driven_by(const fracture::SteppingOptions& stepping) const;
  // Tips with boundary elements that may grow: neither frozen by the host nor stopped.
  std::vector<regions::TipValues> growing_tips();
  // Forgets the stress intensity factors of tips, because the scene or its loads have changed.
  void forget_factors() noexcept { factors_.scene = nullptr; }

  // Prepared scene with longer cracks, in which the present run continues (longer_cracks.cpp). `on_way` are the values
  // of loads and supports that act; null for the values that the host has set. Throws crack::CannotGrow if the longer
  // cracks are impossible.
  std::unique_ptr<PreparedScene> with_cracks(std::vector<scene::Crack> longer, const scene::SceneValues* on_way);
  // Prepared scene with other lattice patches (lattices inside a body), in which the present run continues
  // (laid_patches.cpp). The model's scene gets these patches and, if given, `cracks`; after an error it is as before.
  // `layout` is the record of the change in fracture::EvolutionState::layouts. `on_way` are the values of loads and
  // supports that act; null for the values that the host has set.
  std::unique_ptr<PreparedScene> with_patches(std::vector<regions::Patch> patches,
                                              std::optional<std::vector<scene::Crack>> cracks,
                                              const scene::SceneValues* on_way, std::int64_t layout);
  // Prepared scene in which the cracks `before` are longer by the extensions of `growing`, and in which the present run
  // continues; `on_way` as in with_cracks(). Throws crack::CannotGrow if such cracks are impossible.
  std::unique_ptr<PreparedScene> extended_scene(const std::vector<scene::Crack>& before, Growing& growing,
                                                const scene::SceneValues* on_way);
  // Prepares the scene with the extended cracks, and enters the growth in the history of its run. `on_way` as in
  // with_cracks().
  Grown grown(const std::vector<scene::Crack>& before, Growing growing, ExtensionDirections directions,
              const scene::SceneValues* on_way);

 private:
  const std::vector<regions::TipValues>& tip_factors();
  std::vector<regions::TipValues> free_tips();
  Growing go_to_growth(double length);

  Model& model_;
  std::set<crack::TipId> frozen_;
  TipFactors factors_;
};

}  // namespace bempd::model
