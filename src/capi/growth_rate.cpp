#include <functional>

#include "capi/given_struct.hpp"
#include "model/fatigue.hpp"

using namespace bempd;
using namespace bempd::capi;

namespace {

constexpr bempd_growth_rate rate_defaults{.struct_size = sizeof(bempd_growth_rate),
                                          .kind = BEMPD_RATE_PARIS,
                                          .reserved = 0,
                                          .coefficient = 0,
                                          .exponent = 0,
                                          .unit_intensity = 1,
                                          .threshold = 0,
                                          .critical_intensity = 0,
                                          .walker = 1,
                                          .p = 0,
                                          .q = 0,
                                          .closure_alpha = 1,
                                          .closure_stress = 0,
                                          .function = nullptr,
                                          .user = nullptr,
                                          .retardation = BEMPD_RETARDATION_NONE,
                                          .reserved2 = 0,
                                          .yield_strength = 0,
                                          .zone_constraint = 0,
                                          .wheeler_exponent = 0,
                                          .shutoff_ratio = 0,
                                          .flow_stress = 0};

// Function of the host for a growth rate or a fracture energy, as a function of a load cycle.
std::function<double(const crack::TipCycle&)> host_growth_function(bempd_growth_function function, void* user) {
  return [=](const crack::TipCycle& c) {
    return function(c.tip.crack, end_of(c.tip.end), c.highest, c.ratio(), c.high.x(), c.high.y(), c.t_stress, c.length,
                    c.place.x(), c.place.y(), user);
  };
}

// Coefficient of a growth law for stress intensity factors in [Pa m^(1/2)], from the coefficient for stress intensity
// factors in the host's unit unit_intensity. The coefficient has the unit to the power -m (exponent m of the law); with
// Forman's law, which divides by a stress intensity factor, to the power 1 - m.
double coefficient_of(const bempd_growth_rate& rate) {
  const double exponent = rate.kind == BEMPD_RATE_FORMAN ? rate.exponent - 1 : rate.exponent;
  const double coefficient = rate.coefficient * std::pow(rate.unit_intensity, -exponent);
  require(std::isfinite(coefficient) && (coefficient > 0) == (rate.coefficient > 0), "coefficient is ",
          rate.coefficient, " with unit_intensity ", rate.unit_intensity, " and exponent ", rate.exponent,
          ", which no number holds in [Pa m^(1/2)]; state them in larger units");
  return coefficient;
}

void set_retardation(const bempd_growth_rate& rate, crack::RateParameters& parameters) {
  require(rate.retardation >= BEMPD_RETARDATION_NONE && rate.retardation <= BEMPD_RETARDATION_WILLENBORG,
          "retardation is ", rate.retardation,
          "; it must be BEMPD_RETARDATION_NONE (0), BEMPD_RETARDATION_WHEELER (1) ",
          "or BEMPD_RETARDATION_WILLENBORG (2)");
  require(rate.reserved2 == 0, "reserved2 is ", rate.reserved2, "; it must be 0");
  parameters.retarding = static_cast<crack::RateParameters::Retarding>(rate.retardation);
  if (rate.retardation == BEMPD_RETARDATION_NONE) return;
  require(rate.kind != BEMPD_RATE_SUSTAINED,
          "retardation is given with BEMPD_RATE_SUSTAINED, growth in time; it acts on growth by cycles");
  require(std::isfinite(rate.yield_strength) && rate.yield_strength > 0, "yield_strength is ", rate.yield_strength,
          "; retardation needs one > 0");
  require_at_least(rate.zone_constraint, 0, "zone_constraint");
  parameters.yield_strength = rate.yield_strength, parameters.zone_constraint = rate.zone_constraint;
  if (rate.retardation == BEMPD_RETARDATION_WHEELER) {
    require(std::isfinite(rate.wheeler_exponent) && rate.wheeler_exponent > 0, "wheeler_exponent is ",
            rate.wheeler_exponent, "; it must be > 0");
    parameters.wheeler_exponent = rate.wheeler_exponent;
    return;
  }
  require(std::isfinite(rate.shutoff_ratio) && rate.shutoff_ratio > 1, "shutoff_ratio is ", rate.shutoff_ratio,
          "; it must be > 1, the overload over the load that stops a crack");
  require(rate.kind != BEMPD_RATE_PARIS || rate.walker != 1,
          "retardation is BEMPD_RETARDATION_WILLENBORG, which acts through the load ratio R, and by the law "
          "BEMPD_RATE_PARIS with walker = 1 R has no effect; give a walker, or another law");
  parameters.shutoff_ratio = rate.shutoff_ratio;
}

crack::RateParameters parameters_of(const bempd_growth_rate* given) {
  const bempd_growth_rate rate = given_struct(given, "rate", rate_defaults);
  require(rate.kind >= BEMPD_RATE_PARIS && rate.kind <= BEMPD_RATE_HOST, "kind is ", rate.kind,
          "; it must be BEMPD_RATE_PARIS (1), BEMPD_RATE_FORMAN (2), BEMPD_RATE_NASGRO (3), BEMPD_RATE_SUSTAINED (4) "
          "or BEMPD_RATE_HOST (5)");
  require(rate.reserved == 0, "reserved is ", rate.reserved, "; it must be 0");
  const bool by_function = rate.kind == BEMPD_RATE_HOST;
  require(!by_function || rate.function != nullptr, "function is NULL; BEMPD_RATE_HOST needs one");
  if (!by_function) {
    require(std::isfinite(rate.coefficient) && rate.coefficient > 0, "coefficient is ", rate.coefficient,
            "; it must be > 0");
    require_at_least(rate.exponent, 0, "exponent");
  }
  require(std::isfinite(rate.unit_intensity) && rate.unit_intensity > 0, "unit_intensity is ", rate.unit_intensity,
          "; it must be > 0");
  require_at_least(rate.threshold, 0, "threshold");
  require_at_least(rate.critical_intensity, 0, "critical_intensity");
  require_at_least(rate.flow_stress, 0, "flow_stress");
  require_at_least(rate.walker, 0, "walker");
  require_at_least(rate.p, 0, "p");
  require_at_least(rate.q, 0, "q");
  require(rate.closure_alpha >= 1 && rate.closure_alpha <= 3, "closure_alpha is ", rate.closure_alpha,
          "; it must lie between 1, plane stress, and 3, plane strain");
  require(rate.closure_stress >= 0 && rate.closure_stress < 1, "closure_stress is ", rate.closure_stress,
          "; it must be >= 0 and < 1");
  crack::RateParameters parameters;
  parameters.kind = static_cast<crack::RateParameters::Kind>(rate.kind);
  if (!by_function) parameters.coefficient = coefficient_of(rate);
  parameters.exponent = rate.exponent, parameters.walker = rate.walker;
  parameters.p = rate.p, parameters.q = rate.q;
  parameters.closure = {rate.closure_alpha, rate.closure_stress};
  parameters.threshold = rate.threshold * rate.unit_intensity;
  parameters.critical = rate.critical_intensity * rate.unit_intensity;
  parameters.flow_stress = rate.flow_stress;
  if (by_function) parameters.function = host_growth_function(rate.function, rate.user);
  set_retardation(rate, parameters);
  return parameters;
}

}  // namespace

bempd_status bempd_growth_rate_init(bempd_growth_rate* rate, int64_t struct_size) {
  return init_struct(__func__, "rate", rate, struct_size, rate_defaults);
}

bempd_status bempd_set_growth_rate(bempd_model* model, int32_t material, const bempd_growth_rate* rate) {
  return with_model(model, __func__, [&](model::Model& m) { m.fatigue().set_rate(material, parameters_of(rate)); });
}

bempd_status bempd_set_resistance_function(bempd_model* model, int32_t material, bempd_growth_function function,
                                           void* user) {
  return with_model(model, __func__, [&](model::Model& m) {
    require(function != nullptr, "function is NULL; give one");
    scene::set_resistance_function(m.editable_scene(), material, host_growth_function(function, user));
  });
}
