#pragma once

#include "regions/places/edge_part.hpp"

namespace bempd::regions {

// Nodes of a part of a free edge; loads on it are a force on each of them [N].
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
