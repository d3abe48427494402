#include "capi/guard.hpp"

#include <cstring>
#include <new>

#include "linalg/blas_threads.hpp"
#include "linalg/external_solver.hpp"
#include "no_memory.hpp"
#include "phase.hpp"
#include "stop_request.hpp"

namespace bempd::capi {

namespace {

// Largest number of points that a call accepts; larger numbers come from a mistake.
constexpr std::int64_t most_points = std::int64_t{1} << 31;

bempd_status status_of(Failure failure) {
  switch (failure) {
    case Failure::argument:
      return BEMPD_ERROR_ARGUMENT;
    case Failure::order:
      return BEMPD_ERROR_ORDER;
    case Failure::unsolvable:
      return BEMPD_ERROR_UNSOLVABLE;
    case Failure::convergence:
      return BEMPD_ERROR_CONVERGENCE;
    case Failure::cancelled:
      return BEMPD_ERROR_CANCELLED;
    case Failure::io:
      return BEMPD_ERROR_IO;
  }
  return BEMPD_ERROR_INTERNAL;
}

// Runs `body` and turns every exception into a status and a message for `error`. An internal error also sets *broken,
// if `broken` is not null.
template <class Message>
bempd_status catch_all(const char* function, Message& error, bool* broken, const Work<>& body) noexcept {
  try {
    const auto report = [&](bempd_status status, const char* what) {
      error.assign(std::string(function) + ": " + what);
      return status;
    };
    try {
      error.clear();
      body();
      return BEMPD_OK;
    } catch (const Error& e) {
      return report(status_of(e.failure()), e.what());
    } catch (const NoMemory& e) {
      return report(BEMPD_ERROR_MEMORY, e.what());
    } catch (const std::bad_alloc&) {
      return report(BEMPD_ERROR_MEMORY, "not enough memory; use fewer elements or a coarser lattice");
    } catch (const std::exception& e) {
      if (broken) *broken = true;
      return report(BEMPD_ERROR_INTERNAL, (std::string("internal error: ") + e.what()).c_str());
    } catch (...) {
      if (broken) *broken = true;
      return report(BEMPD_ERROR_INTERNAL, "internal error");
    }
  } catch (...) {
    error.assign("out of memory");  // short enough for a string's internal buffer
    return BEMPD_ERROR_MEMORY;
  }
}

// Runs a call on a model. After a failure, what the call has prepared is discarded, so that the scene can be corrected.
void run(model::Model& engine, const Work<model::Model&>& body) {
  const bool was_prepared = engine.prepared_or_null() != nullptr;
  const CancellationScope cancellation = engine.host().hear();
  const StopScope stop(engine.host().stop_request());
  const ListeningScope listening(engine.host().phase_listener());
  const linalg::BlasThreads blas_threads(std::max(1, engine.options().whole_number("threads")));
  const linalg::SolverChoice solver = engine.solver().choice();
  const linalg::SolverScope solving(solver);
  try {
    body(engine);
  } catch (const Error& error) {
    engine.call_failed(was_prepared, error.failure() == Failure::unsolvable);
    throw;
  } catch (...) {
    engine.call_failed(was_prepared, false);
    throw;
  }
}

void run(const model::Model& engine, const Work<const model::Model&>& body) { body(engine); }

// Adds, to the message of a failed call, the names that the host gave to parts of the scene. Without memory for the
// names the message stays as it is.
void name_things(const bempd_model& model) noexcept {
  try {
    model.error = model.engine.names().in(model.error);
  } catch (const std::bad_alloc&) {
  }
}

template <class Handle, class Body>
bempd_status guarded(Handle* model, const char* function, const Body& body) noexcept {
  if (!model) {
    return without_model(function, [] { require(false, "model is NULL; create one with bempd_model_create()"); });
  }
  Use idle = Use::idle;
  if (!model->use.compare_exchange_strong(idle, Use::in_a_call)) {
    return without_model(function, [] {
      fail(Failure::order,
           "the model is in another call; from a callback or another thread only bempd_request_cancel() is allowed");
    });
  }
  const bempd_status status = catch_all(function, model->error, &model->broken, [&] {
    if (model->broken)
      throw std::logic_error("the model has had an internal error before; only bempd_model_free() works");
    run(model->engine, body);
  });
  if (status != BEMPD_OK) name_things(*model);
  Use in_a_call = Use::in_a_call;
  if (!model->use.compare_exchange_strong(in_a_call, Use::idle)) {
    thread_error().assign(model->error);  // the host can read this message afterwards
    delete model;
  }
  return status;
}

}  // namespace

bempd_status without_model(const char* function, const Work<>& body) noexcept {
  return catch_all(function, thread_error(), nullptr, body);
}

bempd_status with_model(bempd_model* model, const char* function, const Work<model::Model&>& body) noexcept {
  return guarded(model, function, body);
}

bempd_status with_model(const bempd_model* model, const char* function,
                        const Work<const model::Model&>& body) noexcept {
  return guarded(model, function, body);
}

ThreadError& thread_error() {
  thread_local ThreadError error;  // all zeros, and nothing to do at its end
  return error;
}

std::vector<Point> points_from(const double* values, std::int64_t count, const char* name) {
  require(count >= 0 && count < most_points, "the number of ", name, " is ", count, "; it must be a count");
  require(values != nullptr || count == 0, name, " is NULL; give an array of shape [n][2]");
  std::vector<Point> points(static_cast<std::size_t>(count));
  for (std::int64_t i = 0; i < count; ++i) points[i] = Point(values[2 * i], values[2 * i + 1]);
  return points;
}

void write_bytes(std::span<const std::uint8_t> bytes, void* buffer, std::int64_t capacity, std::int64_t* needed) {
  const auto size = static_cast<std::int64_t>(bytes.size());
  give(needed, size);
  if (!buffer && capacity == 0) return;
  require(buffer != nullptr, "buffer is NULL; give one, or capacity 0 to learn the size");
  require(capacity >= size, "capacity is ", capacity, " bytes; ", size, " are needed");
  std::memcpy(buffer, bytes.data(), bytes.size());
}

void write_text(const std::string& words, char* buffer, std::int64_t capacity, std::int64_t* needed) {
  write_bytes({reinterpret_cast<const std::uint8_t*>(words.c_str()), words.size() + 1}, buffer, capacity, needed);
}

}  // namespace bempd::capi
