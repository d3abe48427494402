#include "regions/places/pressed_crack.hpp"

#include "regions/boundary_conditions.hpp"

namespace bempd::regions {

void PressedCrack::identify(Hash& hash) const {
  hash.add(std::string_view("crack pressure"));
  hash.add(crack());
}

void PressedCrack::add_load(const scene::Scene& scene, const Discretization& d, int load,
                            DofConditions& conditions) const {
  const PartedCrack& parted = d.cracks[static_cast<std::size_t>(crack()) - 1];
  if (parted.has_elements()) add_to_elements(scene, d, load, conditions);
  if (!parted.cuts_bonds()) return;
  const scene::BoundaryValue value = scene.loads()[static_cast<std::size_t>(load)].value(Point::Zero(), 0);
  conditions.crack_pressures.push_back({crack(), {value.constant.x(), value.proportional.x()}});
}

}  // namespace bempd::regions
