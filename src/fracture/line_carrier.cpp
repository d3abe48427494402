#include "fracture/line_carrier.hpp"

#include <stdexcept>

#include "fracture/crack_evolution.hpp"

namespace bempd::fracture {

LineEvents& LineCarrier::source() {
  body_.sources().update_for_reader();
  return *body_.sources().lines();
}

std::vector<crack::Tip> LineCarrier::tips() { return source().tips(); }

std::vector<crack::Tip> LineCarrier::tips_without_loads() { return source().tips(false); }

std::vector<crack::Candidate> LineCarrier::candidates(const crack::LoadWay& way) { return source().candidates(way); }

crack::Advance LineCarrier::advance(const crack::Step& step) {
  const auto known = static_cast<std::ptrdiff_t>(body_.progress().extensions.size());
  if (step.is_driven) {
    const Event* next = body_.events().last_found();
    if (!next || next->tip != step.tip) throw std::logic_error("the step of a crack line is not the next event");
    body_.events().perform(*next);
  } else {
    body_.events().extend_line(step.tip, step.direction);
  }
  const std::vector<CrackExtension>& all = body_.progress().extensions;
  return {{all.begin() + known, all.end()}, false};
}

}  // namespace bempd::fracture
