#pragma once

#include <vector>

#include "bem/crack_tips.hpp"
#include "bem/interior.hpp"
#include "geometry/edge.hpp"

namespace bempd::regions {

// Evaluates displacement and stress inside a boundary element region that cracks or cuts divide into pieces. Each piece
// has an evaluator of its own for the places that lie in it.
class InteriorOfPieces {
 public:
  // Creates the evaluator of an undivided region from the evaluator of its interior.
  explicit InteriorOfPieces(bem::InteriorEvaluator whole) { interiors_.push_back(std::move(whole)); }
  InteriorOfPieces() = default;
  // Adds a piece; `mesh` is the mesh of its boundary.
  void add(bem::InteriorEvaluator piece, const BoundaryMesh& mesh);
  // Adds all pieces of a part with cracks. Places closer to a crack than `tolerance` count as lying on the crack.
  void add(const bem::CrackedOperator& body, const bem::CrackedState& state, double tolerance);

  bem::InteriorEvaluator::Value at(const Point& x) const { return interiors_[piece_at(x)].at(x); }
  Point displacement_at(const Point& x) const { return interiors_[piece_at(x)].displacement_at(x); }
  // Chooses the face of cracks whose values are returned for places on a crack, inside a piece or between two pieces:
  // the right face, or the left face if `right` is false.
  void choose_right_face(bool right);
  std::int64_t kernel_evaluations() const;

 private:
  struct Cut {
    Segment segment;
    std::size_t left, right;  // pieces
  };
  std::size_t piece_at(const Point& x) const;

  std::vector<bem::InteriorEvaluator> interiors_;
  std::vector<std::vector<Edge>> edges_;  // outline of each piece
  std::vector<Box> boxes_;                // around the pieces
  std::vector<Cut> cuts_;
  double tolerance_ = 0;
  bool from_right_ = false;
};

}  // namespace bempd::regions
