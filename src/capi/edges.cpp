#include <algorithm>

#include "capi/guard.hpp"
#include "geometry/edge.hpp"

using namespace bempd;
using namespace bempd::capi;

namespace {

std::vector<double> pairs_from(std::int64_t count, const double* values) {
  require_count(count, "count", "value");
  return numbers_or_zeros(values, 2 * static_cast<std::size_t>(count));
}

scene::PlacedValues placed_values(std::int64_t count, const double* fractions, const double* constant,
                                  const double* proportional) {
  scene::PlacedValues values{{}, pairs_from(count, constant), pairs_from(count, proportional)};
  require(fractions != nullptr, "fractions is NULL; give a fraction of the part for each place");
  values.fractions.assign(fractions, fractions + count);
  return values;
}

void require_room(std::int64_t capacity, std::size_t needed, const char* what) {
  require(capacity >= static_cast<std::int64_t>(needed), "capacity is ", capacity, "; the edge has ", needed, " ",
          what);
}

}  // namespace

bempd_status bempd_set_support_values_at(bempd_model* model, int32_t support, int64_t count, const double* fractions,
                                         const double* constant, const double* proportional) {
  return with_model(model, __func__, [&](model::Model& m) {
    m.loads().set_support_values(support, placed_values(count, fractions, constant, proportional));
  });
}

bempd_status bempd_set_load_values_at(bempd_model* model, int32_t load, int64_t count, const double* fractions,
                                      const double* constant, const double* proportional) {
  return with_model(model, __func__, [&](model::Model& m) {
    m.loads().set_load_values(load, placed_values(count, fractions, constant, proportional));
  });
}

bempd_status bempd_set_support_nodal_values(bempd_model* model, int32_t support, int64_t count, const double* constant,
                                            const double* proportional) {
  return with_model(model, __func__, [&](model::Model& m) {
    m.loads().set_nodal_values(true, support, pairs_from(count, constant), pairs_from(count, proportional));
  });
}

bempd_status bempd_set_load_nodal_values(bempd_model* model, int32_t load, int64_t count, const double* constant,
                                         const double* proportional) {
  return with_model(model, __func__, [&](model::Model& m) {
    m.loads().set_nodal_values(false, load, pairs_from(count, constant), pairs_from(count, proportional));
  });
}

bempd_status bempd_fractions_on_edge(const bempd_model* model, int32_t region, int32_t edge, int64_t count,
                                     const double* points, double* fractions, double* distances) {
  return with_model(model, __func__, [&](const model::Model& m) {
    const Edge line = m.scene().region_with_edge(region, edge).edge(edge);
    const std::vector<Point> places = points_from(points, count, "points");
    for (std::size_t i = 0; i < places.size(); ++i) {
      require(std::isfinite(distance(line, places[i])), "point ", i + 1, " is (", places[i].x(), ", ", places[i].y(),
              "); its distance to the edge must be a finite number");
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (fractions) fractions[i] = std::clamp(closest_fraction(line, places[i]), 0.0, 1.0);
      if (distances) distances[i] = distance(line, places[i]);
    }
  });
}

bempd_status bempd_edge_size(bempd_model* model, int32_t region, int32_t edge, int64_t* nodes, int64_t* elements) {
  return with_model(model, __func__, [&](model::Model& m) {
    if (nodes) *nodes = static_cast<int64_t>(m.edges().nodes(region, edge).size());
    if (elements) *elements = static_cast<int64_t>(m.edges().cells(region, edge).size());
  });
}

bempd_status bempd_copy_edge_nodes(bempd_model* model, int32_t region, int32_t edge, int64_t capacity, int32_t* nodes,
                                   double* fractions, double* weights) {
  return with_model(model, __func__, [&](model::Model& m) {
    const std::vector<regions::EdgeNode> all = m.edges().nodes(region, edge);
    require_room(capacity, all.size(), "nodes");
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (nodes) nodes[i] = all[i].entry;
      if (fractions) fractions[i] = all[i].fraction;
      if (weights) weights[i] = all[i].weight;
    }
  });
}

bempd_status bempd_copy_edge_elements(bempd_model* model, int32_t region, int32_t edge, int64_t capacity,
                                      int32_t* elements) {
  return with_model(model, __func__, [&](model::Model& m) {
    const std::vector<int> all = m.edges().cells(region, edge);
    require_room(capacity, all.size(), "elements");
    std::copy(all.begin(), all.end(), &out(elements, "elements"));
  });
}

bempd_status bempd_copy_edge_forces(bempd_model* model, int32_t region, int32_t edge, int64_t capacity,
                                    double* forces) {
  return with_model(model, __func__, [&](model::Model& m) {
    out(forces, "forces");
    require_room(capacity, m.edges().nodes(region, edge).size(), "nodes");
    const std::vector<Point> all = m.edges().forces(region, edge);
    for (std::size_t i = 0; i < all.size(); ++i) std::copy_n(all[i].data(), 2, forces + 2 * i);
  });
}
