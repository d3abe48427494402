#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "crack/carrier.hpp"
#include "fracture/crack_evolution.hpp"
#include "regions/region.hpp"
#include "scene/options.hpp"

namespace bempd::model {

// Cracks with boundary elements in a run: where their tips grow on the way of the load factor, upwards or downwards,
// held at the load factor or on the path of equilibrium.
class ElementTips final : public crack::Carrier {
 public:
  // `tips` gives those that may grow, as affine functions of the load factor, in the present state.
  using Tips = std::function<std::vector<regions::TipValues>()>;
  ElementTips(const scene::Options& options, Tips tips) : options_(options), find_(std::move(tips)) {}

  // Run whose state the tips are in.
  void follow(const fracture::CrackEvolution& evolution) {
    evolution_ = &evolution;
    is_known_ = false;
  }

  std::vector<crack::Tip> tips() override;
  std::vector<crack::Candidate> candidates(const crack::LoadWay& way) override;

  // Values of these tips: all that regions know of them.
  const std::vector<regions::TipValues>& values() const { return values_; }
  std::size_t number_of(const crack::TipId& tip) const;

 private:
  void update();

  const scene::Options& options_;
  Tips find_;
  const fracture::CrackEvolution* evolution_ = nullptr;
  // What changes between two events changes no tip.
  bool is_known_ = false;
  std::int64_t events_ = 0, switches_ = 0;
  std::vector<regions::TipValues> values_;
  std::vector<crack::Tip> tips_;
};

}  // namespace bempd::model
