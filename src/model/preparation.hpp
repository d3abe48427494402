#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "model/prepared_scene.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

class Model;

// Scene of a model, and all that is prepared from it. Parts of the model change both: cracks grow, elements of bodies
// are refined, and a scene that is prepared anew replaces the previous one.
class Preparation {
 public:
  explicit Preparation(Model& model) : model_(model) {}

  scene::Scene& scene() { return scene_; }
  const scene::Scene& scene() const { return scene_; }

  // Origin of the operators of a scene that is prepared after another one. kept: unchanged operators are reused; anew:
  // all operators are computed, so that their last digits do not depend on the scenes before.
  enum class Operators { kept, anew };
  // Builds a prepared scene; the present one stays in place. `before` is the scene with shorter cracks or other
  // patches; null if there is none.
  std::unique_ptr<PreparedScene> build(const PreparedScene* before, Operators operators = Operators::kept) const;
  PreparedScene* prepared() const { return prepared_.get(); }  // null before the scene is prepared
  // Replaces the prepared scene by another one, or by null, and returns the previous one.
  std::unique_ptr<PreparedScene> exchange(std::unique_ptr<PreparedScene> next) noexcept {
    return std::exchange(prepared_, std::move(next));
  }

  // Number of the present state of the body, which each change raises. Results with a smaller number are out of date.
  std::int64_t generation() const { return generation_; }
  void has_changed() noexcept { ++generation_; }

 private:
  void grow_lines(PreparedScene& prepared) const;

  Model& model_;
  scene::Scene scene_;
  std::unique_ptr<PreparedScene> prepared_;
  std::int64_t generation_ = 1;
};

}  // namespace bempd::model
