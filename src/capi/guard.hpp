#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "bempd.h"
#include "error.hpp"
#include "linalg/blas_threads.hpp"
#include "model/model.hpp"
#include "phase.hpp"

namespace bempd::capi {

enum class Use { idle, in_a_call, to_be_freed };  // the last: once the call that runs returns

}  // namespace bempd::capi

// The handles of the C interface. A const model keeps its engine as it is; the books of the calls are not part of that.
struct bempd_model {
  bempd::model::Model engine;
  mutable std::string error;
  mutable std::atomic<bempd::capi::Use> use{bempd::capi::Use::idle};
  mutable bool broken = false;  // after an internal error
};

struct bempd_state {
  bempd::model::SavedState saved;
};

namespace bempd::capi {

// Message of the last failure of a call without a model, cut off where it is too long. A thread's own std::string would
// be registered for its end, for which the C library takes memory and ends the process where there is none.
class ThreadError {
 public:
  void assign(std::string_view message) noexcept {
    const std::size_t size = std::min(message.size(), sizeof text_ - 1);
    std::memcpy(text_, message.data(), size);
    text_[size] = '\0';
  }
  void clear() noexcept { text_[0] = '\0'; }
  const char* c_str() const { return text_; }

 private:
  char text_[2048] = {};
};

ThreadError& thread_error();

bempd_status status_of(Failure failure);

// Runs `body`, turning every exception into a status and a message that starts with the function's name.
template <class Message, class Body>
bempd_status catch_all(const char* function, Message& error, bool* broken, const Body& body) noexcept {
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
    error.assign("out of memory");  // short enough for what every string has of its own
    return BEMPD_ERROR_MEMORY;
  }
}

// A call that has no model.
template <class Body>
bempd_status without_model(const char* function, const Body& body) noexcept {
  return catch_all(function, thread_error(), nullptr, body);
}

// What a failed call has prepared is given up again, so that the scene can be corrected.
template <class Body>
void run(model::Model& engine, const Body& body) {
  const bool was_prepared = engine.prepared_or_null() != nullptr;
  const CancellationScope cancellation = engine.hear_requests();
  const ListeningScope listening(engine.phase_listener());
  const linalg::BlasThreads blas_threads(engine.blas_threads());
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

template <class Body>
void run(const model::Model& engine, const Body& body) {
  body(engine);
}

// A call on a model, const or not; `body` receives its engine.
template <class Handle, class Body>
bempd_status with_model(Handle* model, const char* function, const Body& body) noexcept {
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
  Use in_a_call = Use::in_a_call;
  if (!model->use.compare_exchange_strong(in_a_call, Use::idle)) {
    thread_error().assign(model->error);  // what happened can still be asked for
    delete model;
  }
  return status;
}

template <class T>
T& out(T* pointer, const char* name) {
  require(pointer != nullptr, name, " is NULL; give a place for the result");
  return *pointer;
}

inline void require_finite(double value, const char* name) {
  require(std::isfinite(value), name, " is ", value, "; it must be a finite number");
}

std::vector<Point> points_from(const double* values, std::int64_t count, const char* name);

// Size that a caller's struct must have at least and what it says.
template <class T>
std::size_t struct_bytes(const T* given, const char* name, std::size_t least) {
  require(given != nullptr, name, " is NULL; give a struct filled by its _init function");
  require(given->struct_size >= static_cast<std::int64_t>(least) && given->struct_size < (1 << 20), name,
          "->struct_size is ", given->struct_size, "; give the struct's size to its _init function first");
  return static_cast<std::size_t>(given->struct_size);
}

// Copies into a caller's struct as much as its size allows, keeping that size.
template <class T>
void write_struct(T* target, const T& values, const char* name) {
  const std::size_t size = std::min(struct_bytes(target, name, sizeof(std::int64_t)), sizeof(T));
  const std::int64_t keep = target->struct_size;
  std::memcpy(target, &values, size);
  target->struct_size = keep;
}

// Fills a caller's struct of the size it was compiled with.
template <class T>
bempd_status init_struct(const char* function, const char* name, T* target, std::int64_t size, const T& defaults) {
  return without_model(function, [&] {
    out(target, name).struct_size = size;
    struct_bytes(target, name, sizeof(std::int64_t));
    write_struct(target, defaults, name);
  });
}

}  // namespace bempd::capi
