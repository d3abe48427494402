#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "crack/carrier.hpp"
#include "fracture/body_carrier.hpp"
#include "fracture/crack_evolution.hpp"
#include "model/crack_treatments.hpp"
#include "model/driven_growth.hpp"
#include "regions/patches.hpp"
#include "regions/tip_values.hpp"
#include "scene/scene.hpp"
#include "scene/scene_values.hpp"

namespace bempd::model {

class Model;
struct Growing;

// Carrier of cracks with boundary elements, for one call of a host. When a tip grows, a scene with the longer crack is
// prepared beside the present one, and the run continues in the new scene. When a lattice patch (lattice inside a body)
// gets more blocks around a crack line, a scene with the larger patch is prepared in the same way.
class ElementCarrier final : public fracture::BodyCarrier {
 public:
  // `on_way` are the values of loads and supports that act; null for those that the host has set. Tips grow only if
  // `grows`. A crack line that continues in boundary elements grows there in any case.
  ElementCarrier(Model& model, const scene::SceneValues* on_way, bool grows);
  ~ElementCarrier() override;

  std::vector<crack::Tip> tips() override;
  std::vector<crack::Candidate> candidates(const crack::LoadWay& way) override;
  crack::Advance advance(const crack::Step& step) override;
  std::vector<Point> openings(int crack, const std::vector<double>& fractions) override;

  // Scene in which the tips of `growing` have grown at the present load factor. Of the model only the cracks of its
  // scene change; after a failure they are `before` again. Throws crack::CannotGrow and crack::FreesLoadedPart.
  Grown longer(const std::vector<scene::Crack>& before, const Growing& growing, ExtensionDirections directions);
  // Scene in which a crack line has continued from its lattice into boundary elements, with the longer crack in the
  // model's scene; empty if the line cannot continue. If no load drives the line, another process such as fatigue takes
  // all released energy.
  std::optional<Grown> continued_in_elements(const crack::TipId& tip, bool is_driven);
  // Continues the run in a scene with longer cracks, in whose history the growth is entered.
  void go_on_in(std::unique_ptr<PreparedScene> next, const fracture::Growth& growth);

  fracture::CrackEvolution& body() override;
  int bodies_before() const override { return changes_; }
  bool follow_breaks(const std::vector<coupling::StageChange>& broken) override;
  bool take_over_lines(bool run_ends) override;

  // Computing time of the scenes that were left in this call when cracks or patches changed; the present scene does not
  // count.
  const TimeSpent& spent() const { return spent_; }
  // Returns the model to the scene that it had when the carrier was made.
  void take_back() noexcept;

 private:
  void update();
  std::size_t index_of(const crack::TipId& tip) const;
  std::vector<crack::TipId> tips_that_cannot_grow(const Growing& growing, const std::vector<scene::Crack>& before);
  bool cross_border(const crack::TipId& tip);
  Grown continued_in_elements(const crack::Extension& last, const Point& place, std::vector<scene::Crack> longer,
                              bool is_driven);
  std::vector<crack::TipId> lines_at_border();
  void follow_lines();
  bool change_patches(std::vector<regions::Patch> patches, std::optional<std::vector<scene::Crack>> cracks,
                      std::int64_t layout);
  void change_scene(std::unique_ptr<PreparedScene> next, const std::function<void(const PreparedScene&)>& tell);
  Grown grown(const std::vector<scene::Crack>& before, const std::function<Grown()>& grow);

  Model& model_;
  const scene::SceneValues* on_way_;
  bool grows_;
  std::vector<scene::Crack> cracks_;              // cracks of the scene when the carrier was made
  std::optional<CrackTreatments::Copy> patches_;  // patches of that scene; empty: the patches have not changed
  std::unique_ptr<PreparedScene> start_;          // scene when the carrier was made; null: no crack has grown yet
  TimeSpent spent_;
  int changes_ = 0;  // number of scenes before the present one
  std::size_t extensions_seen_;

  // Whether the stress intensity factors of the tips are known. They are computed again only after an event or a change
  // of contact.
  bool is_known_ = false;
  std::int64_t events_ = 0, switches_ = 0;
  std::vector<regions::TipValues> values_;
  std::vector<crack::Tip> tips_;
};

}  // namespace bempd::model
