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

// Treatments of the cracks of bodies, and the lattice patches that follow from the treatments. A patch is a lattice
// inside a body, made of square blocks of cells around cracks. The scene has its patches from the time when it is
// planned or prepared until the host changes it.
class CrackTreatments {
 public:
  explicit CrackTreatments(Model& model) : model_(model) {}

  // Sets the treatment of a crack. Once the model is prepared, throws Error (order) if the crack would change from
  // elements to a lattice patch or back; freezing and releasing the crack's tips is always possible.
  void set(int crack, CrackTreatment treatment);
  void set_lattice(int body, double spacing, int horizon_ratio);

  // Adds the patches to the scene, unless they are there already.
  void add_patches();
  // Removes the patches from the scene, which is then the scene that the host described.
  void remove_patches() noexcept;
  // Number of the host's own regions. The regions of patches are numbered after these.
  int own_regions() const;
  const std::vector<regions::Patch>& patches() const { return patches_.present; }
  // Patches as they were first laid, before cracks grew in them.
  const std::vector<regions::Patch>& first_patches() const { return patches_.first; }
  // Patches with more blocks around a crack line after an extension; empty if no patch needs or can have more blocks.
  std::optional<std::vector<regions::Patch>> enlarged(const crack::Extension& extension) const;
  // Patches with more blocks around a broken bond; empty if that is impossible.
  std::optional<std::vector<regions::Patch>> enlarged(const regions::BrokenBondNearBorder& broken) const;
  // Blocks that patches can give back to boundary elements behind the crack line that has grown last; empty if there
  // are none. `patches` need not be in the scene yet.
  std::optional<ShorterPatches> shorter_patches(const std::vector<regions::Patch>& patches,
                                                std::span<const crack::Extension> extensions) const;
  // Repeats the changes of patches (layouts) that a saved run made when it had just the extensions `grown`, and removes
  // them from `layouts` (fracture::EvolutionState). The scene's patches, the scene's cracks and the list `cracks`
  // become those of that run. Returns whether there were such changes; the prepared scene is not changed.
  bool repeat_layouts(std::span<const std::int64_t>& layouts, std::span<const crack::Extension> grown,
                      std::vector<scene::Crack>& cracks);
  // Replaces the patches in the scene by `next`, which have other blocks. The prepared scene stays as it is.
  void replace_patches(std::vector<regions::Patch> next);
  // Copy of the scene's patches. To go back from other patches to the copied ones takes no memory.
  struct Copy {
    std::vector<regions::Patch> patches;
    regions::PatchedBodies bodies;
  };
  Copy copy() const;
  void go_back_to(Copy before) noexcept;

  // Patches in the scene: as they are at present, and as they were first laid. `without` describes the bodies without
  // patches.
  struct Laid {
    std::vector<regions::Patch> present, first;
    regions::PatchedBodies without;
  };
  // Takes the patches out of the scene for a while and returns them; bring_back() adds them again.
  Laid set_aside() noexcept;
  void bring_back(Laid aside) noexcept;
  // Load factor at which each tip first grows if boundary elements take the place of the patches; empty if that scene
  // cannot be solved.
  const std::vector<TipLoad>& loads_of_elements() const { return loads_of_elements_; }

 private:
  std::vector<regions::LatticeCrack> in_lattices() const;
  void require_elements() const;

  Model& model_;
  std::map<int, CrackTreatment> treatments_;  // treatments by crack id, except automatic ones
  std::map<int, regions::BodyLattice> lattices_;
  Laid patches_;
  std::vector<regions::LatticeCrack> lattice_cracks_;  // cracks for which the patches were laid
  std::uint64_t mark_of_growth_ = 0;                   // Accuracy::mark_of_growth() when they were laid
  std::vector<TipLoad> loads_of_elements_;
};

}  // namespace bempd::model
