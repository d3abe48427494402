#pragma once

#include <mpi.h>

#include <string>

#include "bempd.h"
#include "mpi/factors.hpp"

namespace bempd::mpi {

// Rank 0's end of a copy of the host's communicator: solver of one model (bempd_sparse_function), which makes the other
// ranks carry out the same orders.
class Connection {
 public:
  // Collective with follow_orders() on the other ranks.
  explicit Connection(MPI_Comm of_host);
  ~Connection();  // lets the other ranks go
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  static bool exists_for(MPI_Comm of_host);

  std::int32_t answer(bempd_sparse_task& task);
  void set_end_flag(bool* flag) { ended_ = flag; }  // set when the connection ends; null: none

 private:
  void send_order(const Order& order) const;

  MPI_Comm of_host_, comm_ = MPI_COMM_NULL;
  Factors factors_;
  std::string sentence_;
  bool* ended_ = nullptr;
};

// Carries out the orders of rank 0 until it closes the connection.
void follow_orders(MPI_Comm of_host);

// Whether MPI can be called here and now; if not, `sentence` says why.
bool may_call_mpi(std::string& sentence);

}  // namespace bempd::mpi
