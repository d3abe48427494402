#include <limits>

#include "capi/guard.hpp"
#include "model/parts.hpp"
#include "model/present_errors.hpp"
#include "model/run_errors.hpp"
#include "number_range.hpp"
#include "regions/boundary/boundary_description.hpp"

using namespace bempd;
using namespace bempd::capi;

namespace {

bempd_status add_body(bempd_model* model, const char* call, int32_t material, int64_t vertex_count,
                      const double* vertices, const double* bulges, int32_t* body) {
  return with_model(model, call, [&](model::Model& m) {
    const auto points = points_from(vertices, vertex_count, "vertices");
    const auto bends = bulges ? std::vector(bulges, bulges + vertex_count) : std::vector<double>();
    give(body, regions::add_body(m.editable_scene(), material, points, bends));
  });
}

bempd_body_plan described(const model::MeshPlan& plan, const model::Model& m) {
  const bool grows = plan.first.crack > 0;
  return {.struct_size = sizeof(bempd_body_plan),
          .boundary_elements = std::llround(plan.cost.elements),
          .unknowns = std::llround(plan.cost.unknowns),
          .material_points = plan.cost.material_points,
          .bonds = plan.cost.bonds,
          .memory = plan.cost.bytes,
          .seconds = plan.cost.seconds,
          .seconds_spent = plan.seconds_spent,
          .error_wanted = m.options().number("error.wanted"),
          .displacement_error = plan.errors.displacement,
          .reaction_error = plan.errors.reaction,
          .intensity_error = plan.errors.intensity,
          .growth_load_error = plan.errors.growth_load,
          .growth_load_factor = grows ? plan.growth_load : std::numeric_limits<double>::max(),
          .growth_crack = plan.first.crack,
          .growth_end = end_of(plan.first),
          .meets_wish = plan.meets_wish ? 1 : 0,
          .is_solved = plan.is_solved ? 1 : 0};
}

const model::Part& part_at(const std::vector<model::Part>& parts, std::int64_t index) {
  return entry_at(parts, index, "; the model has ", " parts");
}

// Load factor limited to finite numbers; NaN, which stands for unknown, stays.
double known_load(double load_factor) { return std::isnan(load_factor) ? load_factor : in_range(load_factor); }

bempd_model_part described(const model::Part& part) {
  return {.struct_size = sizeof(bempd_model_part),
          .kind = part.is_lattice ? BEMPD_PART_LATTICE : BEMPD_PART_ELEMENTS,
          .reason = static_cast<int32_t>(part.reason),
          .body = part.body,
          .region = part.region,
          .crack = part.crack,
          .loops = static_cast<int32_t>(part.outline.loops.size()),
          .horizon_ratio = part.horizon_ratio,
          .reserved = 0,
          .spacing = part.spacing,
          .boundary_elements = part.elements,
          .material_points = part.points,
          .growth_load_factor = known_load(part.growth_load),
          .element_growth_load_factor = known_load(part.growth_load_of_elements)};
}

bempd_run_errors described(const model::RunErrors& errors) {
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  const auto told = [&](double error) { return errors.is_made ? in_range(error) : unknown; };
  const bool is_lattice = errors.lattice.path > errors.boundary.path;
  return {.struct_size = sizeof(bempd_run_errors),
          .expected_seconds = errors.expected_seconds,
          .seconds = errors.seconds,
          .first_growth = told(errors.boundary.first_growth),
          .peak = told(errors.boundary.peak),
          .path = told(errors.boundary.path),
          .lattice_first_growth = told(errors.lattice.first_growth),
          .lattice_peak = told(errors.lattice.peak),
          .lattice_path = told(errors.lattice.path),
          .path_crack = is_lattice ? errors.lattice.crack : errors.boundary.crack,
          .is_made = errors.is_made ? 1 : 0};
}

}  // namespace

bempd_status bempd_add_body(bempd_model* model, int32_t material, int64_t vertex_count, const double* vertices,
                            int32_t* body) {
  return add_body(model, __func__, material, vertex_count, vertices, nullptr, body);
}

bempd_status bempd_add_body_with_arcs(bempd_model* model, int32_t material, int64_t vertex_count,
                                      const double* vertices, const double* bulges, int32_t* body) {
  return add_body(model, __func__, material, vertex_count, vertices, bulges, body);
}

bempd_status bempd_set_body_lattice(bempd_model* model, int32_t body, double spacing, int32_t horizon_ratio) {
  return with_model(model, __func__,
                    [&](model::Model& m) { m.treatments().set_lattice(body, spacing, horizon_ratio); });
}

