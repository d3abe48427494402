#include "model/mesh_answers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace bempd::model {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Order of convergence: the one measured, within limits, or the usual one where there are two meshes only, which do not
// tell it. Quadratic elements have the order 3 once they resolve the field. With the usual orders the estimates are the
// difference over 2.3, and over 3 for stress intensity factors; measured differences of the two coarsest meshes of
// random bodies are 2.4 to 7.4 times the error, and 3 to 70 times.
constexpr double least_order = 0.5, largest_order = 2.7, usual_order = 2.25, usual_order_of_intensity = 2.54;

// Factor on estimates, chosen so that they are at least the error in 19 of 20 meshes of random bodies, and at most
// three times the error in nine of ten (docs/bodies.md).
constexpr double caution = 1.6;

double order_of(const std::vector<MeshErrors>& differences, double MeshErrors::*kind) {
  const double usual = kind == &MeshErrors::intensity ? usual_order_of_intensity : usual_order;
  if (differences.size() < 2) return usual;
  const double last = differences.back().*kind, before = differences[differences.size() - 2].*kind;
  if (!(last > 0) || !(before > 0) || !std::isfinite(before)) return usual;
  return std::clamp(std::log2(before / last), least_order, largest_order);
}

bool is_left_of(const Point& a, const Point& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); }

// Index of the place that equals x; -1 if there is none.
int find_place(const std::vector<Point>& places, const Point& x, double tolerance) {
  const Point left(x.x() - tolerance, -infinite);
  for (auto at = std::lower_bound(places.begin(), places.end(), left, is_left_of);
       at != places.end() && at->x() <= x.x() + tolerance; ++at)
    if (std::abs(at->y() - x.y()) <= tolerance) return static_cast<int>(at - places.begin());
  return -1;
}

// Lengths of vectors whose squares may be beyond the range of numbers.
double length_of(const Point& v) { return std::hypot(v.x(), v.y()); }

// An error that is not known in relation to anything, as that of results that are zero, counts as `largest`.
double relative(double error, double scale) {
  constexpr double largest = 1e300;
  if (!(error > 0)) return 0;
  const double ratio = error / scale;
  return ratio < largest ? ratio : largest;
}

double displacement_error(const MeshAnswers& fine, const MeshAnswers& coarse, double tolerance) {
  double error = 0, scale = 0;
  for (const Eigen::Vector2d& u : fine.displacements) scale = std::max(scale, length_of(u));
  for (std::size_t i = 0; i < coarse.places.size(); ++i) {
    const int same = find_place(fine.places, coarse.places[i], tolerance);
    if (same >= 0)
      error = std::max(error, length_of(fine.displacements[static_cast<std::size_t>(same)] - coarse.displacements[i]));
  }
  return relative(error, scale);
}

double reaction_error(const MeshAnswers& fine, const MeshAnswers& coarse) {
  double error = 0, scale = 0;
  for (std::size_t s = 0; s < fine.reactions.size(); ++s) {
    scale = std::max(scale, length_of(fine.reactions[s]));
    error = std::max(error, length_of(fine.reactions[s] - coarse.reactions[s]));
  }
  return relative(error, scale);
}

double intensity_error(const MeshAnswers& fine, const MeshAnswers& coarse) {
  double error = 0, scale = 0;
  for (const regions::TipValues& tip : fine.tips) {
    scale = std::max(scale, length_of(tip.factors));
    for (const regions::TipValues& other : coarse.tips)
      if (other.crack == tip.crack && other.end == tip.end)
        error = std::max(error, length_of(tip.factors - other.factors));
  }
  return relative(error, scale);
}

}  // namespace

double MeshErrors::largest() const { return std::max({displacement, reaction, intensity}); }

std::vector<TipLoad> growth_loads(const PreparedScene& scene, const std::vector<regions::TipValues>& tips,
                                  const std::set<crack::TipId>& frozen, double shift) {
  std::vector<TipLoad> loads;
  const auto add = [&](const crack::TipId& tip, double load) {
    const bool grows = load < std::numeric_limits<double>::max() && !frozen.contains(tip);
    loads.push_back({tip, grows ? shift + load : infinite});
  };
  for (const regions::TipValues& tip : tips)
    add({tip.crack, tip.end}, tip.toughness > 0 ? tip.critical_load_factor : infinite);
  if (fracture::LineCarrier* lines = scene.evolution->lines())
    for (const crack::Tip& tip : lines->tips()) add(tip.id, tip.range.highest);
  return loads;
}

double first_load(const std::vector<TipLoad>& loads, const std::vector<int>& cracks) {
  double least = std::numeric_limits<double>::quiet_NaN();
  for (const TipLoad& one : loads)
    if (std::find(cracks.begin(), cracks.end(), one.tip.crack) != cracks.end() && !(one.load_factor >= least))
      least = one.load_factor;
  return least;
}

MeshAnswers read_answers(const PreparedScene& scene, std::size_t supports, std::vector<regions::TipValues> tips,
                         std::vector<TipLoad> loads) {
  MeshAnswers answers;
  const std::vector<Point>& positions = scene.discretization.positions;
  const Eigen::VectorXd& u = scene.evolution->state().total_displacement;
  std::vector<int> order(positions.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](int node) -> const Point& { return positions[static_cast<std::size_t>(node)]; };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return is_left_of(at(a), at(b)); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool as_before = i > 0 && at(order[i]) == at(order[i - 1]);
    if (as_before || (i + 1 < order.size() && at(order[i]) == at(order[i + 1]))) continue;
    answers.places.push_back(at(order[i]));
    answers.displacements.emplace_back(u.segment<2>(2 * static_cast<Eigen::Index>(order[i])));
  }
  for (std::size_t s = 0; s < supports; ++s) answers.reactions.push_back(scene.evolution->reaction(s));
  answers.growth_load = infinite;
  for (const TipLoad& one : loads)
    if (one.load_factor < answers.growth_load) answers.growth_load = one.load_factor, answers.first = one.tip;
  answers.loads = std::move(loads);
  answers.tips = std::move(tips);
  return answers;
}

MeshErrors difference(const MeshAnswers& fine, const MeshAnswers& coarse, double tolerance) {
  MeshErrors errors{displacement_error(fine, coarse, tolerance), reaction_error(fine, coarse),
                    intensity_error(fine, coarse), 0};
  if (std::isfinite(fine.growth_load))
    errors.growth_load = relative(std::abs(fine.growth_load - coarse.growth_load), std::abs(fine.growth_load));
  return errors;
}

MeshErrors operator*(double factor, MeshErrors errors) {
  for (double* error : {&errors.displacement, &errors.reaction, &errors.intensity, &errors.growth_load})
    *error *= factor;
  return errors;
}

MeshErrors estimated(const std::vector<MeshErrors>& differences) {
  MeshErrors errors;
  for (const auto kind :
       {&MeshErrors::displacement, &MeshErrors::reaction, &MeshErrors::intensity, &MeshErrors::growth_load})
    errors.*kind = caution * differences.back().*kind / (std::exp2(order_of(differences, kind)) - 1);
  return errors;
}

double expected_reduction(const std::vector<MeshErrors>& differences) {
  const MeshErrors errors = estimated(differences);
  auto worst = &MeshErrors::displacement;
  for (const auto kind : {&MeshErrors::reaction, &MeshErrors::intensity})
    if (errors.*kind > errors.*worst) worst = kind;
  return std::exp2(order_of(differences, worst));
}

}  // namespace bempd::model
