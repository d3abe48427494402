#include "contact_bodies.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>

#include "error.hpp"
#include "regions/lattice/peridynamic_description.hpp"
#include "regions/places/edge_part.hpp"

namespace contact_bodies {

std::unique_ptr<model::Model> plate(const Size& size, const std::vector<std::vector<Point>>& cracks,
                                    const char* contact, double critical_stretch, double poisson_ratio) {
  auto model = std::make_unique<model::Model>();
  model->options().set_text("contact", contact);
  scene::Scene& scene = model->editable_scene();
  scene::Material material;
  material.elasticity = {1, poisson_ratio, PlaneState::stress, 1};
  if (critical_stretch > 0) material.critical_stretch = critical_stretch;
  const double n = size.cells;
  regions::add_peridynamic_region(scene, scene.add_material(material), {{0, 0}, {n, 0}, {n, n}, {0, n}}, 1,
                                  size.horizon_ratio);
  for (const std::vector<Point>& crack : cracks) scene.add_crack(crack);
  return model;
}

void hold(model::Model& model, int edge, int component, double constant, double proportional) {
  model.editable_scene().add_support({std::make_shared<const regions::EdgePart>(1, edge, 0, 1), component,
                                      scene::SampledValues{{constant}, {proportional}}});
}

void move_ends(model::Model& model, double constant, double proportional, double sideways) {
  hold(model, 1, 1, 0, 0);
  hold(model, 1, 2, 0, 0);
  hold(model, 3, 1, sideways * constant, sideways * proportional);
  hold(model, 3, 2, constant, proportional);
}

Eigen::VectorXd displacement(model::Model& model) { return model.prepared().evolution->state().total_displacement; }

std::unique_ptr<model::Model> random_plate(std::mt19937& random) {
  std::uniform_real_distribution<double> place(2.2, 9.8), size(-1, 1);
  std::vector<std::vector<Point>> cracks(1 + random() % 4);
  for (std::vector<Point>& crack : cracks)
    for (int k = 0; k < 2 + static_cast<int>(random() % 2); ++k) crack.emplace_back(place(random), place(random));
  const std::array ratios{0.2, 1.0 / 3, 0.45};
  auto model = plate({12, 3 + static_cast<int>(random() % 2)}, cracks, "faces", 0, ratios[random() % 3]);
  hold(*model, 1, 1, 0, 0);
  hold(*model, 1, 2, 0, 0);
  hold(*model, 3, 1, size(random), size(random));
  hold(*model, 3, 2, size(random), size(random));
  try {
    model->driver().advance(0, fracture::Goal::load_factor);
  } catch (const Error&) {
    return nullptr;
  }
  const bool whole = model->prepared().evolution->state().springs.empty();
  return whole && model->prepared().system->constraints().size() > 0 ? std::move(model) : nullptr;
}

Matrix solved(const Matrix& a, const Matrix& b) { return a.ldlt().solve(b); }

Matrix product(const Matrix& a_transposed, const Matrix& b) { return a_transposed.transpose() * b; }

Numbers least_contact_forces(const Matrix& a, const Numbers& g) {
  const Eigen::Index n = g.size();
  Numbers p = Numbers::Zero(n);
  std::vector<int> active;
  const auto is_active = [&](Eigen::Index i) {
    return std::find(active.begin(), active.end(), static_cast<int>(i)) != active.end();
  };
  const Number zero = 1e-16L * std::max(g.lpNorm<Eigen::Infinity>(), Number{1e-300L});
  for (Eigen::Index round = 0; round < 20 * n; ++round) {
    const Numbers slope = -(product(a, p) + g);
    Eigen::Index next = -1;
    for (Eigen::Index i = 0; i < n; ++i)
      if (!is_active(i) && slope[i] > zero && (next < 0 || slope[i] > slope[next])) next = i;
    if (next < 0) break;
    active.push_back(static_cast<int>(next));
    for (;;) {
      const Numbers trial = solved(a(active, active), -g(active));
      Number step = 1;
      for (std::size_t k = 0; k < active.size(); ++k) {
        const Number now = p[active[k]], then = trial[static_cast<Eigen::Index>(k)];
        if (then <= 0) step = std::min(step, now / (now - then));
      }
      for (std::size_t k = 0; k < active.size(); ++k)
        p[active[k]] += step * (trial[static_cast<Eigen::Index>(k)] - p[active[k]]);
      if (step == 1) break;
      std::erase_if(active, [&](int i) {
        if (p[i] > 1e-17L * p.maxCoeff()) return false;
        p[i] = 0;
        return true;
      });
    }
  }
  return p;
}

struct QuadraticProgramme::Parts {
  std::vector<int> dof_of;
  Matrix stiffness, pull, answer;
  Numbers softness;
};

QuadraticProgramme::QuadraticProgramme(model::Model& model) : model_(model) {
  auto parts = std::make_unique<Parts>();
  auto& [dof_of, stiffness, pull, answer, softness] = *parts;
  coupling::EquilibriumSystem& system = *model.prepared().system;
  const coupling::FactorizedSystem factorized = system.factorized();
  dof_of = factorized.dof_of;
  const Eigen::MatrixXd lower(system.matrix().assemble());
  stiffness = Eigen::MatrixXd(lower.selfadjointView<Eigen::Lower>()).cast<Number>();
  const coupling::Constraints& places = system.constraints();
  const auto count = static_cast<Eigen::Index>(places.size());
  Matrix all = Matrix::Zero(2 * system.node_count(), count);
  softness.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto place = static_cast<std::size_t>(i);
    for (const coupling::TermEntry& e : places[place].pull) {
      all(2 * e.node, i) += e.x;
      all(2 * e.node + 1, i) += e.y;
    }
    softness[i] = 1 / static_cast<Number>(places[place].stiffness);
  }
  pull = all(dof_of, Eigen::all);
  for (Eigen::Index i = 0; i < count; ++i)
    stiffness -= (places.is_closed(static_cast<std::size_t>(i)) ? places[static_cast<std::size_t>(i)].stiffness : 0) *
                 pull.col(i) * pull.col(i).transpose();
  answer = solved(stiffness, pull);
  parts_ = std::move(parts);
}

QuadraticProgramme::~QuadraticProgramme() = default;

Eigen::VectorXd QuadraticProgramme::displacement() const {
  const auto& [dof_of, stiffness, pull, answer, softness] = *parts_;
  const coupling::FactorizedSystem factorized = model_.prepared().system->factorized();
  const double f = model_.load_factor();
  const Numbers load = coupling::evaluate(factorized.right_hand_side, f).cast<Number>();
  const Numbers open = solved(stiffness, load);
  Matrix a = product(pull, answer);
  a.diagonal() += softness;
  const Numbers forces = least_contact_forces(a, product(pull, open));
  const Numbers together = open + product(answer.transpose(), forces);
  Eigen::VectorXd u = coupling::evaluate(factorized.prescribed, f);
  u(dof_of) = together.cast<double>();
  return u;
}

Eigen::VectorXd by_quadratic_programme(model::Model& model) { return QuadraticProgramme(model).displacement(); }

}  // namespace contact_bodies
