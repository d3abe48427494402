#pragma once

#include <cstdint>
#include <vector>

#include "coupling/rigid_motion.hpp"

namespace bempd::model {

class Model;
struct PreparedScene;

// Pieces of the body: sets of nodes that bonds and boundary elements connect, the largest first.
struct PieceNodes {
  std::vector<std::vector<int>> nodes;
  std::vector<int> of_node;  // number of each node's piece, from 1
};

struct PieceState {
  std::int64_t nodes = 0;
  int supports = 0, loads = 0;  // numbers of supports and loads on the piece
  int free_motions = 0;         // number of rigid motions that the supports leave free
  coupling::RigidFit motion;
};

// Directions of displacement that supports hold at the nodes `nodes`.
std::vector<coupling::HeldDirection> held_directions(const PreparedScene& prepared, const std::vector<int>& nodes);

// Throws crack::FreesLoadedPart if cracks cut a piece out of a boundary element region with loads inside (body forces),
// so that the piece can move. Such loads belong to the region as a whole and cannot be removed from one piece.
void check_loads_inside_free_pieces(const PreparedScene& prepared);

// Pieces of a model's body, with the supports and loads of each.
class Pieces {
 public:
  explicit Pieces(Model& model) : model_(model) {}

  const PieceNodes& all();
  std::vector<int> of_support(int support);  // numbers of pieces, from 1, ascending
  std::vector<int> of_load(int load);
  std::vector<int> of_nodes_in(int region);  // one number for each entry of the region's fields
  PieceState state(int number);
  // Number of pieces that have a support or a load.
  int anchored_count();

 private:
  std::vector<int> numbers_of(std::vector<int> nodes);
  std::vector<int> loaded_nodes(int load);

  Model& model_;
  PieceNodes found_;
  std::int64_t generation_ = 0;  // generation of the model when the pieces were found
};

}  // namespace bempd::model
