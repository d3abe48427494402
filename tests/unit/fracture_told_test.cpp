// What a host is told of long work, and when it is heard: the end of a factorization before it begins, and a request to
// stop among events that are computed ahead.
#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "linalg/dense_parts.hpp"
#include "linalg/expected_time.hpp"
#include "model/host_listener.hpp"
#include "model/model.hpp"
#include "regions/lattice/peridynamic_description.hpp"
#include "regions/places/edge_part.hpp"
#include "stop_request.hpp"

namespace {

using namespace bempd;
using fracture::Goal, fracture::StopReason;

struct Word {
  std::string phase;
  double share, expected;
};

// Hears every word, however fast they come.
class Ear final : public PhaseListener {
 public:
  void hear(const char* phase, double share, double, double expected) override {
    words.push_back({phase, share, expected});
    if (on_word) on_word(words.back());
  }

  std::vector<Word> words;
  std::function<void(const Word&)> on_word;
};

// A lattice with an edge crack that is torn bond by bond.
std::unique_ptr<model::Model> edge_crack() {
  auto model = std::make_unique<model::Model>();
  scene::Scene& scene = model->editable_scene();
  scene::Material material;
  material.elasticity = {1, 1.0 / 3, PlaneState::stress, 1};
  material.fracture_energy = 1;
  regions::add_peridynamic_region(scene, scene.add_material(material), {{0, 0}, {24, 0}, {24, 24}, {0, 24}}, 1, 3);
  scene.add_crack({{12.5, 0}, {12.5, 6.5}});
  for (const int edge : {4, 2})
    scene.add_support({std::make_shared<const regions::EdgePart>(1, edge, 0, 1), 3,
                       scene::SampledValues{{0.0, 0.0}, {edge == 2 ? 1.0 : 0.0, 0.0}}});
  model->options().set_text("crack.rule", "bond");
  model->prepare();
  return model;
}

TEST(ToldOfLongWork, a_factorization_tells_its_end_before_it_begins) {
  constexpr int size = 1500;
  Ear ear;
  const ListeningScope listening(&ear);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Constant(size, size, 0.5);
  matrix.diagonal().array() += size;
  ASSERT_TRUE(linalg::factorize_in_parts(matrix));
  ASSERT_GT(ear.words.size(), 2u);
  EXPECT_EQ(ear.words[0].phase, "dense factorization");
  EXPECT_EQ(ear.words[0].share, 0);
  EXPECT_GT(ear.words[0].expected, 0);
  for (std::size_t k = 2; k < ear.words.size(); ++k) EXPECT_GT(ear.words[k].share, ear.words[k - 1].share);
}

TEST(ToldOfLongWork, an_estimate_is_proportional_to_the_work_and_made_for_listeners_only) {
  EXPECT_EQ(linalg::expected_time_of_products(1e12), 0);
  Ear ear;
  const ListeningScope listening(&ear);
  EXPECT_EQ(linalg::expected_time_of_products(1e6), 0);  // not worth it
  EXPECT_GT(linalg::expected_time_of_products(1e14), 10 * linalg::expected_time_of_products(1e11));
  EXPECT_GT(linalg::expected_time_of_entries(1e14), 10 * linalg::expected_time_of_entries(1e11));
}

TEST(ToldOfLongWork, a_host_hears_of_the_end_at_once_and_the_log_has_a_line) {
  std::vector<double> expected;
  std::vector<std::string> lines;
  model::HostListener listener;
  EXPECT_EQ(listener.or_null(), nullptr);
  listener.tell([&](const char*, double, double, double seconds) {
    expected.push_back(seconds);
    return seconds < 100;
  });
  listener.write([&](int level, const std::string& message) { lines.push_back(std::to_string(level) + message); });
  ASSERT_EQ(listener.or_null(), &listener);
  listener.hear("ordering", 0, 0, 0);
  listener.hear("ordering", 0.5, 1, 2);  // within a tenth of a second of the last word
  listener.hear("sparse factorization", 0, 0, 12.4);
  listener.hear("sparse factorization", 0, 0, 0.3);
  EXPECT_EQ(expected, (std::vector<double>{0, 12.4, 0.3}));
  EXPECT_EQ(lines, (std::vector<std::string>{"2sparse factorization: some 12 s"}));
  EXPECT_THROW(listener.hear("sparse factorization", 0, 0, 200), Error);
}

StopReason advance_model(model::Model& model, Goal goal, const std::atomic<bool>* stop = nullptr) {
  fracture::SteppingOptions options;
  options.stop = stop, options.separation_share = 0.02;
  const StopScope scope(stop);
  return model.prepared().evolution->advance(1e9, goal, options, {}, {});
}

// The state after a number of events, done one by one.
const fracture::EvolutionState& after_events(model::Model& model, int events) {
  const fracture::EvolutionState& state = model.prepared().evolution->progress();
  while (state.events < events && advance_model(model, Goal::next_event) == StopReason::event) continue;
  return state;
}

TEST(ToldOfLongWork, a_request_to_stop_is_heard_among_events_computed_ahead) {
  constexpr int events = 30;
  const auto steady = edge_crack();
  const fracture::EvolutionState& expected = after_events(*steady, events);
  ASSERT_EQ(expected.events, events);

  const auto model = edge_crack();
  std::atomic<bool> stop{false};
  int ahead = 0, after = 0;
  Ear ear;
  ear.on_word = [&](const Word& word) {
    if (word.phase != "events ahead in a window" || word.share == 0) return;
    if (stop) ++after;
    if (++ahead == 3) stop = true;
  };
  {
    const ListeningScope listening(&ear);
    ASSERT_EQ(advance_model(*model, Goal::separation, &stop), StopReason::requested);
  }
  EXPECT_EQ(ahead, 3);
  EXPECT_EQ(after, 0);  // nothing more was computed ahead
  const fracture::EvolutionState& progress = model->prepared().evolution->progress();
  EXPECT_EQ(progress.events, 0);  // the first event of a call may be long: it is given up
  // The run goes on as the one that was not stopped.
  after_events(*model, events);
  EXPECT_EQ(progress.events, events);
  EXPECT_EQ(progress.broken_bonds, expected.broken_bonds);
  EXPECT_NEAR(progress.load_factor, expected.load_factor, 1e-9 * expected.load_factor);
}

}  // namespace
