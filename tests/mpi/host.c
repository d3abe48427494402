/*
 * An MPI host that embeds the library: rank 0 has the model, the others serve. Run with 1, 2 and 4 ranks.
 *   mpi_host FOLDER [single]     FOLDER: for factors out of core; single: MPI_Init() in place of MPI_Init_thread()
 */
#include "bempd_mpi.h"
#define CRACK_RULE "bond"
#include <pthread.h>

#include "../capi/scenes.h"

static int rank, ranks;

#define CHECK_MPI_FAILS(expected, word, call)                                  \
  do {                                                                         \
    const bempd_status came = (call);                                          \
    CHECK(came == (expected));                                                 \
    if (came != BEMPD_OK) CHECK(strstr(bempd_mpi_last_error(), word) != NULL); \
  } while (0)

static bempd_model* strip(void) {
  const double pull = 1e-6;
  int32_t pulled = 0;
  return strip_with_crack(0.0045, 1, NULL, &pull, &pulled);
}

/** Events and bonds of a run, on rank 0. */
static outcome torn(bempd_model* model, int events) {
  outcome seen = {NULL, 0};
  bempd_step_report report;
  int k;
  CHECK_OK(model, bempd_step_report_init(&report, sizeof report));
  for (k = 0; k < events; ++k) {
    CHECK_OK(model, bempd_step_to_next_event(model, 1e4, &report));
    outcome_append_bonds(&seen, model, 2);
  }
  return seen;
}

static void attach(bempd_model* model) { CHECK_MPI_FAILS(BEMPD_OK, "", bempd_mpi_attach(model, MPI_COMM_WORLD)); }

static void serve(void) { CHECK_MPI_FAILS(BEMPD_OK, "", bempd_mpi_serve(MPI_COMM_WORLD)); }

/** A model breaks the same bonds as one process does, in core and out of core; then it goes on alone. */
static void the_same_bonds_break(const char* scratch, int events) {
  if (rank == 0) {
    bempd_model* with = strip();
    bempd_model* without = strip();
    outcome here, there;
    bempd_statistics statistics;
    CHECK_OK(with, bempd_set_option_text(with, "linalg.scratch", scratch));
    attach(with);
    here = torn(with, events);
    there = torn(without, events);
    CHECK(outcome_same(&here, &there));
    outcome_free(&here);
    outcome_free(&there);
    CHECK_OK(NULL, bempd_statistics_init(&statistics, sizeof statistics));
    CHECK_OK(with, bempd_get_statistics(with, &statistics));
    CHECK(statistics.factor_nonzeros > 0 && statistics.sparse_factorizations > 0);
    CHECK(statistics.reciprocal_condition > 1e-9 && statistics.reciprocal_condition <= 1.0);
    CHECK_MPI_FAILS(BEMPD_OK, "", bempd_mpi_detach(with));
    CHECK_OK(with, bempd_set_option_text(with, "linalg.scratch", ""));
    here = torn(with, 5);
    there = torn(without, 5);
    CHECK(outcome_same(&here, &there));
    outcome_free(&here);
    outcome_free(&there);
    bempd_model_free(with);
    bempd_model_free(without);
  } else {
    serve();
  }
}

static void freeing_a_model_lets_the_others_go(void) {
  if (rank == 0) {
    bempd_model* model = strip();
    attach(model);
    CHECK_OK(model, bempd_step(model, 1.0, NULL));
    bempd_model_free(model);
  } else {
    serve();
  }
}

/** A model that refuses the solver lets the others go as well. */
static void a_refused_attachment_lets_the_others_go(void) {
  if (rank == 0) {
    bempd_model* model = strip();
    CHECK_OK(model, bempd_step(model, 1.0, NULL));
    CHECK_MPI_FAILS(BEMPD_ERROR_ORDER, "before the first step", bempd_mpi_attach(model, MPI_COMM_WORLD));
    bempd_model_free(model);
  } else {
    serve();
  }
  if (rank == 0) {
    CHECK_MPI_FAILS(BEMPD_ERROR_ARGUMENT, "model", bempd_mpi_attach(NULL, MPI_COMM_WORLD));
  } else {
    serve();
  }
}

