#include "model/state_checks.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "error.hpp"

namespace bempd::model {

namespace {

bool are_flags(const std::vector<char>& values) {
  return std::all_of(values.begin(), values.end(), [](char flag) { return flag == 0 || flag == 1; });
}

bool is_sound(const coupling::HoldingSpring& s, Eigen::Index dofs) {
  return s.node >= 0 && 2 * static_cast<Eigen::Index>(s.node) < dofs &&
         std::abs(std::hypot(s.cosine, s.sine) - 1) < 1e-6 && s.stiffness > 0 && std::isfinite(s.stiffness) &&
         std::isfinite(s.anchor);
}

bool are_finite(std::initializer_list<double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); });
}

// Checks a line of the history: all its numbers are finite, because energies beyond the range of numbers are written as
// the largest number (in_range).
bool is_sound(const fracture::HistoryEntry& h) {
  return h.event >= 0 && h.total_broken_bonds >= 0 &&
         are_finite({h.load_factor, h.stretch_ratio, h.stored_energy, h.released_energy, h.work, h.energy_balance_error,
                     h.residual, h.critical_load_factor, h.critical_stored_energy, h.bond_energy, h.load_factor_before,
                     h.stored_energy_before, h.work_before, h.resistance_before, h.resistance});
}

// Checks an extension. Stress intensity factors and energy release rates may be NaN, where they are not known.
bool is_sound(const fracture::CrackExtension& e) {
  return e.crack >= 1 && (e.end == 0 || e.end == 1) && e.state <= crack::TipState::separated &&
         are_finite({e.x, e.y, e.from_x, e.from_y, e.angle, e.length, e.crack_length, e.load_factor}) &&
         !std::isnan(e.released_energy) && !std::isnan(e.resistance);
}

bool is_sound(const fracture::Sums& s) {
  return are_finite({s.released_energy, s.bond_energy, s.work, s.largest_work, s.worst_energy_balance_error, s.residual,
                     s.resistance.present, s.resistance.peak, s.resistance.stiffness, s.work_out_of_balance});
}

void sound(bool good, const char* what) { require(good, "the bytes of the state are damaged: ", what); }

template <class Parts>
bool are_values(const Parts& parts) {
  const auto finite = [](double value) { return std::isfinite(value); };
  return !parts.constant.empty() && parts.constant.size() == parts.proportional.size() &&
         std::all_of(parts.constant.begin(), parts.constant.end(), finite) &&
         std::all_of(parts.proportional.begin(), parts.proportional.end(), finite);
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
  sound(std::isfinite(e.load_factor) && e.displacement.allFinite() && e.total_displacement.allFinite() &&
            e.total_force.allFinite(),
        "a displacement or a force is not a finite number");
  sound(e.events >= 0 && e.broken_bonds >= 0 && e.fragments >= 0 && e.contact_switches >= 0 && e.ties >= 0,
        "a count is negative");
  sound(is_sound(static_cast<const fracture::Sums&>(e)) && !std::isnan(e.first_unit_energy) &&
            std::isfinite(e.largest_force),
        "a sum of its run is not a finite number");
  sound(are_flags(e.unloaded) && are_flags(e.faces.closed), "a flag is neither 0 nor 1");
  sound(std::all_of(e.springs.begin(), e.springs.end(), [&](const auto& spring) { return is_sound(spring, dofs); }),
        "a spring that holds a free piece is at no node or no spring");
  sound(std::all_of(e.history.begin(), e.history.end(), [](const auto& line) { return is_sound(line); }),
        "a line of the history is none");
  sound(e.reactions_before.size() == e.reactions.size() && e.support_displacements.size() == e.reactions.size(),
        "what its supports exert and how they move is not of the same lines");
  sound(e.history.empty() ? e.reactions.empty() : e.reactions.size() % (2 * e.history.size()) == 0,
        "its reactions are not those of the lines of its history");
  sound(std::all_of(e.reactions.begin(), e.reactions.end(), [](double force) { return std::isfinite(force); }),
        "a reaction is not a finite number");
  sound(std::none_of(e.reactions_before.begin(), e.reactions_before.end(), [](double f) { return std::isnan(f); }),
        "a reaction before an event is not a number");
  sound(std::all_of(e.extensions.begin(), e.extensions.end(), [](const auto& one) { return is_sound(one); }),
        "an extension of a crack is none");
}

}  // namespace

void require_consistent(const SavedState& state) {
  sound(state.acting <= Acting::on_a_way && (state.acting != Acting::on_a_way || state.in_force),
        "it has no values between which it is");
  sound(std::isfinite(state.end_of_way), "a load factor is not a finite number");
  sound(state.frozen.empty() || (state.said && state.frozen.size() % 2 == 0), "it keeps tips without saying which");
  for (std::size_t k = 1; k < state.frozen.size(); k += 2)
    sound(state.frozen[k - 1] > 0 && (state.frozen[k] == 0 || state.frozen[k] == 1), "a tip that it keeps is none");
  require_consistent(state.evolution);
  for (const std::optional<scene::SceneValues>& both :
       {state.in_force, std::optional(state.acting_values), state.said}) {
    if (!both) continue;
    for (const std::vector<scene::Values>& all : {both->supports, both->loads})
      for (const scene::Values& values : all) sound(is_sound(values), "the values of a load or a support are none");
  }
}

}  // namespace bempd::model
