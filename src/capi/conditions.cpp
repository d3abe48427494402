#include <map>
#include <memory>

#include "capi/guard.hpp"
#include "capi/host_function.hpp"
#include "regions/places/crack_faces.hpp"
#include "regions/places/edge_part.hpp"
#include "regions/places/forced_nodes.hpp"
#include "regions/places/heated_region.hpp"
#include "regions/places/pressed_crack.hpp"
#include "regions/places/pressed_edge.hpp"
#include "regions/places/single_point.hpp"
#include "regions/places/turning_region.hpp"
#include "regions/places/whole_region.hpp"

using namespace bempd;
using namespace bempd::capi;

namespace {

using scene::Condition;
using scene::SampledValues;

SampledValues samples(std::int64_t count, const double* constant, const double* proportional) {
  require_count(count, "value_count", "value");
  const auto size = static_cast<std::size_t>(count);
  return {numbers_or_zeros(constant, size), numbers_or_zeros(proportional, size)};
}

SampledValues single(double constant, double proportional) { return {{constant}, {proportional}}; }

void require_single(std::int32_t component) {
  require(component == BEMPD_X || component == BEMPD_Y, "component is ", component,
          "; it must be BEMPD_X (1) or BEMPD_Y (2)");
}

std::shared_ptr<const scene::Place> on_edge(std::int32_t region, std::int32_t edge, double from, double to) {
  return std::make_shared<const regions::EdgePart>(region, edge, from, to);
}

std::shared_ptr<const scene::Place> at_point(double x, double y) {
  return std::make_shared<const regions::SinglePoint>(Point(x, y));
}

// Adds a support that make() returns. make() is called inside the guard, which turns exceptions into a status, because
// it allocates memory.
template <class Make>
bempd_status add_support(bempd_model* handle, const char* function, std::int32_t* id, const Make& make) {
  return with_model(handle, function, [&](model::Model& m) { give(id, m.editable_scene().add_support(make())); });
}

template <class Make>
bempd_status add_load(bempd_model* handle, const char* function, std::int32_t* id, const Make& make) {
  return with_model(handle, function, [&](model::Model& m) { give(id, m.editable_scene().add_load(make())); });
}

}  // namespace

scene::BoundaryFunction bempd::capi::host_function(bempd_boundary_function function, void* user) {
  require(function != nullptr, "function is NULL; give a function of the position");
  auto known = std::make_shared<std::map<std::pair<double, double>, scene::BoundaryValue>>();
  return [known, function, user](const Point& p, double) {
    const auto key = std::make_pair(p.x(), p.y());
    if (const auto found = known->find(key); found != known->end()) return found->second;
    double constant[2] = {0, 0}, proportional[2] = {0, 0};
    if (function(p.x(), p.y(), constant, proportional, user) != 0) {
      fail(Failure::cancelled, "the boundary function asked to stop at (", p.x(), ", ", p.y(), ")");
    }
    const scene::BoundaryValue value{Point(constant[0], constant[1]), Point(proportional[0], proportional[1])};
    known->emplace(key, value);
    return value;
  };
}

bempd_status bempd_fix_edge(bempd_model* model, int32_t region, int32_t edge, int32_t component, int32_t* support) {
  return add_support(model, __func__, support, [&] {
    return Condition{on_edge(region, edge, 0, 1), component, single(0, 0)};
  });
}

bempd_status bempd_fix_point(bempd_model* model, double x, double y, int32_t component, int32_t* support) {
  return add_support(model, __func__, support, [&] { return Condition{at_point(x, y), component, single(0, 0)}; });
}

bempd_status bempd_prescribe_edge(bempd_model* model, int32_t region, int32_t edge, double from, double to,
                                  int32_t component, int64_t value_count, const double* constant,
                                  const double* proportional, int32_t* support) {
  return add_support(model, __func__, support, [&] {
    require_single(component);
    return Condition{on_edge(region, edge, from, to), component, samples(value_count, constant, proportional)};
  });
}

bempd_status bempd_prescribe_edge_function(bempd_model* model, int32_t region, int32_t edge, double from, double to,
                                           int32_t component, bempd_boundary_function function, void* user,
                                           int32_t* support) {
  return add_support(model, __func__, support, [&] {
    return Condition{on_edge(region, edge, from, to), component, host_function(function, user)};
  });
}

bempd_status bempd_prescribe_point(bempd_model* model, double x, double y, int32_t component, double constant,
                                   double proportional, int32_t* support) {
  return add_support(model, __func__, support, [&] {
    require_single(component);
    return Condition{at_point(x, y), component, single(constant, proportional)};
  });
}

