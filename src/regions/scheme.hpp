#pragma once

#include <memory>
#include <string>
#include <vector>

#include "regions/region.hpp"
#include "scene/options.hpp"

namespace bempd::regions {

class PeridynamicDescription;

// Scheme: discretization method of the scene. It chooses the class that each described region is built as, such as
// symmetric Galerkin or collocation boundary elements.
class Scheme {
 public:
  virtual ~Scheme() = default;

  virtual std::unique_ptr<Region> boundary_region(int id, const scene::Material& material) const = 0;
  virtual std::unique_ptr<Region> lattice_region(int id, const PeridynamicDescription& described,
                                                 const scene::Material& material) const = 0;
  // Builds a peridynamic region with an outline of any shape. Throws Error (argument) if the scheme has only lattices
  // along the axes.
  virtual std::unique_ptr<Region> outlined_region(int id, const PeridynamicDescription& described,
                                                  const scene::Material& material) const;

  // Throws Error (argument) if two regions (ids) with regular grids of nodes cannot share an interface in this scheme.
  virtual void require_grids_can_touch(int /*region*/, int /*other_region*/) const {}
};

// Creates the scheme that the option `scheme` names.
std::unique_ptr<Scheme> make_scheme(const scene::Options& options);

// Options that only the chosen scheme has; each of them changes the scheme's operators.
const std::vector<scene::OptionDescription>& scheme_options(const scene::Options& options);

// Words that the option `scheme` may have.
std::vector<std::string> scheme_names();

// Description of a scheme in the list of all schemes: the word that chooses it, its phrase in the help of the option
// `scheme`, the function that makes it, and the options that only this scheme has.
struct SchemeEntry {
  const char* name;
  const char* summary;
  std::unique_ptr<Scheme> (*make)(const scene::Options& options);
  std::vector<scene::OptionDescription> options;
};

// Adds a scheme to the list of schemes. The scheme's own files create an object of this class with static duration. No
// other file names the scheme, so a build without the scheme's files lacks it.
class SchemeRegistration {
 public:
  explicit SchemeRegistration(SchemeEntry entry);
};

}  // namespace bempd::regions