bempd_status bempd_set_crack_treatment(bempd_model* model, int32_t crack, int32_t treatment) {
  return with_model(model, __func__, [&](model::Model& m) {
    require(treatment >= BEMPD_TREATMENT_AUTOMATIC && treatment <= BEMPD_TREATMENT_FROZEN, "treatment is ", treatment,
            "; it must be BEMPD_TREATMENT_AUTOMATIC (1), BEMPD_TREATMENT_ELEMENTS (2), BEMPD_TREATMENT_LATTICE (3) or "
            "BEMPD_TREATMENT_FROZEN (4)");
    m.treatments().set(crack, static_cast<model::CrackTreatment>(treatment));
  });
}

bempd_status bempd_body_plan_init(bempd_body_plan* plan, int64_t struct_size) {
  return init_struct(__func__, "plan", plan, struct_size, bempd_body_plan{});
}

bempd_status bempd_plan(bempd_model* model, bempd_body_plan* plan) {
  return with_model(model, __func__, [&](model::Model& m) {
    struct_bytes(plan, "plan");
    write_struct(plan, described(m.accuracy().plan(), m), "plan");
  });
}

bempd_status bempd_errors_init(bempd_errors* errors, int64_t struct_size) {
  return init_struct(__func__, "errors", errors, struct_size, bempd_errors{});
}

bempd_status bempd_error_estimate(bempd_model* model, bempd_errors* errors) {
  return with_model(model, __func__, [&](model::Model& m) {
    struct_bytes(errors, "errors");
    const model::ErrorSources found = model::errors_now(m);
    const bool is_boundary = !(found.model > found.boundary.largest());
    write_struct(errors,
                 bempd_errors{.struct_size = sizeof(bempd_errors),
                              .wanted = m.options().number("error.wanted"),
                              .displacement = found.boundary.displacement,
                              .reaction = found.boundary.reaction,
                              .stress_intensity = found.boundary.intensity,
                              .growth_load = found.boundary.growth_load,
                              .lattice = found.has_lattices ? std::numeric_limits<double>::quiet_NaN() : 0,
                              .patch = 0,
                              .model = found.model,
                              .dominating = is_boundary ? BEMPD_ERROR_SOURCE_BOUNDARY : BEMPD_ERROR_SOURCE_MODEL,
                              .reserved = 0,
                              .halving_seconds = found.halving_seconds,
                              .halving_memory = found.halving_bytes},
                 "errors");
  });
}

bempd_status bempd_run_errors_init(bempd_run_errors* errors, int64_t struct_size) {
  return init_struct(__func__, "errors", errors, struct_size, bempd_run_errors{});
}

bempd_status bempd_run_error_estimate(bempd_model* model, double seconds_allowed, bempd_run_errors* errors) {
  return with_model(model, __func__, [&](model::Model& m) {
    struct_bytes(errors, "errors");
    require(seconds_allowed >= 0, "seconds_allowed is ", seconds_allowed, "; it must be >= 0");
    write_struct(errors, described(model::errors_of_run(m, seconds_allowed)), "errors");
  });
}

bempd_status bempd_part_count(bempd_model* model, int64_t* count) {
  return with_model(model, __func__, [&](model::Model& m) {
    out(count, "count") = static_cast<int64_t>(m.accuracy().scene_of_plan().discretization.regions.size());
  });
}

bempd_status bempd_part_init(bempd_model_part* part, int64_t struct_size) {
  return init_struct(__func__, "part", part, struct_size, bempd_model_part{});
}

bempd_status bempd_part(bempd_model* model, int64_t index, bempd_model_part* part) {
  return with_model(model, __func__, [&](model::Model& m) {
    struct_bytes(part, "part");
    write_struct(part, described(part_at(model::parts_of(m), index)), "part");
  });
}

bempd_status bempd_part_outline(bempd_model* model, int64_t index, int32_t loop, int64_t capacity, double* points,
                                int64_t* count) {
  return with_model(model, __func__, [&](model::Model& m) {
    const std::vector<model::Part> parts = model::parts_of(m);
    const Outline& outline = part_at(parts, index).outline;
    require(loop >= 0 && loop < static_cast<int32_t>(outline.loops.size()), "loop is ", loop, "; the part has ",
            outline.loops.size(), " loops");
    const std::vector<Point> line = model::polyline_of(outline, static_cast<std::size_t>(loop));
    out(count, "count") = static_cast<int64_t>(line.size());
    if (capacity == 0) return;
    require(points != nullptr && capacity >= static_cast<int64_t>(line.size()), "capacity is ", capacity,
            "; give room for ", line.size(), " points");
    for (std::size_t i = 0; i < line.size(); ++i) points[2 * i] = line[i].x(), points[2 * i + 1] = line[i].y();
  });
}
