#pragma once

#include <optional>
#include <span>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/critical_events.hpp"
#include "fracture/event_source.hpp"
#include "fracture/load_way.hpp"

namespace bempd::fracture {

// List of bonds among which the next break is chosen: all bonds of the body, or those that a window (region around
// crack tips that is solved alone) watches. A bond is called by its place in this list.
struct BondList {
  const AffineRatios& ratios;
  const std::vector<char>& intact;
  const std::vector<int>* numbers = nullptr;  // numbers in the system of the listed bonds; null: all bonds are listed
  // Whether all stretch ratios have a constant part of 0 (and broken bonds the ratio 0). In that case load paths have
  // to lead upwards from a load factor >= 0.
  bool is_proportional = false;
};

// Load factor at which the first of the bonds reaches its critical stretch on a load path; empty if none does.
std::optional<double> next_critical(const BondList& bonds, const LoadWay& way);

// Most stretched bonds at a load factor: those whose stretch ratio (stretch over critical stretch) is within the
// relative `band` below the largest ratio; at most `limit`, 0 for all.
std::vector<int> most_critical(const BondList& bonds, double load_factor, double band, int limit);

// Event at which the bonds `chosen` enter their next damage stage. The caller adds the followers of the bonds (cell
// squares that break with them, TermStages::with_followers).
Event break_of(const BondList& bonds, std::span<const int> chosen, double load_factor,
               const coupling::EquilibriumSystem& system);

}  // namespace bempd::fracture
