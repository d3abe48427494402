#include "model/explanation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "error.hpp"
#include "model/element_growth.hpp"
#include "model/model.hpp"
#include "model/stepping_options.hpp"

namespace bempd::model {

namespace {

std::string name_of(const crack::TipId& tip) {
  return text("crack ", tip.crack, " at its ", tip.end == 0 ? "start" : "end");
}

std::string place_of(const Point& place) { return text("(", place.x(), ", ", place.y(), ")"); }

// Load factor at which a tip grows if the load factor rises (`upwards`) or falls; infinite if the tip never grows, NaN
// if unknown.
double critical_load_factor(const regions::TipValues& tip, bool upwards) {
  const double critical = upwards ? tip.critical_load_factor : tip.critical_load_factor_down;
  return std::abs(critical) == std::numeric_limits<double>::max()
             ? std::copysign(std::numeric_limits<double>::infinity(), critical)
             : critical;
}

bool breaks(const scene::Material& material) {
  return material.fracture_energy > 0 || (material.critical_stretch > 0 && std::isfinite(material.critical_stretch));
}

// Collects sentences; a sentence that is added twice appears once.
class Reasons {
 public:
  void add(const std::string& sentence) {
    if (known_.insert(sentence).second) text_ += (text_.empty() ? "" : " ") + sentence;
  }
  const std::string& text() const { return text_; }

 private:
  std::set<std::string> known_;
  std::string text_;
};

class Explainer {
 public:
  Explainer(Model& model, bool upwards)
      : model_(model),
        scene_(model.scene()),
        upwards_(upwards),
        evolution_(*model.in_equilibrium().evolution),
        stepping_(stepping_options(model.options())) {}

  Explanation explain() {
    find_tip();
    find_bond();
    Reasons reasons;
    reasons.add(what_is_next());
    tell_of_body(reasons);
    for (const regions::TipValues& tip : model_.cracks().tips()) tell_of_tip(tip, reasons);
    tell_of_ended(reasons);
    tell_of_cycles(reasons);
    found_.text = reasons.text();
    return found_;
  }

 private:
  bool is_before(double one, double other) const { return upwards_ ? one < other : one > other; }

  // Whether a tip grows by itself in the current stepping mode. In the mode of load increments no tip does. In a
  // lattice only the tip of a crack line does; where cracks grow bond by bond, tips are only read from broken bonds.
  bool grows(const regions::TipValues& tip) const {
    if (stepping_.mode != fracture::SteppingMode::events) return false;
    return tip.method == regions::TipMethod::elements || evolution_.lines() != nullptr;
  }

  // Finds the tip that grows next and its load factor. If the load factor is held constant, an overloaded tip grows at
  // the present load factor.
  void find_tip() {
    const bool is_held = stepping_.control == fracture::Control::load;
    for (const regions::TipValues& tip : model_.cracks().tips()) {
      if (!grows(tip)) continue;
      const crack::TipId id = tip.id();
      const double critical = critical_load_factor(tip, upwards_);
      if (!std::isfinite(critical) || model_.growth().is_frozen(id)) continue;
      const double present = model_.load_factor();
      const double at = is_held && is_before(critical, present) ? present : critical;
      if (found_.next == Explanation::Next::tip && !is_before(at, found_.load_factor)) continue;
      found_.next = Explanation::Next::tip;
      found_.tip = id, found_.place = tip.place, found_.load_factor = at;
      found_.ratio = law_of(tip, model_.options()).ratio(factors_of(tip), present);
    }
  }

  void find_bond() {
    const std::optional<fracture::NextBond> bond = evolution_.next_bond(upwards_, stepping_.control);
    if (!bond) return;
    if (found_.next == Explanation::Next::tip && !is_before(bond->load_factor, found_.load_factor)) return;
    const auto term = static_cast<std::size_t>(bond->term);
    const coupling::Terms& terms = model_.prepared().system->terms();
    const std::vector<Point>& positions = model_.prepared().discretization.positions;
    const int first = terms.first[term], second = terms.second[term];
    found_ = {};
    found_.next = Explanation::Next::bond;
    found_.place = 0.5 * (positions[static_cast<std::size_t>(first)] + positions[static_cast<std::size_t>(second)]);
    found_.load_factor = bond->load_factor, found_.ratio = bond->ratio;
    for (const auto& region : model_.prepared().discretization.regions) {
      const std::vector<int>& nodes = region->nodes();
      const bool has_bonds = !scene_.region(region->id()).has_elements();
      if (has_bonds && std::find(nodes.begin(), nodes.end(), first) != nodes.end()) found_.region = region->id();
    }
  }

  std::string what_is_next() const {
    const char* const way = upwards_ ? "rises" : "falls";
    const double present = model_.load_factor();
    switch (found_.next) {
      case Explanation::Next::tip:
        return text("While the load factor ", way, " from ", present, ", ", name_of(found_.tip), ", ",
                    place_of(found_.place), ", grows next, at ", found_.load_factor, "; its load is ", found_.ratio,
                    " of its toughness.");
      case Explanation::Next::bond:
        return text("While the load factor ", way, " from ", present, ", a bond of region ", found_.region, " at ",
                    place_of(found_.place), " breaks next, at ", found_.load_factor, "; its stretch is ", found_.ratio,
                    " of the critical one.");
      case Explanation::Next::nothing:
        break;
    }
    return text("Nothing breaks or grows while the load factor ", way, " from ", present, ", however far.");
  }

