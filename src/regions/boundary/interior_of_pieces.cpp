#include "regions/boundary/interior_of_pieces.hpp"

#include <limits>

#include "geometry/outline.hpp"

namespace bempd::regions {

void InteriorOfPieces::add(bem::InteriorEvaluator piece, const BoundaryMesh& mesh) {
  interiors_.push_back(std::move(piece));
  edges_.emplace_back();
  boxes_.emplace_back();
  for (const BoundaryElement& element : mesh.elements) {
    edges_.back().emplace_back(Arc{mesh.nodes[element.nodes[0]], mesh.nodes[element.nodes[2]], element.sweep});
    boxes_.back().extend(bounding_box(edges_.back().back()));
  }
}

void InteriorOfPieces::add(const bem::CrackedOperator& body, const bem::CrackedState& state, double tolerance) {
  const bem::CrackPieces& pieces = body.cracks().pieces;
  const std::size_t first = interiors_.size();
  for (int piece = 0; piece < pieces.count; ++piece)
    add(bem::interior_of_piece(body, state, piece), bem::elements_of_piece(body.mesh(), pieces, piece));
  tolerance_ = tolerance;
  for (const bem::CutElement& e : body.cracks().cuts)
    cuts_.push_back({{body.mesh().nodes[e.left[0]], body.mesh().nodes[e.left[2]]},
                     first + static_cast<std::size_t>(pieces.left_of(e.line)),
                     first + static_cast<std::size_t>(pieces.right_of(e.line))});
}

void InteriorOfPieces::choose_right_face(bool right) {
  from_right_ = right;
  for (bem::InteriorEvaluator& interior : interiors_) interior.choose_right_face(right);
}

std::int64_t InteriorOfPieces::kernel_evaluations() const {
  std::int64_t sum = 0;
  for (const bem::InteriorEvaluator& interior : interiors_) sum += interior.kernel_evaluations();
  return sum;
}

// Index of the piece in which a place lies, or of the nearest piece if rounding puts the place outside of all pieces.
std::size_t InteriorOfPieces::piece_at(const Point& x) const {
  if (interiors_.size() == 1) return 0;
  for (const Cut& cut : cuts_)
    if (distance(cut.segment, x) <= tolerance_) return from_right_ ? cut.right : cut.left;
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t piece = 0; piece < boxes_.size(); ++piece)
    if (boxes_[piece].contains(x) && locate(edges_[piece], x, 0) != Location::outside) return piece;
  for (std::size_t piece = 0; piece < edges_.size(); ++piece)
    for (const Edge& edge : edges_[piece])
      if (const double gap = distance(edge, x); gap < least) least = gap, nearest = piece;
  return nearest;
}

}  // namespace bempd::regions
