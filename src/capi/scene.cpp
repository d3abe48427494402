#include <algorithm>
#include <cmath>
#include <numbers>

#include "capi/given_struct.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/lattice/peridynamic_description.hpp"

using namespace bempd;
using namespace bempd::capi;

namespace {

constexpr bempd_material material_defaults{sizeof(bempd_material), 0, 0, 1, 0, 0, BEMPD_PLANE_STRESS, 0, 0};

// Loop of vertices and bulges as the caller gives it.
struct GivenLoop {
  std::int64_t vertex_count;
  const double* vertices;
  const double* bulges = nullptr;

  std::vector<Point> points() const { return points_from(vertices, vertex_count, "vertices"); }
  std::vector<double> bends() const {
    return bulges ? std::vector(bulges, bulges + vertex_count) : std::vector<double>();
  }
};

bempd_status add_bem_region(bempd_model* model, const char* call, int32_t material, const GivenLoop& loop,
                            double element_length, int32_t* region) {
  return with_model(model, call, [&](model::Model& m) {
    const auto points = loop.points();
    give(region, regions::add_boundary_region(m.editable_scene(), material, points, element_length, loop.bends()));
  });
}

bempd_status add_pd_region(bempd_model* model, const char* call, int32_t material, const GivenLoop& loop,
                           double spacing, int32_t horizon_ratio, double angle, int32_t* region) {
  return with_model(model, call, [&](model::Model& m) {
    constexpr int usual_horizon_ratio = 4;
    constexpr double most_angle = 2 * std::numbers::pi;
    const auto points = loop.points();
    require(std::abs(angle) <= most_angle, "angle is ", angle, "; it must lie between -2 pi and 2 pi");
    const int ratio = horizon_ratio == 0 ? usual_horizon_ratio : horizon_ratio;
    const regions::PointChoice choice{m.options().text_value("test.outline_points") == "always", angle};
    give(region,
         regions::add_peridynamic_region(m.editable_scene(), material, points, spacing, ratio, choice, loop.bends()));
  });
}

bempd_status add_hole(bempd_model* model, const char* call, int32_t region, const GivenLoop& loop,
                      int32_t* first_edge) {
  return with_model(model, call, [&](model::Model& m) {
    const auto points = loop.points();
    give(first_edge, m.editable_scene().shape_of(region).add_hole(points, loop.bends()));
  });
}

}  // namespace

bempd_status bempd_material_init(bempd_material* material, int64_t struct_size) {
  return init_struct(__func__, "material", material, struct_size, material_defaults);
}

bempd_status bempd_add_material(bempd_model* model, const bempd_material* material, int32_t* id) {
  return with_model(model, __func__, [&](model::Model& m) {
    const bempd_material given =
        given_struct(material, "material", material_defaults, offsetof(bempd_material, thickness));
    require(given.plane == BEMPD_PLANE_STRESS || given.plane == BEMPD_PLANE_STRAIN, "plane is ", given.plane,
            "; it must be BEMPD_PLANE_STRESS (1) or BEMPD_PLANE_STRAIN (2)");
    require(given.reserved == 0, "reserved is ", given.reserved, "; it must be 0");
    scene::Material values;
    values.elasticity = {given.young_modulus, given.poisson_ratio,
                         given.plane == BEMPD_PLANE_STRESS ? PlaneState::stress : PlaneState::strain, given.thickness};
    values.critical_stretch = given.critical_stretch;
    values.fracture_energy = given.fracture_energy;
    values.thermal_expansion = given.thermal_expansion;
    give(id, m.editable_scene().add_material(values));
  });
}

bempd_status bempd_add_bem_region(bempd_model* model, int32_t material, int64_t vertex_count, const double* vertices,
                                  double element_length, int32_t* region) {
  return add_bem_region(model, __func__, material, {vertex_count, vertices}, element_length, region);
}

bempd_status bempd_add_bem_region_with_arcs(bempd_model* model, int32_t material, int64_t vertex_count,
                                            const double* vertices, const double* bulges, double element_length,
                                            int32_t* region) {
  return add_bem_region(model, __func__, material, {vertex_count, vertices, bulges}, element_length, region);
}

bempd_status bempd_add_bem_disc(bempd_model* model, int32_t material, double x, double y, double radius,
                                double element_length, int32_t* region) {
  return with_model(model, __func__, [&](model::Model& m) {
    give(region, regions::add_boundary_disc(m.editable_scene(), material, {x, y}, radius, element_length));
  });
}

bempd_status bempd_add_pd_region(bempd_model* model, int32_t material, int64_t vertex_count, const double* vertices,
                                 double spacing, int32_t horizon_ratio, int32_t* region) {
  return add_pd_region(model, __func__, material, {vertex_count, vertices}, spacing, horizon_ratio, 0, region);
}

bempd_status bempd_add_pd_region_with_arcs(bempd_model* model, int32_t material, int64_t vertex_count,
                                           const double* vertices, const double* bulges, double spacing,
                                           int32_t horizon_ratio, int32_t* region) {
  return add_pd_region(model, __func__, material, {vertex_count, vertices, bulges}, spacing, horizon_ratio, 0, region);
}

