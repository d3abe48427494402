#pragma once

#include <vector>

#include "bem/crack_tips.hpp"
#include "bem/interior.hpp"
#include "geometry/edge.hpp"

namespace bempd::regions {

// Evaluates displacement and stress inside a region of several pieces, into which cracks or the library have cut it, by
// the evaluator of the piece in which a place lies.
class InteriorOfPieces {
 public:
  // Creates the evaluator for a region of one piece.
  explicit InteriorOfPieces(bem::InteriorEvaluator whole) { interiors_.push_back(std::move(whole)); }
  InteriorOfPieces() = default;
  // Adds a piece with this boundary, or all pieces of a part that has cracks.
  void add(bem::InteriorEvaluator piece, const BoundaryMesh& mesh);
  void add(const bem::CrackedOperator& body, const bem::CrackedState& state, double tolerance);

  bem::InteriorEvaluator::Value at(const Point& x) const { return interiors_[piece_at(x)].at(x); }
  Point displacement_at(const Point& x) const { return interiors_[piece_at(x)].displacement_at(x); }
  // Chooses the right face for places on cracks, including those between two pieces; the left face if `right` is false.
  void choose_right_face(bool right);
  std::int64_t kernel_evaluations() const;

 private:
  struct Cut {
    Segment segment;
    std::size_t left, right;  // pieces
  };
  std::size_t piece_at(const Point& x) const;

  std::vector<bem::InteriorEvaluator> interiors_;
  std::vector<std::vector<Edge>> edges_;  // of each piece
  std::vector<Box> boxes_;                // around them
  std::vector<Cut> cuts_;
  double tolerance_ = 0;
  bool from_right_ = false;
};

}  // namespace bempd::regions
