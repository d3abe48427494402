#include "scene/options.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "error.hpp"

namespace bempd::scene {

namespace {

OptionDescription number_option(const char* name, const char* summary, double value, double minimum, double maximum,
                                bool whole) {
  return {name, summary, "-", false, whole, value, minimum, maximum, "", ""};
}

OptionDescription text_option(const char* name, const char* summary, const char* choices, const char* default_text) {
  return {name, summary, "-", true, false, 0, 0, 0, choices, default_text};
}

// Defaults that the option `accuracy` moves. A lattice's horizon is not among them: it is part of the material.
struct PresetValue {
  const char* option;
  double value;
};

// Crack runs have no draft: a tie band of 1 % breaks more bonds at once, but takes no less time.
constexpr PresetValue draft_values[] = {{"bem.quadrature_tolerance", 1e-6}};
constexpr PresetValue fine_values[] = {{"bem.quadrature_tolerance", 1e-15}, {"stepping.tie_band", 0}};

std::span<const PresetValue> preset_values(std::string_view accuracy) {
  if (accuracy == "draft") return draft_values;
  if (accuracy == "fine") return fine_values;
  return {};
}

// Number of single-letter edits between two names.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitute = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitute});
    }
  }
  return row[b.size()];
}

std::string near_names(std::string_view name) {
  std::vector<std::pair<std::size_t, std::string>> ranked;
  for (const OptionDescription& option : option_descriptions()) {
    const std::string_view known = option.name;
    // A name given without its group, or only in part, counts as near.
    const bool contained = !name.empty() && known.find(name) != std::string_view::npos;
    ranked.emplace_back(contained ? 0 : edit_distance(name, known), option.name);
  }
  std::sort(ranked.begin(), ranked.end());
  std::string list;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, ranked.size()); ++i) {
    list += (i == 0 ? "" : ", ") + ranked[i].second;
  }
  return list;
}

const OptionDescription& describe(std::string_view name) {
  for (const OptionDescription& option : option_descriptions()) {
    if (name == option.name) return option;
  }
  fail(Failure::argument, "there is no option '", name, "'; near names are ", near_names(name));
}

std::vector<OptionDescription> discretization_options() {
  return {
      text_option("accuracy",
                  "Defaults of bem.quadrature_tolerance and stepping.tie_band: draft, 1e-6 for the first; standard, "
                  "their own; fine, 1e-15 and 0. A value set by hand stands, before or after.",
                  "draft | standard | fine", "standard"),
      text_option(
          "scheme",
          "Discretization: symmetric Galerkin boundary elements with exactly consistent bonds, or collocation with "
          "uncorrected bonds as Yang and Liu 2021 have it.",
          "symmetric | paper", "symmetric"),
      text_option("critical_stretch",
                  "Constant that turns a fracture energy into a critical stretch: exact, or as printed by Yang and Liu "
                  "2021, Eq. 15 (plane stress only).",
                  "exact | printed", "exact"),
      text_option("paper.lattice",
                  "Material points of scheme paper: cell_centred with points of their own on interfaces, or nodal.",
                  "cell_centred | nodal", "cell_centred"),
      text_option(
          "paper.interface",
          "What scheme paper balances at interfaces: nodal_force, tractions times the lengths of nodes against bond "
          "forces, or traction, t = -b dx at every node (Eq. 27).",
          "nodal_force | traction", "nodal_force"),
      text_option("paper.corner_tractions", "Tractions at a corner of a boundary element region in scheme paper.",
                  "two | one", "two"),
      number_option("threads", "Threads for the library's own loops; 0 for all cores.", 0, 0, 1024, true),
      number_option("pd.horizon_ratio", "Horizon over lattice spacing of regions that do not give their own.", 4, 2, 8,
                    true),
      number_option("bem.quadrature_tolerance",
                    "Relative error of the boundary integrals of a pair of elements; a looser one is faster.", 1e-14,
                    1e-15, 1e-3, false),
      text_option("bem.grading",
                  "Boundary elements near places where stress is singular: auto, smaller and smaller towards "
                  "re-entrant corners and ends of supports on edges without bempd_set_edge_mesh(); none. Scheme paper "
                  "has none.",
                  "auto | none", "auto"),
  };
}

std::vector<OptionDescription> stepping_options() {
  return {
      text_option(
          "stepping.mode",
          "How bonds break: event, the most stretched first at the load factor they reach, until none is "
          "overstretched; paper, fixed increments with one solution each in which every overstretched bond breaks.",
          "event | paper", "event"),
      number_option(
          "stepping.increment",
          "Increment of the load factor in the stepping mode paper; its multiples and the ends of steps count.", 1,
          1e-300, 1e300, false),
      number_option("stepping.tie_band",
                    "Bonds within this share of the largest stretch ratio break together; 0 breaks one by one.", 1e-3,
                    0, 0.5, false),
      text_option(
          "stepping.solver",
          "How events are computed in scheme symmetric: window, ahead of time in a small part of the body around "
          "what breaks, with a proof for each that the whole body breaks in the same way; plain, one by one with "
          "a solution of the whole body each.",
          "plain | window", "window"),
      number_option("stepping.window_length",
                    "How far a window reaches ahead of a crack tip, in lattice spacings; 0 lets the library choose, as "
                    "it always does for the first window at initial cracks.",
                    0, 0, 1e4, false),
      number_option("stepping.max_breaks_per_solve", "Most bonds that break at one event; 0 for no limit.", 0, 0, 1e9,
                    true),
      number_option("stepping.max_events", "Events in one step after which it gives up.", 1e7, 1, 1e15, true),
  };
}

}  // namespace

const std::vector<OptionDescription>& option_descriptions() {
  static const std::vector<OptionDescription> all = [] {
    std::vector<OptionDescription> options = discretization_options();
    for (const OptionDescription& option : stepping_options()) options.push_back(option);
    return options;
  }();
  return all;
}

void Options::set(std::string_view name, double value) {
  const OptionDescription& option = describe(name);
  require(!option.is_text, "option ", name, " takes a word (", option.choices, "), not a number");
  require(std::isfinite(value) && value >= option.minimum && value <= option.maximum, "option ", name, " is ", value,
          "; it must lie between ", option.minimum, " and ", option.maximum);
  require(!option.whole_number || value == std::floor(value), "option ", name, " is ", value,
          "; it must be a whole number");
  numbers_.insert_or_assign(std::string(name), value);
}

void Options::set_text(std::string_view name, std::string_view value) {
  const OptionDescription& option = describe(name);
  require(option.is_text, "option ", name, " takes a number, not a word");
  const std::string choices = std::string(" | ") + option.choices + " | ";
  require(!value.empty() && value.find('|') == std::string_view::npos &&
              choices.find(text(" | ", value, " | ")) != std::string::npos,
          "option ", name, " is '", value, "'; it must be one of: ", option.choices);
  texts_.insert_or_assign(std::string(name), std::string(value));
}

double Options::number(std::string_view name) const {
  const OptionDescription& option = describe(name);
  require(!option.is_text, "option ", name, " takes a word; ask for its text");
  if (const auto own = numbers_.find(name); own != numbers_.end()) return own->second;
  for (const PresetValue& preset : preset_values(text_value("accuracy")))
    if (name == preset.option) return preset.value;
  return option.default_value;
}

std::string Options::text_value(std::string_view name) const {
  const OptionDescription& option = describe(name);
  require(option.is_text, "option ", name, " takes a number; ask for its value");
  const auto own = texts_.find(name);
  return own != texts_.end() ? own->second : option.default_text;
}

}  // namespace bempd::scene
