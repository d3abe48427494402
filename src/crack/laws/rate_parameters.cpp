#include "crack/laws/rate_parameters.hpp"

#include "crack/laws/forman.hpp"
#include "crack/laws/paris_walker.hpp"
#include "crack/laws/sustained.hpp"
#include "error.hpp"

namespace bempd::crack {

namespace {

std::unique_ptr<RateLaw> make_law(const RateParameters& p) {
  using Kind = RateParameters::Kind;
  switch (p.kind) {
    case Kind::forman:
      return std::make_unique<Forman>(p.coefficient, p.exponent, p.threshold);
    case Kind::nasgro:
      return std::make_unique<Nasgro>(p.coefficient, p.exponent, p.p, p.q, p.closure, p.threshold);
    case Kind::sustained:
      return std::make_unique<Sustained>(p.coefficient, p.exponent, p.threshold);
    case Kind::host:
      return std::make_unique<HostRate>(p.function, p.threshold);
    case Kind::paris_walker:
      break;
  }
  return std::make_unique<ParisWalker>(p.coefficient, p.exponent, p.walker, p.threshold);
}

std::unique_ptr<Retardation> make_retardation(const RateParameters& p, bool plane_strain) {
  const double constraint = p.zone_constraint > 0 ? p.zone_constraint : plane_strain ? 6 : 2;
  switch (p.retarding) {
    case RateParameters::Retarding::wheeler:
      return std::make_unique<Wheeler>(p.yield_strength, constraint, p.wheeler_exponent);
    case RateParameters::Retarding::willenborg:
      return std::make_unique<Willenborg>(p.yield_strength, constraint, p.threshold, p.shutoff_ratio);
    case RateParameters::Retarding::none:
      break;
  }
  return nullptr;
}

}  // namespace

std::unique_ptr<RateLaw> make_rate_law(const RateParameters& parameters, bool plane_strain) {
  std::unique_ptr<RateLaw> law = make_law(parameters);
  law->slow_down(make_retardation(parameters, plane_strain));
  return law;
}

double critical_of(const RateParameters& p, double toughness) {
  using Kind = RateParameters::Kind;
  const double critical = p.critical > 0 ? p.critical : toughness;
  const bool needs_toughness = p.kind == Kind::forman || (p.kind == Kind::nasgro && p.q > 0);
  require(!needs_toughness || std::isfinite(critical), "the growth law needs the factor at which a tip breaks, and ",
          "neither critical_intensity nor a fracture_energy of the material is given; give one of them");
  return critical;
}

}  // namespace bempd::crack
