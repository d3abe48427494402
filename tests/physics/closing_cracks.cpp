#include "closing_cracks.hpp"

#include "contact_bodies.hpp"
#include "geometry/turning.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/boundary/boundary_region.hpp"
#include "regions/places/crack_faces.hpp"
#include "regions/places/edge_part.hpp"
#include "regions/places/single_point.hpp"

namespace closing_cracks {

Eigen::Matrix2d stress(double xx, double yy, double xy) {
  Eigen::Matrix2d s;
  s << xx, xy, xy, yy;
  return s;
}

Stress uniform(double xx, double yy, double xy) {
  return [=](const Point&) { return stress(xx, yy, xy); };
}

void pull(model::Model& model, const Stress& constant, const Stress& proportional) {
  const Point normals[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  for (int edge = 1; edge <= 4; ++edge) {
    const Point normal = normals[edge - 1];
    model.editable_scene().add_load({std::make_shared<const regions::EdgePart>(1, edge, 0, 1), 3,
                                     scene::BoundaryFunction([=](const Point& x, double) {
                                       return scene::BoundaryValue{constant(x) * normal, proportional(x) * normal};
                                     })});
  }
}

std::unique_ptr<model::Model> plate(double half, double element, const std::vector<std::vector<Point>>& cracks,
                                    const char* contact, double fracture_energy) {
  auto model = std::make_unique<model::Model>();
  model->options().set_text("contact", contact);
  scene::Scene& scene = model->editable_scene();
  scene::Material material;
  material.elasticity = {1, 0.3, PlaneState::stress, 1};
  if (fracture_energy > 0) material.fracture_energy = fracture_energy;
  regions::add_boundary_region(scene, scene.add_material(material),
                               {{-half, -half}, {half, -half}, {half, half}, {-half, half}}, element);
  for (const std::vector<Point>& crack : cracks) scene.add_crack(crack);
  const auto fix = [&](const Point& where, int component) {
    scene.add_support(
        {std::make_shared<const regions::SinglePoint>(where), component, scene::SampledValues{{0.0}, {0.0}}});
  };
  fix({-half, -half}, 1), fix({-half, -half}, 2), fix({half, -half}, 2);
  return model;
}

void press_faces(model::Model& model, int crack, double constant, double proportional) {
  model.editable_scene().add_load(
      {std::make_shared<const regions::CrackFaces>(crack), 1, scene::SampledValues{{constant}, {proportional}}});
}

const bem::CrackedOperator& operator_of(model::Model& model) {
  const auto& region = static_cast<const regions::BoundaryRegion&>(model.results().region(1));
  return static_cast<const bem::CrackedOperator&>(*region.operators()->whole());
}

Solved by_quadratic_programme(model::Model& model, const bem::FaceTraction& faces) {
  using contact_bodies::Matrix, contact_bodies::Number, contact_bodies::Numbers, contact_bodies::product;
  const bem::CrackedOperator& op = operator_of(model);
  const bem::CrackMesh& cracks = op.cracks();
  const auto& conditions = model.prepared().conditions;
  const Eigen::Index size = op.full_stiffness().rows(), u = op.stiffness().rows();
  Eigen::VectorXd on_faces = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(cracks.nodes.size()));
  if (faces) on_faces = bem::crack_forces(cracks, faces, op.elasticity().thickness);
  Eigen::VectorXd force = cracks.constraint.transpose() * on_faces;
  // What the library adds to the boundary for them comes off again.
  force.head(u) += coupling::evaluate(conditions.force, model.load_factor()) - op.forces_on_boundary(on_faces);
  std::vector<Eigen::VectorXd> gaps;
  for (const bem::CrackElement& e : cracks.elements)
    for (const int node : e.nodes) {
      Eigen::VectorXd own = Eigen::VectorXd::Zero(on_faces.size());
      own.segment<2>(2 * node) = left_of((cracks.nodes[e.nodes[2]] - cracks.nodes[e.nodes[0]]).normalized());
      const Eigen::VectorXd gap = cracks.constraint.transpose() * own;
      const auto same = [&](const Eigen::VectorXd& other) { return (other - gap).norm() < 1e-9; };
      if (gap.norm() > 0 && std::none_of(gaps.begin(), gaps.end(), same)) gaps.push_back(gap);
    }
  std::vector<Eigen::Index> free;
  for (Eigen::Index dof = 0; dof < size; ++dof)
    if (dof >= u || !conditions.prescribed[static_cast<std::size_t>(dof)]) free.push_back(dof);
  const Matrix stiffness = op.full_stiffness()(free, free).cast<Number>();
  Matrix columns(static_cast<Eigen::Index>(free.size()), static_cast<Eigen::Index>(gaps.size()));
  for (std::size_t i = 0; i < gaps.size(); ++i)
    columns.col(static_cast<Eigen::Index>(i)) = gaps[i](free).cast<Number>();
  const Numbers open = contact_bodies::solved(stiffness, force(free).cast<Number>());
  const Matrix answer = contact_bodies::solved(stiffness, columns);
  const Numbers forces = contact_bodies::least_contact_forces(product(columns, answer), product(columns, open));
  Eigen::VectorXd all = Eigen::VectorXd::Zero(size);
  all(free) = Numbers(open + product(answer.transpose(), forces)).cast<double>();
  return {all.head(u), cracks.constraint * all};
}

Eigen::VectorXd openings(model::Model& model) {
  const bem::CrackMesh& cracks = operator_of(model).cracks();
  Eigen::VectorXd all(2 * static_cast<Eigen::Index>(cracks.nodes.size()));
  const regions::Solution solution = model::solution_of(model.prepared());
  // Pictures have the nodes of elements one after another, crack by crack.
  const auto& region = static_cast<const regions::BoundaryRegion&>(model.results().region(1));
  const std::vector<regions::CrackPicture> pictures = region.crack_elements()->pictures(solution);
  std::vector<std::size_t> next(pictures.size(), 0);
  for (const bem::CrackElement& e : cracks.elements) {
    const auto crack =
        static_cast<std::size_t>(region.crack_elements()->lines()->lines[static_cast<std::size_t>(e.line)].crack);
    for (const int n : e.nodes) all.segment<2>(2 * n) = pictures[crack].openings[next[crack]++];
  }
  return all;
}

}  // namespace closing_cracks
