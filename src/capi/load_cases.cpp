#include "model/load_cases.hpp"

#include "capi/described_tip.hpp"
#include "capi/guard.hpp"

using namespace bempd;
using namespace bempd::capi;

namespace {

std::vector<int> ids_from(std::int64_t count, const std::int32_t* ids, const char* name) {
  require(count >= 0, "there are ", count, " ", name, "; give 0 or more");
  require(count == 0 || ids != nullptr, name, " is NULL; give ", count, " ids");
  return std::vector<int>(ids, ids + count);
}

std::vector<double> factors_from(std::int64_t count, const double* factors) {
  require(count >= 1, "case_count is ", count, "; give a factor for each load case, at least 1");
  require(factors != nullptr, "factors is NULL; give ", count, " numbers");
  return std::vector<double>(factors, factors + count);
}

}  // namespace

bempd_status bempd_load_case_add(bempd_model* model, int64_t load_count, const int32_t* loads, int64_t support_count,
                                 const int32_t* supports, int32_t* load_case) {
  return with_model(model, __func__, [&](model::Model& m) {
    give(load_case,
         m.load_cases().add(ids_from(load_count, loads, "loads"), ids_from(support_count, supports, "supports")));
  });
}

bempd_status bempd_load_case_count(const bempd_model* model, int32_t* count) {
  return with_model(model, __func__, [&](const model::Model& m) { out(count, "count") = m.load_cases().count(); });
}

bempd_status bempd_load_case_tip_count(bempd_model* model, int64_t case_count, const double* factors, int64_t* count) {
  return with_model(model, __func__, [&](model::Model& m) {
    out(count, "count") = static_cast<int64_t>(m.load_cases().under(factors_from(case_count, factors)).tips.size());
  });
}

bempd_status bempd_load_case_tip(bempd_model* model, int64_t case_count, const double* factors, int64_t index,
                                 bempd_crack_tip* tip) {
  return with_model(model, __func__, [&](model::Model& m) {
    struct_bytes(tip, "tip");
    const auto& tips = m.load_cases().under(factors_from(case_count, factors)).tips;
    write_struct(tip, described(entry_at(tips, index, "; cracks have ", " tips")), "tip");
  });
}

bempd_status bempd_load_case_reaction(bempd_model* model, int64_t case_count, const double* factors, int32_t support,
                                      double* force) {
  return with_model(model, __func__, [&](model::Model& m) {
    m.scene().support(support);
    out(force, "force");
    const auto& reactions = m.load_cases().under(factors_from(case_count, factors)).reactions;
    std::copy_n(reactions[static_cast<std::size_t>(support) - 1].data(), 2, force);
  });
}

bempd_status bempd_load_case_evaluate(bempd_model* model, int64_t case_count, const double* factors, int64_t count,
                                      const double* points, double* displacement, double* stress) {
  return with_model(model, __func__, [&](model::Model& m) {
    const auto values = m.load_cases().evaluate(factors_from(case_count, factors), points_from(points, count, "points"),
                                                stress != nullptr);
    give_values(values, displacement, stress);
  });
}

bempd_status bempd_load_case_pressed_faces(bempd_model* model, int64_t case_count, const double* factors,
                                           int64_t* count) {
  return with_model(model, __func__, [&](model::Model& m) {
    out(count, "count") = m.load_cases().under(factors_from(case_count, factors)).pressed;
  });
}
