// Cracked plates of lattice for tests of contact, and their equilibrium by an active set of contact forces, which knows
// nothing of how the library finds it.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <random>
#include <vector>

#include "model/model.hpp"

namespace contact_bodies {

using namespace bempd;

struct Size {
  int cells, horizon_ratio;
};

std::unique_ptr<model::Model> plate(const Size& size, const std::vector<std::vector<Point>>& cracks,
                                    const char* contact = "faces", double critical_stretch = 0,
                                    double poisson_ratio = 1.0 / 3);

void hold(model::Model& model, int edge, int component, double constant, double proportional);

// The lower edge is held, the upper one moves up, and to the right by a share of that.
void move_ends(model::Model& model, double constant, double proportional, double sideways = 0);

Eigen::VectorXd displacement(model::Model& model);

// One to four cracks away from held edges under constant and growing motions of the upper edge; null if they cut
// something off.
std::unique_ptr<model::Model> random_plate(std::mt19937& random);

// Numbers of the reference: a body whose cracks are open may hang together by next to nothing.
using Number = long double;
using Matrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;
using Numbers = Eigen::Matrix<Number, Eigen::Dynamic, 1>;

// A^-1 B of a positive definite A, and A^T B: vectors, too, compiled once for all.
Matrix solved(const Matrix& a, const Matrix& b);
Matrix product(const Matrix& a_transposed, const Matrix& b);

// Forces p >= 0 with the least 1/2 p.A p + g.p, by the active set of Lawson and Hanson 1974.
Numbers least_contact_forces(const Matrix& a, const Numbers& g);

// The whole body's displacements by dense algebra, with all places open and the forces that keep them from overlapping.
// No place touches a held point.
class QuadraticProgramme {
 public:
  explicit QuadraticProgramme(model::Model& model);
  ~QuadraticProgramme();

  // Displacement at the model's load factor.
  Eigen::VectorXd displacement() const;

 private:
  struct Parts;

  model::Model& model_;
  std::unique_ptr<const Parts> parts_;
};

Eigen::VectorXd by_quadratic_programme(model::Model& model);

}  // namespace contact_bodies
