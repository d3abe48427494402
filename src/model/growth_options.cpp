#include "model/growth_options.hpp"

namespace bempd::model {

namespace {

const scene::OptionGroup growth_group(scene::OptionPlace::growth, [] {
  return std::vector<scene::OptionDescription>{
      scene::text_option(
          "crack.criterion",
          "What decides when a crack of a BEM region grows and in which direction: hoop, the largest "
          "hoop stress before it turns; energy, the largest energy release rate after it has. A crack that "
          "grows as a line in a lattice takes the load from it and always turns to the largest hoop "
          "stress.",
          "hoop | energy", "hoop"),
      scene::text_option("crack.load",
                         "What tells the load of the next step of a crack that grows as a line in a lattice: fit, the "
                         "stress around its tip everywhere; energy, that of trial steps where the fit does not hold "
                         "(docs/cracks.md). Loads at kinks and before interfaces are within some percent by energy, "
                         "and other scenes are worse: it is being tried.",
                         "fit | energy", "fit"),
      scene::text_option("crack.direction",
                         "Direction of an extension by bempd_grow_cracks(): tip, that at its start; chord, turned by "
                         "half the angle by which its end would turn on, as the chord of a curved path, for one "
                         "solution more. Steps choose by themselves.",
                         "tip | chord", "tip"),
      scene::number_option(
          "crack.tie_share",
          "Tips whose load factor of growth is higher than the smallest one by less than this share grow together "
          "with that one; 0: one tip at an event, of tips that tie that of the crack that was added first, its start "
          "before its end. Where cracks grow bond by bond, bonds within this share of the largest stretch ratio, at "
          "most "
          "0.5, break together: 0.001 unless it is set, 0 for one by one.",
          0, 0, 1e9, false),
      scene::number_option("crack.step",
                           "Length by which cracks of BEM regions grow at an event of a step [m]; 0: chosen by the "
                           "library from the length of the crack and the way to the nearest edge, hole or crack.",
                           0, 0, 1e300, false),
      scene::number_option("crack.exponent",
                           "Tips that grow together do so by the length asked for times this power of their energy "
                           "release rate over the fracture energy; 0: all by that length.",
                           0, 0, 100, false)};
});

}  // namespace

KinkCriterion growth_criterion(const scene::Options& options) {
  return options.text_value("crack.criterion") == "energy" ? KinkCriterion::energy_release_rate
                                                           : KinkCriterion::hoop_stress;
}

}  // namespace bempd::model
