#pragma once

#include <mpi.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace bempd::mpi {

// Order of rank 0 to all ranks of a communicator: a request (bempd_sparse_request) with the sizes of its arrays. The
// arrays follow in messages of their own.
struct Order {
  std::int64_t request = 0, factor = 0, unknowns = 0, entries = 0, sides = 0;
  std::int64_t kept = 0, has_order = 0, scratch_bytes = 0;
};

// Error that all ranks agree on; status 0: no error.
struct Verdict {
  std::int32_t status = 0;
  std::string sentence;
  bool is_good() const { return status == 0; }
};

constexpr int tag_of_orders = 1, tag_of_arrays = 2;

// Largest number of values in a message: counts of MPI are 32-bit integers, so that long arrays are sent in pieces.
constexpr std::int64_t most_at_once = std::int64_t{1} << 27;

template <class T>
MPI_Datatype datatype();
template <>
inline MPI_Datatype datatype<int>() {
  return MPI_INT;
}
template <>
inline MPI_Datatype datatype<double>() {
  return MPI_DOUBLE;
}

template <class T>
void send(const T* values, std::int64_t count, int rank, MPI_Comm comm) {
  for (std::int64_t first = 0; first < count; first += most_at_once)
    MPI_Send(values + first, static_cast<int>(std::min(most_at_once, count - first)), datatype<T>(), rank,
             tag_of_arrays, comm);
}

template <class T>
void receive(T* values, std::int64_t count, int rank, MPI_Comm comm) {
  for (std::int64_t first = 0; first < count; first += most_at_once)
    MPI_Recv(values + first, static_cast<int>(std::min(most_at_once, count - first)), datatype<T>(), rank,
             tag_of_arrays, comm, MPI_STATUS_IGNORE);
}

// Whether `here` is true on all ranks.
inline bool on_all(bool here, MPI_Comm comm) {
  int mine = here ? 1 : 0, all = 0;
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MIN, comm);
  return all == 1;
}

}  // namespace bempd::mpi
