#pragma once

#include <array>
#include <optional>
#include <vector>

#include "coupling/affine.hpp"
#include "elasticity/linear_body_force.hpp"
#include "geometry/crack_lines.hpp"
#include "regions/fields.hpp"
#include "regions/tip_values.hpp"

namespace bempd::regions {

enum class TipDetail { factors, everything };

// Elements on a crack for a picture: places of the start, the middle and the end of each element, and the openings and
// mean displacements of the crack's faces at these places [m].
struct CrackPicture {
  int crack;
  std::vector<Point> places, openings, displacements;
};

// Boundary elements that a region has on its parts of cracks (Preparation::cracks): loads on the faces of cracks,
// results of tips, and openings.
class CrackElements {
 public:
  virtual ~CrackElements() = default;

  // Crack lines: pieces into which tips, mouths and places where cracks meet divide the region's cracks; null if the
  // region has no cracks.
  virtual const CrackLines* lines() const = 0;
  // Whether cracks cut the region into separate pieces.
  virtual bool cut_the_region() const = 0;
  // Whether some part of a crack lies inside one piece of the region, with this piece on both of its sides.
  virtual bool lie_inside(int crack) const = 0;
  // Adds nodal forces [N] of a load on the faces of a crack; `part` is 0 for the constant, 1 for the proportional part
  // of the load.
  virtual void add_load(const CrackLoad& load, int part, Eigen::Ref<Eigen::VectorXd> force) const = 0;
  // Gaps of the contact constraints of crack faces due to loads inside the region [m]; no rows if crack faces cannot
  // close.
  virtual coupling::Affine face_offsets(const std::array<BodyForce, 2>& body_force,
                                        const std::vector<CrackLoad>& crack_loads) const = 0;
  // Tips of the region's cracks with results. TipDetail::factors leaves out T-stress and errors, which growth does not
  // need.
  virtual std::vector<TipValues> tips(const Solution& solution, TipDetail detail) const = 0;
  // Openings of one crack at fractions of its length: tangential, and normal (positive if open) [m].
  virtual std::vector<Point> openings(int crack, const std::vector<double>& fractions,
                                      const Solution& solution) const = 0;
  virtual std::vector<CrackPicture> pictures(const Solution& solution) const = 0;
  // Largest overlap of crack faces in the region; empty if no faces overlap.
  virtual std::optional<Overlap> overlap(const Solution& solution) const = 0;
};

}  // namespace bempd::regions
