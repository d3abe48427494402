#include "capi/guard.hpp"

using namespace bempd;
using namespace bempd::capi;

namespace {

const model::SavedState& saved_in(const bempd_state* state) {
  require(state != nullptr, "state is NULL; save one with bempd_state_save()");
  return state->saved;
}

}  // namespace

bempd_status bempd_state_save(bempd_model* model, bempd_state** state) {
  return with_model(model, __func__, [&](model::Model& m) {
    out(state, "state");
    *state = new bempd_state{m.states().save()};
  });
}

bempd_status bempd_state_save_with(bempd_model* model, int32_t contents, bempd_state** state) {
  return with_model(model, __func__, [&](model::Model& m) {
    out(state, "state");
    require(contents == BEMPD_STATE_BODY || contents == BEMPD_STATE_BODY_AND_VALUES, "contents is ", contents,
            "; it must be BEMPD_STATE_BODY (1) or BEMPD_STATE_BODY_AND_VALUES (2)");
    *state = new bempd_state{m.states().save(contents == BEMPD_STATE_BODY_AND_VALUES)};
  });
}

bempd_status bempd_state_restore(bempd_model* model, const bempd_state* state) {
  return with_model(model, __func__, [&](model::Model& m) { m.states().restore(saved_in(state)); });
}

void bempd_state_free(bempd_state* state) { delete state; }

bempd_status bempd_state_to_bytes(const bempd_state* state, int64_t capacity, uint8_t* buffer, int64_t* needed) {
  return without_model(__func__, [&] { write_bytes(model::to_bytes(saved_in(state)), buffer, capacity, needed); });
}

bempd_status bempd_state_from_bytes(int64_t size, const uint8_t* bytes, bempd_state** state) {
  return without_model(__func__, [&] {
    require(bytes != nullptr, "bytes is NULL; give what bempd_state_to_bytes() wrote");
    require(size >= 0, "size is ", size, "; it must be the number of bytes");
    out(state, "state");
    *state = new bempd_state{model::from_bytes(bytes, static_cast<std::size_t>(size))};
  });
}

bempd_status bempd_state_write(const bempd_state* state, const char* path) {
  return without_model(__func__, [&] {
    const model::SavedState& saved = saved_in(state);
    model::write_state(saved, file_name(path));
  });
}

bempd_status bempd_state_read(const char* path, bempd_state** state) {
  return without_model(__func__, [&] {
    const char* name = file_name(path);
    out(state, "state");
    *state = new bempd_state{model::read_state(name)};
  });
}
