#include "mpi/mumps_factor.hpp"

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>

namespace bempd::mpi {

namespace {

constexpr int initialize = -1, terminate = -2, analysis = 1, factorization = 2, solution = 3;
constexpr int most_retries = 2;  // with twice the workspace each time

// Entries of MUMPS' control and result arrays by the numbers of its manual, which count from 1.
int& control(DMUMPS_STRUC_C& mumps, int number) { return mumps.icntl[number - 1]; }
int found(const DMUMPS_STRUC_C& mumps, int number) { return mumps.infog[number - 1]; }

// Whether a file can be made in a folder.
bool can_write_in(const std::string& folder, int rank) {
  const std::string path = (std::filesystem::path(folder) / ("bempd_scratch_" + std::to_string(rank))).string();
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  if (!file) return false;
  std::fclose(file);
  std::remove(path.c_str());
  return true;
}

}  // namespace

MumpsFactor::MumpsFactor(MPI_Comm comm) : comm_(comm) {
  MPI_Comm_rank(comm, &rank_);
  MPI_Comm_size(comm, &ranks_);
}

MumpsFactor::~MumpsFactor() {
  if (is_started_) run(terminate);
}

void MumpsFactor::set_controls() {
  for (const int stream : {1, 2, 3}) control(mumps_, stream) = -1;
  control(mumps_, 4) = 0;   // silent
  control(mumps_, 8) = 0;   // no scaling: the diagonal is about 1
  control(mumps_, 13) = 1;  // no ScaLAPACK at the root, so that every pivot is seen
  control(mumps_, 18) = 3;  // each rank has entries
  control(mumps_, 28) = 1;  // sequential analysis, which takes an order
}

Verdict MumpsFactor::run(int job) {
  mumps_.job = job;
  dmumps_c(&mumps_);
  switch (job) {
    case analysis:
      return verdict("analysing");
    case factorization:
      return verdict("factorizing");
    default:
      return verdict("solving");
  }
}

Verdict MumpsFactor::verdict(const char* doing) const {
  const int error = found(mumps_, 1), detail = found(mumps_, 2);
  if (error >= 0) return {};
  const std::string numbers = std::string("MUMPS failed while ") + doing + " (INFOG(1) = " + std::to_string(error) +
                              ", INFOG(2) = " + std::to_string(detail) + ")";
  switch (error) {
    case -10:
    case -40:
      return {BEMPD_ERROR_UNSOLVABLE, numbers};
    case -5:
    case -7:
    case -8:
    case -9:
    case -11:
    case -13:
    case -14:
    case -15:
    case -17:
    case -19:
    case -20:
    case -22:
      return {BEMPD_ERROR_MEMORY, numbers};
    case -90:
      return {BEMPD_ERROR_IO, "the factor could not be written to or read from the folder '" + scratch_ +
                                  "' of the option linalg.scratch: disk full? " + numbers};
    default:
      return {BEMPD_ERROR_INTERNAL, numbers};
  }
}

Verdict MumpsFactor::analyse(const Order& order, const bempd_sparse_task* task) {
  scratch_.assign(static_cast<std::size_t>(order.scratch_bytes), '\0');
  if (task && order.scratch_bytes > 0) scratch_ = task->scratch;
  MPI_Bcast(scratch_.data(), static_cast<int>(order.scratch_bytes), MPI_CHAR, 0, comm_);
  mumps_.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(comm_));
  mumps_.par = 1;  // rank 0 works too
  mumps_.sym = 1;  // positive definite
  Verdict result = run(initialize);
  if (!result.is_good()) return result;
  is_started_ = true;
  set_controls();
  if (!scratch_.empty()) result = use_scratch(scratch_);
  if (result.is_good()) result = share_pattern(order, task);
  return result.is_good() ? run(analysis) : result;
}

Verdict MumpsFactor::use_scratch(const std::string& folder) {
  const bool fits = folder.size() < sizeof mumps_.ooc_tmpdir;
  if (!on_all(fits && can_write_in(folder, rank_), comm_))
    return {BEMPD_ERROR_IO, "a process can write no file in the folder '" + folder +
                                "' of the option linalg.scratch; make it writable, or give another of at most " +
                                std::to_string(sizeof mumps_.ooc_tmpdir - 1) + " bytes"};
  std::memcpy(mumps_.ooc_tmpdir, folder.c_str(), folder.size() + 1);
  control(mumps_, 22) = 1;
  // MUMPS is told to write files without a thread for that: the thread ends at the first error, and ranks would wait
  // for it for ever.
  mumps_.keep[98] = 3;
  return {};
}

