#pragma once

#include <array>
#include <cstddef>

namespace bempd::fracture {

// Tuning parameters of windows. None of them changes which bonds break: a badly placed or sized window only costs time,
// and events that the certificate cannot prove are computed on the whole body. Lengths are in lattice spacings.
struct WindowSettings {
  // Length of a window ahead of a tip. The window costs its length squared for each bond and its length cubed once. A
  // longer one saves factorizations of the whole body, each of which costs the system's size to the power 1.5. The best
  // length grows with the square root of the size.
  static constexpr double length_at_20000_unknowns = 31, least_length = 8, most_length = 320;
  // Factor on the length of windows at the ends of initial cracks, so that a straight crack needs one factorization
  // there.
  static constexpr double length_of_expected = 1.5;
  // Largest number of unknowns of a window: the larger of a fixed number and a number for each spacing of its length.
  static constexpr double least_most_unknowns = 2600, most_unknowns_per_length = 46;

  // Size of a zone (rectangle around hot bonds): its least reach behind them, and its least half width.
  static constexpr double back = 4, half_width = 4;
  // Width of the rim in front of a zone, in which breaks are left to the next window; and least distance of its sides
  // from hot bonds.
  static constexpr double front_rim = 3, beside_hot = 2.4;
  // Shares of the largest stretch ratio from which on a bond is hot (close to breaking). The next share is tried if
  // there are too many hot bonds, or if their window is too large.
  static constexpr std::array hot_shares{0.7, 0.8, 0.9, 0.97};
  // Share of the largest ratio from which on bonds have to lie in the present window if it is to be kept, in systems
  // where terms follow others (squares of cells). Then the largest number of hot bonds around which a window is placed,
  // and of bonds cut by initial cracks for windows at the ends of these.
  static constexpr double hot_share_in_present_window = 0.9;
  static constexpr std::size_t most_hot_bonds = 1500, most_cut_bonds = 6000;
  // Distance below which hot bonds belong to one crowd (group of hot bonds), and distance from a crowd within which
  // broken bonds tell on which side of it the crack lies.
  static constexpr double crowd_distance = 6, crack_distance = 8;
  // Share of the largest stretch ratio in a crowd (group of hot bonds) from which on a bond counts for the crowd's
  // centre.
  static constexpr double centre_share = 0.85;
  // Bonds that determine the direction in which a crack opens near a crowd (group of hot bonds): share of the crowd's
  // largest stretch ratio, and distance from the crowd. The few bonds about to break would only give the next step of a
  // zigzag path.
  static constexpr double opening_share = 0.5, opening_reach = 16;
  // Ratio of the least to the largest opening above which bonds open in all directions alike; the crack behind them
  // then gives the direction.
  static constexpr double opening_all_around = 0.75;

  // Narrowing of a window: number of bonds broken between two attempts; least share of the followed nodes that makes it
  // worthwhile; share of the largest stretch ratio from which on bonds are hot; and distance behind the hindmost hot
  // bond, in spacings, from which on nodes are dropped.
  static constexpr std::size_t breaks_between_narrowings = 96;
  static constexpr double least_narrowing = 0.15, hot_when_narrowing = 0.5, behind_hot = 1;
  // Distance that followers (squares of cells) may reach beyond the terms that they follow.
  static constexpr double reach_of_followers = 1.5;

  // Numbers of events computed at once: few at first, because the host may want few, then more, up to the largest
  // number.
  static constexpr int first_events = 16, growth_of_events = 4, most_events_at_once = 1024;
  // Largest number of events in the whole body before a window is tried again.
  static constexpr int most_patience = 64;
  // Number of events in the whole body after a window that ended because crack faces moved. Such events follow each
  // other, and each window would cost a factorization.
  static constexpr int events_beside_faces = 16;

  // Windows for lines: least length of the path that they hold, and how much wider they are than the reach of a step.
  // Then the number of steps that a window has to save so that another one, which costs a factorization, is tried at
  // once.
  static constexpr double least_path = 8, margin_beside_path = 0.5;
  static constexpr int worthwhile_steps = 16;
  // Share of the load factor that windows pass to LineSteps::is_driven() in place of the whole. It makes this test
  // stricter, so that a tip that counts as driven in a window does so in the whole body too.
  static constexpr double surely_driven = 0.1;

  // Limits beyond which a term was the last, or nearly the last, resistance to a motion: a pivot below the first, or
  // displacements that grow by the second.
  static constexpr double smallest_pivot = 1e-7, most_growth = 1e6;
  // Number of columns collected before they are added to the flexibility: enough for a fast product, few enough to be
  // cheap in responses.
  static constexpr int most_pending_changes = 96;
  // Number of columns of a triangular factor that are multiplied at once, so that the zero rows above them can be left
  // out.
  static constexpr int factor_columns_at_once = 96;

  // Certificate: number of bonds that may break between two states computed for the whole body, and number of rounds
  // after which every uncertified state is computed.
  static constexpr int breaks_between_snapshots = 40;
  static constexpr int most_rounds = 6;
  // Certificate: bonds outside the window are sorted into classes by the logarithm of the largest stretch ratio that
  // one unit of energy can cause in them, so that one bound proves a whole class. Here are the number of classes, and
  // the least range that they divide.
  static constexpr int classes = 8;
  static constexpr double least_class_width = 1e-12;
  // Number of states solved at once, enough for fast products; and number of states compared at once with each bond,
  // few enough for the caches.
  static constexpr std::size_t states_solved_at_once = 64;
  static constexpr int states_swept_at_once = 16;

  // Margins for rounding, relative to the stiffness around a window: in the certificate's comparisons, and in energies.
  static constexpr double comparison_margin = 1e-9;
  static constexpr double energy_rounding = 1e-13;
  // Share of the undamaged scene's energy below which a body may have separated although rounding hides it.
  static constexpr double doubtful_energy = 1e-7;
  // Largest residual with which computed events are accepted; smaller ones are rounding.
  static constexpr double acceptable_residual = 1e-11;
  // Number of events between two checks of the balance of forces in a window, and the residual above which it is
  // corrected. Only used where terms follow others (squares of cells).
  static constexpr int events_between_balances = 32;
  static constexpr double negligible_residual = 1e-12;
};

}  // namespace bempd::fracture
