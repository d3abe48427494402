#pragma once

#include <functional>

#include "crack/laws/rate_law.hpp"

namespace bempd::crack {

// Growth rate given by a function of the host.
class HostRate final : public RateLaw {
 public:
  using Function = std::function<double(const TipCycle&)>;

  HostRate(Function function, double threshold) : RateLaw(threshold), function_(std::move(function)) {}

 private:
  double growth(const TipCycle& cycle) const override { return function_(cycle); }

  Function function_;
};

}  // namespace bempd::crack
