#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geometry/blocks.hpp"
#include "geometry/outline.hpp"
#include "regions/patches.hpp"

namespace bempd::regions {

// Straight piece of what bounds a patch: of a body's edge or of another crack.
struct Wall {
  Segment piece;
  int loop;          // of the outline; -1: of a crack
  std::string name;  // for messages
};

// Part of a crack inside a body.
struct CrackInBody {
  LatticeCrack crack;
  std::vector<Segment> pieces;
  struct Tip {
    Point place, direction;  // unit vector
    bool grows;
  };
  std::vector<Tip> tips;
  std::vector<std::pair<Point, int>> mouths;  // places on the outline, and the loops

  double length() const {
    double sum = 0;
    for (const Segment& piece : pieces) sum += piece.length();
    return sum;
  }
};

// Patches of one body.
class PatchLayout {
 public:
  PatchLayout(const scene::Scene& scene, int body, std::vector<CrackInBody> cracks, const BodyLattice& lattice);

  std::vector<Patch> patches();

 private:
  double chosen_spacing() const;
  double clearance(const Point& origin) const;
  Point origin() const;
  const Wall* wall_beside(const Block& block) const;
  bool is_allowed(const Block& block) const { return !wall_beside(block); }
  void add_band(const CrackInBody& crack);
  void require_room(const CrackInBody& crack, const Segment& along, bool is_tip);
  std::string advice() const;

  int body_;
  std::vector<CrackInBody> cracks_;
  std::vector<Wall> walls_, crack_walls_;
  std::vector<Edge> edges_;
  int ratio_;
  double spacing_;
  BlockGrid grid_;
  Blocks blocks_;
};

}  // namespace bempd::regions
