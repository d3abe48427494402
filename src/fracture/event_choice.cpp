#include "fracture/event_choice.hpp"

namespace bempd::fracture {

std::optional<double> next_critical(const BondList& bonds, const LoadWay& way) {
  const bool on_path = way.control == Control::path;
  if (bonds.is_proportional) return bonds.ratios.next_proportional_break(on_path ? 0 : way.present);
  if (on_path) return bonds.ratios.admissible(bonds.intact, way.upwards).next(way.upwards);
  return bonds.ratios.next_break(bonds.intact, way.present, way.end());
}

std::vector<int> most_critical(const BondList& bonds, double load_factor, double band, int limit) {
  if (!bonds.is_proportional) return bonds.ratios.most_stretched(bonds.intact, load_factor, band, limit);
  const double largest = load_factor * bonds.ratios.steepest();
  return bonds.ratios.most_stretched(bonds.intact, load_factor, band, limit, largest);
}

Event break_of(const BondList& bonds, std::span<const int> chosen, double load_factor,
               const coupling::EquilibriumSystem& system) {
  Event event;
  event.load_factor = event.critical_load_factor = load_factor;
  for (const int place : chosen) {
    const auto bond = static_cast<std::size_t>(place);
    event.changes.push_back(system.stages().after_critical(bonds.numbers ? (*bonds.numbers)[bond] : place));
    event.reach(bonds.ratios.at(bond, load_factor), bonds.ratios.critical_load_factor(bond, load_factor));
  }
  return event;
}

}  // namespace bempd::fracture
