#include "regions/boundary/interior_of_pieces.hpp"

#include <limits>

#include "geometry/outline.hpp"

namespace bempd::regions {

InteriorOfPieces::InteriorOfPieces(std::vector<bem::InteriorEvaluator> interiors, const BoundaryMesh& mesh,
                                   const bem::CrackMesh& cracks, double tolerance)
    : interiors_(std::move(interiors)), edges_(interiors_.size()), tolerance_(tolerance) {
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const BoundaryElement& element = mesh.elements[e];
    edges_[static_cast<std::size_t>(cracks.pieces.of_element[e])].emplace_back(
        Arc{mesh.nodes[element.nodes[0]], mesh.nodes[element.nodes[2]], element.sweep});
  }
  for (const bem::CutElement& e : cracks.cuts)
    cuts_.push_back({{mesh.nodes[e.left[0]], mesh.nodes[e.left[2]]},
                     static_cast<std::size_t>(cracks.pieces.left_of(e.line)),
                     static_cast<std::size_t>(cracks.pieces.right_of(e.line))});
}

InteriorOfPieces::InteriorOfPieces(std::vector<bem::InteriorEvaluator> interiors, std::vector<std::vector<Edge>> edges)
    : interiors_(std::move(interiors)), edges_(std::move(edges)) {
  for (const std::vector<Edge>& own : edges_) {
    boxes_.emplace_back();
    for (const Edge& edge : own) boxes_.back().extend(bounding_box(edge));
  }
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

// Index of the piece in which a place lies; the nearest piece if rounding puts the place outside all of them.
std::size_t InteriorOfPieces::piece_at(const Point& x) const {
  if (interiors_.size() == 1) return 0;
  for (const Cut& cut : cuts_)
    if (distance(cut.segment, x) <= tolerance_) return from_right_ ? cut.right : cut.left;
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t piece = 0; piece < boxes_.size(); ++piece)
    if (boxes_[piece].contains(x) && locate(edges_[piece], x, 0) != Location::outside) return piece;
  for (std::size_t piece = 0; piece < edges_.size(); ++piece) {
    if (boxes_.empty() && locate(edges_[piece], x, 0) != Location::outside) return piece;
    for (const Edge& edge : edges_[piece])
      if (const double gap = distance(edge, x); gap < least) least = gap, nearest = piece;
  }
  return nearest;
}

}  // namespace bempd::regions
