#include "model/stepping_options.hpp"

#include <algorithm>

#include "error.hpp"

namespace bempd::model {

namespace {

const scene::OptionGroup stepping_group(scene::OptionPlace::stepping, [] {
  return std::vector<scene::OptionDescription>{
      scene::text_option(
          "stepping.control",
          "What is held while bonds break and cracks grow. load: the load factor, so that where growth is unstable "
          "events follow each other at one load factor, out of equilibrium. path: equilibrium; the load factor falls "
          "where growth is unstable, and each event is at exactly its critical load.",
          "load | path", "load"),
      scene::number_option("stepping.max_events", "Events in one step after which it gives up.", 1e7, 1, 1e15, true),
      scene::number_option("stepping.separation_share",
                           "Share of the largest force so far below which a body counts as separated, if the bonds "
                           "that are left break under larger loads only. 0: once the body bears nothing.",
                           0.02, 0, 0.5, false),
      scene::number_option("tips.record",
                           "Tips of cracks are recorded at every event whose number this divides and at the ends of "
                           "steps, and shown in snapshots; 0 for never.",
                           0, 0, 1e9, true)};
});

const scene::OptionGroup increment_group(scene::OptionPlace::schemes, [] {
  return std::vector<scene::OptionDescription>{
      scene::text_option(
          "paper.mode",
          "How bonds break. event: the most stretched bond first, at the load factor at which it reaches its critical "
          "stretch. paper: in fixed increments, with one solution for each, in which every overstretched bond breaks.",
          "event | paper", "event"),
      scene::number_option(
          "paper.increment",
          "Increment of the load factor where paper.mode is paper; its multiples and the ends of steps count.", 1,
          1e-300, 1e300, false)};
});

const scene::OptionGroup hooks(scene::OptionPlace::test_hooks, [] {
  return std::vector<scene::OptionDescription>{
      scene::text_option("test.solver",
                         "How events are computed: in windows, or one by one with a solution of the whole body each.",
                         "plain | window", "window"),
      scene::text_option("test.factorization",
                         "What a call that breaks bonds leaves to the next one: the changed factorization, or none.",
                         "fresh | kept", "kept"),
      scene::number_option("test.window_length", "How far a window reaches ahead of a tip, in spacings; 0: chosen.", 0,
                           0, 1e4, false)};
});

// Bonds break together with the bond of the largest stretch ratio (stretch over critical stretch) if their ratio is
// less than a share below this ratio: tie_share_of_bonds, if the option crack.tie_share is not set; else the value of
// the option, at most most_tie_share_of_bonds.
constexpr double tie_share_of_bonds = 1e-3, most_tie_share_of_bonds = 0.5;

}  // namespace

fracture::SteppingOptions stepping_options(const scene::Options& options) {
  const bool increments = options.text_value("paper.mode") == "paper";
  const bool path = options.text_value("stepping.control") == "path";
  require(
      !(increments && path),
      "stepping.control = path goes from event to event and paper.mode = paper in increments; set one of them back: "
      "paper.mode to event, or stepping.control to load");
  fracture::SteppingOptions result;
  result.mode = increments ? fracture::SteppingMode::increments : fracture::SteppingMode::events;
  result.control = path ? fracture::Control::path : fracture::Control::load;
  result.increment = options.number("paper.increment");
  result.tie_band = options.is_set("crack.tie_share")
                        ? std::min(options.number("crack.tie_share"), most_tie_share_of_bonds)
                        : tie_share_of_bonds;
  result.max_events = static_cast<std::int64_t>(options.number("stepping.max_events"));
  result.window = options.text_value("test.solver") == "window";
  result.separation_share = options.number("stepping.separation_share");
  result.leaves_fresh = options.text_value("test.factorization") == "fresh";
  result.window_ahead = options.number("test.window_length");
  return result;
}

}  // namespace bempd::model
