#include "model/state_checks.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "error.hpp"
#include "model/state_members.hpp"
#include "regions/patches.hpp"

namespace bempd::model {

namespace {

// Visitor of the members of a state. It checks whether all numbers are finite or as the list of members allows, and
// whether flags are 0 or 1.
class NumberCheck {
 public:
  static constexpr int format = state_format;
  bool passed() const { return passed_; }

  template <class Number>
  requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
  void operator()(const Number& number, Allowed allowed = Allowed::finite) {
    if constexpr (std::is_floating_point_v<Number>)
      passed_ &=
          std::isfinite(number) || allowed == Allowed::unknown || (allowed == Allowed::infinite && !std::isnan(number));
    if constexpr (std::is_same_v<Number, char>) passed_ &= number == 0 || number == 1;
  }
  template <class Values>
  requires requires(const Values& values) { values.data(); }
  void operator()(const Values& values, Allowed allowed = Allowed::finite) {
    for (auto one = values.data(); one != values.data() + values.size(); ++one)
      if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(*one)>>)
        (*this)(*one, allowed);
      else
        (*this)(*one);
  }
  template <class Struct>
  requires requires(const Struct& one, NumberCheck& check) { visit_members(one, check); }
  void operator()(const Struct& one) { visit_members(one, *this); }
  void operator()(const scene::Values& values) {
    if (const auto* samples = std::get_if<scene::SampledValues>(&values)) visit_members(*samples, *this);
    if (const auto* placed = std::get_if<scene::PlacedValues>(&values)) visit_members(*placed, *this);
  }
  template <class T>
  void operator()(const std::optional<T>& one) {
    if (one) (*this)(*one);
  }

 private:
  bool passed_ = true;
};

bool is_sound(const coupling::HoldingSpring& s, Eigen::Index dofs) {
  return s.node >= 0 && 2 * static_cast<Eigen::Index>(s.node) < dofs &&
         std::abs(std::hypot(s.cosine, s.sine) - 1) < 1e-6 && s.stiffness > 0;
}

bool is_sound(const fracture::CrackExtension& e) {
  return e.crack >= 1 && (e.end == 0 || e.end == 1) && e.state <= crack::TipState::separated;
}

void sound(bool good, const char* what) { require(good, "the bytes of the state are damaged: ", what); }

template <class Parts>
bool are_values(const Parts& parts) {
  return !parts.constant.empty() && parts.constant.size() == parts.proportional.size();
}

bool is_sound(const scene::Values& values) {
  if (const auto* samples = std::get_if<scene::SampledValues>(&values)) {
    const bool removed = samples->constant.empty() && samples->proportional.empty();
    return removed || are_values(*samples);
  }
  const auto* placed = std::get_if<scene::PlacedValues>(&values);
  if (!placed) return true;
  const std::vector<double>& fractions = placed->fractions;
  const auto falls = [](double one, double next) { return !(one < next); };
  return are_values(*placed) && placed->constant.size() == 2 * fractions.size() &&
         std::adjacent_find(fractions.begin(), fractions.end(), falls) == fractions.end() && fractions.front() >= 0 &&
         fractions.back() <= 1;
}

void require_consistent(const fracture::EvolutionState& e) {
  const Eigen::Index dofs = e.total_displacement.size();
  sound(dofs % 2 == 0 && e.displacement.rows() == dofs && e.total_force.size() == dofs &&
            2 * static_cast<Eigen::Index>(e.unloaded.size()) == dofs,
        "its arrays are not of the same nodes");
  sound(e.events >= 0 && e.broken_bonds >= 0 && e.fragments >= 0 && e.contact_switches >= 0 && e.ties >= 0,
        "a count is negative");
  sound(std::all_of(e.springs.begin(), e.springs.end(), [&](const auto& spring) { return is_sound(spring, dofs); }),
        "a spring that holds a free piece is at no node or no spring");
  sound(std::all_of(e.history.begin(), e.history.end(),
                    [](const auto& line) { return line.event >= 0 && line.total_broken_bonds >= 0; }),
        "a line of the history is none");
  sound(e.reactions_before.size() == e.reactions.size() && e.support_displacements.size() == e.reactions.size(),
        "what its supports exert and how they move is not of the same lines");
  sound(e.history.empty() ? e.reactions.empty() : e.reactions.size() % (2 * e.history.size()) == 0,
        "its reactions are not those of the lines of its history");
  const auto grown = [](std::int64_t layout) { return regions::extensions_before(layout); };
  sound(std::ranges::is_sorted(e.layouts, {}, grown) &&
            (e.layouts.empty() || grown(e.layouts.back()) <= e.extensions.size()),
        "a lattice patch has grown by no extension");
  sound(std::all_of(e.extensions.begin(), e.extensions.end(), [](const auto& one) { return is_sound(one); }),
        "an extension of a crack is none");
}

}  // namespace

void require_consistent(const SavedState& state) {
  NumberCheck numbers;
  numbers(state);
  sound(numbers.passed(), "a number is not finite, or a flag is neither 0 nor 1");
  sound(state.acting <= Acting::on_path && (state.acting != Acting::on_path || state.in_force),
        "it has no values between which it is");
  sound(state.frozen.empty() || (state.host_values && state.frozen.size() % 2 == 0),
        "it keeps tips without saying which");
  for (std::size_t k = 1; k < state.frozen.size(); k += 2)
    sound(state.frozen[k - 1] > 0 && (state.frozen[k] == 0 || state.frozen[k] == 1), "a tip that it keeps is none");
  require_consistent(state.evolution);
  for (const std::optional<scene::SceneValues>& both :
       {state.in_force, std::optional(state.acting_values), state.host_values}) {
    if (!both) continue;
    for (const std::vector<scene::Values>& all : {both->supports, both->loads})
      for (const scene::Values& values : all) sound(is_sound(values), "the values of a load or a support are none");
  }
}

bool is_sound(const fracture::GrowingTip& tip) {
  const auto is_ratio = [](double ratio) { return ratio >= 0 && std::isfinite(ratio); };
  return tip.place.allFinite() && std::abs(tip.direction.norm() - 1) < 1e-6 && tip.law >= 0 && tip.id.crack >= 1 &&
         (tip.id.end == 0 || tip.id.end == 1) && std::isfinite(tip.even_ahead.value_or(0)) && tip.grown >= 0 &&
         std::isfinite(tip.grown) && tip.state <= crack::TipState::carried_on &&
         std::all_of(tip.energy_ratios.begin(), tip.energy_ratios.end(), is_ratio);
}

void require_same_ends(const SavedState& saved, const regions::LatticeCracks& cracks) {
  const bool are_placed = std::ranges::any_of(cracks.even_ahead, [](const auto& ends) { return ends[0] || ends[1]; });
  require(saved.format > 15 || !are_placed, "the state has format version ", saved.format,
          ", in which initial cracks of lattices acted up to 0.6 spacings longer; repeat the run, or go on with the "
          "version of bempd that wrote it");
}

void require_nearby(const std::vector<crack::Extension>& extensions, const Box& scene) {
  const double margin = scene.diagonal().norm();
  const auto is_near = [&](double x, double y) { return scene.exteriorDistance(Point(x, y)) <= margin; };
  require(
      std::ranges::all_of(extensions, [&](const auto& e) { return is_near(e.x, e.y) && is_near(e.from_x, e.from_y); }),
      "cracks of the state have grown far outside of the scene; its bytes were altered");
}

}  // namespace bempd::model