  void tell_of_body(Reasons& reasons) const {
    if (evolution_.progress().separated) reasons.add("The body is separated.");
    bool has_bonds = false;
    for (const int id : scene_.region_ids()) {
      if (scene_.region(id).has_elements()) continue;
      has_bonds = true;
      if (!breaks(scene_.material_of(id)))
        reasons.add(text("Region ", id, " does not break: material ", scene_.region(id).material(),
                         " has neither a fracture energy nor a critical stretch."));
    }
    if (!has_bonds && model_.cracks().count() == 0)
      reasons.add("The body is of boundary elements alone and has no crack: such a body does not break.");
    const coupling::Affine& displacement = evolution_.state().displacement;
    if (displacement.col(1).isZero(0))
      reasons.add("No load and no support moves the body in proportion to the load factor.");
  }

  void tell_of_tip(const regions::TipValues& tip, Reasons& reasons) const {
    if (!grows(tip)) return;
    const crack::TipId id = tip.id();
    const std::string which = "The tip of " + name_of(id);
    if (model_.growth().is_frozen(id)) return reasons.add(which + " is frozen by bempd_set_tip_frozen().");
    const double critical = critical_load_factor(tip, upwards_);
    if (std::isfinite(critical)) return;
    if (has_stopped(id, evolution_.progress())) return reasons.add(which + " has stopped before an interface.");
    if (std::isnan(critical)) return reasons.add(which + " has stress intensity factors that are not known.");
    if (!(tip.toughness > 0) || std::isinf(tip.toughness))
      return reasons.add(which + " lies in a material without a fracture energy.");
    if (tip.proportional_factors.isZero(0))
      return reasons.add(which + " is not loaded in proportion to the load factor.");
    if (tip.proportional_factors.x() * (upwards_ ? 1 : -1) <= 0)
      return reasons.add(which + " is pressed shut on this way of the load factor.");
    reasons.add(which + " does not reach its toughness on this way of the load factor.");
  }

  // Tells of tips that have ended. They are not among the model's tips, but their last extensions say where they ended.
  void tell_of_ended(Reasons& reasons) const {
    for (const fracture::CrackExtension& e : model_.cracks().extensions()) {
      const char* where = nullptr;
      switch (e.state) {
        case crack::TipState::at_edge:
          where = "an edge of the body";
          break;
        case crack::TipState::at_hole:
          where = "a hole";
          break;
        case crack::TipState::at_crack:
          where = "another crack";
          break;
        default:
          break;
      }
      if (where) reasons.add(text("The tip of ", name_of(e.tip()), " has ended at ", where, "."));
    }
  }

  // Records of growing tips at the end of the last growth by cycles, without cracks that have changed since.
  std::vector<FatigueRecord> grown_by_cycles() const {
    std::vector<FatigueRecord> last;
    for (const FatigueRecord& record : model_.fatigue().records()) {
      if (!last.empty() && last.front().step != record.step) last.clear();
      last.push_back(record);
    }
    const std::vector<FatigueRecord> all = last;
    const auto is_there = [&](const FatigueRecord& record) {
      if (record.tip.crack > model_.cracks().count()) return false;
      const std::vector<crack::PathVertex> path = model_.cracks().path(record.tip.crack);
      const Point& end = record.tip.end == 0 ? path.front().place : path.back().place;
      return (end - record.place).norm() <= 1e-9 * record.length;
    };
    std::erase_if(last, [&](const FatigueRecord& record) {
      return !(record.rate > 0) || std::ranges::any_of(all, [&](const FatigueRecord& one) {
        return one.tip.crack == record.tip.crack && !is_there(one);
      });
    });
    return last;
  }

  // Tells which tip limits the life: the tip that grows fastest in relation to the length of its crack.
  void tell_of_cycles(Reasons& reasons) const {
    std::vector<FatigueRecord> tips = grown_by_cycles();
    if (tips.empty()) return;
    const auto speed = [](const FatigueRecord& record) { return record.rate / record.length; };
    std::stable_sort(tips.begin(), tips.end(), [&](const auto& a, const auto& b) { return speed(a) > speed(b); });
    const FatigueRecord& first = tips.front();
    std::string sentence = text("By cycles, ", name_of(first.tip), ", ", place_of(first.place),
                                ", limits the life where the last growth by cycles has ended: it grows by ", first.rate,
                                " in a cycle, with K_max = ", first.highest);
    if (tips.size() > 1)
      sentence += text("; in relation to the length of its crack that is ", speed(first) / speed(tips[1]),
                       " times the growth of the next tip, ", name_of(tips[1].tip));
    reasons.add(sentence + ".");
  }

  Model& model_;
  const scene::Scene& scene_;
  bool upwards_;
  fracture::CrackEvolution& evolution_;
  fracture::SteppingOptions stepping_;
  Explanation found_;
};

}  // namespace

Explanation explain(Model& model, bool upwards) { return Explainer(model, upwards).explain(); }

}  // namespace bempd::model
