/* The BLAS that runs is named, and one that takes the processor for an older one is warned of. */
#include "scenes.h"

typedef struct heard {
  int warned, named;
} heard;

static void listen(int32_t level, const char* message, void* user) {
  heard* lines = (heard*)user;
  if (level == 1 && check_has_word(message, "older one, Prescott")) lines->warned = 1;
  if (level == 3 && check_has_word(message, "OpenBLAS")) lines->named = 1;
}

int main(void) {
  const char* info = bempd_build_info();
  bempd_model* model = new_model();
  heard lines = {0, 0};
  printf("%s\n", info);
  CHECK(check_has_word(info, "BLAS"));
  add_pd_rectangle(model, add_sound_material(model), 0.0, 0.0, 60.0, 60.0, 1.0);
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_set_log(model, listen, &lines));
  CHECK_OK(model, bempd_prepare(model));
  /* Run with OPENBLAS_CORETYPE=Prescott; the warning is for processors with AVX2. */
  if (check_has_word(info, "OpenBLAS")) {
    CHECK(check_has_word(info, "(Prescott, 1 thread)"));
    CHECK(lines.named);
#if defined(__x86_64__)
    CHECK(lines.warned == (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")));
#endif
  }
  bempd_model_free(model);
  return check_finish();
}
