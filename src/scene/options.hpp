#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace bempd::scene {

class Options;

struct OptionDescription {
  const char* name;
  const char* summary;
  const char* unit;
  bool is_text;
  bool whole_number;
  double default_value, minimum, maximum;
  const char* choices;  // of a text option, separated by " | "
  const char* default_text;
  bool shapes_operators = false;  // states fit only scenes with the same value
  // Word that is in effect where the option leaves the choice to other options; null where it never does.
  std::string (*in_effect)(const Options& options) = nullptr;
};

OptionDescription number_option(const char* name, const char* summary, double value, double minimum, double maximum,
                                bool whole);
OptionDescription text_option(const char* name, const char* summary, const char* choices, const char* default_text);
// Marks an option as one that shapes operators.
OptionDescription shaping(OptionDescription option);

// Order in which groups of options are listed. Hooks of tests are not listed: a host sees and sets them only where the
// environment has BEMPD_TEST_HOOKS=1.
enum class OptionPlace { general, schemes, lattices, boundaries, stepping, growth, results, test_hooks };

// Options that belong together, described next to the code that reads them. Objects of static duration: all exist
// before main() begins, and the first question for an option asks them for their descriptions.
class OptionGroup {
 public:
  using Describe = std::vector<OptionDescription> (*)();
  OptionGroup(OptionPlace place, Describe describe);
};

const std::vector<OptionDescription>& option_descriptions();  // without hooks of tests
const OptionDescription& option_description(std::string_view name);
const std::vector<OptionDescription>& test_hook_descriptions();

// Options by name. The value is the one that was set, else the default. Throws Error (argument) for unknown names, for
// names of earlier versions, with what to use instead, and for illegal values.
class Options {
 public:
  // Throws where a host may not know the name.
  static void require_known(std::string_view name);

  void set(std::string_view name, double value);
  void set_text(std::string_view name, std::string_view value);
  double number(std::string_view name) const;
  int whole_number(std::string_view name) const { return static_cast<int>(number(name)); }
  std::string text_value(std::string_view name) const;
  std::string text_in_effect(std::string_view name) const;
  bool is_set(std::string_view name) const { return numbers_.contains(name) || texts_.contains(name); }

 private:
  // Values that were set; all others are defaults.
  std::map<std::string, double, std::less<>> numbers_;
  std::map<std::string, std::string, std::less<>> texts_;
};

}  // namespace bempd::scene
