#pragma once

#include <functional>
#include <vector>

#include "fracture/event_source.hpp"
#include "fracture/line/line_path.hpp"
#include "fracture/line/line_step.hpp"
#include "fracture/line/tip_fields.hpp"

namespace bempd::fracture {

// Growth of crack lines (cracks that grow in a lattice) by steps that have been performed: moves tips, ends them at
// edges and faces, and remembers the energy that each step released, which corrects the load factors of the next steps.
class LineGrowth {
 public:
  LineGrowth(const std::vector<Point>& positions, const TipFields& fields, const LinePath& path)
      : positions_(positions), fields_(fields), path_(path) {}

  // Correction of the load factor: factor on the stress intensity factors of a fit of stresses, from the ratios of
  // released to expected energy in the tip's last steps.
  static double correction_of(const GrowingTip& tip);

  // Function that returns the displacements after an event, which need to be known around the given tips only.
  using DisplacementAt = std::function<const coupling::Affine&(const std::vector<GrowingTip>&)>;
  // Completes a step after its event, which has released `released_energy` [J]: moves the tip, ends it if it has met an
  // edge or a face, and remembers the ratio of released to expected energy, which corrects the tip's next load factors.
  crack::Extension complete_step(const LineStep& step, const Event& event, double released_energy,
                                 const DisplacementAt& displacement_at, std::vector<GrowingTip>& tips) const;

  // State of a tip whose crack has just begun: a tip at a free edge or a hole has ended, any other tip grows.
  crack::TipState state_of_begun(const GrowingTip& tip) const;

 private:
  void move(const LineStep& step, std::vector<GrowingTip>& tips) const;
  crack::Extension remember(const LineStep& step, double ratio, double released_energy,
                            const coupling::Affine& displacement, double load_factor,
                            std::vector<GrowingTip>& tips) const;
  crack::TipState state_at_edge(const Point& place) const;
  // Ratio of a tip's equivalent stress intensity factor after a step to the toughness of `law`. `displacement` is the
  // solution after the step.
  double ratio_after(const GrowingTip& tip, const pd::TipLaw& law, const coupling::Affine& displacement,
                     double load_factor) const;

  const std::vector<Point>& positions_;
  const TipFields& fields_;
  const LinePath& path_;
};

}  // namespace bempd::fracture
