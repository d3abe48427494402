// Rules by which places open and close, and load factors at which they do.
#include <algorithm>
#include <cmath>

#include "fracture/contact/crack_faces.hpp"
#include "fracture/contact/gap_rule.hpp"

namespace bempd::fracture {

namespace {

// Solutions, iterated ones too, tell displacements to this share of the largest one: gaps below are zero, and so are
// their rates.
constexpr double rounding_of_gaps = 1e-12;

// A gap that is zero in exact numbers while its place is closed has that rounding. Once the place is open the same
// rounding shows in the gap as many times larger as the place was stiffer than what is left, which nothing tells in
// advance. So a gap that has passed zero by less than this share is still zero while it goes back. What is neglected of
// the energy is the square of that. Inside operators what closed faces press may change by more than any displacement
// while the load factor goes by as little: there it is that share of the way.
constexpr double rounding_of_passed_gaps = 1e-8;

// Openings inside operators come from solutions with dense matrices.
constexpr double rounding_of_faces = 1e-10;

// Gaps of one place as they follow the load factor, and the share of the largest ones that counts as zero.
struct GapLine {
  double gap, rate;
  double largest_displacement, largest_rate;
  double rounding;

  // How the gap goes on: negative while it closes.
  double way(double direction) const { return std::abs(rate) <= rounding * largest_rate ? 0 : direction * rate; }
  double faster() const { return std::max(1.0, std::abs(rate) / largest_rate); }
  bool is_wrong(bool closed, double direction) const {
    const double passed = passed_zero(closed, gap), passes = passed_zero(closed, way(direction));
    if (std::abs(gap) <= rounding * largest_displacement) return passes > 0;
    return passed > (passes < 0 ? rounding_of_passed_gaps * largest_displacement * faster() : 0);
  }
};

// Distance on the way in a direction at which the place opens or closes; nothing if it does not.
std::optional<double> distance_to_switch(const GapLine& line, bool closed, double direction) {
  if (line.is_wrong(closed, direction)) return 0;
  const double way = line.way(direction);
  if (closed ? way <= 0 : way >= 0) return std::nullopt;
  return std::max(0.0, -line.gap / way);
}

template <class Visit>
void for_each_face(const coupling::EquilibriumSystem& system, const coupling::Affine& u, double load_factor,
                   const Visit& visit) {
  if (system.face_count() == 0) return;
  const double largest[2] = {u.col(0).lpNorm<Eigen::Infinity>(), u.col(1).lpNorm<Eigen::Infinity>()};
  const double largest_displacement = largest[0] + std::abs(load_factor) * largest[1];
  const coupling::Affine gaps = system.face_gaps(u);
  for (Eigen::Index i = 0; i < gaps.rows(); ++i)
    visit(static_cast<std::size_t>(i), GapLine{gaps(i, 0) + load_factor * gaps(i, 1), gaps(i, 1), largest_displacement,
                                               largest[1], rounding_of_faces});
}

template <class Visit>
void for_each_line(const coupling::Contacts& places, const coupling::Affine& u, double load_factor,
                   const Visit& visit) {
  const double largest[2] = {u.col(0).lpNorm<Eigen::Infinity>(), u.col(1).lpNorm<Eigen::Infinity>()};
  const double largest_displacement = largest[0] + std::abs(load_factor) * largest[1];
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double constant = places[i].gap(u.col(0).data()), rate = places[i].gap(u.col(1).data());
    visit(i, GapLine{constant + load_factor * rate, rate, largest_displacement, largest[1], rounding_of_gaps});
  }
}

}  // namespace

double gap_rounding(double largest_displacement) { return rounding_of_gaps * largest_displacement; }

std::vector<int> wrong_places(const coupling::Contacts& places, const coupling::Affine& displacement,
                              double load_factor, double direction) {
  std::vector<int> wrong;
  if (places.size() == 0) return wrong;
  for_each_line(places, displacement, load_factor, [&](std::size_t i, const GapLine& line) {
    const bool closed = places.is_closed(i);
    if (places.is_barred(i) ? closed : line.is_wrong(closed, direction)) wrong.push_back(static_cast<int>(i));
  });
  return wrong;
}

std::optional<double> next_switch(const coupling::Contacts& places, const coupling::Affine& displacement, double from,
                                  double to) {
  if (places.size() == 0 || from == to) return std::nullopt;
  const double direction = to > from ? 1 : -1, farthest = (to - from) * direction;
  std::optional<double> least;
  for_each_line(places, displacement, from, [&](std::size_t i, const GapLine& line) {
    if (places.is_barred(i)) return;
    const std::optional<double> distance = distance_to_switch(line, places.is_closed(i), direction);
    if (distance && *distance <= farthest && (!least || *distance < *least)) least = distance;
  });
  return least ? std::optional(from + direction * *least) : std::nullopt;
}

double face_rounding(double largest_displacement) { return rounding_of_faces * largest_displacement; }

std::vector<int> wrong_faces(const coupling::EquilibriumSystem& system, const coupling::Affine& displacement,
                             double load_factor, double direction) {
  std::vector<int> wrong;
  for_each_face(system, displacement, load_factor, [&](std::size_t i, const GapLine& line) {
    if (line.is_wrong(system.closed_faces()[i] != 0, direction)) wrong.push_back(static_cast<int>(i));
  });
  return wrong;
}

std::optional<double> next_face_switch(const coupling::EquilibriumSystem& system, const coupling::Affine& displacement,
                                       double from, double to) {
  if (from == to) return std::nullopt;
  const double direction = to > from ? 1 : -1, farthest = (to - from) * direction;
  std::optional<double> least;
  for_each_face(system, displacement, from, [&](std::size_t i, const GapLine& line) {
    const std::optional<double> distance = distance_to_switch(line, system.closed_faces()[i] != 0, direction);
    if (distance && *distance <= farthest && (!least || *distance < *least)) least = distance;
  });
  return least ? std::optional(from + direction * *least) : std::nullopt;
}

}  // namespace bempd::fracture
