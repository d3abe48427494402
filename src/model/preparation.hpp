#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "model/prepared_scene.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

class Model;

// Scene of a model and what is prepared from it. Parts of the model change both: cracks grow, elements of bodies are
// refined, and a scene that is prepared anew takes the place of the one before.
class Preparation {
 public:
  explicit Preparation(Model& model) : model_(model) {}

  scene::Scene& scene() { return scene_; }
  const scene::Scene& scene() const { return scene_; }

  // Builds a prepared scene, which does not take the place of the present one yet. `before` is the scene with shorter
  // cracks, or smaller patches; null if there is none. Its unchanged operators are reused, unless all are made `anew`:
  // they then have the same digits whatever the scene before was.
  enum class Operators { kept, anew };
  std::unique_ptr<PreparedScene> build(const PreparedScene* before, Operators operators = Operators::kept) const;
  PreparedScene* prepared() const { return prepared_.get(); }  // null before it is prepared
  // Puts a prepared scene, or null, in the place of the present one, which it returns.
  std::unique_ptr<PreparedScene> exchange(std::unique_ptr<PreparedScene> next) noexcept {
    return std::exchange(prepared_, std::move(next));
  }

  // Number of the present state of the body: results of an earlier one are out of date.
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
