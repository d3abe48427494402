#include "model/explanation.hpp"

#include "capi/guard.hpp"

using namespace bempd;
using namespace bempd::capi;

bempd_status bempd_explanation_init(bempd_explanation* explanation, int64_t struct_size) {
  return init_struct(__func__, "explanation", explanation, struct_size, bempd_explanation{});
}

bempd_status bempd_explain(bempd_model* model, int32_t rising, bempd_explanation* explanation, char* buffer,
                           int64_t capacity, int64_t* needed) {
  return with_model(model, __func__, [&](model::Model& m) {
    require(rising == 0 || rising == 1, "rising is ", rising, "; it must be 1 for a load factor that rises, else 0");
    if (explanation) struct_bytes(explanation, "explanation");
    const model::Explanation found = model::explain(m, rising == 1);
    if (explanation)
      write_struct(explanation,
                   bempd_explanation{
                       .struct_size = sizeof(bempd_explanation),
                       .next = static_cast<int32_t>(found.next),
                       .region = found.region,
                       .crack = found.tip.crack,
                       .end = end_of(found.tip),
                       .x = found.place.x(),
                       .y = found.place.y(),
                       .load_factor = found.load_factor,
                       .ratio = found.ratio,
                   },
                   "explanation");
    write_text(m.names().in(found.text), buffer, capacity, needed);
  });
}
