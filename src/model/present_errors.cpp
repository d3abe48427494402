#include "model/present_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "error.hpp"
#include "geometry/turning.hpp"
#include "model/accuracy.hpp"
#include "model/element_growth.hpp"
#include "model/model.hpp"
#include "regions/memory_limit.hpp"
#include "stopwatch.hpp"

namespace bempd::model {

namespace {

// Largest number of elements of a scene that is solved with halved elements to estimate errors, if memory allows: the
// change of the results is then most of the error. Larger scenes are solved with longer elements instead, which takes
// less time than the scene itself took, but requires extrapolation.
constexpr std::int64_t most_halved = 1000;

bool can_be_halved(const Model& model, const PreparedScene& scene) {
  return scene.discretization.statistics().boundary_elements <= most_halved &&
         bytes_of_elements(scene, 2) <= regions::memory_allowed(model.options());
}

// Relative difference between the load factors of the next growth by the two growth criteria; 0 if no tip grows.
double between_criteria(const std::vector<regions::TipValues>& tips) {
  const auto load_by = [&](KinkCriterion criterion) {
    double least = std::numeric_limits<double>::infinity();
    for (const regions::TipValues& tip : tips) {
      const crack::GrowthLaw law{tip.toughness, tip.plane_modulus, criterion, tip.directions,
                                 heading_of(tip.direction)};
      if (tip.toughness > 0) least = std::min(least, law.range(factors_of(tip)).highest);
    }
    return least;
  };
  const double first = load_by(KinkCriterion::hoop_stress), second = load_by(KinkCriterion::energy_release_rate);
  return std::isfinite(first) && std::isfinite(second) ? std::abs(first - second) / std::abs(first) : 0;
}

// Present scene in equilibrium, for comparison with other meshes. Throws Error (order) if bonds have broken or a part
// has come off.
PreparedScene& comparable(Model& model) {
  PreparedScene& scene = model.in_equilibrium();
  const fracture::EvolutionState& state = scene.evolution->progress();
  if (state.broken_bonds > 0 || state.fragments > 0 || state.separated)
    fail(Failure::order,
         "bonds have broken or a part has come off, and the scene cannot be solved with longer elements "
         "from there; ask before that");
  return scene;
}

// Calls `read` with the present scene in another mesh, whose elements are halved `halvings` times (merged in pairs if
// negative). Adds the time that this took to `seconds`.
void read_with(Model& model, int halvings, double& seconds, const std::function<void(PreparedScene&)>& read) {
  const Stopwatch watch(seconds);
  model.accuracy().solve_with({model.accuracy().refinement().of_bodies, halvings}, model.loads().acting_values(),
                              model.load_factor(), read);
}

}  // namespace

ErrorSources errors_now(Model& model) {
  PreparedScene& scene = comparable(model);
  const double load_factor = model.load_factor();
  const double tolerance = scene.discretization.tolerance;
  const regions::RegionStatistics sizes = scene.discretization.statistics();
  const MeshAnswers present = model.accuracy().answers_of(scene, 0);
  ErrorSources errors;
  errors.model = between_criteria(present.tips);
  errors.has_lattices = sizes.material_points > 0;
  errors.halving_bytes = bytes_of_elements(scene, 2);
  const auto with = [&](int halvings, double& seconds) {
    MeshAnswers answers;
    read_with(model, halvings, seconds,
              [&](PreparedScene& other) { answers = model.accuracy().answers_of(other, load_factor); });
    return answers;
  };
  if (can_be_halved(model, scene)) {
    const MeshAnswers finer = with(1, errors.halving_seconds);
    errors.boundary = estimated_by_finer(finer, present, tolerance, model.options());
    return errors;
  }
  double seconds_of_coarsest = 0, seconds_of_coarser = 0;
  const MeshAnswers coarser = with(-1, seconds_of_coarser);
  MeshAnswers coarsest;
  std::vector<const MeshAnswers*> meshes{&coarser, &present};
  // A second coarser mesh, with elements merged twice, shows the order of convergence. Bodies whose elements were
  // halved less than twice have no such mesh.
  if (!model.accuracy().chosen() || model.accuracy().refinement().of_bodies > 1) {
    coarsest = with(-2, seconds_of_coarsest);
    meshes.insert(meshes.begin(), &coarsest);
  }
  errors.boundary = estimated(meshes, tolerance, model.options());
  const double ratio = seconds_of_coarsest > 0 ? seconds_of_coarser / seconds_of_coarsest : HUGE_VAL;
  errors.halving_seconds = seconds_of_coarser * std::pow(clamped_time_ratio(ratio), 2);
  return errors;
}

namespace {

// Limits of the order of convergence of the value at a place, as coarser meshes show it. Coarse meshes often show too
// high an order, so the upper limits are the orders of values on edges; inside the body errors are smaller than
// estimated.
constexpr double least_order_at_places = 1, largest_order_of_stress = 2, largest_order_of_displacement = 3;
// Factor by which errors at places are increased that are extrapolated from coarser meshes.
constexpr double caution_at_places = 2;
// Ratio of the estimated error of a value to its change by halved elements. In random bodies 5 % of the errors of
// stress on edges were larger.
constexpr double caution_at_places_by_finer = 1.6;

double distance_of(const Point& a, const Point& b) { return (a - b).norm(); }

// Norm of the difference of two stress tensors, given as xx, yy, xy; the principal stresses differ by no more than
// this.
double distance_of(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d d = a - b;
  return std::sqrt(d.x() * d.x() + d.y() * d.y() + 2 * d.z() * d.z());
}

using Values = std::vector<regions::PointValue>;

// Error of the value at a place, from two meshes (the mesh with halved elements, then the present one) or from three
// meshes (the present one, then ever coarser ones).
template <class Value>
double error_at(const std::vector<Values>& meshes, std::size_t place, Value regions::PointValue::*value,
                double largest_order) {
  const auto apart = [&](std::size_t fine) {
    return distance_of(meshes[fine][place].*value, meshes[fine + 1][place].*value);
  };
  if (meshes.size() == 2) return caution_at_places_by_finer * apart(0);
  // The difference of the two finer meshes may vanish by chance, so at least a sixteenth of the difference of the two
  // coarser meshes counts.
  const double fine = std::max(apart(0), apart(1) / 16);
  if (!(fine > 0)) return 0;
  const double gain = std::exp2(std::clamp(std::log2(apart(1) / fine), least_order_at_places, largest_order));
  return caution_at_places * fine / (gain - 1);
}

}  // namespace

PlaceErrors errors_at(Model& model, const std::vector<Point>& places, const results::Side& side) {
  const PreparedScene& scene = comparable(model);
  const Values present = model.results().evaluate(places, true, side);
  const std::vector<double> orders = model.results().stress_orders(places);
  double seconds = 0;
  const auto with = [&](int halvings) {
    Values values;
    read_with(model, halvings, seconds,
              [&](const PreparedScene&) { values = model.results().evaluate(places, true, side); });
    return values;
  };
  std::vector<Values> meshes;
  if (can_be_halved(model, scene)) {
    meshes = {with(1), present};
  } else {
    meshes = {present, with(-1), with(-2)};
  }
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  PlaceErrors errors;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const bool is_known = model.scene().region(present[k].region).has_elements();
    const double u = error_at(meshes, k, &regions::PointValue::displacement, largest_order_of_displacement);
    const double s = error_at(meshes, k, &regions::PointValue::stress, largest_order_of_stress);
    errors.displacement.push_back(is_known ? u : unknown);
    errors.stress.push_back(is_known && orders[k] == 0 ? s : unknown);
  }
  return errors;
}

// Raises the error of each tip's factors to that of the mesh. The chosen plan has an error for each tip, which holds as
// long as the tip has not grown and there are no constant loads; else the plan's error relative to the largest factors
// of all tips holds.
void Accuracy::raise_errors(std::vector<regions::TipValues>& tips) const {
  if (!chosen_) return;
  double largest = 0;
  for (const regions::TipValues& tip : tips) largest = std::max(largest, tip.factors.norm());
  for (regions::TipValues& tip : tips) {
    double error = chosen_->errors.intensity * largest;
    for (const TipErrors& own : chosen_->errors.tips)
      if (own.tip == crack::TipId{tip.crack, tip.end} && own.place == tip.place && tip.constant_factors.isZero(0))
        error = own.relative() * tip.factors.norm();
    tip.error = std::max(tip.error, error);
  }
}

}  // namespace bempd::model
