// Plates of boundary elements whose cracks close, and their equilibrium by an active set of contact forces on the whole
// matrices of displacements and openings, which knows nothing of how the library finds it.
#pragma once

#include <functional>

#include "bem/crack_forces.hpp"
#include "bem/cracked_operator.hpp"
#include "model/model.hpp"

namespace closing_cracks {

using namespace bempd;
using Stress = std::function<Eigen::Matrix2d(const Point&)>;

Eigen::Matrix2d stress(double xx, double yy, double xy = 0);
Stress uniform(double xx, double yy, double xy = 0);

// Tractions of a stress in equilibrium on all sides, in its constant and its proportional part.
void pull(model::Model& model, const Stress& constant, const Stress& proportional);

// A square of boundary elements around the origin, held at two corners.
std::unique_ptr<model::Model> plate(double half, double element, const std::vector<std::vector<Point>>& cracks,
                                    const char* contact = "faces", double fracture_energy = 0);

void press_faces(model::Model& model, int crack, double constant, double proportional);

const bem::CrackedOperator& operator_of(model::Model& model);

// Openings at nodes across their cracks, of a straight crack or elements of one direction around each node.
struct Solved {
  Eigen::VectorXd displacements, openings;
};

// Solves K z = f + C^T q, C z >= 0, q >= 0, q.C z = 0 at a model's load factor, with all of its forces.
Solved by_quadratic_programme(model::Model& model, const bem::FaceTraction& faces = {});

// All openings of the model's state, at the places of the nodes.
Eigen::VectorXd openings(model::Model& model);

}  // namespace closing_cracks
