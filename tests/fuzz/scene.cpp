#include "scene.hpp"

#include <array>
#include <cstdlib>

#include "checks.hpp"

namespace fuzz {

namespace {

// Bodies have at most this many grid steps along each axis, and so some hundred cells and elements.
constexpr int most_steps = 12;

// GB. Scenes that need more, by fine elements on an edge, take minutes under sanitizers.
constexpr double most_memory = 0.1;

}  // namespace

Scene::Scene(Bytes& bytes) : bytes_(bytes) {
  setenv("BEMPD_TEST_HOOKS", "1", 1);
  good("bempd_model_create", nullptr, bempd_model_create(&model_));
  static constexpr std::array scales = {1.0, 1.0, 1.0, 1e-3, 1e3, 1e-9, 1e60, 1e-60, 1e-140, 1e140};
  scale_ = bytes_.of(scales);
  height_ = 2 + bytes_.pick(6);
  FUZZ_CALL(bempd_set_option, model_, "threads", 1.0 + bytes_.pick(2));
  FUZZ_CALL(bempd_set_option, model_, "stepping.max_events", 12.0);
  limit_memory();
}

void Scene::limit_memory() {
  double limit = 0;
  if (FUZZ_CALL(bempd_get_option, model_, "memory.limit", &limit) && (limit == 0 || limit > most_memory))
    FUZZ_CALL(bempd_set_option, model_, "memory.limit", most_memory);
}

Scene::~Scene() {
  bempd_state_free(state_);
  bempd_model_free(model_);
}

Marks Scene::marks() const {
  Marks marks;
  FUZZ_CALL(bempd_region_count, model_, &marks.regions);
  FUZZ_CALL(bempd_history_count, model_, &marks.lines);
  FUZZ_CALL(bempd_load_factor, model_, &marks.load_factor);
  return marks;
}

Scene::Place Scene::place() {
  const double x = bytes_.pick(4 * most_steps) * 0.5, y = bytes_.pick(2 * most_steps) * 0.5;
  return {bytes_.mostly(x * scale_), bytes_.mostly(y * scale_)};
}

Scene::Place Scene::place_on_body() {
  if (bytes_.byte() > 250 || corners_.empty()) return place();
  return corners_[static_cast<std::size_t>(bytes_.pick(static_cast<int>(corners_.size())))];
}

std::int32_t Scene::region() {
  return bytes_.byte() < 250 && regions_ > 0 ? 1 + bytes_.pick(regions_) : bytes_.pick(9) - 2;
}

std::int32_t Scene::edge() { return bytes_.byte() < 250 ? 1 + bytes_.pick(4) : bytes_.pick(12) - 2; }

std::int32_t Scene::component(int most) { return bytes_.byte() < 250 ? 1 + bytes_.pick(most) : bytes_.pick(8) - 2; }

void Scene::build() {
  add_material(bytes_.pick(8) != 7);
  const int boxes = 1 + bytes_.pick(3);
  for (int k = 0; k < boxes; ++k) add_box(bytes_.pick(3) != 0);
  const int cracks = bytes_.pick(3);
  for (int k = 0; k < cracks; ++k) add_crack(true);
  FUZZ_CALL(bempd_fix_edge, model_, 1, 4, BEMPD_BOTH, nullptr);
  ++supports_;
  support_values_.push_back(1);
  add_load();
  if (bytes_.pick(4) != 3) advance();
}

void Scene::act() {
  switch (bytes_.pick(32)) {
    case 0:
      return set_option();
    case 1:
      return add_material(false);
    case 2:
      return add_box(true);
    case 3:
      return add_box(false);
    case 4:
      return add_polygon();
    case 5:
      return add_hole();
    case 6:
      return bend_edge();
    case 7:
      return mesh_edge();
    case 8:
      return add_crack(bytes_.pick(2) == 0);
    case 9:
    case 10:
      return add_support();
    case 11:
    case 12:
      return add_load();
    case 13:
      return change_values();
    case 14:
      return read_fields();
    case 15:
      return evaluate();
    case 16:
      return read_books();
    case 17:
    case 18:
      return keep_state();
    case 19:
      return write_files();
    case 20:
      return add_curved();
    case 21:
      return add_whole_load();
    case 22:
      return grow();
    case 23:
      return read_tips();
    case 24:
      return read_pieces();
    case 25:
      return remove();
    case 26:
      return interrupt();
    case 27:
      return act_on_edges();
    default:
      return advance();
  }
}

// One case of act(), so that older inputs keep most of their meaning.
void Scene::act_on_edges() {
  switch (bytes_.pick(8)) {
    case 0:
      return add_other_load();
    case 1:
      return read_edge();
    case 2:
      return read_bounds();
    case 3:
      return change_values_along();
    case 4:
      return listen();
    case 5:
      return read_options();
    case 6:
      return give_edge_values();
    default:
      return bytes_.pick(2) == 0 ? vary_toughness() : keep_file();
  }
}

}  // namespace fuzz
