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

// What keeps the blocks of patches in a body away: its edges and holes, and cracks that have elements.
class PatchWalls {
 public:
  explicit PatchWalls(const Outline& body);

  void add_crack(const Segment& piece, int crack);
  // The wall nearest to a block that is closer than a block's size; null if there is none. A block outside of the body
  // has the first wall.
  const Wall* beside(const Box& block) const;
  const std::vector<Wall>& all() const { return walls_; }

 private:
  std::vector<Wall> walls_;
  std::vector<Edge> edges_;
};

// Pieces of a polyline between the places at which it meets edges.
std::vector<Segment> pieces_between(const std::vector<Point>& points, const std::vector<Edge>& edges);

// Distances from a crack, in blocks, within which it has lattice: as usual, and where more would enclose a hole or
// another crack. With two horizons single loads are up to 4e-3 off those of a large lattice, with three 5e-4.
inline constexpr double usual_patch_reach = 1.5, least_patch_reach = 1;

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
  bool is_allowed(const Block& block) const { return !walls_.beside(grid_.box(block)); }
  void add_band(const CrackInBody& crack, double reach);
  void require_room(const CrackInBody& crack, const Segment& along, bool is_tip);
  std::string advice() const;

  int body_;
  std::vector<CrackInBody> cracks_;
  PatchWalls walls_;
  std::vector<Wall> own_cracks_;
  int ratio_;
  double spacing_;
  BlockGrid grid_;
  Blocks blocks_;
};

}  // namespace bempd::regions
