#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/point.hpp"

namespace bempd::pd {

// The rows of a lattice in the body: its points are origin + spacing R (i, j), R turning by the angle.
struct FaceLattice {
  Point origin;
  double spacing;
  double angle;
};

// A place where the two faces of a crack in a lattice meet. Its gap is the opening along the crack's normal, taken
// between the points x + h n and x - h' n to both sides of the place x, where displacements are interpolated between
// material points. Rigid motions have no gap, and a strain of the body has that of the material between.
struct FacePlace {
  struct Pull {
    int node;
    Eigen::Vector2d pull;
  };
  std::vector<Pull> pulls;  // gap = sum of pull . displacement
  double stiffness;         // of the material between, per gap [N/m]
};

// Places where faces can meet, on lattices of a body.
//
// Docs: materials.md.
class FacePlaces {
 public:
  struct Body {
    FaceLattice lattice;
    double stiffness;        // thickness times the modulus of a uniaxial stress in the plane [N/m]
    std::vector<int> nodes;  // at its points; those that do not lie on its rows are left out
  };
  FacePlaces(const std::vector<Point>& positions, const std::vector<Body>& bodies);
  FacePlaces() = default;

  std::size_t lattice_count() const { return lattices_.size(); }
  double spacing(int lattice) const { return lattices_[static_cast<std::size_t>(lattice)].lattice.spacing; }

  // The lattice in which two nodes are neighbours along a row or a column; nothing if there is none.
  std::optional<int> lattice_of_neighbours(int node, int other) const;

  // At a place on a crack, for a part of it as long as so many spacings. Each side is taken as near as its points lie
  // on it and `reaches(node, place)` holds for all. Nothing where there are none.
  using Reaches = std::function<bool(int node, const Point& place)>;
  std::optional<FacePlace> at(int lattice, const Point& place, const Point& normal, double length,
                              const Reaches& reaches = {}) const;

  // Where a straight piece of a crack crosses the columns of a lattice, or its rows if it crosses more of those, and
  // how many spacings of the crack it stands for there: half as many where the piece ends on one.
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
    std::vector<Numbered> points;  // by rows, then columns

    Point to_rows(const Point& p) const;
    Point from_rows(const Point& p) const;
    bool continues(const FaceLattice& other, double its_stiffness) const;
    std::optional<int> node_at(const Eigen::Vector2i& at) const;
  };

  // Interpolation on one side, as near as it goes: appends to the pulls and returns the distance in spacings.
  std::optional<double> add_side(const Lattice& lattice, const Point& place, const Point& normal, double sign,
                                 const Reaches& reaches, std::vector<FacePlace::Pull>& pulls) const;

  std::vector<Point> positions_;
  std::vector<Lattice> lattices_;
  std::vector<int> lattice_at_;  // of every node, one of those that it is in; -1: none
};

}  // namespace bempd::pd
