#include "coupling/term_law.hpp"

#include <cmath>
#include <utility>

#include "error.hpp"

namespace bempd::coupling {

TermLaw::TermLaw(std::vector<Stage> stages) : stages_(std::move(stages)) {
  require(!stages_.empty() && broken_stage() <= 255, "a law has ", stages_.size(), " stages; give 1 to 255 of them");
  const auto is_share = [](double value) { return std::isfinite(value) && value > 0; };
  for (const Stage& s : stages_) {
    require(is_share(s.stiffness_share) && is_share(s.critical_share), "a stage of a law has the stiffness share ",
            s.stiffness_share, " and the critical share ", s.critical_share, "; both must be positive and finite");
  }
}

const TermLaw& TermLaw::brittle() {
  static const TermLaw law({{1, 1}});
  return law;
}

std::vector<int> terms_of(std::span<const StageChange> changes) {
  std::vector<int> terms;
  terms.reserve(changes.size());
  for (const StageChange& c : changes) terms.push_back(c.term);
  return terms;
}

}  // namespace bempd::coupling
