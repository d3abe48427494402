#pragma once

#include "regions/places/edge_part.hpp"

namespace bempd::regions {

// Nodes on a part of a free edge; the value of a load is the force on each of the nodes [N].
class ForcedNodes final : public EdgePart {
 public:
  using EdgePart::EdgePart;

  void identify(Hash& hash) const override {
    hash.add(std::string_view("forced nodes"));
    EdgePart::identify(hash);
  }
  void add_load(const scene::Scene& scene, const Discretization& discretization, int load,
                DofConditions& conditions) const override;
};

}  // namespace bempd::regions
