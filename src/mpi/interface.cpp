#include <dmumps_c.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <string>

#include "bempd_mpi.h"
#include "mpi/connection.hpp"

using namespace bempd::mpi;

namespace {

// Message of the last failed call on this thread.
char (&last_error())[1024] {
  thread_local char text[1024] = "";
  return text;
}

bempd_status report(bempd_status status, const std::string& function, const std::string& sentence) {
  std::string whole = sentence.rfind("bempd_", 0) == 0 ? sentence : function + ": " + sentence;
  whole.resize(std::min(whole.size(), sizeof last_error() - 1));
  std::memcpy(last_error(), whole.c_str(), whole.size() + 1);
  return status;
}

// Runs a call of the C interface and turns every exception into a status and a message.
template <class Body>
bempd_status guarded(const char* function, const Body& body) noexcept {
  last_error()[0] = '\0';
  try {
    std::string why;
    if (!may_call_mpi(why)) return report(BEMPD_ERROR_ORDER, function, why);
    return body();
  } catch (const std::bad_alloc&) {
    std::strcpy(last_error(), "not enough memory");
    return BEMPD_ERROR_MEMORY;
  } catch (const std::exception& error) {
    return report(BEMPD_ERROR_INTERNAL, function, error.what());
  }
}

// Function that the core library calls as its sparse solver. The request BEMPD_SPARSE_DETACH is the last one and ends
// the connection.
int32_t answer(bempd_sparse_task* task, void* user) {
  auto* const connection = static_cast<Connection*>(user);
  if (task->request == BEMPD_SPARSE_DETACH) {
    delete connection;
    return BEMPD_OK;
  }
  return connection->answer(*task);
}

int rank_in(MPI_Comm comm) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  return rank;
}

}  // namespace

bempd_status bempd_mpi_attach(bempd_model* model, MPI_Comm comm) {
  const char* const function = __func__;
  return guarded(function, [&] {
    if (comm == MPI_COMM_NULL) return report(BEMPD_ERROR_ARGUMENT, function, "comm is MPI_COMM_NULL");
    if (rank_in(comm) != 0)
      return report(BEMPD_ERROR_ARGUMENT, function, "it is for rank 0; the other ranks call bempd_mpi_serve()");
    if (Connection::exists_for(comm))
      return report(BEMPD_ERROR_ORDER, function,
                    "the communicator serves another model; detach that one, or give a communicator of its own");
    bool has_ended = false;
    auto* const connection = new Connection(comm);
    connection->set_end_flag(&has_ended);
    const bempd_status status = bempd_set_sparse_solver(model, answer, connection);
    if (status == BEMPD_OK) {
      connection->set_end_flag(nullptr);
      return status;
    }
    if (!has_ended) delete connection;  // the core has not taken the connection over
    return report(status, function, bempd_last_error(model));
  });
}

bempd_status bempd_mpi_serve(MPI_Comm comm) {
  const char* const function = __func__;
  return guarded(function, [&] {
    if (comm == MPI_COMM_NULL) return report(BEMPD_ERROR_ARGUMENT, function, "comm is MPI_COMM_NULL");
    if (rank_in(comm) == 0)
      return report(BEMPD_ERROR_ARGUMENT, function, "it is for other ranks; rank 0 calls bempd_mpi_attach()");
    follow_orders(comm);
    return BEMPD_OK;
  });
}

bempd_status bempd_mpi_detach(bempd_model* model) {
  const char* const function = __func__;
  return guarded(function, [&] {
    const bempd_status status = bempd_set_sparse_solver(model, nullptr, nullptr);
    return status == BEMPD_OK ? status : report(status, function, bempd_last_error(model));
  });
}

bempd_status bempd_mpi_attach_handle(bempd_model* model, int32_t comm) {
  return bempd_mpi_attach(model, MPI_Comm_f2c(static_cast<MPI_Fint>(comm)));
}

bempd_status bempd_mpi_serve_handle(int32_t comm) { return bempd_mpi_serve(MPI_Comm_f2c(static_cast<MPI_Fint>(comm))); }

const char* bempd_mpi_last_error(void) { return last_error(); }

const char* bempd_mpi_build_info(void) { return "MUMPS " MUMPS_VERSION ", licence CeCILL-C"; }
