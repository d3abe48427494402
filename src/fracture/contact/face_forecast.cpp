#include "fracture/contact/face_forecast.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace bempd::fracture {

namespace {

constexpr int for_good = std::numeric_limits<int>::max();

}  // namespace

FaceForecast::FaceForecast(CrackFaces& faces, const FaceState& state) : faces_(faces), grown_(state.grown) {
  const coupling::Constraints& present = faces.constraints();
  for (std::size_t i = 0; i < present.size(); ++i) {
    latest_.push_back(i);
    watched_.push_back({present[i], present.is_closed(i), true, 0, present.is_barred(i) ? 0 : for_good, i, 0});
  }
  for (std::size_t k = 0; k < grown_.size(); ++k) number_of_[grown_[k].term] = faces.first_grown() + k;
  for (const std::vector<int>& terms : faces.pending()) follow(terms, 0);
}

FaceForecast::~FaceForecast() { faces_.forget_terms(counted_); }

void FaceForecast::follow(std::span<const int> broken, int state) {
  state_ = state;
  const std::vector<int> terms = faces_.follow(broken, *this);
  counted_.insert(counted_.end(), terms.begin(), terms.end());
}

std::optional<std::size_t> FaceForecast::place_of(int term) const {
  const auto known = number_of_.find(term);
  return known == number_of_.end() ? std::nullopt : std::optional(known->second);
}

void FaceForecast::add(const GrownFace& face, coupling::Constraint constraint) {
  number_of_[face.term] = latest_.size();
  grown_.push_back(face);
  latest_.push_back(watched_.size());
  watched_.push_back({std::move(constraint), false, false, state_, for_good, latest_.size() - 1, state_});
}

void FaceForecast::renew(std::size_t place, const GrownFace& face, coupling::Constraint constraint) {
  WatchedConstraint& before = watched_[latest_[place]];
  if (before.until == 0) return;  // a barred constraint gets no other normal
  before.until = state_;
  grown_[place - faces_.first_grown()] = face;
  latest_[place] = watched_.size();
  // A new normal is used only if the faces do not overlap with it in the state before the break. The proof of the
  // forecast has to check that, so the constraint is watched from that state on.
  watched_.push_back({std::move(constraint), false, false, std::max(state_ - 1, 0), for_good, place, state_});
}

void FaceForecast::switch_constraint(std::size_t watched, int state) {
  WatchedConstraint next = watched_[watched];
  next.closed = !next.closed;
  next.since = next.event = state;
  watched_[watched].until = state;
  latest_[next.number] = watched_.size();
  watched_.push_back(std::move(next));
}

void FaceForecast::forget_after(int state) {
  std::erase_if(watched_, [&](const WatchedConstraint& place) { return place.event > state; });
  for (WatchedConstraint& place : watched_) {
    if (place.until > state) place.until = for_good;
  }
}

std::vector<std::size_t> FaceForecast::last() const {
  std::vector<std::size_t> result;
  for (const std::size_t place : latest_) {
    if (watched_[place].until == for_good) result.push_back(place);
  }
  return result;
}

FaceState FaceForecast::last_state() const {
  FaceState result;
  result.grown = grown_;
  for (const std::size_t place : latest_) result.closed.push_back(watched_[place].closed ? 1 : 0);
  return result;
}

}  // namespace bempd::fracture
