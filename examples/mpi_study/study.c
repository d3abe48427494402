/* Strengths of plates with a random crack: each MPI rank takes every size-th case, with
 * models of its own. The library knows nothing of MPI. */
#include <bempd.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>

/* Random numbers between 0 and 1 (Park and Miller, Comm. ACM 31, 1988): the same in every
 * language, and for a case the same on every rank. */
static double random_number(int64_t* state) {
  *state = 16807 * *state % 2147483647;
  return (double)*state / 2147483647.0;
}

/* Force at which the plate of a case tears; its sentence and 0 if it fails. */
static double strength(int number) {
  const double square[] = {0, 0, 0.024, 0, 0.024, 0.024, 0, 0.024}, pull = 1e-6;
  int64_t state = 1 + 1000003 * (int64_t)(number + 1) % 2147483646;
  double x, y, crack[4], force = 0;
  bempd_model* model = NULL;
  bempd_material glass;
  bempd_step_report end;
  int32_t id;

  random_number(&state);
  x = 0.006 + 0.012 * random_number(&state);
  y = 0.006 + 0.012 * random_number(&state);
  crack[0] = x - 0.003, crack[1] = y, crack[2] = x + 0.003, crack[3] = y;

  bempd_model_create(&model);
  bempd_set_option(model, "threads", 1); /* ranks share the cores */
  bempd_material_init(&glass, sizeof glass);
  glass.young_modulus = 70e9;
  glass.poisson_ratio = 1.0 / 3;
  glass.fracture_energy = 8;
  bempd_add_material(model, &glass, &id);
  bempd_add_pd_region(model, id, 4, square, 0.001, 4, NULL);
  bempd_add_crack(model, 2, crack, NULL);
  bempd_fix_edge(model, 1, 1, BEMPD_BOTH, NULL);
  bempd_prescribe_edge(model, 1, 3, 0, 1, BEMPD_Y, 1, NULL, &pull, NULL);
  bempd_step_report_init(&end, sizeof end);
  if (bempd_run_to_separation(model, 1e4, &end) == BEMPD_OK)
    force = end.peak_resistance;
  else
    fprintf(stderr, "case %d: %s\n", number, bempd_last_error(model));
  bempd_model_free(model);
  return force;
}

int main(int argc, char** argv) {
  const int cases = argc > 1 ? atoi(argv[1]) : 12;
  int rank, size, number, failed = 0;
  double *own, *all, sum = 0;

  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  own = calloc((size_t)cases, sizeof *own);
  all = calloc((size_t)cases, sizeof *all);
  for (number = rank; number < cases; number += size) own[number] = strength(number);
  MPI_Reduce(own, all, cases, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
  if (rank == 0) {
    for (number = 0; number < cases; ++number) {
      printf("%4d %14.6E N/m\n", number, all[number]);
      failed += all[number] == 0;
      sum += all[number];
    }
    if (cases > failed) printf("mean %14.6E N/m of %d plates\n", sum / (cases - failed), cases - failed);
  }
  free(own);
  free(all);
  MPI_Finalize();
  return failed > 0;
}
