/*
 * A host lends a solver of the sparse system: here a dense Cholesky factorization. The same bonds break as with the
 * library's own factorization, in windows and outside, and the solver's errors become those of the calls.
 */
#define CRACK_RULE "bond"
#include "scenes.h"

#define MOST 8

typedef struct dense {
  int64_t number, n, inside; /* unknowns in all, and eliminated ones */
  int32_t* order;            /* unknown eliminated k-th */
  double* lower; /* shape [n][n] in this order: factor of the eliminated part, rows of the kept ones below */
  double* half;  /* shape [sides][inside], of the last reduction */
} dense;

typedef struct solver {
  dense factors[MOST];
  int64_t requests[8]; /* by kind */
  int32_t fails_with, fails_at;
  int64_t most_kept;
} solver;

static dense* factor_of(solver* s, int64_t number) {
  int k;
  for (k = 0; k < MOST; ++k)
    if (s->factors[k].number == number) return &s->factors[k];
  return NULL;
}

static void forget(dense* f) {
  if (f == NULL) return;
  free(f->order);
  free(f->lower);
  free(f->half);
  memset(f, 0, sizeof *f);
}

static int32_t analyse(solver* s, const bempd_sparse_task* task) {
  dense* f = factor_of(s, 0);
  int64_t k;
  if (f == NULL) return BEMPD_ERROR_INTERNAL;
  f->number = task->factor;
  f->n = task->unknowns;
  f->inside = task->unknowns - task->kept_count;
  f->order = (int32_t*)calloc((size_t)f->n, sizeof *f->order);
  f->lower = (double*)calloc((size_t)(f->n * f->n), sizeof *f->lower);
  if (f->order == NULL || f->lower == NULL) abort();
  for (k = 0; k < f->n; ++k) f->order[k] = task->order != NULL ? task->order[k] : (int32_t)k;
  if (task->kept_count > s->most_kept) s->most_kept = task->kept_count;
  return task->struct_size == (int64_t)sizeof *task && task->scratch != NULL ? BEMPD_OK : BEMPD_ERROR_INTERNAL;
}

static int32_t factorize(const dense* f, bempd_sparse_task* task) {
  const int64_t n = f->n, inside = f->inside;
  int64_t* place = (int64_t*)calloc((size_t)n, sizeof *place);
  int64_t i, j, k;
  if (place == NULL) abort();
  for (k = 0; k < n; ++k) place[f->order[k]] = k;
  memset(f->lower, 0, (size_t)(n * n) * sizeof *f->lower);
  for (j = 0; j < n; ++j)
    for (k = task->column_start[j]; k < task->column_start[j + 1]; ++k) {
      const int64_t a = place[j], b = place[task->rows[k]];
      f->lower[(a > b ? a : b) * n + (a > b ? b : a)] = task->values[k];
    }
  free(place);
  task->smallest_pivot = 1.0;
  for (j = 0; j < inside; ++j) {
    double* own = f->lower + j * n;
    for (k = 0; k < j; ++k) own[j] -= own[k] * own[k];
    if (!(own[j] > 0.0)) return BEMPD_ERROR_UNSOLVABLE;
    if (own[j] < task->smallest_pivot) task->smallest_pivot = own[j];
    own[j] = sqrt(own[j]);
    for (i = j + 1; i < n; ++i) {
      double* row = f->lower + i * n;
      for (k = 0; k < j; ++k) row[j] -= row[k] * own[k];
      row[j] /= own[j];
    }
  }
  for (i = inside; i < n; ++i)
    for (j = inside; j <= i; ++j) {
      double sum = f->lower[i * n + j];
      for (k = 0; k < inside; ++k) sum -= f->lower[i * n + k] * f->lower[j * n + k];
      task->schur[(i - inside) * (n - inside) + j - inside] = sum;
      task->schur[(j - inside) * (n - inside) + i - inside] = sum;
    }
  task->entries = inside * (inside + 1) / 2;
  return BEMPD_OK;
}

/* Forward elimination of one right-hand side; `half` has its eliminated part. */
static void forward(const dense* f, const double* side, double* half) {
  int64_t i, k;
  for (i = 0; i < f->inside; ++i) {
    const double* row = f->lower + i * f->n;
    half[i] = side[f->order[i]];
    for (k = 0; k < i; ++k) half[i] -= row[k] * half[k];
    half[i] /= row[i];
  }
}

static void backward(const dense* f, double* half, double* solution) {
  int64_t i, k;
  for (i = f->inside - 1; i >= 0; --i) {
    for (k = i + 1; k < f->inside; ++k) half[i] -= f->lower[k * f->n + i] * half[k];
    half[i] /= f->lower[i * f->n + i];
    solution[f->order[i]] = half[i];
  }
}

