#include "fracture/window/face_watch.hpp"

#include <unordered_map>

#include "fracture/contact/crack_faces.hpp"
#include "fracture/window/lookahead.hpp"

namespace bempd::fracture {

FaceWatch::FaceWatch(const coupling::Contacts& places, const CrackFaces& faces,
                     const std::vector<ForeseenEvent>& events, double from, bool proportional) {
  if (faces.are_none()) return;
  for (std::size_t i = 0; i < places.size(); ++i) places_.push_back({places[i], places.is_closed(i), 0});
  std::vector<int> next;
  std::unordered_map<int, int> since;
  for (std::size_t e = 0; e < events.size(); ++e) {
    for (const coupling::StageChange& change : events[e].event.changes) {
      next.push_back(change.term);
      since[change.term] = static_cast<int>(e) + 1;
    }
  }
  for (auto& [term, contact] : faces.foreseen(next)) {
    const auto found = since.find(term);
    places_.push_back({std::move(contact), false, found == since.end() ? 0 : found->second});
  }
  // In proportion all load factors are alike.
  double arrival = proportional ? 1 : from;
  for (std::size_t e = 0; e <= events.size(); ++e) {
    const double departure = proportional || e == events.size() ? arrival : events[e].event.load_factor;
    load_factors_.push_back({arrival, departure});
    arrival = departure;
  }
}

double FaceWatch::rounding(double largest) { return gap_rounding(largest); }

}  // namespace bempd::fracture
