#include "fracture/line_carrier.hpp"

#include <stdexcept>

#include "fracture/crack_evolution.hpp"

namespace bempd::fracture {

std::vector<crack::Tip> LineCarrier::tips() { return body_.looked_at_lines().tips(); }

std::vector<crack::Candidate> LineCarrier::candidates(const crack::LoadWay& way) {
  return body_.looked_at_lines().candidates(way);
}

crack::Advance LineCarrier::advance(const crack::Step& step) {
  const auto known = static_cast<std::ptrdiff_t>(body_.state_.extensions.size());
  if (step.is_driven) {
    const Event* next = body_.next_;
    if (!next || next->tip != step.tip) throw std::logic_error("the step of a crack line is not the next event");
    body_.perform_and_book(*next);
  } else {
    body_.extend_line(step.tip, step.direction);
  }
  const std::vector<CrackExtension>& all = body_.state_.extensions;
  return {{all.begin() + known, all.end()}, false};
}

}  // namespace bempd::fracture
