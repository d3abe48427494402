#include <gtest/gtest.h>

#include "paper/collocation_operator.hpp"
#include "physics/curved_patch.hpp"

namespace paper_curved_patch_test {
namespace {

using namespace bempd;
using namespace bempd::bem_test;

TEST(CollocationCurvedPatch, constant_strain_and_rigid_motions_are_exact) {
  for (const PlaneState state : {PlaneState::stress, PlaneState::strain})
    for (const Body& body : curved_bodies()) {
      const PlaneElasticity elasticity{2, 0.3, state, 1};
      const BoundaryMesh mesh = mesh_boundary(body.loops);
      check_patch("collocation", body, mesh, some_field(elasticity), paper::CollocationOperator(mesh, elasticity));
    }
}

}  // namespace
}  // namespace paper_curved_patch_test
