#include "model/stepping_options.hpp"

#include "error.hpp"

namespace bempd::model {

namespace {

const scene::OptionGroup stepping_group(scene::OptionPlace::stepping, [] {
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
                           "Bonds within this share of the largest stretch ratio break together; 0 breaks one by one. "
                           "Not for lines, which grow by one tip at an event: within 1e-9 the least number goes first.",
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
      scene::text_option(
          "stepping.control",
          "What is held while bonds break: load, the load factor, so that where growth is unstable events "
          "follow each other at one load factor, out of equilibrium; path, the equilibrium: the load "
          "factor falls where growth is unstable, and each event is at exactly its critical load.",
          "load | path", "load"),
      scene::number_option("stepping.max_breaks_per_solve", "Most bonds that break at one event; 0 for no limit.", 0, 0,
                           1e9, true),
      scene::number_option("stepping.max_events", "Events in one step after which it gives up.", 1e7, 1, 1e15, true),
      scene::number_option("stepping.separation_share",
                           "The body is separated once it bears less than this share of the largest force that it has "
                           "borne, and bonds that are left break under larger loads only; 0: once nothing is borne.",
                           0.02, 0, 0.5, false),
      scene::text_option(
          "stepping.factorization",
          "What a call that breaks bonds leaves to the next one: kept, the changed factorization and what is computed "
          "ahead, which states tell how to make again; fresh, nothing, so that states are shorter and restored at "
          "once, for a factorization more in each call that breaks bonds.",
          "fresh | kept", "kept"),
      scene::number_option("tips.record",
                           "Tips of cracks are recorded at every event whose number this divides and at the ends of "
                           "steps, and shown in snapshots; 0 for never.",
                           0, 0, 1e9, true)};
});

}  // namespace

fracture::SteppingOptions stepping_options(const scene::Options& options) {
  const bool increments = options.text_value("stepping.mode") == "paper";
  const bool path = options.text_value("stepping.control") == "path";
  require(!(increments && path),
          "stepping.control = path goes from event to event and stepping.mode = paper in increments; set one of them "
          "back: stepping.mode to event, or stepping.control to load");
  fracture::SteppingOptions result;
  result.mode = increments ? fracture::SteppingMode::increments : fracture::SteppingMode::events;
  result.control = path ? fracture::Control::path : fracture::Control::load;
  result.increment = options.number("stepping.increment");
  result.tie_band = options.number("stepping.tie_band");
  result.max_breaks_per_solve = options.whole_number("stepping.max_breaks_per_solve");
  result.max_events = static_cast<std::int64_t>(options.number("stepping.max_events"));
  result.window = options.text_value("stepping.solver") == "window";
  result.separation_share = options.number("stepping.separation_share");
  result.leaves_fresh = options.text_value("stepping.factorization") == "fresh";
  result.window_ahead = options.number("stepping.window_length");
  return result;
}

}  // namespace bempd::model
