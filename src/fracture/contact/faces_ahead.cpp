#include "fracture/contact/faces_ahead.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace bempd::fracture {

namespace {

constexpr int for_good = std::numeric_limits<int>::max();

}  // namespace

FacesAhead::FacesAhead(CrackFaces& faces, const FaceState& state) : faces_(faces), grown_(state.grown) {
  const coupling::Contacts& present = faces.places();
  for (std::size_t i = 0; i < present.size(); ++i) {
    latest_.push_back(i);
    places_.push_back({present[i], present.is_closed(i), true, 0, present.is_barred(i) ? 0 : for_good, i, 0});
  }
  for (const auto& [term, grown] : faces.grown_) number_of_[term] = faces.initial_count() + grown;
  for (const std::vector<int>& terms : faces.gone_) follow(terms, 0);
}

FacesAhead::~FacesAhead() {
  for (const int term : entered_) faces_.leave(term);
}

void FacesAhead::follow(std::span<const int> gone, int state) {
  const std::vector<int> terms = faces_.fresh(gone);
  for (const int term : terms) faces_.enter(term);
  entered_.insert(entered_.end(), terms.begin(), terms.end());
  for (const int term : faces_.around(terms)) {
    const auto known = number_of_.find(term);
    if (known != number_of_.end() && places_[latest_[known->second]].closed) continue;
    const Point normal = faces_.normal_at(term, faces_.near(term));
    std::optional<coupling::Contact> contact = faces_.contact_at(term, normal);
    if (!contact) continue;
    const GrownFace face{term, normal.x(), normal.y()};
    if (known == number_of_.end()) {
      number_of_[term] = latest_.size();
      grown_.push_back(face);
      latest_.push_back(places_.size());
      places_.push_back({std::move(*contact), false, false, state, for_good, latest_.size() - 1, state});
      continue;
    }
    const std::size_t number = known->second;
    WatchedPlace& before = places_[latest_[number]];
    if (before.until == 0) continue;  // barred
    before.until = state;
    grown_[number - faces_.initial_count()] = face;
    latest_[number] = places_.size();
    // A new normal counts only if the place does not overlap for it before the break.
    places_.push_back({std::move(*contact), false, false, std::max(state - 1, 0), for_good, number, state});
  }
}

void FacesAhead::switch_place(std::size_t place, int state) {
  WatchedPlace next = places_[place];
  next.closed = !next.closed;
  next.since = next.event = state;
  places_[place].until = state;
  latest_[next.number] = places_.size();
  places_.push_back(std::move(next));
}

void FacesAhead::forget_after(int state) {
  std::erase_if(places_, [&](const WatchedPlace& place) { return place.event > state; });
  for (WatchedPlace& place : places_) {
    if (place.until > state) place.until = for_good;
  }
}

std::vector<std::size_t> FacesAhead::last() const {
  std::vector<std::size_t> result;
  for (const std::size_t place : latest_) {
    if (places_[place].until == for_good) result.push_back(place);
  }
  return result;
}

FaceState FacesAhead::last_state() const {
  FaceState result;
  result.grown = grown_;
  for (const std::size_t place : latest_) result.closed.push_back(places_[place].closed ? 1 : 0);
  return result;
}

}  // namespace bempd::fracture
