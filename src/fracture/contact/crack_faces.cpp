#include "fracture/contact/crack_faces.hpp"

#include <algorithm>
#include <cmath>

#include "fracture/contact/gap_rule.hpp"
#include "linalg/symmetric_modes.hpp"

namespace bempd::fracture {

using coupling::Constraint;
using coupling::Constraints;

namespace {

// Distance in spacings around a contact place, about a horizon: broken bonds between neighbouring points within this
// distance determine the direction of the crack.
constexpr double normal_reach = 3.6;

// Ratio of spreads of the middles of broken bonds, across their principal axis to along it. With a larger ratio these
// bonds determine no direction of the crack.
constexpr double no_axis = 0.4;

// Least ratio of the component of a bond across the crack to the bond's length. With a smaller ratio the broken bond
// gets no contact place.
constexpr double least_share_across = 0.2;

std::uint64_t cell_of(const Point& p, double size, int right, int up) {
  const auto x = static_cast<std::int64_t>(std::floor(p.x() / size)) + right;
  const auto y = static_cast<std::int64_t>(std::floor(p.y() / size)) + up;
  return static_cast<std::uint64_t>(x) << 32 ^ static_cast<std::uint32_t>(y);
}

Constraint constraint_of(const pd::FacePlace& place) {
  Constraint constraint{{}, place.stiffness};
  for (const pd::FacePlace::Pull& p : place.pulls) constraint.pull.push_back({p.node, p.pull.x(), p.pull.y()});
  return constraint;
}

}  // namespace

CrackFaces::CrackFaces(coupling::EquilibriumSystem& system, const std::vector<Point>& positions, ContactPlan plan,
                       const std::vector<int>& cut)
    : system_(system), positions_(positions), plan_(std::move(plan)) {
  if (are_none()) return;
  for (std::size_t k = 0; k < plan_.lattices.lattice_count(); ++k)
    reach_ = std::max(k == 0 ? 0 : reach_, normal_reach * plan_.lattices.spacing(static_cast<int>(k)));
  for (const int term : cut) {
    if (can_be_a_place(term)) cut_.push_back(term);
  }
  restore({});
}

bool CrackFaces::can_be_a_place(int term) const {
  if (system_.terms().is_wide(static_cast<std::size_t>(term))) return false;
  return plan_.lattices.lattice_of_neighbours(system_.terms().first[term], system_.terms().second[term]).has_value();
}

bool CrackFaces::can_have(const GrownFace& face) const {
  const Point normal(face.normal_x, face.normal_y);
  return !are_none() && std::abs(normal.norm() - 1) < 1e-6 && can_be_a_place(face.term) &&
         constraint_at(face.term, normal).has_value();
}

Point CrackFaces::middle(int term) const {
  return 0.5 * (positions_[system_.terms().first[term]] + positions_[system_.terms().second[term]]);
}

double CrackFaces::spacing(int term) const { return system_.terms().length[term]; }

void CrackFaces::count_for_normals(int term) {
  if (counted_.insert(term).second) broken_near_[cell_of(middle(term), reach_, 0, 0)].push_back(term);
}

void CrackFaces::stop_counting(int term) {
  if (counted_.erase(term) > 0) std::erase(broken_near_[cell_of(middle(term), reach_, 0, 0)], term);
}

std::vector<int> CrackFaces::near(int term) const {
  const Point place = middle(term);
  std::vector<int> found;
  for (int right = -1; right <= 1; ++right) {
    for (int up = -1; up <= 1; ++up) {
      const auto cell = broken_near_.find(cell_of(place, reach_, right, up));
      if (cell == broken_near_.end()) continue;
      for (const int other : cell->second)
        if ((middle(other) - place).norm() < normal_reach * spacing(term)) found.push_back(other);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Normal of the contact place at a broken bond: perpendicular to the principal axis of the middles of the broken bonds
// around (`others`), and towards the bond's second end. If these bonds determine no axis, the normal is along the bond.
Point CrackFaces::normal_at(int term, std::span<const int> others) const {
  const Point along(system_.terms().cosine[term], system_.terms().sine[term]);
  if (others.size() < 2) return along;
  Point mean = Point::Zero();
  for (const int other : others) mean += middle(other) / static_cast<double>(others.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const int other : others) {
    const Point away = middle(other) - mean;
    spread += away * away.transpose();
  }
  const linalg::SymmetricModes modes = linalg::symmetric_modes(spread);
  if (modes.values[0] > no_axis * no_axis * modes.values[1]) return along;
  const Point normal = modes.vectors.col(0);
  return normal.dot(along) < 0 ? Point(-normal) : normal;
}

std::optional<Constraint> CrackFaces::constraint_at(int term, const Point& normal) const {
  const coupling::Terms& terms = system_.terms();
  const Point along(terms.cosine[term], terms.sine[term]);
  const double across = std::abs(normal.dot(along));
  if (across < least_share_across) return std::nullopt;
  // Length of crack that each contact place stands for [spacings]: a straight crack breaks a bond between neighbours at
  // each row and each column of points that it crosses.
  const double length = 1 / (across + std::abs(cross(normal, along)));
  const int lattice = *plan_.lattices.lattice_of_neighbours(terms.first[term], terms.second[term]);
  const auto place = plan_.lattices.at(lattice, middle(term), normal, length);
  return place ? std::optional(constraint_of(*place)) : std::nullopt;
}

void CrackFaces::note_broken(std::span<const int> terms, FaceState& state) {
  if (are_none()) return;
  pending_.emplace_back(terms.begin(), terms.end());
  state.pending.push_back(pending_.back());
}

std::vector<int> CrackFaces::newly_broken(std::span<const int> terms) const {
  std::vector<int> found;
  for (const int term : terms) {
    if (!system_.stages().intact()[term] && !counted_.contains(term) && can_be_a_place(term)) found.push_back(term);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

// Contact places of the body itself (not of a forecast), updated at a displacement of the body.
class CrackFaces::PresentPlaces final : public FacePlaces {
 public:
  PresentPlaces(CrackFaces& faces, const Eigen::VectorXd& displacement, FaceState& state)
      : faces_(faces), displacement_(displacement), state_(state) {}

  std::optional<std::size_t> place_of(int term) const override {
    const auto found = faces_.grown_.find(term);
    return found == faces_.grown_.end() ? std::nullopt : std::optional(faces_.first_grown() + found->second);
  }
  bool is_closed(std::size_t place) const override { return faces_.constraints().is_closed(place); }

  void add(const GrownFace& face, Constraint constraint) override {
    faces_.grown_[face.term] = state_.grown.size();
    state_.grown.push_back(face);
    state_.closed.push_back(0);
    faces_.system_.contact().add(std::move(constraint));
  }

  void renew(std::size_t place, const GrownFace& face, Constraint constraint) override {
    GrownFace& known = state_.grown[place - faces_.first_grown()];
    if (face.normal_x == known.normal_x && face.normal_y == known.normal_y) return;
    const double largest = displacement_.lpNorm<Eigen::Infinity>();
    if (is_wrong(constraint, false, constraint.gap(displacement_.data()), largest)) return;
    known = face;
    faces_.system_.contact().replace_open(place, std::move(constraint));
  }

 private:
  CrackFaces& faces_;
  const Eigen::VectorXd& displacement_;
  FaceState& state_;
};

// Broken bonds near the given terms, which may get a contact place or another normal. Bonds that initial cracks cut are
// left out.
std::vector<int> CrackFaces::places_affected(std::span<const int> terms) const {
  std::vector<int> found;
  for (const int term : terms) {
    const std::vector<int> some = near(term);
    found.insert(found.end(), some.begin(), some.end());
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::erase_if(found, [&](int term) { return std::binary_search(cut_.begin(), cut_.end(), term); });
  return found;
}

void CrackFaces::update(const Eigen::VectorXd& displacement, FaceState& state) {
  PresentPlaces places(*this, displacement, state);
  for (const std::vector<int>& terms : pending_) follow(terms, places);
  pending_.clear();
  state.pending.clear();
}

std::vector<int> CrackFaces::follow(std::span<const int> broken, FacePlaces& places) {
  if (are_none()) return {};
  std::vector<int> terms = newly_broken(broken);
  for (const int term : terms) count_for_normals(term);
  for (const int term : places_affected(terms)) {
    const std::optional<std::size_t> place = places.place_of(term);
    if (place && places.is_closed(*place)) continue;
    const Point normal = normal_at(term, near(term));
    std::optional<Constraint> constraint = constraint_at(term, normal);
    if (!constraint) continue;
    const GrownFace face{term, normal.x(), normal.y()};
    if (place) {
      places.renew(*place, face, std::move(*constraint));
    } else {
      places.add(face, std::move(*constraint));
    }
  }
  return terms;
}

void CrackFaces::forget_terms(std::span<const int> terms) {
  for (const int term : terms) stop_counting(term);
}

Constraints CrackFaces::constraints_of(const FaceState& state) const {
  Constraints constraints(system_.constraints().exact_count());
  for (const pd::FacePlace& place : plan_.initial) constraints.add(constraint_of(place));
  for (const GrownFace& face : state.grown) {
    if (auto constraint = constraint_at(face.term, {face.normal_x, face.normal_y}))
      constraints.add(std::move(*constraint));
  }
  for (std::size_t i = 0; i < std::min(constraints.size(), state.closed.size()); ++i)
    constraints.set_closed(i, state.closed[i] != 0);
  return constraints;
}

void CrackFaces::restore(const FaceState& state) {
  system_.contact().set(constraints_of(state));
  take_over(state);
}

void CrackFaces::go_on_from(const FaceState& state) {
  system_.contact().set_without_factor(constraints_of(state));
  take_over(state);
}

void CrackFaces::take_over(const FaceState& state) {
  if (are_none()) return;
  broken_near_.clear(), counted_.clear(), grown_.clear();
  for (const int term : cut_) count_for_normals(term);
  for (std::size_t i = 0; i < state.grown.size(); ++i) {
    grown_[state.grown[i].term] = i;
    count_for_normals(state.grown[i].term);
  }
  pending_ = state.pending;
  std::unordered_set<int> pending;
  for (const std::vector<int>& terms : pending_) pending.insert(terms.begin(), terms.end());
  for (std::size_t t = 0; t < system_.terms().size(); ++t) {
    const int term = static_cast<int>(t);
    if (!system_.stages().intact()[t] && !pending.contains(term) && can_be_a_place(term)) count_for_normals(term);
  }
}

}  // namespace bempd::fracture
