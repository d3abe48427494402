#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "crack/growth_law.hpp"
#include "crack/order.hpp"
#include "fracture/crack_evolution.hpp"
#include "fracture/other_tips.hpp"
#include "regions/region.hpp"
#include "scene/options.hpp"

namespace bempd::model {

// Tips of cracks with boundary elements in a run: which of them grows next on the way of the load factor, upwards or
// downwards, held at the load factor or on the path of equilibrium.
class ElementTips final : public fracture::OtherTips {
 public:
  // `tips` gives those that may grow, as affine functions of the load factor, in the present state.
  using Tips = std::function<std::vector<regions::TipValues>()>;
  ElementTips(const scene::Options& options, Tips tips) : options_(options), find_(std::move(tips)) {}

  // Run whose state the tips are in.
  void follow(const fracture::CrackEvolution& evolution) {
    evolution_ = &evolution;
    is_known_ = false;
  }

  const fracture::Event* next(double target, const fracture::SteppingOptions& options) override;
  bool rest_somewhere() override;

  // Tips that there are, and the one that the told event is of.
  const std::vector<regions::TipValues>& tips() const { return tips_; }
  std::size_t first() const { return first_; }
  int ties() const { return ties_; }

 private:
  void update();

  const scene::Options& options_;
  Tips find_;
  const fracture::CrackEvolution* evolution_ = nullptr;
  // What changes between two events changes no tip.
  bool is_known_ = false;
  std::int64_t events_ = 0, switches_ = 0;
  std::vector<regions::TipValues> tips_;
  std::vector<crack::GrowthRange> ranges_;
  std::size_t first_ = 0;
  int ties_ = 0;
  fracture::Event event_;
};

}  // namespace bempd::model