bempd_status bempd_add_traction(bempd_model* model, int32_t region, int32_t edge, double from, double to,
                                int32_t component, int64_t value_count, const double* constant,
                                const double* proportional, int32_t* load) {
  return add_load(model, __func__, load, [&] {
    require_single(component);
    return Condition{on_edge(region, edge, from, to), component, samples(value_count, constant, proportional)};
  });
}

bempd_status bempd_add_traction_function(bempd_model* model, int32_t region, int32_t edge, double from, double to,
                                         bempd_boundary_function function, void* user, int32_t* load) {
  return add_load(model, __func__, load, [&] {
    return Condition{on_edge(region, edge, from, to), BEMPD_BOTH, host_function(function, user)};
  });
}

bempd_status bempd_add_pressure(bempd_model* model, int32_t region, int32_t edge, double from, double to,
                                int64_t value_count, const double* constant, const double* proportional,
                                int32_t* load) {
  return add_load(model, __func__, load, [&] {
    return Condition{std::make_shared<const regions::PressedEdge>(region, edge, from, to), BEMPD_X,
                     samples(value_count, constant, proportional)};
  });
}

bempd_status bempd_add_edge_forces(bempd_model* model, int32_t region, int32_t edge, double from, double to,
                                   int32_t* load) {
  return add_load(model, __func__, load, [&] {
    return Condition{std::make_shared<const regions::ForcedNodes>(region, edge, from, to), BEMPD_BOTH,
                     scene::PlacedValues{{0}, {0, 0}, {0, 0}}};
  });
}

bempd_status bempd_add_point_force(bempd_model* model, double x, double y, int32_t component, double constant,
                                   double proportional, int32_t* load) {
  return add_load(model, __func__, load, [&] {
    require_single(component);
    return Condition{at_point(x, y), component, single(constant, proportional)};
  });
}

bempd_status bempd_add_body_force(bempd_model* model, int32_t region, int32_t component, double constant,
                                  double proportional, int32_t* load) {
  return add_load(model, __func__, load, [&] {
    require_single(component);
    return Condition{std::make_shared<const regions::WholeRegion>(region), component, single(constant, proportional)};
  });
}

bempd_status bempd_add_rotation(bempd_model* model, int32_t region, double x, double y, double constant,
                                double proportional, int32_t* load) {
  return add_load(model, __func__, load, [&] {
    return Condition{std::make_shared<const regions::TurningRegion>(region, Point(x, y)), BEMPD_X,
                     single(constant, proportional)};
  });
}

bempd_status bempd_add_temperature(bempd_model* model, int32_t region, double constant, double proportional,
                                   int32_t* load) {
  return add_load(model, __func__, load, [&] {
    return Condition{std::make_shared<const regions::HeatedRegion>(region), BEMPD_X, single(constant, proportional)};
  });
}

bempd_status bempd_add_temperature_function(bempd_model* model, int32_t region, bempd_boundary_function function,
                                            void* user, int32_t* load) {
  return add_load(model, __func__, load, [&] {
    return Condition{std::make_shared<const regions::HeatedRegion>(region), BEMPD_X, host_function(function, user)};
  });
}

bempd_status bempd_add_crack_traction(bempd_model* model, int32_t crack, int32_t component, int64_t value_count,
                                      const double* constant, const double* proportional, int32_t* load) {
  return add_load(model, __func__, load, [&] {
    require(component == BEMPD_PRESSURE || component == BEMPD_SHEAR, "component is ", component,
            "; it must be BEMPD_PRESSURE (1) or BEMPD_SHEAR (2)");
    return Condition{std::make_shared<const regions::CrackFaces>(crack), component,
                     samples(value_count, constant, proportional)};
  });
}

bempd_status bempd_add_crack_pressure(bempd_model* model, int32_t crack, double constant, double proportional,
                                      int32_t* load) {
  return add_load(model, __func__, load, [&] {
    return Condition{std::make_shared<const regions::PressedCrack>(crack), BEMPD_X, single(constant, proportional)};
  });
}

bempd_status bempd_set_load_values(bempd_model* model, int32_t load, int64_t value_count, const double* constant,
                                   const double* proportional) {
  return with_model(model, __func__, [&](model::Model& m) {
    m.loads().set_load_values(load, samples(value_count, constant, proportional));
  });
}

bempd_status bempd_set_support_values(bempd_model* model, int32_t support, int64_t value_count, const double* constant,
                                      const double* proportional) {
  return with_model(model, __func__, [&](model::Model& m) {
    m.loads().set_support_values(support, samples(value_count, constant, proportional));
  });
}

bempd_status bempd_remove_support(bempd_model* model, int32_t support) {
  return with_model(model, __func__, [&](model::Model& m) { m.editable_scene().remove_support(support); });
}

bempd_status bempd_remove_load(bempd_model* model, int32_t load) {
  return with_model(model, __func__, [&](model::Model& m) { m.editable_scene().remove_load(load); });
}
