#include "model/mesh_answers.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace bempd::model {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

bool is_left_of(const Point& a, const Point& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); }

}  // namespace

std::vector<TipLoad> growth_loads(const PreparedScene& scene, const std::vector<regions::TipValues>& tips,
                                  const std::set<crack::TipId>& frozen, double shift) {
  std::vector<TipLoad> loads;
  const auto add = [&](const crack::TipId& tip, double load) {
    const bool grows = load < std::numeric_limits<double>::max() && !frozen.contains(tip);
    loads.push_back({tip, grows ? shift + load : infinite});
  };
  for (const regions::TipValues& tip : tips) add(tip.id(), tip.toughness > 0 ? tip.critical_load_factor : infinite);
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
  const fracture::LoadedBody& body = scene.evolution->body();
  for (std::size_t s = 0; s < supports; ++s) answers.reactions.push_back(body.supports().reaction(s));
  const std::vector<std::vector<coupling::SharedForce>>& shared = body.supports().dofs().shared;
  answers.supports_share = std::any_of(shared.begin(), shared.end(), [](const auto& own) { return !own.empty(); });
  answers.carried = body.supports().resistance(body.supports().reactions());
  answers.growth_load = infinite;
  for (const TipLoad& one : loads)
    if (one.load_factor < answers.growth_load) answers.growth_load = one.load_factor, answers.first = one.tip;
  answers.loads = std::move(loads);
  answers.tips = std::move(tips);
  return answers;
}

}  // namespace bempd::model
