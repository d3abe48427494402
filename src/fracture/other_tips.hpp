#pragma once

#include "fracture/event_source.hpp"

namespace bempd::fracture {

// Tips of cracks that do not grow by breaking bonds, as those with boundary elements. Whoever knows them says where the
// next one grows and lets it grow; a run only goes there.
class OtherTips {
 public:
  OtherTips() = default;
  OtherTips(const OtherTips&) = delete;
  OtherTips& operator=(const OtherTips&) = delete;
  virtual ~OtherTips() = default;

  // The next growth on the way to a target; null if there is none in that direction. Asked again after whatever changes
  // the body.
  virtual const Event* next(double target, const SteppingOptions& options) = 0;
  // Whether they stay where they are at some load factor.
  virtual bool rest_somewhere() = 0;
};

}  // namespace bempd::fracture
