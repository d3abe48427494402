#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "crack/carrier.hpp"
#include "fracture/crack_evolution.hpp"
#include "regions/region.hpp"
#include "scene/options.hpp"

namespace bempd::model {

// Carrier of cracks with boundary elements: it finds the load factors at which their tips grow.
class ElementTips final : public crack::Carrier {
 public:
  // Function that returns the tips that may grow in the present state, with factors affine in the load factor.
  using Tips = std::function<std::vector<regions::TipValues>()>;
  ElementTips(const scene::Options& options, Tips tips) : options_(options), find_(std::move(tips)) {}

  // Follows a run: tips are computed for its present state. Called again when a growth continues in another scene.
  void follow(const fracture::CrackEvolution& evolution) {
    evolution_ = &evolution;
    is_known_ = false;
  }

  std::vector<crack::Tip> tips() override;
  std::vector<crack::Candidate> candidates(const crack::LoadWay& way) override;

  // Results of the tips as regions have computed them, in the order of tips().
  const std::vector<regions::TipValues>& values() const { return values_; }
  std::size_t number_of(const crack::TipId& tip) const;

 private:
  void update();

  const scene::Options& options_;
  Tips find_;
  const fracture::CrackEvolution* evolution_ = nullptr;
  // Tips are computed again only after an event or a contact change: nothing changes them in between.
  bool is_known_ = false;
  std::int64_t events_ = 0, switches_ = 0;
  std::vector<regions::TipValues> values_;
  std::vector<crack::Tip> tips_;
};

}  // namespace bempd::model
