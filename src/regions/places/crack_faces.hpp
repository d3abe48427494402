#pragma once

#include "regions/places/off_edges.hpp"

namespace bempd::regions {

// Faces of a crack as a place of loads, which act on both faces. The x component of a load's value is a pressure that
// pushes the faces apart; the y component is a shear that drives the left face (seen along the crack) forward and the
// right face back [Pa].
class CrackFaces : public OffEdges {
 public:
  explicit CrackFaces(int crack) : crack_(crack) {}

  void check(const scene::Scene& scene) const override;
  bool lies_along_a_line() const override { return true; }
  bool needs_crack(int crack) const override { return crack == crack_; }
  void identify(Hash& hash) const override {
    hash.add(std::string_view("crack faces"));
    hash.add(crack_);
  }
  std::vector<PlacedNode> held_nodes(const scene::Scene& scene, const Discretization& discretization,
                                     int support) const override;
  void add_load(const scene::Scene& scene, const Discretization& discretization, int load,
                DofConditions& conditions) const override;

 protected:
  int crack() const { return crack_; }
  // Adds the load to `conditions` for those parts of the crack that have boundary elements.
  void add_to_elements(const scene::Scene& scene, const Discretization& discretization, int load,
                       DofConditions& conditions) const;

 private:
  int crack_;
};

}  // namespace bempd::regions