static int32_t solve(dense* f, bempd_sparse_task* task) {
  const int64_t n = f->n, inside = f->inside, kept = n - inside;
  int64_t side, i, k;
  if (task->request != BEMPD_SPARSE_EXPAND) {
    free(f->half);
    f->half = (double*)calloc((size_t)(task->sides * (inside + 1)), sizeof *f->half);
    if (f->half == NULL) abort();
  }
  for (side = 0; side < task->sides; ++side) {
    double* values = task->vectors + side * n;
    double* half = f->half + side * inside;
    double* reduced = task->kept != NULL ? task->kept + side * kept : NULL;
    if (task->request != BEMPD_SPARSE_EXPAND) forward(f, values, half);
    for (i = 0; reduced != NULL && i < kept; ++i) {
      const double* row = f->lower + (inside + i) * n;
      if (task->request == BEMPD_SPARSE_REDUCE) reduced[i] = values[f->order[inside + i]];
      for (k = 0; k < inside; ++k) {
        if (task->request == BEMPD_SPARSE_REDUCE) reduced[i] -= row[k] * half[k];
        if (task->request == BEMPD_SPARSE_EXPAND) half[k] -= row[k] * reduced[i];
      }
    }
    if (task->request != BEMPD_SPARSE_REDUCE) backward(f, half, values);
  }
  return BEMPD_OK;
}

static int32_t answer(bempd_sparse_task* task, void* user) {
  solver* s = (solver*)user;
  ++s->requests[task->request];
  if (task->request == s->fails_at) {
    task->message = "the fire alarm rang";
    return s->fails_with;
  }
  switch (task->request) {
    case BEMPD_SPARSE_ANALYSE:
      return analyse(s, task);
    case BEMPD_SPARSE_FACTORIZE:
      return factorize(factor_of(s, task->factor), task);
    case BEMPD_SPARSE_FORGET:
      forget(factor_of(s, task->factor));
      return BEMPD_OK;
    case BEMPD_SPARSE_DETACH:
      return BEMPD_OK;
    default:
      return solve(factor_of(s, task->factor), task);
  }
}

static int all_are_forgotten(const solver* s) {
  int k;
  for (k = 0; k < MOST; ++k)
    if (s->factors[k].number != 0) return 0;
  return 1;
}

/** The bonds that are broken after each event must be the same ones. */
static void compare(bempd_model* with, bempd_model* without, int32_t region, int most_events) {
  bempd_step_report report, other;
  int event;
  CHECK_OK(with, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(without, bempd_step_report_init(&other, sizeof other));
  for (event = 0; event < most_events; ++event) {
    outcome one = {NULL, 0}, two = {NULL, 0};
    double here = 0.0, there = 0.0;
    CHECK_OK(with, bempd_step_to_next_event(with, 1e4, &report));
    CHECK_OK(without, bempd_step_to_next_event(without, 1e4, &other));
    CHECK(report.stop_reason == other.stop_reason && report.broken_bonds == other.broken_bonds);
    CHECK_OK(with, bempd_load_factor(with, &here));
    CHECK_OK(without, bempd_load_factor(without, &there));
    CHECK(fabs(here - there) <= 1e-9 * there);
    outcome_append_bonds(&one, with, region);
    outcome_append_bonds(&two, without, region);
    CHECK(outcome_same(&one, &two));
    outcome_free(&one);
    outcome_free(&two);
    if (report.stop_reason != BEMPD_STOP_EVENT) break;
  }
}

static void the_same_bonds_break(const char* way) {
  const double pull = 1e-6;
  int32_t pulled = 0;
  bempd_model* with = strip_with_crack(0.0045, 1, NULL, &pull, &pulled);
  bempd_model* without = strip_with_crack(0.0045, 1, NULL, &pull, &pulled);
  solver s;
  memset(&s, 0, sizeof s);
  CHECK_OK(with, bempd_set_option_text(with, "test.solver", way));
  CHECK_OK(without, bempd_set_option_text(without, "test.solver", way));
  CHECK_OK(with, bempd_set_sparse_solver(with, answer, &s));
  compare(with, without, 2, 25);
  CHECK(s.requests[BEMPD_SPARSE_FACTORIZE] > 0);
  /* Windows solve for a few functions of the whole body; without them each event iterates with the old factor. */
  CHECK(s.most_kept > 0 && s.requests[BEMPD_SPARSE_REDUCE] > 0);
  CHECK((s.requests[BEMPD_SPARSE_REDUCE] < 25) == (strcmp(way, "window") == 0));
  /* Taken away in the middle of the run. */
  CHECK_OK(with, bempd_set_sparse_solver(with, NULL, NULL));
  CHECK(s.requests[BEMPD_SPARSE_DETACH] == 1 && all_are_forgotten(&s));
  memset(s.requests, 0, sizeof s.requests);
  compare(with, without, 2, 25);
  bempd_model_free(with);
  bempd_model_free(without);
  CHECK(s.requests[BEMPD_SPARSE_FACTORIZE] == 0 && s.requests[BEMPD_SPARSE_DETACH] == 0);
}

static void errors_are_those_of_the_call(void) {
  static const int32_t statuses[] = {BEMPD_ERROR_MEMORY, BEMPD_ERROR_IO, BEMPD_ERROR_UNSOLVABLE, BEMPD_ERROR_CANCELLED};
  static const char* const words[] = {"memory", "fire alarm", "indefinite", "fire alarm"};
  int k;
  for (k = 0; k < 4; ++k) {
    coupled_plate plate = coupled_plate_create();
    solver s;
    memset(&s, 0, sizeof s);
    s.fails_at = BEMPD_SPARSE_FACTORIZE;
    s.fails_with = statuses[k];
    CHECK_OK(plate.model, bempd_set_sparse_solver(plate.model, answer, &s));
    CHECK_FAILS(plate.model, (bempd_status)statuses[k], words[k], bempd_step(plate.model, 0.01, NULL));
    s.fails_at = 0;
    CHECK_OK(plate.model, bempd_step(plate.model, 0.01, NULL));
    bempd_model_free(plate.model);
    CHECK(s.requests[BEMPD_SPARSE_DETACH] == 1 && all_are_forgotten(&s));
  }
}

static void other_errors_are_internal(void) {
  coupled_plate plate = coupled_plate_create();
  solver s;
  memset(&s, 0, sizeof s);
  s.fails_at = BEMPD_SPARSE_ANALYSE;
  s.fails_with = BEMPD_ERROR_INTERNAL;
  CHECK_OK(plate.model, bempd_set_sparse_solver(plate.model, answer, &s));
  CHECK_FAILS(plate.model, BEMPD_ERROR_INTERNAL, "fire alarm", bempd_step(plate.model, 0.01, NULL));
  bempd_model_free(plate.model);
  CHECK(all_are_forgotten(&s));
}

static void comes_before_the_first_step_and_once(void) {
  coupled_plate plate = coupled_plate_create();
  solver first, second;
  memset(&first, 0, sizeof first);
  memset(&second, 0, sizeof second);
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "model", bempd_set_sparse_solver(NULL, answer, &first));
  CHECK_OK(plate.model, bempd_set_sparse_solver(plate.model, NULL, NULL));
  CHECK_OK(plate.model, bempd_set_sparse_solver(plate.model, answer, &first));
  CHECK_FAILS(plate.model, BEMPD_ERROR_ORDER, "detach", bempd_set_sparse_solver(plate.model, answer, &second));
  CHECK(second.requests[BEMPD_SPARSE_DETACH] == 1 && first.requests[BEMPD_SPARSE_DETACH] == 0);
  CHECK_OK(plate.model, bempd_set_sparse_solver(plate.model, NULL, NULL));
  CHECK(first.requests[BEMPD_SPARSE_DETACH] == 1);
  CHECK_OK(plate.model, bempd_step(plate.model, 0.01, NULL));
  CHECK_FAILS(plate.model, BEMPD_ERROR_ORDER, "before the first step",
              bempd_set_sparse_solver(plate.model, answer, &first));
  bempd_model_free(plate.model);
}

