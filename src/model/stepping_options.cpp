#include "scene/options.hpp"

namespace bempd::model {

namespace {

const scene::OptionGroup group(scene::OptionPlace::stepping, [] {
  return std::vector<scene::OptionDescription>{
      scene::text_option(
          "stepping.mode",
          "How bonds break: event, the most stretched first at the load factor they reach, until none is "
          "overstretched; paper, fixed increments with one solution each in which every overstretched bond breaks.",
          "event | paper", "event"),
      scene::number_option(
          "stepping.increment",
          "Increment of the load factor in the stepping mode paper; its multiples and the ends of steps count.", 1,
          1e-300, 1e300, false),
      scene::number_option("stepping.tie_band",
                           "Bonds within this share of the largest stretch ratio break together; 0 breaks one by one.",
                           1e-3, 0, 0.5, false),
      scene::text_option(
          "stepping.solver",
          "How events are computed in scheme symmetric: window, ahead of time in a small part of the body around "
          "what breaks, with a proof for each that the whole body breaks in the same way; plain, one by one with "
          "a solution of the whole body each.",
          "plain | window", "window"),
      scene::number_option(
          "stepping.window_length",
          "How far a window reaches ahead of a crack tip, in lattice spacings; 0 lets the library choose, as "
          "it always does for the first window at initial cracks.",
          0, 0, 1e4, false),
      scene::number_option("stepping.max_breaks_per_solve", "Most bonds that break at one event; 0 for no limit.", 0, 0,
                           1e9, true),
      scene::number_option("stepping.max_events", "Events in one step after which it gives up.", 1e7, 1, 1e15, true),
      scene::number_option("tips.record",
                           "Tips of cracks are recorded at every event whose number this divides and at the ends of "
                           "steps, and shown in snapshots; 0 for never.",
                           0, 0, 1e9, true)};
});

}  // namespace

}  // namespace bempd::model
