#include <numbers>

#include "error.hpp"
#include "scene/options.hpp"

namespace bempd::regions {

namespace {

scene::OptionDescription in_radians(scene::OptionDescription option) {
  option.unit = "rad";
  return option;
}

scene::OptionDescription outline_balance() {
  return scene::text_option(
      "pd.outline_balance",
      "What bonds near outlines carry in peridynamic regions with points on them that are added from now on: "
      "constant, constant stress exactly; linear, that and, nearly, stress that varies linearly, so that bonds "
      "along "
      "a round hole are stretched as its stress says, within 5 % from radii of five spacings on.",
      "constant | linear", "constant");
}

std::string crack_rule_in_effect(const scene::Options& options) {
  const std::string rule = options.text_value("pd.crack_rule");
  const bool has_lines = options.text_value("scheme") == "symmetric" && options.text_value("stepping.mode") == "event";
  if (rule == "auto") return has_lines ? "line" : "bond";
  require(has_lines || rule == "bond",
          "pd.crack_rule is line or tips, by which cracks grow in scheme symmetric and stepping.mode event; choose "
          "these, or pd.crack_rule = auto");
  return rule;
}

scene::OptionDescription crack_rule() {
  scene::OptionDescription option = scene::shaping(scene::text_option(
      "pd.crack_rule",
      "How cracks in peridynamic regions grow: line, by a spacing at a time towards the largest hoop stress, all "
      "bonds across it at once, from initial cracks and from places where a bond reaches its critical stretch; "
      "tips, the same from initial cracks only, and nothing else breaks; bond, bonds break one by one by their own "
      "stretch and the way prefers rows of the lattice; auto, line in scheme symmetric and stepping.mode event, "
      "else bond.",
      "auto | bond | line | tips", "auto"));
  option.in_effect = crack_rule_in_effect;
  return option;
}

const scene::OptionGroup lattice_group(scene::OptionPlace::lattices, [] {
  return std::vector<scene::OptionDescription>{
      scene::number_option("pd.horizon_ratio", "Horizon over lattice spacing of regions that do not give their own.", 4,
                           2, 8, true),
      scene::text_option(
          "pd.outline_points",
          "Where peridynamic regions that are added from now on have points on their outline instead of lattice rows: "
          "slanted, where an edge is round or not parallel to the axes; always.",
          "slanted | always", "slanted"),
      outline_balance(),
      in_radians(
          scene::number_option("pd.lattice_angle",
                               "Angle between the rows of the lattice and the x axis in peridynamic regions that "
                               "are added from now on; other than 0 they have points on their outline.",
                               0, -std::numbers::pi, std::numbers::pi, false)),
      scene::shaping(scene::text_option(
          "critical_stretch",
          "Constant that turns a fracture energy into a critical stretch: exact, what parts a plane at once takes it; "
          "running, a crack that grows bond by bond takes it for its length, within 10 % in all directions of lattices "
          "with horizons of 3 to 5 spacings, and starts earlier by as much; or as printed by Yang and Liu 2021, Eq. 15 "
          "(plane stress only).",
          "exact | running | printed", "exact")),
      scene::shaping(scene::text_option("pd.crack_tip",
                                        "Where tips of initial cracks in peridynamic regions are felt by a load that "
                                        "opens them: ahead, all bonds that meet the crack are cut, so that it acts as "
                                        "if its tip were up to 0.6 spacings ahead, by its place between points; "
                                        "stated, fewer are, and the last ones are weaker, so that it acts as if its "
                                        "tip were where it is, within 0.15 spacings.",
                                        "ahead | stated", "ahead")),
      scene::shaping(
          scene::text_option("pd.criterion",
                             "What counts of a bond's stretch in peridynamic regions: stretch, all of it; opening, all "
                             "but what compression "
                             "across the bond adds by Poisson's effect, so that pressure does not crush a sound body.",
                             "stretch | opening", "stretch")),
      crack_rule(),
      scene::shaping(scene::text_option(
          "pd.contact",
          "What faces of cracks in peridynamic regions of scheme symmetric do where they meet: faces, they press on "
          "each "
          "other without friction; rough, every broken bond presses along itself, so that closed faces hardly slide; "
          "none, they pass through each other.",
          "faces | rough | none", "faces"))};
});

}  // namespace

}  // namespace bempd::regions
