#include "capi/guard.hpp"

using namespace bempd;
using namespace bempd::capi;

bempd_status bempd_write_snapshot(bempd_model* model, const char* prefix) {
  return with_model(model, __func__, [&](model::Model& m) {
    require(prefix != nullptr && *prefix != '\0', "prefix is NULL or empty; give a path without ending");
    m.files().write_snapshot(prefix);
  });
}

bempd_status bempd_write_history(const bempd_model* model, const char* path) {
  return with_model(model, __func__, [&](const model::Model& m) { m.files().write_history(file_name(path)); });
}

bempd_status bempd_write_tips(const bempd_model* model, const char* path) {
  return with_model(model, __func__, [&](const model::Model& m) { m.files().write_tips(file_name(path)); });
}
