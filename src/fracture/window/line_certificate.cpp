#include "fracture/window/line_certificate.hpp"

#include <algorithm>
#include <limits>

#include "cancellation.hpp"
#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

LineCertificate::LineCertificate(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                                 const StretchRatios& ratios, const LineSteps& steps)
    : condensation_(condensation), steps_(steps) {
  const coupling::Terms& terms = system.terms();
  for (std::size_t b = 0; b < terms.size(); ++b) {
    if (!system.stages().intact()[b] || terms.is_wide(b) || ratios.scales().per_elongation[b] == 0) continue;
    bonds_.push_back(static_cast<int>(b));
    first_.push_back(2 * terms.first[b]);
    second_.push_back(2 * terms.second[b]);
    cosine_.push_back(ratios.scales().cosine[b]);
    sine_.push_back(ratios.scales().sine[b]);
  }
}

bool LineCertificate::is_guarded(std::size_t bond, const Step& step) const {
  return std::any_of(step.growing.begin(), step.growing.end(),
                     [&](const GrowingTip& tip) { return steps_.guard().is_guarded(bonds_[bond], tip); });
}

int LineCertificate::first_break(const std::vector<coupling::Affine>& states, const std::vector<Step>& steps) const {
  const int count = static_cast<int>(steps.size());
  std::vector<int> broken_at(bonds_.size(), std::numeric_limits<int>::max());
  for (int s = count; s-- > 0;) {
    for (const coupling::StageChange& change : *steps[static_cast<std::size_t>(s)].changes) {
      const auto at = std::lower_bound(bonds_.begin(), bonds_.end(), change.term);
      if (at != bonds_.end() && *at == change.term) broken_at[static_cast<std::size_t>(at - bonds_.begin())] = s;
    }
  }
  constexpr int batch = WindowSettings::states_swept_at_once;
  for (int begin = 0; begin < count; begin += batch) {
    check_cancelled();
    const int size = std::min(batch, count - begin);
    Eigen::MatrixXd kept(states.front().rows(), size);
    for (int k = 0; k < size; ++k) kept.col(k) = states[static_cast<std::size_t>(begin + k)].col(1);
    Eigen::MatrixXd whole = condensation_.expand(kept, std::vector<int>(static_cast<std::size_t>(size), 1));
    for (int k = 0; k < size; ++k) whole.row(k) *= steps[static_cast<std::size_t>(begin + k)].load_factor;
    const int found = first_break(whole, begin, steps, broken_at);
    if (found < count) return found;
  }
  return count;
}

// Number of the first step before which a bond breaks by itself, among the steps of a batch that starts with `begin`.
// States are treated in batches, so that the numbers of a bond's degrees of freedom are read once for all states of a
// batch.
int LineCertificate::first_break(const Eigen::MatrixXd& stretched, int begin, const std::vector<Step>& steps,
                                 const std::vector<int>& broken_at) const {
  constexpr Eigen::Index batch = WindowSettings::states_swept_at_once;
  constexpr double limit = 1 - WindowSettings::comparison_margin;
  Eigen::Array<double, batch, Eigen::Dynamic> u =
      Eigen::Array<double, batch, Eigen::Dynamic>::Zero(batch, stretched.cols());
  u.topRows(stretched.rows()) = stretched;
  int found = static_cast<int>(steps.size());
  for (std::size_t b = 0; b < bonds_.size(); ++b) {
    const int i = first_[b], j = second_[b];
    const Eigen::Array<double, batch, 1> ratio =
        elongation_along(cosine_[b], sine_[b], u.col(j) - u.col(i), u.col(j + 1) - u.col(i + 1));
    if (ratio.maxCoeff() < limit) continue;
    for (int k = 0; k < static_cast<int>(stretched.rows()) && begin + k < found; ++k) {
      const int state = begin + k;
      if (ratio[k] < limit || broken_at[b] < state) continue;
      if (!is_guarded(b, steps[static_cast<std::size_t>(state)])) found = state;
    }
  }
  return found;
}

}  // namespace bempd::fracture