static void misuse_is_refused(void) {
  bempd_model* model = NULL;
  CHECK_MPI_FAILS(BEMPD_ERROR_ARGUMENT, "NULL", bempd_mpi_attach(model, MPI_COMM_NULL));
  CHECK_MPI_FAILS(BEMPD_ERROR_ARGUMENT, "NULL", bempd_mpi_serve(MPI_COMM_NULL));
  if (rank == 0) {
    bempd_model* first = strip();
    bempd_model* second = strip();
    CHECK_MPI_FAILS(BEMPD_ERROR_ARGUMENT, "attach", bempd_mpi_serve(MPI_COMM_WORLD));
    attach(first);
    CHECK_MPI_FAILS(BEMPD_ERROR_ORDER, "another model", bempd_mpi_attach(second, MPI_COMM_WORLD));
    CHECK_OK(first, bempd_step(first, 1.0, NULL));
    /* A communicator of its own is free. */
    CHECK_MPI_FAILS(BEMPD_OK, "", bempd_mpi_attach(second, MPI_COMM_SELF));
    CHECK_OK(second, bempd_step(second, 1.0, NULL));
    CHECK_MPI_FAILS(BEMPD_OK, "", bempd_mpi_detach(second));
    CHECK_MPI_FAILS(BEMPD_OK, "", bempd_mpi_detach(first));
    CHECK_MPI_FAILS(BEMPD_OK, "", bempd_mpi_detach(first));
    CHECK_MPI_FAILS(BEMPD_ERROR_ARGUMENT, "model", bempd_mpi_detach(NULL));
    bempd_model_free(first);
    bempd_model_free(second);
  } else {
    CHECK_MPI_FAILS(BEMPD_ERROR_ARGUMENT, "serve", bempd_mpi_attach(model, MPI_COMM_WORLD));
    serve();
  }
}

/** Errors of the solution come to rank 0, and the ranks go on together. */
static void errors_come_to_rank_0(void) {
  if (rank == 0) {
    bempd_model* model = strip();
    CHECK_OK(model, bempd_set_option_text(model, "linalg.scratch", "/no/such/folder"));
    attach(model);
    CHECK_FAILS(model, BEMPD_ERROR_IO, "/no/such/folder", bempd_step(model, 1.0, NULL));
    CHECK_OK(model, bempd_set_option_text(model, "linalg.scratch", ""));
    CHECK_OK(model, bempd_step(model, 1.0, NULL));
    CHECK_MPI_FAILS(BEMPD_OK, "", bempd_mpi_detach(model));
    bempd_model_free(model);
  } else {
    serve();
  }
  if (rank == 0) { /* a body that nothing holds */
    bempd_model* model = pd_block();
    attach(model);
    CHECK_OK(model, bempd_fix_point(model, 0.0, 0.0, BEMPD_BOTH, NULL));
    CHECK_OK(model, bempd_prescribe_point(model, 10.0, 0.0, BEMPD_X, 0.0, 1.0, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_UNSOLVABLE, "move|free|turn|rotat|mechanism", bempd_step(model, 0.001, NULL));
    bempd_model_free(model);
  } else {
    serve();
  }
}

static void* steps_elsewhere(void* user) {
  bempd_model* model = (bempd_model*)user;
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "thread", bempd_step(model, 1.0, NULL));
  return NULL;
}

/** Other threads than the one that initialized MPI are refused with MPI_THREAD_FUNNELED. */
static void other_threads_are_refused(int level) {
  if (level >= MPI_THREAD_SERIALIZED) return;
  if (rank == 0) {
    pthread_t thread;
    bempd_model* model = strip();
    attach(model);
    CHECK(pthread_create(&thread, NULL, steps_elsewhere, model) == 0);
    CHECK(pthread_join(thread, NULL) == 0);
    CHECK_OK(model, bempd_step(model, 1.0, NULL));
    bempd_model_free(model);
  } else {
    serve();
  }
}

int main(int count, char** words) {
  int level = MPI_THREAD_SINGLE, sum = 0, all = 0, failures;
  bempd_model* late = NULL;
  CHECK_MPI_FAILS(BEMPD_ERROR_ORDER, "MPI_Init", bempd_mpi_serve(MPI_COMM_WORLD));
  if (count > 2)
    MPI_Init(&count, &words);
  else
    MPI_Init_thread(&count, &words, MPI_THREAD_FUNNELED, &level);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  CHECK(strstr(bempd_mpi_build_info(), "MUMPS 5") != NULL && strstr(bempd_mpi_build_info(), "CeCILL-C") != NULL);
  misuse_is_refused();
  the_same_bonds_break("", 25);
  the_same_bonds_break(count > 1 ? words[1] : "/tmp", 5);
  freeing_a_model_lets_the_others_go();
  a_refused_attachment_lets_the_others_go();
  errors_come_to_rank_0();
  other_threads_are_refused(level);
  /* The host's communicator is its own: nothing of the library travels on it. */
  MPI_Allreduce(&rank, &sum, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  CHECK(sum == ranks * (ranks - 1) / 2);
  if (rank == 0) { /* freed after MPI has ended */
    late = strip();
    CHECK_MPI_FAILS(BEMPD_OK, "", bempd_mpi_attach(late, MPI_COMM_SELF));
    CHECK_OK(late, bempd_step(late, 1.0, NULL));
  }
  failures = check_finish();
  MPI_Allreduce(&failures, &all, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  MPI_Finalize();
  bempd_model_free(late);
  return all;
}
