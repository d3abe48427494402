#include "model/level_factors.hpp"

#include <algorithm>

#include "model/load_cases.hpp"

namespace bempd::model {

namespace {

// Stress intensity factors of tips by load factor. The factors are affine in the load factor as long as the same faces
// are closed. Where faces close or open in between, the scene is moved to the load factors beyond.
class FactorsByLoadFactor {
 public:
  FactorsByLoadFactor(PreparedScene& scene, const std::vector<regions::TipValues>& tips, const LoadLevels& levels,
                      FactorsOfTips& factors)
      : scene_(scene), tips_(tips), levels_(levels), factors_(factors) {}

  void find(bool follow_faces) {
    const std::size_t highest = levels_.highest();
    take(highest, levels_.size(), tips_);
    take(0, highest, tips_);
    const coupling::Constraints& constraints = scene_.system->constraints();
    if (constraints.size() == 0 || levels_.size() == 1 || !follow_faces) return;
    fracture::EvolutionState state = scene_.evolution->state();
    fracture::Continuation continuation = scene_.evolution->continuation();
    closed_ = constraints.closed();
    for (const bool downwards : {true, false}) follow(downwards);
    scene_.evolution->restore(std::move(state), std::move(continuation));
  }

 private:
  // Sets the stress intensity factors under the loads `from` up to, but without, `to`, from `tips`, whose factors are
  // affine in the load factor.
  void take(std::size_t from, std::size_t to, const std::vector<regions::TipValues>& tips) {
    for (std::size_t level = from; level < to; ++level)
      for (std::size_t t = 0; t < tips_.size(); ++t)
        if (const regions::TipValues* tip = crack::tip_in(tips, tips_[t].id()))
          factors_[t][level].factors = factors_of(*tip).at(levels_.factor(level));
  }

  // Moves the scene from the highest load factor step by step towards the first or the last one, until the same faces
  // are closed at the load factor reached and at that end. Gaps and contact forces are affine, so the same faces are
  // closed in between as well.
  void follow(bool downwards) {
    const std::size_t last = downwards ? 0 : levels_.size() - 1;
    if (last == levels_.highest()) return;
    std::vector<char> closed = closed_;
    for (std::size_t level = levels_.highest(); level != last;) {
      go_to(last);
      if (scene_.system->constraints().closed() == closed) return;
      level = downwards ? level - 1 : level + 1;
      go_to(level);
      closed = scene_.system->constraints().closed();
      const std::vector<regions::TipValues> here = tips();
      downwards ? take(0, level + 1, here) : take(level, levels_.size(), here);
    }
  }

  void go_to(std::size_t level) { move_load(scene_, levels_.factor(level), {}); }
  std::vector<regions::TipValues> tips() {
    std::vector<regions::TipValues> found;
    for (const auto& region : scene_.discretization.regions) {
      const regions::CrackElements* cracks = region->crack_elements();
      if (!cracks) continue;
      for (const regions::TipValues& tip : cracks->tips(solution_of(scene_), regions::TipDetail::factors))
        found.push_back(tip);
    }
    return found;
  }

  PreparedScene& scene_;
  const std::vector<regions::TipValues>& tips_;
  const LoadLevels& levels_;
  FactorsOfTips& factors_;
  std::vector<char> closed_;
};

}  // namespace

FactorsOfTips LevelSolver::factors(const std::vector<regions::TipValues>& tips, bool with_t_stress) {
  FactorsOfTips found(tips.size(), std::vector<crack::LevelFactors>(levels_.size()));
  if (!levels_.combine_cases())
    FactorsByLoadFactor(scene(), tips, levels_, found).find(!lengthening_.grows_lines(scene()));
  std::vector<char> solved(levels_.size());
  for (std::size_t level = 0; level < levels_.size(); ++level)
    solved[level] = levels_.combine_cases() || changes_faces(level);
  take_solved(tips, solved, with_t_stress, found);
  return found;
}

// Whether faces of crack lines may close or open between the highest load and the load number `level`. No faces do if
// all loads are proportional to load factors >= 0, because such loads press the same faces on each other.
bool LevelSolver::changes_faces(std::size_t level) {
  if (!lengthening_.grows_lines(scene()) || levels_.size() == 1 || scene().system->constraints().size() == 0)
    return false;
  return levels_.factor(level) < 0 || !scene().evolution->state().displacement.col(0).isZero(0);
}

void LevelSolver::under_each(const std::function<void(std::size_t level)>& read, const std::vector<char>& chosen) {
  lengthening_.in_scene_of(longer_, [&] {
    for (std::size_t level = 0; level < levels_.size(); ++level) {
      if (!chosen.empty() && !chosen[level]) continue;
      const auto there = [&](PreparedScene&) { read(level); };
      if (levels_.combine_cases()) {
        model_.load_cases().solve_under(levels_[level].cases, there);
      } else {
        model_.load_cases().solve_at(levels_.factor(level), there);
      }
    }
  });
}

void LevelSolver::take_solved(const std::vector<regions::TipValues>& tips, const std::vector<char>& with_factors,
                              bool with_t_stress, FactorsOfTips& found) {
  if (!with_t_stress && std::none_of(with_factors.begin(), with_factors.end(), [](char one) { return one != 0; }))
    return;
  const auto detail = with_t_stress ? regions::TipDetail::everything : regions::TipDetail::factors;
  const auto read = [&](std::size_t level) {
    const std::vector<regions::TipValues> here = lengthening_.loaded_tips(detail);
    for (std::size_t t = 0; t < tips.size(); ++t) {
      const regions::TipValues* tip = crack::tip_in(here, tips[t].id());
      if (!tip) continue;
      if (with_t_stress) found[t][level].t_stress = tip->stress_along;
      if (with_factors[level]) found[t][level].factors = tip->closed ? Point(0, tip->factors.y()) : tip->factors;
      if (tip->method == regions::TipMethod::elements) continue;
      found[t][level].turn = tip->kink_angle, found[t][level].felt_ahead = tip->felt_ahead;
    }
  };
  under_each(read, with_t_stress ? std::vector<char>{} : with_factors);
}

}  // namespace bempd::model
