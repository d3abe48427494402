#pragma once

#include "regions/places/edge_part.hpp"

namespace bempd::regions {

// Part of an edge under a pressure: the first component of a load's values [Pa] pushes against the body.
class PressedEdge final : public EdgePart {
 public:
  using EdgePart::EdgePart;

  void identify(Hash& hash) const override {
    hash.add(std::string_view("pressed edge"));
    EdgePart::identify(hash);
  }

 protected:
  Point traction(const Edge& edge, double fraction, const Point& value) const override;
};

}  // namespace bempd::regions
