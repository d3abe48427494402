#include <algorithm>
#include <cmath>

#include "even_cuts.hpp"
#include "rules.hpp"

namespace directions {
namespace {

// Bonds break one by one, or soften tooth by tooth, by their own stretch, by the mean strain in their direction, by a
// mixture of both, or by the energy that breaking them releases over their own fracture energy.
class BondRule final : public Rule {
 public:
  BondRule(const Setting& setting, const Body& body, Window& window, unsigned seed)
      : setting_(setting),
        body_(body),
        window_(window),
        mean_(body, window, setting.radius * body.horizon),
        tooth_(body.bonds.size(), 0),
        factor_(body.bonds.size(), 1) {
    std::mt19937 random(seed + 77);
    std::normal_distribution<double> normal(0, 1);
    for (double& f : factor_) f = 1 + setting.scatter * std::clamp(normal(random), -2.0, 2.0);
    if (setting.even != 0) {
      const std::vector<double> even = even_stretches(body);
      for (std::size_t k = 0; k < factor_.size(); ++k)
        factor_[k] *= std::sqrt(1 + setting.even * (even[k] * even[k] - 1));
    }
    if (setting.release != 0) window.keep_compliances();
    teeth();
  }

  Event next() override {
    if (setting_.mix > 0 && setting_.radius > 0) mean_.update();
    int worst = -1;
    double largest = 0;
    for (const int k : window_.bonds()) {
      if (window_.stiffness(k) <= 0) continue;
      const std::size_t b = static_cast<std::size_t>(k);
      const double ratio = measure(k) / (factor_[b] * critical_[static_cast<std::size_t>(tooth_[b])]);
      if (ratio > largest) largest = ratio, worst = k;
    }
    Event event;
    if (worst < 0) return event.finished = true, event;
    event.load = 1 / largest;
    const std::size_t b = static_cast<std::size_t>(worst);
    const bool last = ++tooth_[b] == setting_.teeth;
    event.losses.push_back({worst, last ? window_.stiffness(worst) : body_.bonds[b].stiffness / setting_.teeth});
    return event;
  }

 private:
  double measure(int k) const {
    const double own = window_.stretch(k);
    const Bond& bond = body_.bonds[static_cast<std::size_t>(k)];
    if (setting_.release != 0)  // over the energy of a bond at stretch one
      return own > 0 ? std::sqrt(2 * window_.release_of(k) / bond.stiffness) / bond.length : 0;
    if (setting_.radius == 0) return own;
    const Eigen::Vector3d s = (mean_.at(bond.first) + mean_.at(bond.second)) / 2;
    const Eigen::Vector3d strain(9.0 / 8 * (s[0] - s[1] / 3), 9.0 / 8 * (s[1] - s[0] / 3), 1.5 * s[2]);
    const Point e = bond.direction;
    const double along = e.x() * e.x() * strain[0] + e.y() * e.y() * strain[1] + 2 * e.x() * e.y() * strain[2];
    return own > 0 ? setting_.mix * along + (1 - setting_.mix) * own : 0;
  }

  // Stretches at which a bond of falling stiffness meets linear softening, the energy of a bond kept.
  void teeth() {
    const int n = setting_.teeth;
    double energy = 0;
    for (int t = 0; t < n; ++t) {
      const double left = 1 - static_cast<double>(t) / n;
      critical_.push_back(setting_.ductility / (left * (setting_.ductility - 1) + 1));
      energy += critical_.back() * critical_.back() / n;
    }
    for (double& s : critical_) s *= body_.critical_stretch / std::sqrt(energy);
  }

  const Setting& setting_;
  const Body& body_;
  Window& window_;
  MeanStress mean_;
  std::vector<int> tooth_;
  std::vector<double> factor_, critical_;
};

}  // namespace

std::unique_ptr<Rule> bond_rule(const Setting& setting, const Body& body, Window& window, unsigned seed) {
  return std::make_unique<BondRule>(setting, body, window, seed);
}

std::unique_ptr<Rule> make_rule(const Setting& setting, const Body& body, Window& window, unsigned seed) {
  if (setting.rule == "facet") return facet_rule(setting, body, window);
  if (setting.rule == "line") return line_rule(setting, body, window);
  return bond_rule(setting, body, window, seed);
}

}  // namespace directions
