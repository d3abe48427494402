#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "crack/carrier.hpp"

namespace bempd::fracture {

class CrackEvolution;
class LineEvents;

// Carrier of crack lines (cracks that grow in the lattices of a body by steps of a spacing). A step cuts all bonds
// across it, in the whole body or in an open window (region around crack tips that is solved alone) that has computed
// the step ahead.
class LineCarrier final : public crack::Carrier {
 public:
  using Openings = std::function<std::vector<Point>(int crack, const std::vector<double>& fractions)>;

  LineCarrier(CrackEvolution& body, Openings openings) : body_(body), openings_(std::move(openings)) {}

  std::vector<crack::Tip> tips() override;
  // Tips without their critical load factors, because these may need trial steps.
  std::vector<crack::Tip> tips_without_loads();
  std::vector<crack::Candidate> candidates(const crack::LoadWay& way) override;
  // Performs a step of a crack line. A step that the load drives has to be the next event of the run. Nothing grows if
  // no bond lies ahead of the tip.
  crack::Advance advance(const crack::Step& step) override;
  std::vector<Point> openings(int crack, const std::vector<double>& fractions) override {
    return openings_(crack, fractions);
  }

 private:
  LineEvents& source();  // source of steps, for the present state

  CrackEvolution& body_;
  Openings openings_;
};

}  // namespace bempd::fracture
