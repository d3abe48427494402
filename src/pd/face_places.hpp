#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/point.hpp"

namespace bempd::pd {

// Position of a lattice in the body: its points are origin + spacing R (i, j), where R is the rotation by `angle`.
struct FaceLattice {
  Point origin;
  double spacing;
  double angle;
};

// Face place: a place at which the two faces of a crack in a lattice may touch. Its gap is the opening along the
// crack's normal n, taken between the points x + h n and x - h' n on both sides of the place x, where displacements are
// interpolated between material points. A rigid motion does not change the gap. A strain changes the gap by the
// elongation of the material between the two points.
struct FacePlace {
  struct Pull {
    int node;
    Eigen::Vector2d pull;
  };
  std::vector<Pull> pulls;  // gap = sum of pull . displacement
  double stiffness;         // stiffness of the material between the two points: force per gap [N/m]
};

// Makes the face places of cracks (places at which the two faces of a crack may touch) on the lattices of a body.
//
// Docs: materials.md.
class FacePlaces {
 public:
  struct Body {
    FaceLattice lattice;
    double stiffness;        // thickness times the modulus of a uniaxial stress in the plane [N/m]
    std::vector<int> nodes;  // nodes of the region; nodes off the lattice's rows are ignored
  };
  FacePlaces(const std::vector<Point>& positions, const std::vector<Body>& bodies);
  FacePlaces() = default;

  std::size_t lattice_count() const { return lattices_.size(); }
  double spacing(int lattice) const { return lattices_[static_cast<std::size_t>(lattice)].lattice.spacing; }

  // Number of a lattice in which two nodes are neighbours along a row or a column; empty if there is no such lattice.
  std::optional<int> lattice_of_neighbours(int node, int other) const;

  // Function that tells whether the displacement of a node may be used for the face place at `place`.
  using Reaches = std::function<bool(int node, const Point& place)>;
  // Face place at `place` on a crack with this normal; it represents `length` spacings of the crack. On each side of
  // the crack, displacements are taken at the nearest point for which the material points around it all lie on that
  // side and satisfy reaches(node, place). Empty if one side has no such point.
  std::optional<FacePlace> at(int lattice, const Point& place, const Point& normal, double length,
                              const Reaches& reaches = {}) const;

  // Crossing of a straight piece of a crack with a column of a lattice, or with a row if the piece crosses more rows
  // than columns. `length` is the length of crack that the crossing represents [spacings], half as much for a crossing
  // at an end of the piece.
  struct Crossing {
    Point place;
    double length;
  };
  std::vector<Crossing> crossings(int lattice, const Point& start, const Point& end) const;

 private:
  struct Numbered {
    Eigen::Vector2i at;
    int node;
  };
  struct Lattice {
    FaceLattice lattice;
    double stiffness;
    std::vector<Numbered> points;  // ordered by rows, then by columns

    Point to_rows(const Point& p) const;
    Point from_rows(const Point& p) const;
    bool continues(const FaceLattice& other, double its_stiffness) const;
    std::optional<int> node_at(const Eigen::Vector2i& at) const;
  };

  // Interpolates the displacement on one side of a crack, as near to the place as possible. Appends the nodes and their
  // interpolation coefficients to `pulls`, and returns the distance of the interpolated point from the place in
  // spacings; empty if no point on this side is suitable.
  std::optional<double> add_side(const Lattice& lattice, const Point& place, const Point& normal, double sign,
                                 const Reaches& reaches, std::vector<FacePlace::Pull>& pulls) const;

  std::vector<Point> positions_;
  std::vector<Lattice> lattices_;
  std::vector<int> lattice_at_;  // index of a lattice that has each node; -1: none
};

}  // namespace bempd::pd
