#include <algorithm>

#include "capi/guard.hpp"

using namespace bempd;
using namespace bempd::capi;

bempd_status bempd_singularity_init(bempd_singularity* singularity, int64_t struct_size) {
  return init_struct(__func__, "singularity", singularity, struct_size, bempd_singularity{});
}

bempd_status bempd_singularity_count(bempd_model* model, int64_t* count) {
  return with_model(model, __func__, [&](model::Model& m) {
    out(count, "count") = static_cast<int64_t>(m.results().singular_places().size());
  });
}

bempd_status bempd_get_singularity(bempd_model* model, int64_t index, bempd_singularity* singularity) {
  return with_model(model, __func__, [&](model::Model& m) {
    struct_bytes(singularity, "singularity");
    const regions::SingularPlace& s =
        entry_at(m.results().singular_places(), index, "; stress is unbounded at ", " places");
    write_struct(singularity,
                 bempd_singularity{sizeof(bempd_singularity), static_cast<int32_t>(s.kind), s.region, s.place.x(),
                                   s.place.y(), s.exponent.real(), s.exponent.imag()},
                 "singularity");
  });
}

bempd_status bempd_stress_orders(bempd_model* model, int64_t count, const double* points, double* orders) {
  return with_model(model, __func__, [&](model::Model& m) {
    const std::vector<double> found = m.results().stress_orders(points_from(points, count, "points"));
    std::copy(found.begin(), found.end(), found.empty() ? orders : &out(orders, "orders"));
  });
}
