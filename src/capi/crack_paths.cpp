#include "capi/guard.hpp"

using namespace bempd;
using namespace bempd::capi;

bempd_status bempd_crack_count(const bempd_model* model, int64_t* count) {
  return with_model(model, __func__, [&](const model::Model& m) { out(count, "count") = m.cracks().count(); });
}

bempd_status bempd_crack_length(const bempd_model* model, int32_t crack, double* length) {
  return with_model(model, __func__, [&](const model::Model& m) { out(length, "length") = m.cracks().length(crack); });
}

bempd_status bempd_path_vertex_init(bempd_path_vertex* vertex, int64_t struct_size) {
  return init_struct(__func__, "vertex", vertex, struct_size, bempd_path_vertex{});
}

bempd_status bempd_crack_path_count(const bempd_model* model, int32_t crack, int64_t* count) {
  return with_model(model, __func__, [&](const model::Model& m) {
    out(count, "count") = static_cast<int64_t>(m.cracks().path(crack).size());
  });
}

bempd_status bempd_crack_path(const bempd_model* model, int32_t crack, int64_t index, bempd_path_vertex* vertex) {
  return with_model(model, __func__, [&](const model::Model& m) {
    struct_bytes(vertex, "vertex");
    const std::vector<crack::PathVertex> path = m.cracks().path(crack);
    const crack::PathVertex& v = entry_at(path, index, text("; the path of crack ", crack, " has "), " vertices");
    write_struct(vertex,
                 bempd_path_vertex{
                     .struct_size = sizeof(bempd_path_vertex),
                     .event = v.event,
                     .end = v.end + 1,
                     .x = v.place.x(),
                     .y = v.place.y(),
                     .load_factor = v.load_factor,
                     .stress_intensity_1 = v.factors.x(),
                     .stress_intensity_2 = v.factors.y(),
                     .energy_release_rate = v.energy_release_rate,
                     .resistance = v.resistance,
                 },
                 "vertex");
  });
}
