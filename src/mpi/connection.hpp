#pragma once

#include <mpi.h>

#include <string>

#include "bempd.h"
#include "mpi/factors.hpp"

namespace bempd::mpi {

// Connection of rank 0 to the other ranks of an MPI communicator, for the solver of one model. On rank 0 it answers the
// model's requests (bempd_sparse_function), and makes the other ranks carry out the same orders. Messages go over a
// copy of the host's communicator.
class Connection {
 public:
  // Opens the connection; collective with follow_orders() on the other ranks.
  explicit Connection(MPI_Comm of_host);
  ~Connection();  // ends follow_orders() on the other ranks
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  // Whether a connection over this communicator of the host is open.
  static bool exists_for(MPI_Comm of_host);

  std::int32_t answer(bempd_sparse_task& task);
  void set_end_flag(bool* flag) { ended_ = flag; }  // *flag becomes true when the connection ends; null: no flag

 private:
  void send_order(const Order& order) const;

  MPI_Comm of_host_, comm_ = MPI_COMM_NULL;
  Factors factors_;
  std::string sentence_;
  bool* ended_ = nullptr;
};

// Carries out the orders of rank 0 until rank 0 closes the connection.
void follow_orders(MPI_Comm of_host);

// Whether MPI can be called now and on this thread; if not, `sentence` says why.
bool may_call_mpi(std::string& sentence);

}  // namespace bempd::mpi
