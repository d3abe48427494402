#include "mpi/connection.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <thread>
#include <vector>

#include "linalg/blas_threads.hpp"

namespace bempd::mpi {

namespace {

// Calls happened() until it returns true, and sleeps in between: rank 0 may work alone for a long time, during which
// the other ranks should not use their processors.
template <class Happened>
void wait_for(const Happened& happened) {
  using namespace std::chrono_literals;
  for (auto pause = 0us; !happened(); pause = std::min<std::chrono::microseconds>(pause + 10us, 1000us))
    std::this_thread::sleep_for(pause);
}

MPI_Comm copy_of(MPI_Comm comm) {
  MPI_Comm copy = MPI_COMM_NULL;
  MPI_Request all_have_come = MPI_REQUEST_NULL;
  MPI_Comm_idup(comm, &copy, &all_have_come);
  wait_for([&] {
    int done = 0;
    MPI_Test(&all_have_come, &done, MPI_STATUS_IGNORE);
    return done != 0;
  });
  return copy;
}

// Communicators of hosts over which a connection is open.
struct Used {
  std::mutex mutex;
  std::vector<MPI_Comm> comms;
};

Used& used() {
  static Used all;
  return all;
}

constexpr int numbers_of_an_order = sizeof(Order) / sizeof(std::int64_t);

Order next_order(MPI_Comm comm) {
  wait_for([&] {
    int has_come = 0;
    MPI_Iprobe(0, tag_of_orders, comm, &has_come, MPI_STATUS_IGNORE);
    return has_come != 0;
  });
  Order order;
  MPI_Recv(&order, numbers_of_an_order, MPI_INT64_T, 0, tag_of_orders, comm, MPI_STATUS_IGNORE);
  return order;
}

Order order_for(const bempd_sparse_task& task) {
  Order order;
  order.request = task.request;
  order.factor = task.factor;
  order.unknowns = task.unknowns;
  order.entries = task.column_start ? task.column_start[task.unknowns] : 0;
  order.sides = task.sides;
  order.kept = task.kept_count;
  order.has_order = task.order ? 1 : 0;
  order.scratch_bytes = task.scratch ? static_cast<std::int64_t>(std::char_traits<char>::length(task.scratch)) : 0;
  return order;
}

}  // namespace

Connection::Connection(MPI_Comm of_host) : of_host_(of_host), comm_(copy_of(of_host)), factors_(comm_) {
  const std::lock_guard lock(used().mutex);
  used().comms.push_back(of_host);
}

bool Connection::exists_for(MPI_Comm of_host) {
  const std::lock_guard lock(used().mutex);
  return std::find(used().comms.begin(), used().comms.end(), of_host) != used().comms.end();
}

void Connection::send_order(const Order& order) const {
  int ranks = 1;
  MPI_Comm_size(comm_, &ranks);
  for (int rank = 1; rank < ranks; ++rank)
    MPI_Send(&order, numbers_of_an_order, MPI_INT64_T, rank, tag_of_orders, comm_);
}

std::int32_t Connection::answer(bempd_sparse_task& task) {
  if (task.request == BEMPD_SPARSE_FORGET && !factors_.has(task.factor)) return BEMPD_OK;
  if (!may_call_mpi(sentence_)) {
    task.message = sentence_.c_str();
    return BEMPD_ERROR_ORDER;
  }
  const Order order = order_for(task);
  send_order(order);
  Verdict verdict = factors_.perform(order, &task);
  sentence_ = std::move(verdict.sentence);
  task.message = sentence_.c_str();
  return verdict.status;
}

Connection::~Connection() {
  if (ended_) *ended_ = true;
  {
    const std::lock_guard lock(used().mutex);
    used().comms.erase(std::find(used().comms.begin(), used().comms.end(), of_host_));
  }
  std::string why_not;
  if (!may_call_mpi(why_not)) {  // for example if a model is freed after MPI_Finalize()
    factors_.abandon();
    return;
  }
  Order end;
  end.request = BEMPD_SPARSE_DETACH;
  send_order(end);
  factors_.clear();
  MPI_Comm_free(&comm_);
}

void follow_orders(MPI_Comm of_host) {
  const linalg::BlasThreads one_thread(1);
  MPI_Comm comm = copy_of(of_host);
  Factors factors(comm);
  for (;;) {
    const Order order = next_order(comm);
    if (order.request == BEMPD_SPARSE_DETACH) break;
    factors.perform(order, nullptr);
  }
  factors.clear();
  MPI_Comm_free(&comm);
}

bool may_call_mpi(std::string& sentence) {
  int began = 0, ended = 0, level = 0, is_main = 0;
  MPI_Initialized(&began);
  if (began) MPI_Finalized(&ended);
  if (!began || ended) {
    sentence = began ? "MPI_Finalize() was called before" : "MPI is not initialized; the host calls MPI_Init_thread()";
    return false;
  }
  MPI_Query_thread(&level);
  MPI_Is_thread_main(&is_main);
  if (level >= MPI_THREAD_SERIALIZED || is_main) return true;
  sentence =
      "the call comes from another thread than the one that initialized MPI; make it there, or initialize MPI with "
      "MPI_THREAD_SERIALIZED";
  return false;
}

}  // namespace bempd::mpi
