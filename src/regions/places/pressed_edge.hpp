#pragma once

#include "regions/places/edge_part.hpp"

namespace bempd::regions {

// Part of an edge under pressure: the x component of a load's value [Pa] pushes against the body.
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
