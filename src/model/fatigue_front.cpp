#include "model/fatigue_front.hpp"

#include <algorithm>

#include "elasticity/kinked_tip.hpp"
#include "model/crack_lengthening.hpp"
#include "model/growth_options.hpp"

namespace bempd::model {

namespace {

// Stress intensity factors of tips at the load factors of a program.
class FactorsByLevel {
 public:
  FactorsByLevel(PreparedScene& scene, const std::vector<regions::TipValues>& tips, const crack::CycleProgram& program,
                 bool follows_faces)
      : scene_(scene), tips_(tips), program_(program), follows_faces_(follows_faces) {}

  std::vector<std::vector<Point>> all() {
    const std::size_t highest = program_.highest();
    factors_.assign(tips_.size(), std::vector<Point>(program_.load_factors().size(), Point(0, 0)));
    take(highest, program_.load_factors().size(), tips_);
    take(0, highest, tips_);
    const coupling::Constraints& constraints = scene_.system->constraints();
    if (constraints.size() == 0 || program_.load_factors().size() == 1 || !follows_faces_) return factors_;
    fracture::EvolutionState state = scene_.evolution->state();
    fracture::Continuation continuation = scene_.evolution->continuation();
    closed_ = constraints.closed();
    for (const bool downwards : {true, false}) follow(downwards);
    scene_.evolution->restore(std::move(state), std::move(continuation));
    return factors_;
  }

 private:
  // Sets the factors at the load factors with the indices `from` up to, but without, `to`.
  void take(std::size_t from, std::size_t to, const std::vector<regions::TipValues>& tips) {
    for (std::size_t level = from; level < to; ++level)
      for (std::size_t t = 0; t < tips_.size(); ++t)
        for (const regions::TipValues& tip : tips)
          if (tip.crack == tips_[t].crack && tip.end == tips_[t].end)
            factors_[t][level] = factors_of(tip).at(program_.load_factors()[level]);
  }

  // Moves from the highest load factor downwards or upwards, until the faces closed at a load factor are those closed
  // at the last one. Gaps and contact forces are affine, so the same faces are closed in between as well.
  void follow(bool downwards) {
    const std::vector<double>& loads = program_.load_factors();
    const std::size_t last = downwards ? 0 : loads.size() - 1;
    if (last == program_.highest()) return;
    std::vector<char> closed = closed_;
    for (std::size_t level = program_.highest(); level != last;) {
      go_to(last);
      if (scene_.system->constraints().closed() == closed) return;
      level = downwards ? level - 1 : level + 1;
      go_to(level);
      closed = scene_.system->constraints().closed();
      const std::vector<regions::TipValues> here = tips();
      downwards ? take(0, level + 1, here) : take(level, loads.size(), here);
    }
  }

  void go_to(std::size_t level) { move_load(scene_, program_.load_factors()[level], {}); }
  std::vector<regions::TipValues> tips() {
    std::vector<regions::TipValues> found;
    for (const auto& region : scene_.discretization.regions)
      for (const regions::TipValues& tip : region->tips(solution_of(scene_), regions::TipDetail::factors))
        found.push_back(tip);
    return found;
  }

  PreparedScene& scene_;
  const std::vector<regions::TipValues>& tips_;
  const crack::CycleProgram& program_;
  bool follows_faces_;
  std::vector<char> closed_;
  std::vector<std::vector<Point>> factors_;
};

// Equivalent stress intensity factor (mode I) in the direction `angle`, by the growth criterion.
double equivalent_in(const Point& factors, double angle, KinkCriterion criterion) {
  return criterion == KinkCriterion::hoop_stress ? hoop_factor(factors, angle) : kinked_factors(factors, angle).x();
}

}  // namespace

const crack::RateLaw* RateLaws::of(int region, double toughness) {
  if (region == 0) return nullptr;
  const int material = model_.scene().region(region).material();
  const crack::RateParameters* parameters = model_.fatigue().rate_of(material);
  if (!parameters) return nullptr;
  if (!(toughness > 0)) toughness = FatigueOptions::unlimited;
  std::unique_ptr<crack::RateLaw>& law = laws_[{material, toughness}];
  if (!law)
    law = crack::make_rate_law(*parameters, toughness,
                               model_.scene().material(material).elasticity.state == PlaneState::strain);
  return law.get();
}

// The angle of a tip is that of the load at which its equivalent factor is larger, the highest or the lowest one.
Front front_of(PreparedScene& scene, const std::vector<regions::TipValues>& tips, const crack::CycleProgram& program,
               const CrackLengthening& lengthening, Model& model, RateLaws& laws) {
  const KinkCriterion criterion = growth_criterion(model.options());
  const std::vector<std::vector<Point>> factors =
      FactorsByLevel(scene, tips, program, !lengthening.grows_lines()).all();
  Front front;
  for (std::size_t t = 0; t < tips.size(); ++t) {
    FrontTip tip;
    tip.values = tips[t];
    const crack::GrowthLaw law = law_of(tips[t], model.options());
    const Kink high = law.kink(factors[t][program.highest()]), low = law.kink(factors[t][program.lowest()]);
    tip.angle = low.equivalent_factor > high.equivalent_factor ? low.angle : high.angle;
    const double toughness = law.directions ? law.toughness * std::sqrt(law.share_in(tip.angle)) : law.toughness;
    tip.law = laws.of(lengthening.region_of(tips[t], scene), toughness);
    for (const Point& at : factors[t]) tip.levels.push_back({at, equivalent_in(at, tip.angle, criterion)});
    front.push_back(std::move(tip));
  }
  return front;
}

const FrontTip* tip_in(const Front& front, const crack::TipId& tip) {
  const auto found = std::find_if(front.begin(), front.end(), [&](const FrontTip& one) { return one.id() == tip; });
  return found == front.end() ? nullptr : &*found;
}

}  // namespace bempd::model
