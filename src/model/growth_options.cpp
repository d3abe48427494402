#include "model/growth_options.hpp"

namespace bempd::model {

namespace {

const scene::OptionGroup growth_group(scene::OptionPlace::growth, [] {
  return std::vector<scene::OptionDescription>{
      scene::text_option("crack.criterion",
                         "What decides when a crack grows. hoop: the largest hoop stress, in whose direction the crack "
                         "turns. energy: the largest energy release rate after the crack has turned. A line in a "
                         "lattice takes its load from this criterion and always turns to the largest hoop stress.",
                         "hoop | energy", "hoop"),
      scene::text_option(
          "crack.load",
          "What gives the load of the next step of a crack that grows as a line in a lattice. energy: the stress "
          "around "
          "its tip, and the energy of trial steps where that stress is not the tip's own, as at kinks, beside edges "
          "and before other materials (docs/cracks.md). fit: that stress everywhere, to compare.",
          "energy | fit", "energy"),
      scene::text_option(
          "crack.direction",
          "Direction of an extension by bempd_grow_cracks(). tip: that at its start. chord: turned by half of the "
          "angle by which its end would turn on, for one solution more. Steps choose by themselves.",
          "tip | chord", "tip"),
      scene::number_option(
          "crack.tie_share",
          "Tips whose load factor of growth exceeds the smallest one by less than this share grow together with that "
          "tip. 0: one tip at an event; of tips that tie it is that of the crack that was added first, its start "
          "before its end. Bond by bond, bonds within this share of the largest stretch ratio break together: at most "
          "0.5, 0.001 unless it is set, 0 for one by one.",
          0, 0, 1e9, false),
      scene::number_option("crack.step",
                           "Length by which cracks of BEM regions grow at an event of a step [m]. 0: the library "
                           "chooses it from the length of the crack and the way to the nearest edge, hole or crack. "
                           "It is halved where the crack would turn by more than 20 degrees behind it. In either "
                           "case a ligament of up to a quarter of the length breaks too.",
                           0, 0, 1e300, false),
      scene::number_option("crack.exponent",
                           "Tips that grow together do so by the length asked for times this power of their energy "
                           "release rate over the fracture energy. 0: all of them by that length.",
                           0, 0, 100, false)};
});

}  // namespace

KinkCriterion growth_criterion(const scene::Options& options) {
  return options.text_value("crack.criterion") == "energy" ? KinkCriterion::energy_release_rate
                                                           : KinkCriterion::hoop_stress;
}

}  // namespace bempd::model
