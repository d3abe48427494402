#pragma once

#include <array>
#include <cstddef>

namespace bempd::fracture {

// All that is tuned in windows. None of it changes what breaks: windows that are badly placed or sized cost time, and
// the certificate sends every event that it cannot prove to the whole body. Lengths are in lattice spacings.
struct WindowSettings {
  // How far a window reaches ahead of a tip. Its own costs grow with the square of its length per bond and with the
  // cube once; the longer it is, the fewer factorizations of the whole body it takes, whose cost grows with the size of
  // the system to the power 1.5. Both sides balance where the length grows with the root of the size.
  static constexpr double length_at_20000_unknowns = 31, least_length = 8, most_length = 320;
  // Windows at the ends of initial cracks are longer by this factor: a straight run is to take one factorization there.
  static constexpr double length_of_expected = 1.5;
  // Unknowns that a window may have: so many, or so many for each spacing of its length.
  static constexpr double least_most_unknowns = 2600, most_unknowns_per_length = 46;

  // How far a zone reaches behind its hot bonds and to each side of its axis at least; how far beyond hot bonds beside
  // it; and the rim in front, in which breaks are left to the next window.
  static constexpr double back = 4, half_width = 4;
  static constexpr double front_rim = 3, beside_hot = 2.4;
  // Hot are bonds with this share of the largest ratio; the next share is taken where they are too many or their window
  // is too large.
  static constexpr std::array hot_shares{0.7, 0.8, 0.9, 0.97};
  // The share with which a window stays that is there already, where terms follow others.
  static constexpr double hot_in_present = 0.9;
  static constexpr std::size_t most_hot_bonds = 1500, most_cut_bonds = 6000;
  // Hot bonds nearer to each other than this are one crowd; broken bonds as near as the second tell on which side of a
  // crowd the crack is.
  static constexpr double crowd_distance = 6, crack_distance = 8;
  // Bonds with this share of the largest ratio in a crowd tell where its middle is.
  static constexpr double centre_share = 0.85;
  // Bonds that tell in which direction a crack opens: those with this share of the largest ratio in a crowd, up to so
  // many spacings from it. The few that are about to break would tell the next step of a path that goes to and fro.
  static constexpr double opening_share = 0.5, opening_reach = 16;
  // The crack behind tells the direction where bonds open in all directions alike, by this ratio of the least to the
  // largest.
  static constexpr double opening_all_around = 0.75;

  // Bonds broken between two looks at what can be left behind; the least share of what is followed that is worth it;
  // and where it lies: so far behind the bonds with this share of the largest ratio.
  static constexpr std::size_t breaks_between_narrowings = 96;
  static constexpr double least_narrowing = 0.15, hot_when_narrowing = 0.5, behind_hot = 1;
  // Distance that followers may reach beyond the terms that they follow.
  static constexpr double reach_of_followers = 1.5;

  // Events computed at once: few at first, in case the host wants few, then more, up to this many.
  static constexpr int first_events = 16, growth_of_events = 4, most_events_at_once = 1024;
  // Events in the whole body after which a window is tried again at the latest.
  static constexpr int most_patience = 64;
  // Events of the whole body after a window that ended because faces of cracks move: such come one after the other, and
  // each window would cost a factorization.
  static constexpr int events_beside_faces = 16;

  // Lines: a window has to hold the way for so many spacings at first, how much wider it is than a step reaches, and
  // how many steps it has to save for the next one to be tried at once, which costs a factorization.
  static constexpr double least_way = 8, beside_way = 0.5;
  static constexpr int worthwhile_steps = 16;
  // A tip counts as driven in the whole body too if it is by this share of the load factor of an event.
  static constexpr double surely_driven = 0.1;

  // A term was the last resistance to some motion, or nearly so, below this pivot, or if displacements grow by this
  // factor.
  static constexpr double smallest_pivot = 1e-7, most_growth = 1e6;
  // Columns collected before they are added to the flexibility: enough for a fast product, few enough to be cheap to
  // carry along.
  static constexpr int most_pending_changes = 96;
  // Columns of a triangular factor whose product with itself leaves out the rows above them.
  static constexpr int factor_columns_at_once = 96;

  // Bonds that may break between two states that are computed for the whole body; and rounds of the certificate, after
  // which every state in doubt is computed.
  static constexpr int breaks_between_snapshots = 40;
  static constexpr int most_rounds = 6;
  // Bonds outside that answer alike to an energy are proved safe together: so many classes, the logarithms of their
  // answers at least this wide in all.
  static constexpr int classes = 8;
  static constexpr double least_class_width = 1e-12;
  // States solved at once, enough for fast products; and swept at once, so that each bond's ends are fetched once for
  // all of them, few enough for the caches.
  static constexpr std::size_t states_solved_at_once = 64;
  static constexpr int states_swept_at_once = 16;

  // What rounding may do to what the certificate compares, and to energies, relative to the stiffness around a window.
  static constexpr double certificate_margin = 1e-9;
  static constexpr double energy_rounding = 1e-13;
  // A body with less than this share of the energy of the undamaged scene may be separated, and rounding may hide it.
  static constexpr double doubtful_energy = 1e-7;
  // Worst residual with which computed events are taken; what is left is rounding.
  static constexpr double acceptable_residual = 1e-11;
  // Events between two looks at the balance of forces in a window, and the residual that is put right; they serve terms
  // that follow others.
  static constexpr int events_between_balances = 32;
  static constexpr double negligible_residual = 1e-12;
};

}  // namespace bempd::fracture
