// A further carrier of cracks beside a lattice: one class says when its tips grow, and the run goes to where the first
// tip of all grows.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "crack/cannot_grow.hpp"
#include "crack/extension.hpp"
#include "model/model.hpp"
#include "regions/lattice/peridynamic_description.hpp"
#include "regions/places/edge_part.hpp"

namespace {

using namespace bempd;
using crack::Candidate, crack::Control, crack::LoadWay, crack::Tip, crack::TipId;
using fracture::Goal, fracture::StopReason;

// Tips with factors that are proportional to the load factor. They note their steps and do not grow.
class SomeTips : public fracture::BodyCarrier {
 public:
  explicit SomeTips(model::Model& model) : model_(model) {}

  void add(const TipId& id, double factor) {
    Tip tip{id, {0, 0}, {1, 0}, {{0, 0}, {factor, 0}}, {2, 1}, {}};
    tip.range = tip.law.range(tip.factors);
    tips_.push_back(tip);
  }

  std::vector<Tip> tips() override { return tips_; }
  std::vector<Candidate> candidates(const LoadWay& way) override {
    std::vector<Candidate> all;
    for (const Tip& tip : tips_) {
      const double critical = way.upwards ? tip.range.highest : tip.range.lowest;
      if (std::isfinite(critical))
        all.push_back(crack::candidate(tip.id, critical, tip.law.ratio(tip.factors, way.present), way));
    }
    return all;
  }
  crack::Advance advance(const crack::Step& step) override {
    steps.push_back(step);
    return {{}, true};
  }
  std::vector<Point> openings(int, const std::vector<double>& fractions) override {
    return std::vector<Point>(fractions.size());
  }
  fracture::CrackEvolution& body() override { return *model_.prepared().evolution; }
  int bodies_before() const override { return 0; }
  bool follow_breaks(const std::vector<coupling::StageChange>&) override { return false; }
  bool take_over_lines(bool) override { return false; }

  std::vector<crack::Step> steps;

 protected:
  model::Model& model_;

 private:
  std::vector<Tip> tips_;
};

// A square of lattice with a crack in its middle, moved apart.
std::unique_ptr<model::Model> cracked_lattice() {
  auto model = std::make_unique<model::Model>();
  scene::Scene& scene = model->editable_scene();
  scene::Material material;
  material.elasticity = {1, 1.0 / 3, PlaneState::stress, 1};
  material.fracture_energy = 1;
  regions::add_peridynamic_region(scene, scene.add_material(material), {{0, 0}, {24, 0}, {24, 24}, {0, 24}}, 1, 3);
  scene.add_crack({{8, 12.3}, {16, 12.3}});
  for (const int edge : {1, 3})
    for (const int component : {1, 2})
      scene.add_support({std::make_shared<const regions::EdgePart>(1, edge, 0, 1), component,
                         scene::SampledValues{{0.0}, {edge == 3 && component == 2 ? 1.0 : 0.0}}});
  return model;
}

double load_of_line() {
  const auto model = cracked_lattice();
  model->prepare();
  return model->driver().advance(1e6, Goal::next_event).reason == StopReason::event ? model->load_factor() : 0;
}

StopReason advance(model::Model& model, SomeTips& elements, double target, Control control = Control::load) {
  model.prepare();
  fracture::SteppingOptions options;
  options.elements = &elements, options.control = control;
  return model.prepared().evolution->advance(target, Goal::next_event, options, {}, {});
}

TEST(CrackCarrier, tips_of_all_carriers_grow_in_one_order) {
  const double line = load_of_line();
  ASSERT_GT(line, 0);
  for (const Control control : {Control::load, Control::path}) {
    for (const double share : {0.9, 1.1}) {
      const auto model = cracked_lattice();
      SomeTips tips(*model);
      tips.add({7, 1}, 2 / (share * line)), tips.add({5, 1}, 2 / (2 * share * line));
      tips.add({7, 0}, 2 / (share * line) * (1 + 1e-12));
      const StopReason reason = advance(*model, tips, 1e6, control);
      EXPECT_EQ(reason, share < 1 ? StopReason::crack_stopped : StopReason::event);
      EXPECT_NEAR(model->load_factor(), std::min(share, 1.0) * line, 1e-9 * line);
      ASSERT_EQ(tips.steps.size(), share < 1 ? 1U : 0U);
      if (share > 1) continue;
      EXPECT_EQ(tips.steps[0].tip, (TipId{7, 0}));
      EXPECT_EQ(tips.steps[0].ties, 1);
    }
  }
}

TEST(CrackCarrier, grow_where_they_are_overloaded_and_downwards) {
  const double line = load_of_line();
  const auto model = cracked_lattice();
  SomeTips none(*model), tips(*model);
  ASSERT_EQ(advance(*model, none, 0.5 * line), StopReason::load_factor);
  tips.add({2, 0}, 5 / line), tips.add({3, 0}, 6 / line);
  EXPECT_EQ(advance(*model, tips, line), StopReason::crack_stopped);
  EXPECT_EQ(tips.steps.at(0).tip, (TipId{3, 0}));
  EXPECT_EQ(model->load_factor(), 0.5 * line);

  const auto other = cracked_lattice();
  SomeTips below(*other);
  below.add({2, 0}, -4 / line);
  EXPECT_EQ(advance(*other, below, -line), StopReason::crack_stopped);
  EXPECT_NEAR(other->load_factor(), -0.5 * line, 1e-9 * line);
}

// Tips whose first step has made two bodies. The second one lies where the body before the step lay.
class TwiceChanged final : public SomeTips {
 public:
  using SomeTips::SomeTips;
  crack::Advance advance(const crack::Step& step) override {
    bodies_ = 2;
    body().events().begin({});
    steps.push_back(step);
    crack::Advance done;
    done.extensions.emplace_back().crack = step.tip.crack;
    return done;
  }
  std::vector<Candidate> candidates(const LoadWay& way) override {
    return steps.empty() ? SomeTips::candidates(way) : std::vector<Candidate>();
  }
  int bodies_before() const override { return bodies_; }

