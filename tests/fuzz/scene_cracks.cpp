// Bodies of curved outlines, cracks in boundary elements with their growth, pieces, and what is removed.
#include <array>
#include <cmath>

#include "checks.hpp"
#include "scene.hpp"

namespace fuzz {

void Scene::add_curved() {
  const std::int32_t material = 1 + bytes_.pick(2);
  const double length = (1 + bytes_.pick(2)) * scale_, size = (3 + bytes_.pick(4)) * scale_;
  const double left = front_ * scale_;
  static constexpr std::array bends = {0.0, 0.1, -0.1, 0.4, -0.4, 1.0, 2.4};
  std::array<double, 4> bulges;
  for (double& bulge : bulges) bulge = bytes_.mostly(bytes_.of(bends));
  const std::array vertices = {left, 0.0, left + size, 0.0, left + size, size, left, size};
  const double x = left + 0.5 * size, y = 0.5 * size;
  bool added = false;
  switch (bytes_.pick(5)) {
    case 0:
      added = FUZZ_CALL(bempd_add_bem_disc, model_, material, x, y, bytes_.mostly(0.5 * size), length, nullptr);
      break;
    case 1:
      if (length > scale_) {
        added = FUZZ_CALL(bempd_add_bem_region_with_arcs, model_, material, 4, vertices.data(), bulges.data(), length,
                          nullptr);
      } else {
        added = bulges[0] == 0
                    ? FUZZ_CALL(bempd_add_body, model_, material, 4, vertices.data(), nullptr)
                    : FUZZ_CALL(bempd_add_body_with_arcs, model_, material, 4, vertices.data(), bulges.data(), nullptr);
      }
      break;
    case 2:
      added = FUZZ_CALL(bempd_add_pd_region_with_arcs, model_, material, 4, vertices.data(), bulges.data(), scale_, 3,
                        nullptr);
      break;
    case 3:
      added = FUZZ_CALL(bempd_add_turned_pd_region, model_, material, 4, vertices.data(), nullptr, scale_, 3,
                        bytes_.mostly(0.3), nullptr);
      break;
    default: {
      const double part = 0.15 * size;
      const std::array hole = {x, y - part, x - part, y, x, y + part, x + part, y};
      FUZZ_CALL(bempd_add_hole_with_arcs, model_, region(), 4, hole.data(), bulges.data(), nullptr);
    }
  }
  if (!added) return;
  ++regions_;
  if (bytes_.pick(3) > 0) return;
  FUZZ_CALL(bempd_set_body_lattice, model_, regions_, bytes_.mostly(0.25 * scale_), 3);
  FUZZ_CALL(bempd_set_crack_treatment, model_, 1, 1 + bytes_.pick(5));
  front_ = front_ > 20 ? 0 : (left + size) / scale_;
}

// A plate of boundary elements alone, which may grow its cracks.
void Scene::build_cracked() {
  add_material(true);
  add_box(false);
  if (corners_.empty()) return;
  const Place first = corners_[0], last = corners_[2];
  const int cracks = 1 + bytes_.pick(2);
  for (int k = 0; k < cracks; ++k) {
    std::array<double, 4> points;
    for (std::size_t end = 0; end < 2; ++end) {
      points[2 * end] = first.x + (last.x - first.x) * bytes_.pick(11) / 10.0;
      points[2 * end + 1] = first.y + (last.y - first.y) * (1 + bytes_.pick(9)) / 10.0;
    }
    FUZZ_CALL(bempd_add_crack, model_, 2, points.data(), nullptr);
  }
  FUZZ_CALL(bempd_fix_edge, model_, 1, 1, BEMPD_BOTH, nullptr);
  ++supports_;
  support_values_.push_back(1);
  const double pull = bytes_.mostly(1e-3);
  if (FUZZ_CALL(bempd_add_traction, model_, 1, 3, 0.0, 1.0, BEMPD_Y, 1, nullptr, &pull, nullptr))
    ++loads_, load_values_.push_back(1);
  if (FUZZ_CALL(bempd_add_crack_traction, model_, 1, 1 + bytes_.pick(2), 1, nullptr, &pull, nullptr))
    ++loads_, load_values_.push_back(1);
  advance();
  if (bytes_.pick(2) == 0) grow();
  if (bytes_.pick(3) == 1) grow_by_cycles();
}

void Scene::grow() {
  const Marks before = marks();
  bempd_growth growth;
  good("bempd_growth_init", nullptr, bempd_growth_init(&growth, sizeof growth));
  FUZZ_CALL(bempd_set_tip_frozen, model_, 1 + bytes_.pick(3), 1 + bytes_.pick(2), bytes_.pick(2));
  if (!FUZZ_CALL(bempd_grow_cracks, model_, bytes_.mostly(0.2 * scale_), &growth)) {
    require_same("bempd_grow_cracks", before, marks());
  } else {
    const std::array numbers = {growth.load_factor, growth.length, growth.released_energy};
    require_finite("bempd_grow_cracks", numbers.data(), numbers.size());
    require_true(growth.tips > 0 && growth.ended <= growth.tips, "bempd_grow_cracks", "no tip has grown");
  }
  read_tips();
}

void Scene::grow_by_cycles() {
  const Marks before = marks();
  bempd_growth_rate rate;
  good("bempd_growth_rate_init", nullptr, bempd_growth_rate_init(&rate, sizeof rate));
  rate.kind = 1 + bytes_.pick(4);
  rate.coefficient = bytes_.mostly(1.0), rate.exponent = bytes_.mostly(2.0);
  rate.critical_intensity = bytes_.mostly(10.0), rate.threshold = bytes_.mostly(0.0);
  rate.flow_stress = bytes_.mostly(0.0);
  FUZZ_CALL(bempd_set_growth_rate, model_, 1, &rate);
  bempd_fatigue options;
  good("bempd_fatigue_init", nullptr, bempd_fatigue_init(&options, sizeof options));
  options.most_steps = 1 + bytes_.pick(3);
  bempd_fatigue_report report;
  good("bempd_fatigue_report_init", nullptr, bempd_fatigue_report_init(&report, sizeof report));
  const std::array high = {bytes_.mostly(1.0), 0.5}, low = {bytes_.mostly(-0.5), 0.0},
                   cycles = {bytes_.mostly(10.0), 3.0};
  if (!FUZZ_CALL(bempd_grow_fatigue, model_, 1 + bytes_.pick(2), high.data(), low.data(), cycles.data(), &options,
                 &report)) {
    require_same("bempd_grow_fatigue", before, marks());
  } else {
    const std::array numbers = {report.cycles, report.growth};
    require_finite("bempd_grow_fatigue", numbers.data(), numbers.size());
    // The error of cycles is not known before some tip has led two steps.
    const bool may_be_unknown = report.steps > 0;
    require_true(std::isnan(report.error) ? may_be_unknown : report.error >= 0 && std::isfinite(report.error),
                 "bempd_grow_fatigue", "an error that is no number");
    require_true(report.steps <= options.most_steps, "bempd_grow_fatigue", "too many steps");
  }
  std::int64_t count = 0;
  bempd_fatigue_record record;
  good("bempd_fatigue_record_init", nullptr, bempd_fatigue_record_init(&record, sizeof record));
  if (FUZZ_CALL(bempd_fatigue_record_count, model_, &count) && count > 0 &&
      FUZZ_CALL(bempd_get_fatigue_record, model_, count - 1, &record)) {
    const std::array numbers = {record.cycles, record.length, record.highest, record.range, record.rate};
    require_finite("bempd_get_fatigue_record", numbers.data(), numbers.size());
  }
  const std::int32_t crack = 1 + bytes_.pick(2), end = 1 + bytes_.pick(2);
  const double length = bytes_.mostly(0.1 * scale_);
  FUZZ_CALL(bempd_extend_cracks, model_, 1, &crack, &end, &length, nullptr);
  combine_load_cases();
}

// A combination of load cases, after which the model is as it was.
void Scene::combine_load_cases() {
  const std::int32_t load = 1 + bytes_.pick(3), support = 1 + bytes_.pick(3);
  FUZZ_CALL(bempd_load_case_add, model_, bytes_.pick(2), &load, bytes_.pick(2), &support, nullptr);
  std::int32_t cases = 0;
  if (!FUZZ_CALL(bempd_load_case_count, model_, &cases) || cases == 0) return;
  const auto before = marks();
  const double factor = bytes_.mostly(-1.0);
  std::int64_t count = 0;
  if (FUZZ_CALL(bempd_load_case_tip_count, model_, 1, &factor, &count) && count > 0) {
    bempd_crack_tip tip;
    good("bempd_crack_tip_init", nullptr, bempd_crack_tip_init(&tip, sizeof tip));
    FUZZ_CALL(bempd_load_case_tip, model_, 1, &factor, count - 1, &tip);
  }
  FUZZ_CALL(bempd_load_case_pressed_faces, model_, 1, &factor, &count);
  const Place at = place();
  const std::array point = {at.x, at.y};
  std::array<double, 2> force{}, displacement{};
  std::array<double, 3> stress{};
  FUZZ_CALL(bempd_load_case_reaction, model_, 1, &factor, support, force.data());
  FUZZ_CALL(bempd_load_case_evaluate, model_, 1, &factor, 1, point.data(), displacement.data(), stress.data());
  require_same("bempd_load_case_tip", before, marks());
  bempd_fatigue options;
  good("bempd_fatigue_init", nullptr, bempd_fatigue_init(&options, sizeof options));
  options.most_steps = 1;
  const double low = bytes_.mostly(0.0);
  if (!FUZZ_CALL(bempd_grow_fatigue_cases, model_, 1, 1, &factor, &low, nullptr, &options, nullptr))
    require_same("bempd_grow_fatigue_cases", before, marks());
}

void Scene::read_tips() {
  bempd_crack_tip tip;
  good("bempd_crack_tip_init", nullptr, bempd_crack_tip_init(&tip, sizeof tip));
  const auto require_tip = [&](const char* call) {
    const std::array places = {tip.x, tip.y, tip.direction_x, tip.direction_y, tip.contour_radius};
    require_finite(call, places.data(), places.size());
    // Less is known of a tip around which no ring fits; the angle of growth is unknown where the tip never grows.
    if (tip.method != BEMPD_TIP_ELEMENTS && tip.contours == 0) {
      require_true(std::isnan(tip.error) && std::isnan(tip.t_stress), call, "rings that do not fit tell");
      return;
    }
    const std::array numbers = {tip.stress_intensity_1,
                                tip.stress_intensity_2,
                                tip.energy_release_rate,
                                tip.t_stress,
                                tip.error,
                                tip.kink_angle,
                                tip.critical_load_factor,
                                tip.critical_load_factor_down,
                                tip.straight_load_factor,
                                tip.felt_ahead};
    require_finite(call, numbers.data(), numbers.size());
  };
  std::int64_t count = 0;
  if (FUZZ_CALL(bempd_tip_count, model_, &count))
    for (std::int64_t k = 0; k <= count; ++k)
      if (FUZZ_CALL(bempd_tip, model_, k, &tip)) require_tip("bempd_tip");
  if (FUZZ_CALL(bempd_tip_history_count, model_, &count) && count > 0 &&
      FUZZ_CALL(bempd_get_tip_history, model_, count - 1, nullptr, nullptr, nullptr, &tip))
    require_tip("bempd_get_tip_history");
  const std::array fractions = {0.0, 0.3, 1.0};
  std::array<double, 6> openings;
  if (FUZZ_CALL(bempd_crack_opening, model_, 1 + bytes_.pick(2), 3, fractions.data(), openings.data(), &openings[3]))
    for (const double opening : openings)
      require_true(!std::isinf(opening), "bempd_crack_opening", "an opening is infinite");
  read_paths();
}

// Growth values are NaN for a crack that begins in a lattice.
void Scene::read_paths() {
  std::int64_t count = 0;
  if (!FUZZ_CALL(bempd_extension_count, model_, &count)) return;
  for (std::int64_t k = 0; k <= count; ++k) {
    bempd_crack_extension e;
    good("bempd_crack_extension_init", nullptr, bempd_crack_extension_init(&e, sizeof e));
    if (!FUZZ_CALL(bempd_extension, model_, k, &e)) continue;
    const std::array numbers = {e.x,      e.y,     e.angle, e.length, e.load_factor, e.crack_length, e.released_energy,
                                e.from_x, e.from_y};
    require_finite("bempd_extension", numbers.data(), numbers.size());
    const std::array rates = {e.energy_release_rate_before, e.stress_intensity_2, e.resistance};
    if (!std::isnan(e.stress_intensity_1)) require_finite("bempd_extension", rates.data(), rates.size());
  }
  if (!FUZZ_CALL(bempd_crack_count, model_, &count)) return;
  const auto crack = static_cast<std::int32_t>(bytes_.pick(3));
  double length = 0;
  if (FUZZ_CALL(bempd_crack_length, model_, crack, &length)) require_finite("bempd_crack_length", &length, 1);
  if (!FUZZ_CALL(bempd_crack_path_count, model_, crack, &count)) return;
  for (std::int64_t k = 0; k <= count; ++k) {
    bempd_path_vertex vertex;
    good("bempd_path_vertex_init", nullptr, bempd_path_vertex_init(&vertex, sizeof vertex));
    if (!FUZZ_CALL(bempd_crack_path, model_, crack, k, &vertex)) continue;
    const std::array place = {vertex.x, vertex.y};
    require_finite("bempd_crack_path", place.data(), place.size());
    require_true(std::isnan(vertex.load_factor) == (vertex.event == 0), "bempd_crack_path", "growth without an event");
  }
}

void Scene::read_pieces() {
  std::int64_t count = 0;
  if (!FUZZ_CALL(bempd_piece_count, model_, &count)) return;
  for (std::int32_t k = 0; k <= count + 1 && k < 6; ++k) {
    bempd_piece piece;
    good("bempd_piece_init", nullptr, bempd_piece_init(&piece, sizeof piece));
    if (!FUZZ_CALL(bempd_get_piece, model_, k, &piece)) continue;
    const std::array numbers = {piece.x, piece.y, piece.move_x, piece.move_y, piece.rotation, piece.deviation};
    require_finite("bempd_get_piece", numbers.data(), numbers.size());
    require_true(piece.nodes > 0 && piece.free_motions >= 0 && piece.free_motions <= 3, "bempd_get_piece", "no piece");
  }
  const std::int32_t of = region();
  std::int64_t nodes = 0;
  if (FUZZ_CALL(bempd_node_count, model_, of, &nodes)) {
    std::vector<std::int32_t> pieces(static_cast<std::size_t>(nodes));
    if (FUZZ_CALL(bempd_copy_node_pieces, model_, of, nodes, pieces.data()))
      for (const std::int32_t piece : pieces)
        require_true(piece >= 1 && piece <= count, "bempd_copy_node_pieces", "no such piece");
  }
  for (std::int32_t id = 0; id <= supports_ && id < 5; ++id) {
    std::int32_t piece = 0, connected = 0;
    if (FUZZ_CALL(bempd_support_piece, model_, id, &piece))
      require_true(piece >= 0 && piece <= count, "bempd_support_piece", "no such piece");
    if (FUZZ_CALL(bempd_load_piece, model_, id, &piece))
      require_true(piece >= 0 && piece <= count, "bempd_load_piece", "no such piece");
    FUZZ_CALL(bempd_are_connected, model_, id, 1, &connected);
  }
}

void Scene::remove() {
  const std::int32_t id = bytes_.pick(4);
  switch (bytes_.pick(4)) {
    case 0:
      FUZZ_CALL(bempd_remove_region, model_, id);
      break;
    case 1:
      FUZZ_CALL(bempd_remove_crack, model_, id);
      break;
    case 2:
      FUZZ_CALL(bempd_remove_support, model_, id);
      break;
    default:
      FUZZ_CALL(bempd_remove_load, model_, id);
  }
}

}  // namespace fuzz
