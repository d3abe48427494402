#pragma once

#include <cholmod.h>

#include <new>
#include <stdexcept>
#include <string>

namespace bempd::linalg {

// Throws std::runtime_error if the CHOLMOD that is loaded has another main version than the one compiled with, because
// its settings then lie elsewhere in memory.
inline void require_cholmod(int running) {
  if (running == CHOLMOD_MAIN_VERSION) return;
  throw std::runtime_error("CHOLMOD " + std::to_string(running) + " runs, but bempd was compiled with CHOLMOD " +
                           std::to_string(CHOLMOD_MAIN_VERSION) + "; install that one or compile bempd again");
}

// Workspace and settings of CHOLMOD. Its errors become exceptions instead of messages on the host's terminal.
class CholmodCommon {
 public:
  CholmodCommon() {
    int running[3] = {0, 0, 0};
    cholmod_version(running);
    require_cholmod(running[0]);
    cholmod_start(&common_);
    common_.print = 0;
    common_.error_handler = [](int, const char*, int, const char* message) { last_message() = message; };
  }
  ~CholmodCommon() { cholmod_finish(&common_); }
  CholmodCommon(const CholmodCommon&) = delete;
  CholmodCommon& operator=(const CholmodCommon&) = delete;

  cholmod_common* get() { return &common_; }
  cholmod_common* operator->() { return &common_; }

  // Throws if the last CHOLMOD call has failed; to be called after each. A negative status is an error, a positive one
  // a warning.
  void check() const {
    // A matrix too large for CHOLMOD's 32-bit integers would need tens of gigabytes, so it counts as out of memory.
    if (common_.status == CHOLMOD_OUT_OF_MEMORY || common_.status == CHOLMOD_TOO_LARGE) throw std::bad_alloc();
    if (common_.status < 0) throw std::runtime_error(std::string("CHOLMOD: ") + last_message());
  }

 private:
  // Message of the last error in this thread. CHOLMOD's handler gets no user pointer, so the message is stored per
  // thread.
  static const char*& last_message() {
    thread_local const char* message = "unknown error";
    return message;
  }

  cholmod_common common_;
};

// Owner of a CHOLMOD object that `release(&pointer, common)` frees; `slot` is where CHOLMOD stores or replaces it.
template <class T, int (*release)(T**, cholmod_common*)>
class CholmodHandle {
 public:
  explicit CholmodHandle(CholmodCommon& common) : common_(common) {}
  ~CholmodHandle() { reset(); }
  CholmodHandle(const CholmodHandle&) = delete;
  CholmodHandle& operator=(const CholmodHandle&) = delete;

  void reset(T* value = nullptr) {
    if (value_) release(&value_, common_.get());
    value_ = value;
  }
  T* get() const { return value_; }
  T* operator->() const { return value_; }
  T** slot() { return &value_; }
  explicit operator bool() const { return value_ != nullptr; }

 private:
  CholmodCommon& common_;
  T* value_ = nullptr;
};

using CholmodFactor = CholmodHandle<cholmod_factor, cholmod_free_factor>;
using CholmodDense = CholmodHandle<cholmod_dense, cholmod_free_dense>;

}  // namespace bempd::linalg
