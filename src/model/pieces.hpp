#pragma once

#include <cstdint>
#include <vector>

#include "coupling/rigid_motion.hpp"

namespace bempd::model {

class Model;
struct PreparedScene;

// Sets of nodes that bonds and boundary elements join, the largest first.
struct PieceNodes {
  std::vector<std::vector<int>> nodes;
  std::vector<int> of_node;  // number of each node's piece, from 1
};

struct PieceState {
  std::int64_t nodes = 0;
  int supports = 0, loads = 0;  // numbers of those that hold and load the piece
  int free_motions = 0;         // number of rigid motions that supports leave free
  coupling::RigidFit motion;
};

// What supports hold of some nodes.
std::vector<coupling::HeldDirection> held_directions(const PreparedScene& prepared, const std::vector<int>& nodes);

// Throws Error (unsolvable) where cracks free a piece that loads inside a boundary element region push: boundary
// elements know such loads for a region as a whole, so that a piece cannot lose its part of them.
void check_loads_inside_free_pieces(const PreparedScene& prepared);

// The pieces of a model's body, and what holds and loads each of them.
class Pieces {
 public:
  explicit Pieces(Model& model) : model_(model) {}

  const PieceNodes& all();
  std::vector<int> of_support(int support);  // numbers from 1, ascending
  std::vector<int> of_load(int load);
  std::vector<int> of_nodes_in(int region);  // one number for each entry of the region's fields
  PieceState state(int number);
  // How many pieces something holds or loads.
  int anchored_count();

 private:
  std::vector<int> numbers_of(std::vector<int> nodes);
  std::vector<int> loaded_nodes(int load);

  Model& model_;
  PieceNodes found_;
  std::int64_t generation_ = 0;  // of the model, when they were found
};

}  // namespace bempd::model
