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

// Elements on a crack for a picture: start, middle and end of each, the openings and mean displacements there [m].
struct CrackPicture {
  int crack;
  std::vector<Point> places, openings, displacements;
};

// Elements that a region puts on cracks (parts of Preparation::cracks): loads on their faces, tips and openings.
class CrackElements {
 public:
  virtual ~CrackElements() = default;

  // Lines of the region's cracks; null if it has none.
  virtual const CrackLines* lines() const = 0;
  // Whether cracks cut the region into separate pieces.
  virtual bool cut_the_region() const = 0;
  // Whether part of a crack lies inside a piece of the region, so that it does not separate two pieces.
  virtual bool lie_inside(int crack) const = 0;
  // Adds nodal forces [N] of a load on one of the cracks; `part` is 0 for the constant, 1 for the proportional part.
  virtual void add_load(const CrackLoad& load, int part, Eigen::Ref<Eigen::VectorXd> force) const = 0;
  // Gaps of contact constraints due to loads inside the region [m]; no rows if no crack can close.
  virtual coupling::Affine face_offsets(const std::array<BodyForce, 2>& body_force,
                                        const std::vector<CrackLoad>& crack_loads) const = 0;
  // Tips with results. TipDetail::factors leaves out T-stress and errors, which growth does not need.
  virtual std::vector<TipValues> tips(const Solution& solution, TipDetail detail) const = 0;
  // Openings of one of the cracks at fractions of the length: tangential, and normal (positive if open) [m].
  virtual std::vector<Point> openings(int crack, const std::vector<double>& fractions,
                                      const Solution& solution) const = 0;
  virtual std::vector<CrackPicture> pictures(const Solution& solution) const = 0;
  // Largest overlap of crack faces in the region; empty if there is none.
  virtual std::optional<Overlap> overlap(const Solution& solution) const = 0;
};

}  // namespace bempd::regions
