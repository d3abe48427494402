// Values along a part of an edge, described by one struct of the caller.
#include <algorithm>
#include <cstddef>

#include "capi/guard.hpp"
#include "capi/host_function.hpp"
#include "regions/places/edge_part.hpp"

using namespace bempd;
using namespace bempd::capi;

namespace {

constexpr bempd_edge_values empty_edge_values{
    sizeof(bempd_edge_values), 0, 1, 0, nullptr, nullptr, nullptr, nullptr, nullptr};

bempd_edge_values checked_values(const bempd_edge_values* values) {
  const std::size_t size = struct_bytes(values, "values", sizeof(bempd_edge_values));
  const auto* bytes = reinterpret_cast<const unsigned char*>(values);
  require(std::all_of(bytes + sizeof(bempd_edge_values), bytes + size, [](unsigned char b) { return b == 0; }),
          "values were filled by a program made for a newer bempd, with members this version does not know");
  require(values->kind >= BEMPD_UNIFORM && values->kind <= BEMPD_FUNCTION, "values->kind is ", values->kind,
          "; it must be a bempd_value_kind, 1 .. 5");
  require(values->components == 1 || values->components == 2, "values->components is ", values->components,
          "; it must be 1, or 2 for x and y");
  return *values;
}

std::size_t row_count(const bempd_edge_values& values) {
  if (values.kind == BEMPD_UNIFORM) return 1;
  const std::int64_t least = values.kind == BEMPD_LINEAR ? 2 : 1;
  require(values.count >= least && values.count < (std::int64_t{1} << 31), "values->count is ", values.count,
          "; give at least ", least);
  return static_cast<std::size_t>(values.count);
}

// Rows of `numbers` as pairs (x, y); a single component stands for both. Zeros if `numbers` is null.
std::vector<double> rows_as_pairs(const bempd_edge_values& values, const double* numbers, std::size_t rows) {
  std::vector<double> result(2 * rows, 0.0);
  if (!numbers) return result;
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = numbers[values.components == 2 ? k : k / 2];
  return result;
}

std::vector<double> row_fractions(const bempd_edge_values& values, std::size_t rows) {
  if (values.kind == BEMPD_UNIFORM) return {0};
  std::vector<double> fractions(rows);
  if (values.kind == BEMPD_TABLE) {
    require(values.fractions != nullptr, "values->fractions is NULL; give a fraction of the part for each place");
    std::copy_n(values.fractions, rows, fractions.begin());
  } else {
    for (std::size_t k = 0; k < rows; ++k) fractions[k] = static_cast<double>(k) / static_cast<double>(rows - 1);
  }
  return fractions;
}

scene::PlacedValues values_at_places(const bempd_edge_values& values) {
  const std::size_t rows = row_count(values);
  return {row_fractions(values, rows), rows_as_pairs(values, values.constant, rows),
          rows_as_pairs(values, values.proportional, rows)};
}

bool are_samples(const bempd_edge_values& values) {
  return values.components == 1 && (values.kind == BEMPD_UNIFORM || values.kind == BEMPD_LINEAR);
}

scene::SampledValues values_as_samples(const bempd_edge_values& values) {
  const std::size_t rows = row_count(values);
  return {numbers_or_zeros(values.constant, rows), numbers_or_zeros(values.proportional, rows)};
}

scene::Condition condition_on(std::int32_t region, std::int32_t edge, double from, double to, std::int32_t component,
                              const bempd_edge_values& values) {
  require(values.kind != BEMPD_NODAL,
          "nodes are known once the scene is whole: give one value of 0 for the whole edge now, and the values of its "
          "nodes "
          "by bempd_set_support_edge_values() or bempd_set_load_edge_values()");
  const auto place = std::make_shared<const regions::EdgePart>(region, edge, from, to);
  if (values.kind == BEMPD_FUNCTION) return {place, component, host_function(values.function, values.user)};
  if (are_samples(values)) return {place, component, values_as_samples(values)};
  return {place, component, values_at_places(values)};
}

// Sets new values of a support or a load. Samples remain samples if their number is unchanged; values at nodes are set
// at the nodes; all other values become values at places.
void set_edge_values(model::Model& m, bool of_support, std::int32_t id, const bempd_edge_values& values) {
  require(values.kind != BEMPD_FUNCTION,
          "new values are numbers, not a function: give those of the function as a table");
  const auto& all = of_support ? m.scene().supports() : m.scene().loads();
  const auto sample_count = [&] {
    return id >= 1 && id <= static_cast<int>(all.size()) ? all[static_cast<std::size_t>(id) - 1].sample_count : 0;
  };
  if (values.kind == BEMPD_NODAL) {
    const std::size_t rows = row_count(values);
    m.loads().set_nodal_values(of_support, id, rows_as_pairs(values, values.constant, rows),
                               rows_as_pairs(values, values.proportional, rows));
  } else if (are_samples(values) && sample_count() == row_count(values)) {
    of_support ? m.loads().set_support_values(id, values_as_samples(values))
               : m.loads().set_load_values(id, values_as_samples(values));
  } else {
    of_support ? m.loads().set_support_values(id, values_at_places(values))
               : m.loads().set_load_values(id, values_at_places(values));
  }
}

}  // namespace

bempd_status bempd_edge_values_init(bempd_edge_values* values, int64_t struct_size) {
  return init_struct(__func__, "values", values, struct_size, empty_edge_values);
}

bempd_status bempd_prescribe_edge_values(bempd_model* model, int32_t region, int32_t edge, double from, double to,
                                         int32_t component, const bempd_edge_values* values, int32_t* support) {
  return with_model(model, __func__, [&](model::Model& m) {
    give(support,
         m.editable_scene().add_support(condition_on(region, edge, from, to, component, checked_values(values))));
  });
}

bempd_status bempd_add_traction_values(bempd_model* model, int32_t region, int32_t edge, double from, double to,
                                       int32_t component, const bempd_edge_values* values, int32_t* load) {
  return with_model(model, __func__, [&](model::Model& m) {
    give(load, m.editable_scene().add_load(condition_on(region, edge, from, to, component, checked_values(values))));
  });
}

bempd_status bempd_set_support_edge_values(bempd_model* model, int32_t support, const bempd_edge_values* values) {
  return with_model(model, __func__,
                    [&](model::Model& m) { set_edge_values(m, true, support, checked_values(values)); });
}

bempd_status bempd_set_load_edge_values(bempd_model* model, int32_t load, const bempd_edge_values* values) {
  return with_model(model, __func__, [&](model::Model& m) { set_edge_values(m, false, load, checked_values(values)); });
}
