// What a Schur complement costs MUMPS: the matrix of a cracked plate, of whose window some unknowns are kept.
//   mpirun -np RANKS bempd_schur POINTS KEPT [FOLDER]     POINTS: on a side; FOLDER: for a factor out of core
// Rank 0 prints a line of JSON; seconds are processor seconds of rank 0, memory is the peak of each rank [MB].
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include "bempd.h"
#include "mpi/connection.hpp"

using bempd::mpi::Connection;

namespace {

struct Study {
  Connection& mumps;
  std::int32_t kept = 0, most = 0;  // unknowns: wanted, and those of the window
  std::string scratch;
  double analysis = 0, factorization = 0;
  std::int64_t unknowns = 0, entries = 0;
};

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double peak() {
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line))
    if (line.rfind("VmHWM:", 0) == 0) return std::atof(line.c_str() + 6) / 1e3;
  return 0;
}

// Hands the requests of the model on with fewer kept unknowns. After the factorization nothing more is wanted.
std::int32_t answer(bempd_sparse_task* task, void* user) {
  Study& study = *static_cast<Study*>(user);
  if (task->request != BEMPD_SPARSE_ANALYSE && task->request != BEMPD_SPARSE_FACTORIZE) return BEMPD_OK;
  bempd_sparse_task fewer = *task;
  fewer.kept_count = study.kept;
  study.most = task->kept_count;
  study.unknowns = task->unknowns;
  if (study.kept > study.most) return BEMPD_ERROR_ARGUMENT;
  const double begin = seconds();
  if (task->request == BEMPD_SPARSE_ANALYSE) {
    fewer.scratch = study.scratch.c_str();
    const std::int32_t status = study.mumps.answer(fewer);
    study.analysis = seconds() - begin;
    return status;
  }
  std::vector<double> schur(static_cast<std::size_t>(study.kept) * static_cast<std::size_t>(study.kept));
  fewer.schur = schur.data();
  const std::int32_t status = study.mumps.answer(fewer);
  study.factorization = seconds() - begin;
  study.entries = fewer.entries;
  return status == BEMPD_OK ? BEMPD_ERROR_CANCELLED : status;
}

// Square plate with an edge crack, pulled at its ends; the window lies ahead of the tip.
bool factorize(int points, Study& study) {
  const double side = 0.1, middle = (points + 1) * side / (2 * points);
  const double outline[] = {0, 0, side, 0, side, side, 0, side}, crack[] = {middle, 0, middle, 0.3 * side}, pull = 1e-6;
  bempd_model* model = nullptr;
  bempd_material material;
  std::int32_t solid = 0, plate = 0;
  bempd_material_init(&material, sizeof material);
  material.young_modulus = 30e9;
  material.poisson_ratio = 1.0 / 3;
  material.fracture_energy = 100;
  const bool is_built = bempd_model_create(&model) == BEMPD_OK &&
                        bempd_set_option_text(model, "crack.rule", "bond") == BEMPD_OK &&
                        bempd_add_material(model, &material, &solid) == BEMPD_OK &&
                        bempd_add_pd_region(model, solid, 4, outline, side / points, 4, &plate) == BEMPD_OK &&
                        bempd_add_crack(model, 2, crack, nullptr) == BEMPD_OK &&
                        bempd_fix_edge(model, plate, 4, BEMPD_BOTH, nullptr) == BEMPD_OK &&
                        bempd_prescribe_edge(model, plate, 2, 0, 1, BEMPD_X, 1, nullptr, &pull, nullptr) == BEMPD_OK &&
                        bempd_set_sparse_solver(model, answer, &study) == BEMPD_OK;
  const bool is_done = is_built && bempd_step(model, 1e-6, nullptr) == BEMPD_ERROR_CANCELLED;
  if (!is_done) std::fprintf(stderr, "%s; the window has %d unknowns\n", bempd_last_error(model), study.most);
  bempd_model_free(model);
  return is_done;
}

}  // namespace

int main(int count, char** words) {
  int level = 0, rank = 0, ranks = 1;
  bool is_good = true;
  MPI_Init_thread(&count, &words, MPI_THREAD_FUNNELED, &level);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  if (count < 3) MPI_Abort(MPI_COMM_WORLD, 2);
  if (rank == 0) {
    Connection mumps(MPI_COMM_WORLD);
    Study study{mumps, std::atoi(words[2]), 0, count > 3 ? words[3] : "", 0, 0, 0, 0};
    is_good = factorize(std::atoi(words[1]), study);
    std::printf("{\"unknowns\": %lld, \"kept\": %d, \"analysis\": %.3f, \"factorization\": %.3f, \"entries\": %lld, ",
                static_cast<long long>(study.unknowns), study.kept, study.analysis, study.factorization,
                static_cast<long long>(study.entries));
  } else {
    bempd::mpi::follow_orders(MPI_COMM_WORLD);
  }
  const double own = peak();
  std::vector<double> all(static_cast<std::size_t>(ranks));
  MPI_Gather(&own, 1, MPI_DOUBLE, all.data(), 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  if (rank == 0) {
    std::printf("\"memory\": [");
    for (int r = 0; r < ranks; ++r) std::printf("%s%.0f", r == 0 ? "" : ", ", all[static_cast<std::size_t>(r)]);
    std::printf("]}\n");
  }
  MPI_Finalize();
  return is_good ? 0 : 1;
}