 private:
  int bodies_ = 0;
};

TEST(CrackCarrier, frozen_tips_stay_in_a_new_body_at_the_address_of_the_former_one) {
  const double line = load_of_line();
  const auto model = cracked_lattice();
  model->prepare();
  TwiceChanged tips(*model);
  tips.add({7, 1}, 4 / line);
  fracture::SteppingOptions options;
  options.elements = &tips, options.frozen = {{1, 0}, {1, 1}};
  model->prepared().evolution->advance(2 * line, Goal::load_factor, options, {}, {});
  EXPECT_EQ(tips.steps.size(), 1U);
  for (const crack::Extension& extension : model->prepared().evolution->progress().extensions)
    EXPECT_NE(extension.crack, 1);
}

// Lets the run go on in another model after an event, and then finds that it would set a loaded part free.
class Freeing final : public SomeTips {
 public:
  Freeing(model::Model& model, model::Model& next) : SomeTips(model), next_(next) {}
  fracture::CrackEvolution& body() override { return has_changed_ ? *next_.prepared().evolution : SomeTips::body(); }
  int bodies_before() const override { return has_changed_ ? 1 : 0; }
  bool follow_breaks(const std::vector<coupling::StageChange>&) override {
    has_changed_ = true;
    return false;
  }
  bool take_over_lines(bool) override { throw crack::FreesLoadedPart("it would set a part free"); }

 private:
  model::Model& next_;
  bool has_changed_ = false;
};

TEST(CrackCarrier, a_run_that_ends_before_a_part_is_free_ends_in_the_present_body) {
  const auto model = cracked_lattice(), next = cracked_lattice();
  next->prepare();
  Freeing tips(*model, *next);
  EXPECT_EQ(advance(*model, tips, 1e6), StopReason::separated);
  EXPECT_FALSE(model->prepared().evolution->progress().separated);
  EXPECT_TRUE(next->prepared().evolution->progress().separated);
}

TEST(CrackCarrier, a_range_that_all_tips_share) {
  std::vector<Tip> tips(3);
  tips[0].range = {-4, 2}, tips[1].range = {-1, 5};
  EXPECT_EQ(crack::common_range(tips).lowest, -1);
  EXPECT_EQ(crack::common_range(tips).highest, 2);
  tips[2].range = {3, 8};
  EXPECT_TRUE(crack::common_range(tips).is_empty());
}

}  // namespace
