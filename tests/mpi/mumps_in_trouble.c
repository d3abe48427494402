/*
 * What MUMPS may meet: too little workspace, a full disk, and a request to cancel. This program has a dmumps_c() of its
 * own, which libbempd_mpi finds first and which passes calls on to MUMPS. Run with 1 and 2 ranks. mumps_in_trouble
 * FOLDER     for factors out of core
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <dmumps_c.h>
#include <signal.h>
#include <sys/resource.h>

#include "bempd_mpi.h"
#define CRACK_RULE "bond"
#include "../capi/scenes.h"

enum { analysis = 1, factorization = 2, solution = 3, most = 8 };

static int rank;

/** What goes wrong in the next calls of MUMPS, the same on all ranks, and what its factorizations gave. */
static struct {
  int short_of_workspace; /* factorizations that get a tenth of the workspace that MUMPS has estimated */
  int cancelled_in;       /* job during which rank 0 is asked to cancel; 0: none */
  bempd_model* model;     /* of rank 0 */
  int cancels, factorizations;
  int error[most], reserve[most]; /* INFOG(1), ICNTL(14) */
} trouble;

void dmumps_c(DMUMPS_STRUC_C* mumps) {
  void (*mumps_itself)(DMUMPS_STRUC_C*) = NULL;
  const int job = mumps->job, reserve = mumps->icntl[13];
  *(void**)&mumps_itself = dlsym(RTLD_NEXT, "dmumps_c");
  if (job == trouble.cancelled_in && trouble.model != NULL) {
    ++trouble.cancels;
    bempd_request_cancel(trouble.model);
  }
  if (job == factorization && trouble.short_of_workspace > 0) {
    --trouble.short_of_workspace;
    mumps->icntl[13] = -90;
    mumps_itself(mumps);
    mumps->icntl[13] = reserve;
  } else {
    mumps_itself(mumps);
  }
  if (job != factorization || trouble.factorizations == most) return;
  trouble.error[trouble.factorizations] = mumps->infog[0];
  trouble.reserve[trouble.factorizations++] = reserve;
}

static bempd_model* strip(void) {
  const double pull = 1e-6;
  int32_t pulled = 0;
  return strip_with_crack(0.0045, 1, NULL, &pull, &pulled);
}

static double reach(bempd_model* model) {
  const double corner[2] = {0.03, 0.01};
  double displacement[2] = {0, 0};
  CHECK_OK(model, bempd_evaluate(model, 1, corner, displacement, NULL, NULL));
  return displacement[0];
}

/** One step of a model in whose course something goes wrong, and the same step once more with nothing wrong. */
static void step_in_trouble(const char* scratch, bempd_status expected, const char* word) {
  if (rank != 0) {
    CHECK(bempd_mpi_serve(MPI_COMM_WORLD) == BEMPD_OK);
    return;
  }
  {
    bempd_model* model = strip();
    bempd_model* alone = strip();
    CHECK_OK(model, bempd_set_option_text(model, "linalg.scratch", scratch));
    CHECK(bempd_mpi_attach(model, MPI_COMM_WORLD) == BEMPD_OK);
    trouble.model = model;
    if (expected == BEMPD_OK)
      CHECK_OK(model, bempd_step(model, 1.0, NULL));
    else
      CHECK_FAILS(model, expected, word, bempd_step(model, 1.0, NULL));
    trouble.model = NULL;
    if (expected == BEMPD_ERROR_IO) CHECK_OK(model, bempd_set_option_text(model, "linalg.scratch", ""));
    if (expected != BEMPD_OK) CHECK_OK(model, bempd_step(model, 1.0, NULL));
    CHECK_OK(alone, bempd_step(alone, 1.0, NULL));
    CHECK(fabs(reach(model) - reach(alone)) < 1e-9 * fabs(reach(alone)));
    bempd_model_free(model);
    bempd_model_free(alone);
  }
}

/** MUMPS fails with -9; the library raises its reserve twice at most, and later calls begin with the usual one. */
static void too_little_workspace_is_given_again(int times) {
  int k;
  memset(&trouble, 0, sizeof trouble);
  trouble.short_of_workspace = times;
  step_in_trouble("", times <= 2 ? BEMPD_OK : BEMPD_ERROR_MEMORY, "more processes");
  CHECK(trouble.factorizations > times);
  for (k = 0; k < times; ++k) CHECK(trouble.error[k] == -9);
  CHECK(trouble.error[times] == 0);
  for (k = 1; k <= times && k <= 2; ++k) CHECK(trouble.reserve[k] == 2 * trouble.reserve[k - 1]);
  if (times == 3) CHECK(trouble.reserve[3] == trouble.reserve[0]);
}

/** A request to cancel that comes while MUMPS works ends the call after that phase. */
static void requests_are_heard_after_each_phase(void) {
  int job;
  for (job = analysis; job <= solution; ++job) {
    memset(&trouble, 0, sizeof trouble);
    trouble.cancelled_in = job;
    step_in_trouble("", BEMPD_ERROR_CANCELLED, "cancelled on request");
    if (rank == 0) CHECK(trouble.cancels == (job == solution ? 2 : 1)); /* a solution has two halves */
  }
}

/** No rank may write more than a file of 1,000 bytes; then the same for one rank alone. */
static void full_disks_are_told(const char* folder) {
  int full;
  signal(SIGXFSZ, SIG_IGN); /* writing fails instead */
  memset(&trouble, 0, sizeof trouble);
  for (full = 0; full < 2; ++full) {
    struct rlimit before, little;
    CHECK(getrlimit(RLIMIT_FSIZE, &before) == 0);
    little = before;
    little.rlim_cur = 1000;
    if (full == 0 || rank == 0) CHECK(setrlimit(RLIMIT_FSIZE, &little) == 0);
    step_in_trouble(folder, BEMPD_ERROR_IO, "disk full");
    CHECK(setrlimit(RLIMIT_FSIZE, &before) == 0);
  }
}

int main(int count, char** words) {
  int level = MPI_THREAD_SINGLE, failures, all = 0, times;
  MPI_Init_thread(&count, &words, MPI_THREAD_FUNNELED, &level);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  for (times = 1; times <= 3; ++times) too_little_workspace_is_given_again(times);
  requests_are_heard_after_each_phase();
  step_in_trouble("/proc", BEMPD_ERROR_IO, "linalg.scratch"); /* root too can make no file there */
  full_disks_are_told(count > 1 ? words[1] : "/tmp");
  failures = check_finish();
  MPI_Allreduce(&failures, &all, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  MPI_Finalize();
  return all;
}
