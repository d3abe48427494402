#pragma once

#include <limits>
#include <string>

#include "crack/tip.hpp"
#include "geometry/point.hpp"

namespace bempd::model {

class Model;

// Explanation for the host: what breaks or grows next as the load factor changes, and what keeps the other tips and
// bonds from that.
struct Explanation {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  enum class Next { nothing = 0, bond = 1, tip = 2 };
  Next next = Next::nothing;
  int region = 0;      // region of the bond
  crack::TipId tip{};  // crack 0: no tip
  Point place{unknown, unknown};
  double load_factor = unknown;  // load factor at which this happens
  double ratio = unknown;        // present stretch over critical stretch, or equivalent K_I over toughness
  std::string text;              // the explanation in sentences
};

Explanation explain(Model& model, bool upwards);

}  // namespace bempd::model
