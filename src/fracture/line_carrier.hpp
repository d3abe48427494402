#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "crack/carrier.hpp"

namespace bempd::fracture {

class CrackEvolution;
class LineEvents;

// Carrier of cracks that grow as lines in the lattices of a body. A step cuts all bonds across it, in place or in an
// open window that has computed it ahead.
class LineCarrier final : public crack::Carrier {
 public:
  using Openings = std::function<std::vector<Point>(int crack, const std::vector<double>& fractions)>;

  LineCarrier(CrackEvolution& body, Openings openings) : body_(body), openings_(std::move(openings)) {}

  std::vector<crack::Tip> tips() override;
  // Tips without their loads of growth, for which trial steps may be needed.
  std::vector<crack::Tip> tips_without_loads();
  std::vector<crack::Candidate> candidates(const crack::LoadWay& way) override;
  // A step that the load drives has to be the event that comes next in the run. Without bonds ahead of the tip nothing
  // grows.
  crack::Advance advance(const crack::Step& step) override;
  std::vector<Point> openings(int crack, const std::vector<double>& fractions) override {
    return openings_(crack, fractions);
  }

 private:
  LineEvents& source();  // for the present state

  CrackEvolution& body_;
  Openings openings_;
};

}  // namespace bempd::fracture
