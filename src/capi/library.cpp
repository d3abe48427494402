#include <cstdint>
#include <cstring>

#include "capi/guard.hpp"
#include "linalg/blas.hpp"
#include "linalg/sparse_cholesky.hpp"

using namespace bempd;
using namespace bempd::capi;

namespace {

void require_name(const char* name) { require(name != nullptr, "name is NULL; give an option's name"); }

}  // namespace

const char* bempd_version_string(void) { return BEMPD_VERSION; }

const char* bempd_build_info(void) {
  static const std::string info = [] {
    return std::string("bempd ") + BEMPD_VERSION + ", sparse factorization " + linalg::backend_name() + ", Eigen " +
           std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
           std::to_string(EIGEN_MINOR_VERSION) + ", compiler " + __VERSION__ + ", " +
           linalg::describe(linalg::running_blas());
  }();
  return info.c_str();
}

const char* bempd_status_name(bempd_status status) {
  // The status is read as an integer, because a host may pass a number that no enumerator has.
  std::int32_t value;
  static_assert(sizeof value == sizeof status);
  std::memcpy(&value, &status, sizeof value);
  switch (value) {
    case BEMPD_OK:
      return "BEMPD_OK";
    case BEMPD_ERROR_ARGUMENT:
      return "BEMPD_ERROR_ARGUMENT";
    case BEMPD_ERROR_ORDER:
      return "BEMPD_ERROR_ORDER";
    case BEMPD_ERROR_UNSOLVABLE:
      return "BEMPD_ERROR_UNSOLVABLE";
    case BEMPD_ERROR_CONVERGENCE:
      return "BEMPD_ERROR_CONVERGENCE";
    case BEMPD_ERROR_CANCELLED:
      return "BEMPD_ERROR_CANCELLED";
    case BEMPD_ERROR_MEMORY:
      return "BEMPD_ERROR_MEMORY";
    case BEMPD_ERROR_IO:
      return "BEMPD_ERROR_IO";
    case BEMPD_ERROR_INTERNAL:
      return "BEMPD_ERROR_INTERNAL";
  }
  return "unknown status";
}

const char* bempd_last_error(const bempd_model* model) {
  if (!model) return thread_error().c_str();
  return model->error.c_str();
}

bempd_status bempd_model_create(bempd_model** model) {
  return without_model(__func__, [&] {
    bempd_model*& created = out(model, "model");
    created = new bempd_model;
  });
}

void bempd_model_free(bempd_model* model) {
  if (model && model->use.exchange(Use::to_be_freed) == Use::idle) delete model;
}

bempd_status bempd_option_info_init(bempd_option_info* info, int64_t struct_size) {
  return init_struct(__func__, "info", info, struct_size, {});
}

bempd_status bempd_option_count(int64_t* count) {
  return without_model(__func__,
                       [&] { out(count, "count") = static_cast<int64_t>(scene::option_descriptions().size()); });
}

bempd_status bempd_option_describe(int64_t index, bempd_option_info* info) {
  return without_model(__func__, [&] {
    const auto& all = scene::option_descriptions();
    require(index >= 0 && index < static_cast<int64_t>(all.size()), "index is ", index, "; options are 0 .. ",
            all.size() - 1);
    const scene::OptionDescription& o = all[static_cast<std::size_t>(index)];
    const bempd_option_info values{
        .struct_size = sizeof(bempd_option_info),
        .name = o.name,
        .summary = o.summary,
        .unit = o.unit,
        .choices = o.choices,
        .default_text = o.default_text,
        .kind = o.is_text ? BEMPD_OPTION_TEXT : BEMPD_OPTION_NUMBER,
        .whole_number = o.whole_number ? 1 : 0,
        .default_value = o.default_value,
        .minimum = o.minimum,
        .maximum = o.maximum,
    };
    write_struct(info, values, "info");
  });
}

bempd_status bempd_set_option(bempd_model* model, const char* name, double value) {
  return with_model(model, __func__, [&](model::Model& m) {
    require_name(name);
    m.options().set(name, value);
  });
}

bempd_status bempd_get_option(const bempd_model* model, const char* name, double* value) {
  return with_model(model, __func__, [&](const model::Model& m) {
    require_name(name);
    scene::Options::require_known(name);
    out(value, "value") = m.options().number(name);
  });
}

bempd_status bempd_set_option_text(bempd_model* model, const char* name, const char* value) {
  return with_model(model, __func__, [&](model::Model& m) {
    require_name(name);
    require(value != nullptr, "value is NULL; give one of the option's words");
    m.set_option_text(name, value);
  });
}

bempd_status bempd_get_option_text(const bempd_model* model, const char* name, char* buffer, int64_t capacity,
                                   int64_t* needed) {
  return with_model(model, __func__, [&](const model::Model& m) {
    require_name(name);
    scene::Options::require_known(name);
    const std::string& value = m.options().text_value(name);
    write_text(value, buffer, capacity, needed);
  });
}