// Gives each rank its part of the rows and columns of entries, and MUMPS the order of elimination.
Verdict MumpsFactor::share_pattern(const Order& order, const bempd_sparse_task* task) {
  const std::int64_t mine = first_entry(order.entries, rank_ + 1) - first_entry(order.entries, rank_);
  bool has_memory = true;
  std::vector<int> rows, columns;  // to be sent
  try {
    rows_.resize(static_cast<std::size_t>(mine));
    columns_.resize(static_cast<std::size_t>(mine));
    if (task) name_kept(order, task);
    if (task && ranks_ > 1)
      rows.reserve(static_cast<std::size_t>(mine)), columns.reserve(static_cast<std::size_t>(mine));
  } catch (const std::bad_alloc&) {
    has_memory = false;
  }
  if (!on_all(has_memory, comm_)) return {BEMPD_ERROR_MEMORY, "not enough memory for the matrix on some process"};
  if (task) {
    std::int64_t column = 0;
    for (int r = 0; r < ranks_; ++r) {
      const std::int64_t first = first_entry(order.entries, r), count = first_entry(order.entries, r + 1) - first;
      std::vector<int>& to_rows = r == 0 ? rows_ : rows;
      std::vector<int>& to_columns = r == 0 ? columns_ : columns;
      to_rows.resize(static_cast<std::size_t>(count));
      to_columns.resize(static_cast<std::size_t>(count));
      for (std::int64_t k = 0; k < count; ++k) {
        while (task->column_start[column + 1] <= first + k) ++column;
        to_rows[static_cast<std::size_t>(k)] = task->rows[first + k] + 1;
        to_columns[static_cast<std::size_t>(k)] = static_cast<int>(column) + 1;
      }
      if (r == 0) continue;
      send(rows.data(), count, r, comm_);
      send(columns.data(), count, r, comm_);
    }
  } else {
    receive(rows_.data(), mine, 0, comm_);
    receive(columns_.data(), mine, 0, comm_);
  }
  mumps_.n = static_cast<MUMPS_INT>(order.unknowns);
  mumps_.nnz_loc = mine;
  mumps_.irn_loc = rows_.data();
  mumps_.jcn_loc = columns_.data();
  control(mumps_, 7) = order.has_order ? 1 : 7;
  mumps_.perm_in = order.has_order && task ? position_.data() : nullptr;
  if (order.kept == 0) return {};
  control(mumps_, 19) = 3;  // the whole complement on rank 0
  mumps_.nprow = mumps_.npcol = 1;
  mumps_.mblock = mumps_.nblock = 100;
  mumps_.size_schur = static_cast<MUMPS_INT>(order.kept);
  mumps_.listvar_schur = task ? kept_.data() : nullptr;
  return {};
}

void MumpsFactor::name_kept(const Order& order, const bempd_sparse_task* task) {
  if (!order.has_order) return;
  position_.resize(static_cast<std::size_t>(order.unknowns));
  for (std::int64_t k = 0; k < order.unknowns; ++k)
    position_[static_cast<std::size_t>(task->order[k])] = static_cast<int>(k) + 1;
  for (std::int64_t k = order.unknowns - order.kept; k < order.unknowns; ++k) kept_.push_back(task->order[k] + 1);
}

Verdict MumpsFactor::share_values(const Order& order, const bempd_sparse_task* task) {
  const std::int64_t mine = first_entry(order.entries, rank_ + 1) - first_entry(order.entries, rank_);
  bool has_memory = true;
  try {
    if (!task) values_.resize(static_cast<std::size_t>(mine));
  } catch (const std::bad_alloc&) {
    has_memory = false;
  }
  if (!on_all(has_memory, comm_)) return {BEMPD_ERROR_MEMORY, "not enough memory for the matrix on some process"};
  if (!task) {
    receive(values_.data(), mine, 0, comm_);
    mumps_.a_loc = values_.data();
    return {};
  }
  for (int r = 1; r < ranks_; ++r) {
    const std::int64_t first = first_entry(order.entries, r);
    send(task->values + first, first_entry(order.entries, r + 1) - first, r, comm_);
  }
  mumps_.a_loc = const_cast<double*>(task->values);  // MUMPS reads it only
  return {};
}

Verdict MumpsFactor::factorize(const Order& order, bempd_sparse_task* task) {
  Verdict result = share_values(order, task);
  if (!result.is_good()) return result;
  if (order.kept > 0 && task) {
    mumps_.schur = task->schur;
    mumps_.schur_lld = static_cast<MUMPS_INT>(order.kept);
  }
  result = run(factorization);
  const int workspace = control(mumps_, 14);
  for (int retry = 0; retry < most_retries && (found(mumps_, 1) == -8 || found(mumps_, 1) == -9); ++retry) {
    control(mumps_, 14) *= 2;  // percentage by which the workspace exceeds the estimate
    result = run(factorization);
  }
  control(mumps_, 14) = workspace;
  values_ = {};
  mumps_.a_loc = nullptr;
  if (!result.is_good()) return result;
  if (found(mumps_, 12) > 0) return {BEMPD_ERROR_UNSOLVABLE, "the matrix has negative pivots"};
  if (!task) return {};
  task->smallest_pivot = mumps_.rinfog[18];
  const int entries = found(mumps_, 29);  // negative: number of millions
  task->entries = entries >= 0 ? entries : -std::int64_t{1000000} * entries;
  return {};
}

Verdict MumpsFactor::solve(const Order& order, bempd_sparse_task* task) {
  const int part = order.request == BEMPD_SPARSE_REDUCE ? 1 : order.request == BEMPD_SPARSE_EXPAND ? 2 : 0;
  control(mumps_, 26) = part;
  control(mumps_, 27) = static_cast<int>(order.sides);  // all at once
  mumps_.nrhs = static_cast<MUMPS_INT>(order.sides);
  if (task) {
    mumps_.rhs = task->vectors;
    mumps_.lrhs = static_cast<MUMPS_INT>(order.unknowns);
    mumps_.redrhs = part > 0 ? task->kept : nullptr;
    mumps_.lredrhs = static_cast<MUMPS_INT>(order.kept);
  }
  return run(solution);
}

}  // namespace bempd::mpi
