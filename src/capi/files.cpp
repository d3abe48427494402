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
  return with_model(model, __func__, [&](const model::Model& m) {
    require(path != nullptr && *path != '\0', "path is NULL or empty; give a file name");
    m.files().write_history(path);
  });
}

bempd_status bempd_write_tips(const bempd_model* model, const char* path) {
  return with_model(model, __func__, [&](const model::Model& m) {
    require(path != nullptr && *path != '\0', "path is NULL or empty; give a file name");
    m.files().write_tips(path);
  });
}
