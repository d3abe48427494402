#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geometry/blocks.hpp"
#include "geometry/outline.hpp"
#include "regions/patches.hpp"

namespace bempd::regions {

// Factor on distances from blocks, so that rounding does not decide about equal distances.
inline constexpr double less_rounding = 1 - 1e-9;

// Wall: straight piece of an edge of a body or of a crack with elements, from which lattice patches keep a distance.
struct Wall {
  Segment piece;
  int loop;          // number of the outline's loop; below 0: a crack
  std::string name;  // name for messages
};

// Walls in a body, from which the blocks of lattice patches (squares of 2 x 2 horizons) keep a distance: edges of the
// body and of its holes, and cracks that have elements.
class PatchWalls {
 public:
  explicit PatchWalls(const Outline& body);

  void add_crack(const Segment& piece, int crack);
  // Wall nearest to a block, if it is nearer than the size of a block; null if no wall is so near. A block outside of
  // the body gets the first wall.
  const Wall* nearest_to(const Box& block) const;
  const std::vector<Wall>& all() const { return walls_; }

 private:
  std::vector<Wall> walls_;
  std::vector<Edge> edges_;
};

// Pieces into which edges divide the segments of a polyline.
std::vector<Segment> pieces_between(const std::vector<Point>& points, const std::vector<Edge>& edges);

// Usual distance from a crack, in blocks of two horizons, within which the patch has lattice. The load factors of
// single growth steps are then up to 5e-4 off those in a large lattice.
inline constexpr double usual_patch_reach = 1.5;

// Distance from a crack, in blocks, within which the patch has lattice where the usual distance would enclose a hole or
// another crack. The load factors of single growth steps are then up to 4e-3 off those in a large lattice.
inline constexpr double least_patch_reach = 1;

// Part of a crack that lies in one body (region whose elements the library chooses).
struct CrackInBody {
  LatticeCrack crack;
  std::vector<Segment> pieces;
  struct Tip {
    Point place, direction;  // direction: unit vector
    bool grows;
  };
  std::vector<Tip> tips;
  std::vector<std::pair<Point, int>> mouths;  // places on the outline, and the loops' numbers

  double length() const {
    double sum = 0;
    for (const Segment& piece : pieces) sum += piece.length();
    return sum;
  }
};

// Lays out the lattice patches of one body: blocks of lattice cells around its cracks.
class PatchLayout {
 public:
  // Throws Error (argument) if its lattices need more memory than there is.
  PatchLayout(const scene::Scene& scene, const scene::Options& options, int body, std::vector<CrackInBody> cracks,
              const BodyLattice& lattice);

  std::vector<Patch> patches();

 private:
  double chosen_spacing(std::string& reason) const;
  void require_memory_of_bands(const scene::Material& material, const std::string& reason,
                               const scene::Options& options) const;
  double clearance(const Point& origin) const;
  Point origin() const;
  bool is_allowed(const Block& block) const { return !walls_.nearest_to(grid_.box(block)); }
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
