#include "regions/scheme.hpp"

#include <algorithm>
#include <utility>

#include "error.hpp"
#include "regions/symmetric_scheme.hpp"

namespace bempd::regions {

namespace {

std::vector<SchemeEntry>& entries() {
  static std::vector<SchemeEntry> all = {{"symmetric",
                                          "symmetric Galerkin boundary elements with exactly consistent bonds",
                                          [](const scene::Options&) { return make_symmetric_scheme(); },
                                          {}}};
  return all;
}

const SchemeEntry& chosen(const scene::Options& options) {
  const std::string name = options.text_value("scheme");
  return *std::find_if(entries().begin(), entries().end(), [&](const SchemeEntry& e) { return name == e.name; });
}

std::string join_of_entries(const char* SchemeEntry::*words, const std::string& separator) {
  std::string joined;
  for (const SchemeEntry& entry : entries()) joined += (joined.empty() ? "" : separator) + entry.*words;
  return joined;
}

std::vector<scene::OptionDescription> describe_options() {
  // The texts are static, because option descriptions only point to them.
  static const std::string choices = join_of_entries(&SchemeEntry::name, " | ");
  static const std::string summary = "Discretization: " + join_of_entries(&SchemeEntry::summary, ", or ") + ".";
  std::vector<scene::OptionDescription> all = {
      scene::shaping(scene::text_option("scheme", summary.c_str(), choices.c_str(), "symmetric"))};
  for (const SchemeEntry& entry : entries()) all.insert(all.end(), entry.options.begin(), entry.options.end());
  return all;
}

const scene::OptionGroup scheme_group(scene::OptionPlace::schemes, &describe_options);

}  // namespace

std::unique_ptr<Region> Scheme::outlined_region(int id, const PeridynamicDescription&, const scene::Material&) const {
  fail(Failure::argument, "peridynamic region ", id,
       " has edges that are not parallel to the axes, or points on its outline were asked for; the chosen scheme has "
       "lattices only, scheme symmetric has both");
}

SchemeRegistration::SchemeRegistration(SchemeEntry entry) { entries().push_back(std::move(entry)); }

std::vector<std::string> scheme_names() {
  std::vector<std::string> names;
  for (const SchemeEntry& entry : entries()) names.emplace_back(entry.name);
  return names;
}

std::unique_ptr<Scheme> make_scheme(const scene::Options& options) { return chosen(options).make(options); }

const std::vector<scene::OptionDescription>& scheme_options(const scene::Options& options) {
  return chosen(options).options;
}

}  // namespace bempd::regions
