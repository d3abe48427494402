#pragma once

#include <memory>

#include "crack/laws/host_rate.hpp"
#include "crack/laws/nasgro.hpp"
#include "crack/laws/rate_law.hpp"

namespace bempd::crack {

// Law of crack growth per load cycle or per unit of time, in the numbers that the host gives.
struct RateParameters {
  enum class Retarding { none = 0, wheeler = 1, willenborg = 2 };
  enum class Kind { paris_walker = 1, forman = 2, nasgro = 3, sustained = 4, host = 5 };

  Kind kind = Kind::paris_walker;
  double coefficient = 0, exponent = 0;
  double walker = 1;
  double p = 0, q = 0;
  Nasgro::Closure closure;
  double threshold = 0, critical = 0;  // [Pa m^(1/2)]; `critical` 0: the toughness of the material
  HostRate::Function function;

  Retarding retarding = Retarding::none;
  double yield_strength = 0;   // [Pa]
  double zone_constraint = 0;  // constraint of plastic zones; 0: by the plane state of the material
  double wheeler_exponent = 0, shutoff_ratio = 0;

  double flow_stress = 0;  // limit stress of a net section [Pa]; 0: net sections are not checked
};

// Makes the growth law; `plane_strain` chooses the constraint (factor of the size) of plastic zones if the host gave
// none.
std::unique_ptr<RateLaw> make_rate_law(const RateParameters& parameters, bool plane_strain);

// Stress intensity factor at which a tip breaks: `critical` of the parameters or, if that is 0, the toughness of the
// material (infinite if unknown). Throws Error (argument) if the growth rate depends on this factor and it is unknown.
double critical_of(const RateParameters& parameters, double toughness);

}  // namespace bempd::crack
