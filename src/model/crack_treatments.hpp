#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "crack/extension.hpp"
#include "model/given_back.hpp"
#include "model/mesh_answers.hpp"
#include "regions/patches.hpp"

namespace bempd::model {

class Model;

enum class CrackTreatment { automatic = 1, elements = 2, lattice = 3, frozen = 4 };

// How cracks of bodies are to be modelled, and the lattice patches that follow from it. Patches are in the scene from
// when it is planned or prepared until the host changes it.
class CrackTreatments {
 public:
  explicit CrackTreatments(Model& model) : model_(model) {}

  // Throws Error (order) once the model is prepared, unless the treatment only freezes or releases the crack's tips.
  void set(int crack, CrackTreatment treatment);
  void set_lattice(int body, double spacing, int horizon_ratio);

  // Adds the patches to the scene, if they are not there.
  void add_patches();
  // Takes the patches out of the scene again, so that it is the one of the host.
  void remove_patches() noexcept;
  // Number of the host's own regions; the patches are behind them.
  int own_regions() const;
  const std::vector<regions::Patch>& patches() const { return patches_.present; }
  // Patches as they were before tips have grown in them.
  const std::vector<regions::Patch>& first_patches() const { return patches_.first; }
  // Patches that have more blocks around a line after an extension; empty if none needs or can have more.
  std::optional<std::vector<regions::Patch>> enlarged(const crack::Extension& extension) const;
  // Patches that have more blocks around a broken bond; empty if they cannot.
  std::optional<std::vector<regions::Patch>> enlarged(const regions::BrokenBondNearBorder& broken) const;
  // What patches, which may not be in the scene yet, can give back behind the line that has grown last.
  std::optional<ShorterPatches> shorter_patches(const std::vector<regions::Patch>& patches,
                                                std::span<const crack::Extension> extensions) const;
  // Gives patches the blocks that they got in a run when it had just the extensions `grown`, by its layouts, of which
  // those are taken from the list (fracture::EvolutionState), and the scene the cracks that elements carried from then
  // on; `cracks` get these, too. Returns whether there were any; the prepared scene stays.
  bool repeat_layouts(std::span<const std::int64_t>& layouts, std::span<const crack::Extension> grown,
                      std::vector<scene::Crack>& cracks);
  // Gives the patches in the scene other blocks. The prepared scene stays as it is.
  void replace_patches(std::vector<regions::Patch> next);
  void go_back_to(std::vector<regions::Patch> before) noexcept;

  // Patches in the scene.
  struct Laid {
    std::vector<regions::Patch> present, first;
  };
  // Takes the patches out of the scene for a while; bring_back() adds them again.
  Laid set_aside();
  void bring_back(Laid aside);
  // Load factors of growth with elements in place of the patches; none if the scene cannot be solved so.
  const std::vector<TipLoad>& loads_of_elements() const { return loads_of_elements_; }

 private:
  std::vector<regions::LatticeCrack> in_lattices() const;
  void require_elements() const;

  Model& model_;
  std::map<int, CrackTreatment> treatments_;  // by crack; without automatic ones
  std::map<int, regions::BodyLattice> lattices_;
  Laid patches_;
  std::vector<regions::LatticeCrack> lattice_cracks_;  // for which they are
  std::vector<TipLoad> loads_of_elements_;
};

}  // namespace bempd::model
