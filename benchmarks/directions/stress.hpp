#pragma once

#include "window.hpp"

namespace directions {

// Stress at the window's points at load factor one, the mean over a disc of points: half of the force times bond vector
// of each whole bond belongs to either end, one area of a point; broken bonds carry none.
class MeanStress {
 public:
  MeanStress(const Body& body, const Window& window, double radius);

  void update();
  const Eigen::Vector3d& at(int point) const {
    return mean_[static_cast<std::size_t>(window_.local(point))];
  }  // xx, yy, xy

 private:
  struct Neighbour {
    int local;
    double weight;
  };
  const Body& body_;
  const Window& window_;
  std::vector<std::vector<Neighbour>> neighbours_;
  std::vector<Eigen::Vector3d> own_, mean_;
};

// Largest principal value and its direction.
struct Principal {
  double value;
  Point normal;
};
Principal principal(const Eigen::Vector3d& stress);

}  // namespace directions
