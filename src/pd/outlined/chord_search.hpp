#pragma once

#include <array>
#include <vector>

#include "geometry/edge.hpp"
#include "pd/outlined/chords.hpp"

namespace bempd::pd {

// Grid of squares with lists of items, to find the items near a place.
class Buckets {
 public:
  Buckets() = default;
  Buckets(const Box& box, double side);

  void add(const Box& box, int item);
  // Calls visit(item) for all items that may meet a box, until a call returns true; returns whether one did. An item
  // may be visited several times.
  template <class Visit>
  bool any_near(const Box& box, const Visit& visit) const {
    const Eigen::Array2i low = square_of(box.min()), high = square_of(box.max());
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x)
        for (const int item : items_[static_cast<std::size_t>(y) * columns_ + x])
          if (visit(item)) return true;
    return false;
  }

 private:
  Eigen::Array2i square_of(const Point& p) const;

  Point origin_ = Point::Zero();
  double side_ = 1;
  int columns_ = 0, rows_ = 0;
  std::vector<std::vector<int>> items_;
};

// Searches in the polygon of an outline's chords: which points lie inside, and which of them see each other.
class ChordSearch {
 public:
  explicit ChordSearch(const Chords& chords);

  // Whether a point lies in the closed polygon, up to 1e-9.
  bool inside(const Point& p) const;
  // Whether the segment between two points of the closed polygon stays in it; it may run along a chord.
  bool in_sight(const Point& from, const Point& to) const;

  // View from a point of the closed polygon, up to the distance `reach`. Another point is seen if both points lie on
  // the inner side of all straight pieces of the outline nearby; otherwise the segment between the two points is
  // checked.
  class View {
   public:
    View(const ChordSearch& search, const Point& from, double reach);
    bool sees(const Point& to) const;

   private:
    static constexpr int most_pieces = 4;

    const ChordSearch& search_;
    Point from_;
    int count_ = 0;  // number of pieces nearby; most_pieces + 1: too many, or a round one
    std::array<Segment, most_pieces> pieces_;
  };

 private:
  std::vector<double> meetings(const Point& from, const Point& to) const;
  bool on_chord(const Point& p) const;

  const Chords& chords_;
  Buckets buckets_;
  double low_ = 0;
  std::vector<std::vector<int>> rows_;  // chords by the rows, one spacing high, that they cross
  std::vector<char> straight_;          // per piece
};

}  // namespace bempd::pd
