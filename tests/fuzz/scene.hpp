// A model under a sequence of calls that follows from bytes.
#ifndef BEMPD_TESTS_FUZZ_SCENE_HPP
#define BEMPD_TESTS_FUZZ_SCENE_HPP

#include <bempd.h>

#include <cstdint>
#include <vector>

#include "bytes.hpp"

namespace fuzz {

// The numbers that a failed call has to leave alone.
struct Marks {
  std::int32_t regions = 0;
  std::int64_t lines = 0;
  double load_factor = 0;
};

// A failed call leaves the model as it was.
void require_same(const char* call, const Marks& before, const Marks& after);

// What the host remembers: how many of each kind it has added, so that most ids are good ones, and where they lie.
class Scene {
 public:
  explicit Scene(Bytes& bytes);
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  // One call, or a few that belong together.
  void act();

  // A body as hosts build it, in calls that mostly succeed; act() then meets a prepared model soon.
  void build();
  // A plate of boundary elements with cracks.
  void build_cracked();

 private:
  struct Place {
    double x, y;
  };

  // Bodies (scene_bodies.cpp).
  void set_option();
  void limit_memory();
  void add_material(bool sound);
  void add_box(bool of_lattice);
  void add_polygon();
  void add_hole();
  void bend_edge();
  void mesh_edge();
  void vary_toughness();
  void add_crack(bool in_lattice);

  // Cracks (scene_cracks.cpp).
  void add_curved();
  void grow();
  void grow_by_cycles();
  void combine_load_cases();
  void read_tips();
  void read_paths();
  void read_pieces();
  void remove();

  // Conditions (scene_conditions.cpp).
  void add_whole_load();
  void add_support();
  void add_load();
  void change_values();

  void act_on_edges();

  // Edges (scene_edges.cpp).
  void add_other_load();
  void give_edge_values();
  void name_things(std::int32_t of, std::int32_t number);
  void read_edge();
  void read_bounds();
  void change_values_along();
  void listen();
  void read_options();
  void keep_file();

  // Runs (scene_runs.cpp).
  void advance();
  void interrupt();
  void read_report(const char* call, const bempd_step_report& report);
  void read_fields();
  void read_bonds(std::int32_t region);
  void evaluate();
  void read_books();
  void read_singular_places();
  void keep_state();
  void write_files();

  Marks marks() const;
  Place place();
  Place place_on_body();
  std::int32_t region();
  std::int32_t edge();
  std::int32_t component(int most);

  Bytes& bytes_;
  bempd_model* model_ = nullptr;
  bempd_state* state_ = nullptr;
  double scale_ = 1;   // length of one step of the grid on which places lie
  double height_ = 4;  // of most boxes
  double front_ = 0;   // where the next box begins
  std::int32_t regions_ = 0, supports_ = 0, loads_ = 0, materials_ = 0;
  std::vector<std::int64_t> support_values_, load_values_;
  std::vector<Place> corners_;          // of the boxes
  std::vector<Place> lattice_origins_;  // lower left corners of lattices
};

}  // namespace fuzz

#endif
