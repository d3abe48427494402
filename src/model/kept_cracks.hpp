#pragma once

#include <utility>
#include <vector>

#include "scene/scene.hpp"

namespace bempd::model {

// Scope at whose end a scene has its former cracks again, whatever has ended it; release() lets it keep the longer
// ones.
class KeptCracks {
 public:
  KeptCracks(scene::Scene& scene, std::vector<scene::Crack> cracks) : scene_(scene), cracks_(std::move(cracks)) {}
  ~KeptCracks() {
    if (!is_released_) scene_.set_cracks(std::move(cracks_));
  }
  KeptCracks(const KeptCracks&) = delete;
  KeptCracks& operator=(const KeptCracks&) = delete;

  void release() noexcept { is_released_ = true; }

 private:
  scene::Scene& scene_;
  std::vector<scene::Crack> cracks_;
  bool is_released_ = false;
};

}  // namespace bempd::model
