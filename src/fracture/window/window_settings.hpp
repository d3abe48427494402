#pragma once

#include <array>
#include <cstddef>

namespace bempd::fracture {

// All that is tuned in windows. None of it changes what breaks: windows that are badly placed or sized cost time, and
// the certificate sends every event that it cannot prove to the whole body. Lengths are in lattice spacings.
struct WindowSettings {
  static constexpr double length_at_20000_unknowns = 31, least_length = 8, most_length = 320;
  static constexpr double length_of_expected = 1.5;
  static constexpr double least_most_unknowns = 2600, most_unknowns_per_length = 46;
  static constexpr double back = 4, half_width = 4;
  static constexpr double front_rim = 3, beside_hot = 2.4;
  static constexpr std::array hot_shares{0.7, 0.8, 0.9, 0.97};
  static constexpr std::size_t most_hot_bonds = 1500, most_cut_bonds = 6000;
  static constexpr double crowd_distance = 6, crack_distance = 8;
  static constexpr double centre_share = 0.85;
  static constexpr double opening_share = 0.5, opening_reach = 16;
  static constexpr std::size_t breaks_between_narrowings = 96;
  static constexpr double least_narrowing = 0.15, hot_when_narrowing = 0.5, behind_hot = 1;
  static constexpr int first_events = 16, growth_of_events = 4, most_events_at_once = 1024;
  static constexpr int most_patience = 64;
  static constexpr double smallest_pivot = 1e-7, most_growth = 1e6;
  static constexpr int most_pending_changes = 96;
  static constexpr int factor_columns_at_once = 96;
  static constexpr int breaks_between_snapshots = 40;
  static constexpr int most_rounds = 6;
  static constexpr int classes = 8;
  static constexpr double least_class_width = 1e-12;
  static constexpr std::size_t states_solved_at_once = 64;
  static constexpr int states_swept_at_once = 16;
  static constexpr double certificate_margin = 1e-9;
  static constexpr double energy_rounding = 1e-13;
  // Of the energy of the undamaged scene: with less the body may be separated, and rounding may hide it.
  static constexpr double doubtful_energy = 1e-7;
  static constexpr double acceptable_residual = 1e-11;
};

}  // namespace bempd::fracture
