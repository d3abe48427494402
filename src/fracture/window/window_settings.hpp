#pragma once

#include <array>
#include <cstddef>

namespace bempd::fracture {

// Tuning parameters of windows (regions around crack tips or bonds close to breaking that are solved alone). None of
// them changes which bonds break: a badly placed or sized window only costs time, and events that cannot be proven to
// be those of the whole body are computed on the whole body. Lengths are in lattice spacings.
struct WindowSettings {
  // Length of a window ahead of a crack tip in a system of 20000 unknowns, and limits on the length in other systems. A
  // window costs its length squared for each bond that breaks, and its length cubed once. A longer window saves
  // factorizations of the whole body, each of which costs the size of the system to the power 1.5. So the best length
  // grows with the square root of the size.
  static constexpr double length_at_20000_unknowns = 31, least_length = 8, most_length = 320;
  // Factor on the length of windows at the ends of initial cracks, so that a straight crack needs only one
  // factorization for such a window.
  static constexpr double length_of_expected = 1.5;
  // Largest number of unknowns of a window: least_most_unknowns, or most_unknowns_per_length times the window's length
  // if that is larger.
  static constexpr double least_most_unknowns = 2600, most_unknowns_per_length = 46;

  // Size of a zone (rectangle around hot bonds, which are close to breaking): length by which it reaches behind the
  // bonds, and its least half width.
  static constexpr double back = 4, half_width = 4;
  // Width of the rim at the front end of a zone (rectangle around hot bonds), in which breaks are left to the next
  // window; and least distance from the long sides of the zone to hot bonds.
  static constexpr double front_rim = 3, beside_hot = 2.4;
  // Shares of the largest stretch ratio (stretch over critical stretch) from which on a bond counts as hot (close to
  // breaking). The next share is tried if there are too many hot bonds, or if the window around them is too large.
  static constexpr std::array hot_shares{0.7, 0.8, 0.9, 0.97};
  // Share of the largest stretch ratio: if all bonds from this share on lie in the present window, the window is kept.
  // Used in lattices with cell squares, which break with the bonds that they follow.
  static constexpr double hot_share_in_present_window = 0.9;
  // Largest numbers of hot bonds (close to breaking) around which a window is placed, and of bonds cut by initial
  // cracks for which windows are placed at the ends of these cracks.
  static constexpr std::size_t most_hot_bonds = 1500, most_cut_bonds = 6000;
  // Distance below which hot bonds (close to breaking) belong to one crowd (group of hot bonds); and distance from a
  // crowd within which broken bonds tell on which side of the crowd the crack lies.
  static constexpr double crowd_distance = 6, crack_distance = 8;
  // Share of the largest stretch ratio in a crowd (group of hot bonds) from which on a bond counts for the crowd's
  // centre.
  static constexpr double centre_share = 0.85;
  // Limits for the bonds that determine the direction in which a crack opens near a crowd (group of hot bonds): least
  // stretch ratio, as a share of the crowd's largest, and largest distance from the crowd. The few bonds about to break
  // would only give the next step of a zigzag path.
  static constexpr double opening_share = 0.5, opening_reach = 16;
  // Ratio of the least to the largest principal value of the opening near a crowd (group of hot bonds), above which
  // bonds open in all directions alike, so that the crack behind the bonds gives the direction.
  static constexpr double opening_all_around = 0.75;

  // Number of bonds broken between two attempts to narrow a window, which then no longer follows the nodes behind the
  // crack tip.
  static constexpr std::size_t breaks_between_narrowings = 96;
  // Narrowing of a window (end of following nodes behind the crack tip): least share of the followed nodes that has to
  // be dropped; share of the largest stretch ratio from which on bonds are hot; and distance behind the hindmost hot
  // bond from which on nodes are dropped.
  static constexpr double least_narrowing = 0.15, hot_when_narrowing = 0.5, behind_hot = 1;
  // Distance that followers (cell squares) may reach beyond the bonds that they follow.
  static constexpr double reach_of_followers = 1.5;

  // Largest number of events that a window computes at once: first_events at the first time, because the host may want
  // few events; then growth_of_events times as many each time, up to most_events_at_once.
  static constexpr int first_events = 16, growth_of_events = 4, most_events_at_once = 1024;
  // Largest number of events on the whole body before a window is tried again.
  static constexpr int most_patience = 64;
  // Number of events performed on the whole body after a window that ended because crack faces opened or closed. Such
  // events follow each other, and each window would cost a factorization.
  static constexpr int events_beside_faces = 16;

  // Windows for crack lines (cracks that grow in a lattice by steps): least length of a tip's path that a window
  // contains, and distance by which the window is wider than the bonds across the path.
  static constexpr double least_path = 8, margin_beside_path = 0.5;
  // Number of steps of crack lines that a window has to perform to be worth its factorization; the next window is then
  // tried without waiting.
  static constexpr int worthwhile_steps = 16;
  // Factor on the load factor that windows pass to LineSteps::is_driven(). A factor below 1 makes this test stricter,
  // so that a tip that the load drives in a window is driven in the whole body too.
  static constexpr double surely_driven = 0.1;

  // Limits beyond which a term was the last, or nearly the last, resistance to a motion: the pivot of its removal is
  // less than smallest_pivot, or its removal makes displacements grow by more than the factor most_growth.
  static constexpr double smallest_pivot = 1e-7, most_growth = 1e6;
  // Number of changes of rank one that are collected before they are added to the flexibility matrix: enough for a fast
  // product, few enough to be cheap when responses are computed.
  static constexpr int most_pending_changes = 96;
  // Number of columns of a triangular factor that are multiplied at once: so few that most of the zero rows above them
  // can be left out.
  static constexpr int factor_columns_at_once = 96;

  // Proof of a window's events: number of bonds that may break between two states computed for the whole body.
  static constexpr int breaks_between_snapshots = 40;
  // Proof of a window's events: number of rounds after which every state that is not proven is computed for the whole
  // body.
  static constexpr int most_rounds = 6;
  // Proof of a window's events: number of classes of the bonds outside. Bonds are sorted into classes by the logarithm
  // of the largest stretch ratio that one unit of energy can cause in a bond, so that one inequality proves a whole
  // class.
  static constexpr int classes = 8;
  // Proof of a window's events: least range of the logarithms by which bonds are sorted into classes, for the case that
  // all bonds are equal.
  static constexpr double least_class_width = 1e-12;
  // Number of states (displacements after some events) for which the whole body is solved at once, enough for fast
  // products.
  static constexpr std::size_t states_solved_at_once = 64;
  // Number of states (displacements after some events) that are compared at once for each bond, few enough for the
  // caches.
  static constexpr int states_swept_at_once = 16;

  // Margin for rounding when stretch ratios are compared with limits, as a share of the limit.
  static constexpr double comparison_margin = 1e-9;
  // Rounding error of the strain energy outside a window, as a share of the largest stiffness times squared
  // displacement.
  static constexpr double energy_rounding = 1e-13;
  // Ratio of the energy of the proportional load to its value when the load was given, below which a body may have
  // separated although rounding hides it.
  static constexpr double doubtful_energy = 1e-7;
  // Largest residual (unbalanced force over largest force) with which computed events are accepted.
  static constexpr double acceptable_residual = 1e-11;
  // Number of events between two checks of the balance of forces, in windows with terms that follow others (cell
  // squares).
  static constexpr int events_between_balances = 32;
  // Residual above which the balance of forces in a window is corrected.
  static constexpr double negligible_residual = 1e-12;
};

}  // namespace bempd::fracture
