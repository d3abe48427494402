#include "scene/options.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "error.hpp"

namespace bempd::scene {

namespace {

std::multimap<OptionPlace, OptionGroup::Describe>& groups() {
  static std::multimap<OptionPlace, OptionGroup::Describe> all;
  return all;
}

const OptionGroup general(OptionPlace::general, [] {
  return std::vector<OptionDescription>{
      number_option("threads", "Threads for the library's own loops, 0 for all cores; and for the BLAS, 0 for one.", 0,
                    0, 1024, true)};
});

// Option name of an earlier version, with the advice what to do instead.
struct RemovedName {
  std::string_view name;
  const char* instead;
};

constexpr RemovedName removed_names[] = {
    {"accuracy", "set bem.quadrature_tolerance, and crack.tie_share where cracks grow bond by bond"},
    {"pd.contact", "use contact, which is for faces of cracks in regions of all kinds"},
    {"bem.contact", "use contact, which is for faces of cracks in regions of all kinds"},
    {"pd.crack_tip",
     "leave it out: initial cracks that grow as lines are felt where they are described; crack.rule = bond cuts all "
     "bonds "
     "that meet a crack"},
    {"pd.crack_rule", "use crack.rule"},
    {"growth.criterion", "use crack.criterion"},
    {"growth.share", "use crack.tie_share"},
    {"stepping.tie_band", "use crack.tie_share"},
    {"growth.exponent", "use crack.exponent"},
    {"growth.step", "use crack.step"},
    {"growth.direction", "use crack.direction"},
    {"stepping.mode", "use paper.mode"},
    {"stepping.increment", "use paper.increment"},
    {"stepping.solver", "leave it out: windows serve wherever they can, and break the same bonds"},
    {"stepping.window_length", "leave it out: the library chooses it"},
    {"stepping.factorization", "leave it out: the factorization is kept"},
    {"stepping.max_breaks_per_solve", "leave it out: there is no limit"},
    {"pd.horizon_ratio", "give each region its horizon_ratio; 0 stands for 4"},
    {"pd.lattice_angle", "use bempd_add_turned_pd_region(), which takes the angle as an argument"},
    {"pd.outline_points", "leave it out: there are points on outlines where an edge is round or slanted"},
    {"pd.outline_balance", "leave it out: bonds near outlines carry constant stress exactly"},
    {"results.singular_stress",
     "use bempd_stress_orders() or bempd_get_singularity(), which tell where stress is unbounded"}};

// Edit distance: number of single-letter changes between two names.
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
    // A known name that contains the given name counts as near, so that the name of a group ("crack.") can be left out.
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

const OptionDescription* find(const std::vector<OptionDescription>& options, std::string_view name) {
  const auto found = std::find_if(options.begin(), options.end(),
                                  [&](const OptionDescription& option) { return name == option.name; });
  return found == options.end() ? nullptr : &*found;
}

bool is_any_text(const OptionDescription& option) { return option.is_text && option.choices[0] == '\0'; }

const OptionDescription& describe(std::string_view name) {
  if (const OptionDescription* option = find(option_descriptions(), name)) return *option;
  if (const OptionDescription* hook = find(test_hook_descriptions(), name)) return *hook;
  for (const RemovedName& removed : removed_names)
    require(name != removed.name, "there is no option '", name, "' any more; ", removed.instead);
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

OptionDescription any_text_option(const char* name, const char* summary) { return text_option(name, summary, "", ""); }

OptionDescription shaping(OptionDescription option) {
  option.shapes_operators = true;
  return option;
}

OptionGroup::OptionGroup(OptionPlace place, Describe describe) { groups().emplace(place, describe); }

namespace {

std::vector<OptionDescription> described(bool hooks) {
  std::vector<OptionDescription> options;
  for (const auto& [place, describe] : groups()) {
    if ((place == OptionPlace::test_hooks) != hooks) continue;
    const std::vector<OptionDescription> more = describe();
    options.insert(options.end(), more.begin(), more.end());
  }
  return options;
}

bool hooks_are_allowed() {
  const char* const value = std::getenv("BEMPD_TEST_HOOKS");
  return value != nullptr && std::string_view(value) == "1";
}

}  // namespace

const OptionDescription& option_description(std::string_view name) { return describe(name); }

const std::vector<OptionDescription>& option_descriptions() {
  static const std::vector<OptionDescription> all = described(false);
  return all;
}

const std::vector<OptionDescription>& test_hook_descriptions() {
  static const std::vector<OptionDescription> all = described(true);
  return all;
}

void Options::require_known(std::string_view name) {
  if (find(test_hook_descriptions(), name) && !hooks_are_allowed())
    fail(Failure::argument, "there is no option '", name, "'; near names are ", near_names(name));
  describe(name);
}

void Options::set(std::string_view name, double value) {
  require_known(name);
  const OptionDescription& option = describe(name);
  require(!option.is_text, "option ", name, " takes a word (", option.choices, "), not a number");
  require(std::isfinite(value) && value >= option.minimum && value <= option.maximum, "option ", name, " is ", value,
          "; it must lie between ", option.minimum, " and ", option.maximum);
  require(!option.whole_number || value == std::floor(value), "option ", name, " is ", value,
          "; it must be a whole number");
  numbers_.insert_or_assign(std::string(name), value);
}

void Options::set_text(std::string_view name, std::string_view value) {
  require_known(name);
  const OptionDescription& option = describe(name);
  require(option.is_text, "option ", name, " takes a number, not a word");
  const std::string choices = std::string(" | ") + option.choices + " | ";
  require(is_any_text(option) || (!value.empty() && value.find('|') == std::string_view::npos &&
                                  choices.find(text(" | ", value, " | ")) != std::string::npos),
          "option ", name, " is '", value, "'; it must be one of: ", option.choices);
  texts_.insert_or_assign(std::string(name), std::string(value));
}

double Options::number(std::string_view name) const {
  const OptionDescription& option = describe(name);
  require(!option.is_text, "option ", name, " takes a word; ask for its text");
  const auto own = numbers_.find(name);
  return own != numbers_.end() ? own->second : option.default_value;
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
