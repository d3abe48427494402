#include "model/crack_treatments.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "error.hpp"
#include "model/model.hpp"
#include "regions/boundary/boundary_description.hpp"

namespace bempd::model {

namespace {

const scene::OptionGroup treatment_hooks(scene::OptionPlace::test_hooks, [] {
  return std::vector<scene::OptionDescription>{
      scene::number_option("test.give_back", "0: lattice patches give no blocks back.", 1, 0, 1, true)};
});

}  // namespace

void CrackTreatments::set(int crack, CrackTreatment treatment) {
  if (crack < 1 || crack > model_.cracks().count()) model_.scene().crack(crack);  // throws
  const auto known = treatments_.find(crack);
  const CrackTreatment before = known == treatments_.end() ? CrackTreatment::automatic : known->second;
  const bool was_in_lattice = before == CrackTreatment::lattice;
  const bool is_frozen = treatment == CrackTreatment::frozen;
  if (model_.prepared_or_null() && !is_frozen && treatment != CrackTreatment::automatic) {
    const bool is_carried = std::any_of(patches().begin(), patches().end(), [&](const regions::Patch& patch) {
      return std::find(patch.cracks.begin(), patch.cracks.end(), crack) != patch.cracks.end();
    });
    if (is_carried != (treatment == CrackTreatment::lattice))
      fail(Failure::order, "crack ", crack,
           is_carried ? " runs in a lattice patch, and goes on in elements where it leaves that"
                      : " has no lattice patch, which is laid when the model is prepared",
           "; choose this treatment before, or freeze and release the crack now");
  }
  if (!model_.prepared_or_null() && (was_in_lattice || treatment == CrackTreatment::lattice)) model_.editable_scene();
  // Releasing a crack of which only one tip is frozen leaves this tip frozen, because the host has frozen it alone.
  if (is_frozen || (model_.growth().is_frozen({crack, 0}) && model_.growth().is_frozen({crack, 1})))
    for (const int end : {0, 1}) model_.growth().set_frozen(crack, end, is_frozen);
  if (model_.prepared_or_null()) return;
  if (treatment == CrackTreatment::automatic) {
    treatments_.erase(crack);
  } else {
    treatments_[crack] = treatment;
  }
}

void CrackTreatments::set_lattice(int body, double spacing, int horizon_ratio) {
  const scene::Scene& scene = model_.editable_scene();
  require(regions::is_body(scene.region(body)), "region ", body,
          " is no body; its lattice is given when it is added, or add it with bempd_add_body()");
  require(std::isfinite(spacing) && spacing >= 0, "spacing is ", spacing, "; it must be > 0, or 0 for a choice");
  require(horizon_ratio == 0 || (horizon_ratio >= 3 && horizon_ratio <= 8), "horizon_ratio is ", horizon_ratio,
          "; it must be 3 .. 8, or 0 for the usual one");
  lattices_[body] = {spacing, horizon_ratio};
}

std::vector<regions::LatticeCrack> CrackTreatments::in_lattices() const {
  std::vector<regions::LatticeCrack> cracks;
  for (const auto& [crack, treatment] : treatments_) {
    if (treatment != CrackTreatment::lattice ||
        model_.scene().cracks()[static_cast<std::size_t>(crack) - 1].points.empty())
      continue;
    cracks.push_back({crack, {!model_.growth().is_frozen({crack, 0}), !model_.growth().is_frozen({crack, 1})}});
  }
  return cracks;
}

// Throws Error (argument) if a crack with the treatment `elements` runs through a lattice that the host has added.
void CrackTreatments::require_elements() const {
  for (const auto& [crack, treatment] : treatments_) {
    if (treatment != CrackTreatment::elements) continue;
    const int lattice = regions::lattice_around(model_.scene(), crack);
    require(lattice == 0, "crack ", crack,
            " has the treatment BEMPD_TREATMENT_ELEMENTS and runs through the lattice of ", "region ", lattice,
            "; choose BEMPD_TREATMENT_AUTOMATIC, or add that region with bempd_add_body()");
  }
}

void CrackTreatments::add_patches() {
  std::vector<regions::LatticeCrack> cracks = in_lattices();
  if (cracks != lattice_cracks_ || mark_of_growth_ != model_.accuracy().mark_of_growth()) remove_patches();
  require_elements();
  if (cracks.empty()) return;
  const scene::Options& options = model_.options();
  require(options.text_value("scheme") == "symmetric", "lattice patches need the option scheme = symmetric; it is ",
          options.text_value("scheme"));
  if (!patches().empty()) return;
  std::vector<regions::Patch> patches = regions::lay_out_patches(model_.scene(), options, cracks, lattices_);
  loads_of_elements_.clear();
  try {
    loads_of_elements_ = model_.accuracy().loads_of_elements();
  } catch (const Error& error) {  // these load factors are only for comparison
    if (error.failure() == Failure::cancelled) throw;
  }
  const int own = model_.scene().region_count();
  regions::PatchedBodies bodies(model_.scene(), patches, own);
  Laid laid{patches, patches, {}};
  bodies.exchange(model_.preparation().scene());
  laid.without = std::move(bodies);
  patches_ = std::move(laid), lattice_cracks_ = std::move(cracks);
  mark_of_growth_ = model_.accuracy().mark_of_growth();
}

void CrackTreatments::remove_patches() noexcept {
  if (patches().empty()) return;
  patches_.without.exchange(model_.preparation().scene());
  patches_ = {}, lattice_cracks_.clear();
  model_.accuracy().forget();
}

std::optional<std::vector<regions::Patch>> CrackTreatments::enlarged(const crack::Extension& e) const {
  if (patches().empty() || e.has_ended()) return std::nullopt;
  const Point from(e.from_x, e.from_y), to(e.x, e.y);
  return regions::grown_ahead_of(model_.scene(), patches(), {to, (to - from).normalized()});
}

std::optional<std::vector<regions::Patch>> CrackTreatments::enlarged(
    const regions::BrokenBondNearBorder& broken) const {
  return regions::grown_around(model_.scene(), patches(), broken);
}

std::optional<ShorterPatches> CrackTreatments::shorter_patches(const std::vector<regions::Patch>& patches,
                                                               std::span<const crack::Extension> extensions) const {
  if (model_.options().whole_number("test.give_back") == 0) return std::nullopt;
  return model::shorter_patches(model_.scene(), patches, extensions);
}

bool CrackTreatments::repeat_layouts(std::span<const std::int64_t>& layouts, std::span<const crack::Extension> grown,
                                     std::vector<scene::Crack>& cracks) {
  const std::size_t before = layouts.size();
  for (; !layouts.empty() && regions::extensions_before(layouts.front()) == grown.size();
       layouts = layouts.subspan(1)) {
    const std::int64_t layout = layouts.front();
    std::optional<std::vector<regions::Patch>> next =
        layout < 0 ? enlarged(regions::broken_bond_of(layout)) : enlarged(grown.back());
    std::optional<ShorterPatches> back;
    if (next && regions::gives_back(layout)) {
      back = model::shorter_patches(model_.scene(), *next, grown);
      next = back ? std::optional(std::move(back->layout.patches)) : std::nullopt;
    }
    require(next.has_value(), "the state has other lattice patches; its bytes were altered");
    replace_patches(std::move(*next));
    if (!back) continue;
    const auto number = static_cast<std::size_t>(back->crack) - 1;
    cracks[number] = back->cracks[number];
    model_.preparation().scene().set_cracks(std::move(back->cracks));
  }
  return layouts.size() < before;
}

void CrackTreatments::replace_patches(std::vector<regions::Patch> next) {
  regions::PatchedBodies bodies(model_.scene(), next, own_regions());
  bodies.exchange(model_.preparation().scene());
  patches_.present = std::move(next);
}

CrackTreatments::Copy CrackTreatments::copy() const {
  return {patches(), regions::PatchedBodies(model_.scene(), patches(), own_regions())};
}

void CrackTreatments::go_back_to(Copy before) noexcept {
  before.bodies.exchange(model_.preparation().scene());
  patches_.present = std::move(before.patches);
}

CrackTreatments::Laid CrackTreatments::set_aside() noexcept {
  if (patches().empty()) return {};
  patches_.without.exchange(model_.preparation().scene());
  return std::exchange(patches_, {});
}

void CrackTreatments::bring_back(Laid aside) noexcept {
  aside.without.exchange(model_.preparation().scene());
  patches_ = std::move(aside);
}

int CrackTreatments::own_regions() const { return model_.scene().region_count() - static_cast<int>(patches().size()); }

}  // namespace bempd::model