/** A folder for the factor is for solvers that work out of core: the library's own does not. */
static void scratch_needs_an_attached_solver(void) {
  coupled_plate plate = coupled_plate_create();
  char text[64];
  solver s;
  memset(&s, 0, sizeof s);
  CHECK_OK(plate.model, bempd_set_option_text(plate.model, "linalg.scratch", "/some/folder"));
  CHECK_OK(plate.model, bempd_get_option_text(plate.model, "linalg.scratch", text, (int64_t)sizeof text, NULL));
  CHECK(strcmp(text, "/some/folder") == 0);
  CHECK_FAILS(plate.model, BEMPD_ERROR_ORDER, "bempd_mpi_attach", bempd_step(plate.model, 0.01, NULL));
  CHECK_OK(plate.model, bempd_set_option_text(plate.model, "linalg.scratch", ""));
  CHECK_OK(plate.model, bempd_step(plate.model, 0.01, NULL));
  bempd_model_free(plate.model);
}

/** Indices of 64 bits, which large factors need, change no digit of a run. */
static void wide_indices_change_nothing(void) {
  const double pull = 1e-6;
  outcome seen[2] = {{NULL, 0}, {NULL, 0}};
  int k, event;
  for (k = 0; k < 2; ++k) {
    int32_t pulled = 0;
    bempd_step_report report;
    bempd_model* model = strip_with_crack(0.0045, 1, NULL, &pull, &pulled);
    CHECK_OK(model, bempd_set_option_text(model, "test.indices", k == 0 ? "chosen" : "wide"));
    CHECK_OK(model, bempd_step_report_init(&report, sizeof report));
    for (event = 0; event < 30; ++event) {
      CHECK_OK(model, bempd_step_to_next_event(model, 1e4, &report));
      outcome_append(&seen[k], &report.load_factor, 1);
      outcome_append_bonds(&seen[k], model, 2);
    }
    outcome_append_field(&seen[k], model, 2, BEMPD_DISPLACEMENT);
    bempd_model_free(model);
  }
  CHECK(outcome_same(&seen[0], &seen[1]));
  outcome_free(&seen[0]);
  outcome_free(&seen[1]);
}

int main(void) {
  the_same_bonds_break("window");
  the_same_bonds_break("plain");
  errors_are_those_of_the_call();
  other_errors_are_internal();
  comes_before_the_first_step_and_once();
  scratch_needs_an_attached_solver();
  wide_indices_change_nothing();
  return check_finish();
}
