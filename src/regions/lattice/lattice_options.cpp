#include "error.hpp"
#include "scene/options.hpp"

namespace bempd::regions {

namespace {

// Rule of crack growth: cracks grow as lines (in steps of one lattice spacing) only in the symmetric scheme, event by
// event; otherwise bonds break one by one.
std::string crack_rule_in_effect(const scene::Options& options) {
  const std::string rule = options.text_value("crack.rule");
  const bool has_lines = options.text_value("scheme") == "symmetric" && options.text_value("paper.mode") == "event";
  if (has_lines || rule == "bond") return rule;
  require(!options.is_set("crack.rule"), "crack.rule is ", rule,
          ", by which cracks grow in scheme symmetric and paper.mode event only; choose these, or crack.rule = bond");
  return "bond";
}

scene::OptionDescription crack_rule() {
  scene::OptionDescription option = scene::shaping(scene::text_option(
      "crack.rule",
      "How cracks in peridynamic regions grow. line: by a spacing at a time towards the largest hoop stress; all bonds "
      "across this step break at once. Such cracks grow from initial cracks and from places where a bond reaches its "
      "critical stretch. tips: the same from initial cracks only, and nothing else breaks. bond: each bond breaks by "
      "its own stretch; the path prefers rows of the lattice. With paper.mode = paper the rule is always bond.",
      "line | bond | tips", "line"));
  option.in_effect = crack_rule_in_effect;
  return option;
}

const scene::OptionGroup lattice_group(scene::OptionPlace::lattices, [] {
  return std::vector<scene::OptionDescription>{
      scene::shaping(
          scene::text_option("critical_stretch",
                             "Constant that turns a fracture energy into a critical stretch. exact: what parts a plane "
                             "at once takes the fracture energy. running: a crack that grows bond by bond takes it for "
                             "its length, within 10 % in lattices with horizons of 3 to 5 spacings. Such a crack "
                             "starts earlier by as much. printed: Eq. 15 of Yang and Liu 2021, plane stress only.",
                             "exact | running | printed", "exact")),
      scene::shaping(scene::text_option(
          "pd.criterion",
          "What counts of the stretch of a bond in peridynamic regions. stretch: all of it. opening: all but what "
          "compression across the bond adds by Poisson's effect, so that pressure does not crush a sound body.",
          "stretch | opening", "stretch")),
      crack_rule(),
      scene::shaping(scene::text_option(
          "contact",
          "What faces of cracks do where they meet, in regions of scheme symmetric. faces: they press on each other "
          "without friction. none: they pass through each other, and a warning says where cracks of BEM regions do.",
          "faces | none", "faces"))};
});

const scene::OptionGroup hooks(scene::OptionPlace::test_hooks, [] {
  return std::vector<scene::OptionDescription>{
      scene::text_option("test.outline_points",
                         "Where peridynamic regions that are added from now on have points on their outline instead of "
                         "lattice rows: where an edge is round or not parallel to the axes, or always.",
                         "slanted | always", "slanted")};
});

}  // namespace

}  // namespace bempd::regions
