#include "scene/options.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "error.hpp"

namespace bempd::scene {

namespace {

std::multimap<OptionPlace, OptionGroup::Describe>& groups() {
  static std::multimap<OptionPlace, OptionGroup::Describe> all;
  return all;
}

const OptionGroup general(OptionPlace::general, [] {
  return std::vector<OptionDescription>{
      text_option("accuracy",
                  "Defaults of bem.quadrature_tolerance and stepping.tie_band: draft, 1e-6 for the first; standard, "
                  "their own; fine, 1e-15 and 0. A value set by hand stands, before or after.",
                  "draft | standard | fine", "standard"),
      number_option("threads", "Threads for the library's own loops, 0 for all cores; and for the BLAS, 0 for one.", 0,
                    0, 1024, true)};
});

// Default that the option `accuracy` moves. A lattice's horizon is not among these: it is part of the material.
struct PresetValue {
  const char* option;
  double value;
};

// Draft values. Crack runs have none: a tie band of 1 % breaks more bonds at once, but takes no less time.
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

}  // namespace

OptionDescription number_option(const char* name, const char* summary, double value, double minimum, double maximum,
                                bool whole) {
  return {name, summary, "-", false, whole, value, minimum, maximum, "", "", false};
}

OptionDescription text_option(const char* name, const char* summary, const char* choices, const char* default_text) {
  return {name, summary, "-", true, false, 0, 0, 0, choices, default_text, false};
}

OptionDescription shaping(OptionDescription option) {
  option.shapes_operators = true;
  return option;
}

OptionGroup::OptionGroup(OptionPlace place, Describe describe) { groups().emplace(place, describe); }

const std::vector<OptionDescription>& option_descriptions() {
  static const std::vector<OptionDescription> all = [] {
    std::vector<OptionDescription> options;
    for (const auto& [place, describe] : groups()) {
      const std::vector<OptionDescription> more = describe();
      options.insert(options.end(), more.begin(), more.end());
    }
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

std::string Options::text_in_effect(std::string_view name) const {
  const OptionDescription& option = describe(name);
  return option.in_effect ? option.in_effect(*this) : text_value(name);
}

}  // namespace bempd::scene
