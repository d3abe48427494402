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
  const char* choices;  // words of a text option, separated by " | "; empty if any text is allowed
  const char* default_text;
  bool shapes_operators = false;  // whether saved states fit only scenes with the same value
  // Function that returns the word that is in effect when the option's own word leaves the decision to other options;
  // null if it never does.
  std::string (*in_effect)(const Options& options) = nullptr;
};

OptionDescription number_option(const char* name, const char* summary, double value, double minimum, double maximum,
                                bool whole);
OptionDescription text_option(const char* name, const char* summary, const char* choices, const char* default_text);
OptionDescription any_text_option(const char* name, const char* summary);  // the default is an empty text
// Marks an option as one that shapes operators: a saved state fits only scenes with the same value.
OptionDescription shaping(OptionDescription option);

// Order in which groups of options are listed. Test hooks are not listed: a host can see and set them only if the
// environment has BEMPD_TEST_HOOKS=1.
enum class OptionPlace { general, schemes, lattices, boundaries, stepping, growth, results, test_hooks };

// Group of options that belong together, described in the file of the code that reads them. Objects must be static: all
// groups are registered before main() begins, and are asked for their descriptions when an option is first needed.
class OptionGroup {
 public:
  using Describe = std::vector<OptionDescription> (*)();
  OptionGroup(OptionPlace place, Describe describe);
};

const std::vector<OptionDescription>& option_descriptions();  // without hooks of tests
const OptionDescription& option_description(std::string_view name);
const std::vector<OptionDescription>& test_hook_descriptions();

// Values of options by name: the value that was set, else the default. Throws Error (argument) for unknown names, for
// names of earlier versions (with what to use instead) and for values out of range.
class Options {
 public:
  // Throws Error (argument) for an unknown option, and for a test hook if test hooks are not enabled.
  static void require_known(std::string_view name);

  void set(std::string_view name, double value);
  void set_text(std::string_view name, std::string_view value);
  double number(std::string_view name) const;
  int whole_number(std::string_view name) const { return static_cast<int>(number(name)); }
  std::string text_value(std::string_view name) const;
  std::string text_in_effect(std::string_view name) const;
  bool is_set(std::string_view name) const { return numbers_.contains(name) || texts_.contains(name); }

 private:
  // Values that were set; all other options have their defaults.
  std::map<std::string, double, std::less<>> numbers_;
  std::map<std::string, std::string, std::less<>> texts_;
};

}  // namespace bempd::scene
