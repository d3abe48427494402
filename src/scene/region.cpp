#include "scene/region.hpp"

#include <cmath>

#include "error.hpp"

namespace bempd::scene {

int Region::edge_count() const {
  std::size_t count = 0;
  for (const auto& loop : outline_.loops) count += loop.size();
  return static_cast<int>(count);
}

void Region::identify(Hash& hash) const {
  hash.add(std::string_view(adjective()));
  hash.add(outline_.loops.size());
  for (const std::vector<Point>& loop : outline_.loops) {
    hash.add(loop.size());
    for (const Point& vertex : loop) hash.add(vertex.x()), hash.add(vertex.y());
  }
  // Computed angles and fractions are rounded: they are computed from places that the host gave, and their last digits
  // depend on the processor.
  const auto add_computed = [&](double value) { hash.add(std::llround(value * 1e8)); };
  hash.add(outline_.curved.size());
  for (const auto& [number, edge] : outline_.curved) {
    hash.add(number);
    add_computed(edge.joint());
    for (int k = 0; k < edge.piece_count(); ++k) add_computed(edge.piece(k).sweep);
  }
  if (part_of_ > 0) hash.add(std::string_view("part")), hash.add(part_of_);
  if (!fracture_energies_) return;
  hash.add(std::string_view("fracture energies"));
  for (const Point& place : fracture_energies_->places()) hash.add(place.x()), hash.add(place.y());
  for (const double value : fracture_energies_->values()) hash.add(value);
}

void require_edge(const Region& region, int id, int edge) {
  require(edge >= 1 && edge <= region.edge_count(), "edge ", edge, " does not exist; region ", id, " has edges 1 .. ",
          region.edge_count());
}

}  // namespace bempd::scene
