#pragma once

#include <map>
#include <vector>

#include "geometry/point.hpp"
#include "regions/edge_nodes.hpp"

namespace bempd::model {

class Model;

// Results on edges for coupled hosts: nodes and cells in order along an edge, and the forces of supports and
// neighbouring regions on the region [N].
class EdgeResults {
 public:
  explicit EdgeResults(Model& model) : model_(model) {}

  std::vector<regions::EdgeNode> nodes(int region, int edge);
  std::vector<int> cells(int region, int edge);
  std::vector<Point> forces(int region, int edge);

  struct Reaction {
    Eigen::Vector2d force;
    double moment;
  };
  // Reaction of all supports on an edge [N], and its moment about a place [N m].
  Reaction reaction(int region, int edge, const Point& about);

 private:
  std::vector<Point> traction_forces(int region, int edge, const std::vector<int>& nodes);
  std::map<int, double> forces_of_supports(int region, int edge);   // forces by degree of freedom
  std::map<int, Point> forces_of_neighbours(int region, int edge);  // forces by node
  Eigen::VectorXd forces_from_outside(const std::vector<int>& body);

  Model& model_;
};

}  // namespace bempd::model
