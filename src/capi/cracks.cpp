#include "capi/described_tip.hpp"
#include "capi/guard.hpp"

using namespace bempd;
using namespace bempd::capi;

namespace bempd::capi {

bempd_crack_tip described(const regions::TipValues& t) {
  return {
      .struct_size = sizeof(bempd_crack_tip),
      .crack = t.crack,
      .end = end_of(t.end),
      .x = t.place.x(),
      .y = t.place.y(),
      .direction_x = t.direction.x(),
      .direction_y = t.direction.y(),
      .stress_intensity_1 = t.factors.x(),
      .stress_intensity_2 = t.factors.y(),
      .energy_release_rate = t.energy_release_rate,
      .t_stress = t.stress_along,
      .error = t.error,
      .kink_angle = t.kink_angle,
      .critical_load_factor = t.critical_load_factor,
      .method = static_cast<int32_t>(t.method),
      .contours = t.contours,
      .grown = t.grown ? 1 : 0,
      .branched = t.branched ? 1 : 0,
      .contour_radius = t.contour_radius,
      .felt_ahead = t.felt_ahead,
      .critical_load_factor_down = t.critical_load_factor_down,
      .critical_kink_angle = t.critical_kink_angle,
      .straight_load_factor = t.straight_load_factor,
      .load_rule = static_cast<int32_t>(t.load_rule),
      .closed = t.closed ? 1 : 0,
      .load_error = t.load_error,
      .valid_radius = t.valid_radius,
  };
}

void give_growth(bempd_growth* place, const model::GrowthResult& grown) {
  if (!place) return;
  write_struct(place,
               bempd_growth{sizeof(bempd_growth), grown.tips, grown.ended, grown.load_factor, grown.length,
                            grown.released_energy},
               "growth");
}

}  // namespace bempd::capi

bempd_status bempd_crack_tip_init(bempd_crack_tip* tip, int64_t struct_size) {
  return init_struct(__func__, "tip", tip, struct_size, bempd_crack_tip{});
}

bempd_status bempd_tip_count(bempd_model* model, int64_t* count) {
  return with_model(model, __func__,
                    [&](model::Model& m) { out(count, "count") = static_cast<int64_t>(m.cracks().tips().size()); });
}

bempd_status bempd_tip(bempd_model* model, int64_t index, bempd_crack_tip* tip) {
  return with_model(model, __func__, [&](model::Model& m) {
    struct_bytes(tip, "tip");
    write_struct(tip, described(entry_at(m.cracks().tips(), index, "; cracks have ", " tips")), "tip");
  });
}

bempd_status bempd_tip_history_count(const bempd_model* model, int64_t* count) {
  return with_model(model, __func__, [&](const model::Model& m) {
    out(count, "count") = static_cast<int64_t>(m.cracks().history().size());
  });
}

bempd_status bempd_get_tip_history(const bempd_model* model, int64_t index, int64_t* event, int64_t* total_broken_bonds,
                                   double* load_factor, bempd_crack_tip* tip) {
  return with_model(model, __func__, [&](const model::Model& m) {
    struct_bytes(tip, "tip");
    const results::TipRecord& record =
        entry_at(m.cracks().history(), index, "; ", " tips were recorded; set the option tips.record before stepping");
    write_struct(tip, described(record.tip), "tip");
    give(event, record.event);
    give(total_broken_bonds, record.total_broken_bonds);
    give(load_factor, record.load_factor);
  });
}

bempd_status bempd_growth_init(bempd_growth* growth, int64_t struct_size) {
  return init_struct(__func__, "growth", growth, struct_size, bempd_growth{});
}

bempd_status bempd_grow_cracks(bempd_model* model, double length, bempd_growth* growth) {
  return with_model(model, __func__, [&](model::Model& m) {
    if (growth) struct_bytes(growth, "growth");
    give_growth(growth, m.growth().grow(length));
  });
}

bempd_status bempd_set_tip_frozen(bempd_model* model, int32_t crack, int32_t end, int32_t frozen) {
  return with_model(model, __func__, [&](model::Model& m) {
    const int side = end_from(end);
    require(frozen == 0 || frozen == 1, "frozen is ", frozen, "; it must be 0 or 1");
    m.growth().set_frozen(crack, side, frozen == 1);
  });
}

bempd_status bempd_crack_extension_init(bempd_crack_extension* extension, int64_t struct_size) {
  return init_struct(__func__, "extension", extension, struct_size, bempd_crack_extension{});
}

bempd_status bempd_extension_count(const bempd_model* model, int64_t* count) {
  return with_model(model, __func__, [&](const model::Model& m) {
    out(count, "count") = static_cast<int64_t>(m.cracks().extensions().size());
  });
}

bempd_status bempd_extension(const bempd_model* model, int64_t index, bempd_crack_extension* extension) {
  return with_model(model, __func__, [&](const model::Model& m) {
    struct_bytes(extension, "extension");
    const auto all = m.cracks().extensions();
    const fracture::CrackExtension& e = entry_at(all, index, "; cracks have been extended ", " times");
    int32_t so_far = 0;
    for (const fracture::CrackExtension& other : all.first(static_cast<std::size_t>(index) + 1))
      so_far += other.tip() == e.tip();
    write_struct(extension,
                 bempd_crack_extension{
                     .struct_size = sizeof(bempd_crack_extension),
                     .event = e.event,
                     .crack = e.crack,
                     .end = end_of(e.end),
                     .ended = e.has_ended(),
                     .count = so_far,
                     .x = e.x,
                     .y = e.y,
                     .angle = e.angle,
                     .length = e.length,
                     .crack_length = e.crack_length,
                     .load_factor = e.load_factor,
                     .energy_release_rate_before = e.rate_before,
                     .energy_release_rate_after = e.rate_after,
                     .released_energy = e.released_energy,
                     .from_x = e.from_x,
                     .from_y = e.from_y,
                     .stress_intensity_1 = e.factor_1,
                     .stress_intensity_2 = e.factor_2,
                     .resistance = e.resistance,
                     .state = static_cast<int32_t>(e.state),
                     .reserved = 0,
                     .surface_energy = e.surface_energy,
                 },
                 "extension");
  });
}

bempd_status bempd_crack_opening(bempd_model* model, int32_t crack, int64_t count, const double* fractions,
                                 double* normal, double* tangential) {
  return with_model(model, __func__, [&](model::Model& m) {
    require_count(count, "count", "place");
    require(fractions != nullptr, "fractions is NULL; give places as fractions of the crack's length");
    const std::vector<Point> openings = m.cracks().openings(crack, {fractions, fractions + count});
    for (std::size_t i = 0; i < openings.size(); ++i) {
      if (normal) normal[i] = openings[i].y();
      if (tangential) tangential[i] = openings[i].x();
    }
  });
}
