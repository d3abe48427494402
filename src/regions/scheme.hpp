#pragma once

#include <memory>
#include <string>
#include <vector>

#include "regions/region.hpp"
#include "scene/options.hpp"

namespace bempd::regions {

class BoundaryDescription;
class LatticeDescription;
class OutlinedDescription;

// Scheme: how the kinds of regions in which schemes differ become equations.
class Scheme {
 public:
  virtual ~Scheme() = default;

  virtual std::unique_ptr<Region> boundary_region(int id, const BoundaryDescription& described,
                                                  const scene::Material& material) const = 0;
  virtual std::unique_ptr<Region> lattice_region(int id, const LatticeDescription& described,
                                                 const scene::Material& material) const = 0;
  // Region with any outline. Throws Error (argument) where regions have to lie on the rows of a lattice.
  virtual std::unique_ptr<Region> outlined_region(int id, const OutlinedDescription& described,
                                                  const scene::Material& material) const;

  // Throws Error (argument) if two regions with grids of nodes cannot share an interface.
  virtual void require_grids_can_touch(int /*region*/, int /*other_region*/) const {}
};

// Scheme that the option `scheme` names.
std::unique_ptr<Scheme> make_scheme(const scene::Options& options);

// Options that only this scheme has, all of which shape its operators.
const std::vector<scene::OptionDescription>& scheme_options(const scene::Options& options);

// Legal words of the option `scheme`.
std::vector<std::string> scheme_names();

// Entry of a scheme, except the symmetric one: the word that chooses it, its phrase in the option's sentence, a
// function that makes it, and the options that only it has.
struct SchemeEntry {
  const char* name;
  const char* summary;
  std::unique_ptr<Scheme> (*make)(const scene::Options& options);
  std::vector<scene::OptionDescription> options;
};

// Adds a scheme, from an object of static duration in its own files: nothing else names it, and a build without the
// files is one without the scheme.
class SchemeRegistration {
 public:
  explicit SchemeRegistration(SchemeEntry entry);
};

}  // namespace bempd::regions