bempd_status bempd_add_turned_pd_region(bempd_model* model, int32_t material, int64_t vertex_count,
                                        const double* vertices, const double* bulges, double spacing,
                                        int32_t horizon_ratio, double angle, int32_t* region) {
  return add_pd_region(model, __func__, material, {vertex_count, vertices, bulges}, spacing, horizon_ratio, angle,
                       region);
}

bempd_status bempd_add_hole(bempd_model* model, int32_t region, int64_t vertex_count, const double* vertices,
                            int32_t* first_edge) {
  return add_hole(model, __func__, region, {vertex_count, vertices}, first_edge);
}

bempd_status bempd_add_hole_with_arcs(bempd_model* model, int32_t region, int64_t vertex_count, const double* vertices,
                                      const double* bulges, int32_t* first_edge) {
  return add_hole(model, __func__, region, {vertex_count, vertices, bulges}, first_edge);
}

bempd_status bempd_add_circular_hole(bempd_model* model, int32_t region, double x, double y, double radius,
                                     int32_t* first_edge) {
  return with_model(model, __func__, [&](model::Model& m) {
    give(first_edge, m.editable_scene().shape_of(region).add_circular_hole({x, y}, radius));
  });
}

bempd_status bempd_set_edge_arc(bempd_model* model, int32_t region, int32_t edge, double x, double y) {
  return with_model(model, __func__, [&](model::Model& m) {
    m.editable_scene().shape_of(region).set_arc(edge, {x, y});
  });
}

bempd_status bempd_set_edge_arc_about(bempd_model* model, int32_t region, int32_t edge, double x, double y,
                                      double radius, int32_t turn) {
  return with_model(model, __func__, [&](model::Model& m) {
    require(turn == BEMPD_COUNTER_CLOCKWISE || turn == BEMPD_CLOCKWISE, "turn is ", turn,
            "; it must be BEMPD_COUNTER_CLOCKWISE (1) or BEMPD_CLOCKWISE (2)");
    m.editable_scene().shape_of(region).set_arc_about(edge, {x, y}, radius, turn == BEMPD_CLOCKWISE);
  });
}

bempd_status bempd_set_edges_smooth(bempd_model* model, int32_t region, int32_t first_edge, int32_t last_edge) {
  return with_model(model, __func__,
                    [&](model::Model& m) { m.editable_scene().shape_of(region).set_smooth(first_edge, last_edge); });
}

bempd_status bempd_set_edge_mesh(bempd_model* model, int32_t region, int32_t edge, double element_length,
                                 double grading) {
  return with_model(model, __func__, [&](model::Model& m) {
    m.editable_scene().shape_of(region).set_mesh(edge, {element_length, grading});
  });
}

bempd_status bempd_set_toughness_at(bempd_model* model, int32_t region, int64_t count, const double* places,
                                    const double* values) {
  return with_model(model, __func__, [&](model::Model& m) {
    require(count >= 1, "count is ", count, "; give at least one place with its value");
    require(values != nullptr, "values is NULL; give ", count, " fracture energies");
    m.editable_scene().set_toughness(region, points_from(places, count, "places"), {values, values + count});
  });
}

namespace {

// Two columns of a table of fracture energies: `at`, which messages call `first`, and `energies`.
std::pair<std::vector<double>, std::vector<double>> energy_table(std::int64_t count, const double* at,
                                                                 const char* first, const double* energies) {
  require(count >= 1, "count is ", count, "; give at least one row of the table");
  require(at != nullptr, first, " is NULL; give ", count, " numbers");
  require(energies != nullptr, "energies is NULL; give ", count, " fracture energies");
  return {{at, at + count}, {energies, energies + count}};
}

}  // namespace

bempd_status bempd_set_resistance_curve(bempd_model* model, int32_t material, int64_t count, const double* extensions,
                                        const double* energies) {
  return with_model(model, __func__, [&](model::Model& m) {
    auto [at, values] = energy_table(count, extensions, "extensions", energies);
    scene::set_resistance_curve(m.editable_scene(), material, std::move(at), std::move(values));
  });
}

bempd_status bempd_set_resistance_directions(bempd_model* model, int32_t material, int64_t count, const double* angles,
                                             const double* energies) {
  return with_model(model, __func__, [&](model::Model& m) {
    auto [at, values] = energy_table(count, angles, "angles", energies);
    scene::set_resistance_directions(m.editable_scene(), material, std::move(at), std::move(values));
  });
}

bempd_status bempd_add_crack(bempd_model* model, int64_t point_count, const double* points, int32_t* crack) {
  return with_model(model, __func__, [&](model::Model& m) {
    give(crack, m.editable_scene().add_crack(points_from(points, point_count, "points")));
  });
}

bempd_status bempd_remove_region(bempd_model* model, int32_t region) {
  return with_model(model, __func__, [&](model::Model& m) { m.editable_scene().remove_region(region); });
}

bempd_status bempd_remove_crack(bempd_model* model, int32_t crack) {
  return with_model(model, __func__, [&](model::Model& m) { m.editable_scene().remove_crack(crack); });
}

bempd_status bempd_region_count(const bempd_model* model, int32_t* count) {
  return with_model(model, __func__, [&](const model::Model& m) { out(count, "count") = m.scene().region_count(); });
}

bempd_status bempd_edge_count(const bempd_model* model, int32_t region, int32_t* count) {
  return with_model(model, __func__,
                    [&](const model::Model& m) { out(count, "count") = m.scene().region(region).edge_count(); });
}
