#pragma once

#include <cholmod.h>

#include <new>
#include <stdexcept>
#include <string>

namespace bempd::linalg {

// Throws std::runtime_error if the loaded CHOLMOD has another main version than the version compiled with, because
// CHOLMOD's settings then lie elsewhere in memory.
inline void require_cholmod(int running) {
  if (running == CHOLMOD_MAIN_VERSION) return;
  throw std::runtime_error("CHOLMOD " + std::to_string(running) + " runs, but bempd was compiled with CHOLMOD " +
                           std::to_string(CHOLMOD_MAIN_VERSION) + "; install that one or compile bempd again");
}

// CHOLMOD's functions for its two kinds of indices: 32 bits, for factors of up to 2^31 entries, and 64 bits.
template <class Index>
struct Cholmod;

template <>
struct Cholmod<int> {
  static constexpr int index_type = CHOLMOD_INT;
  static constexpr auto version = cholmod_version;
  static constexpr auto start = cholmod_start, finish = cholmod_finish;
  static constexpr auto analyze = cholmod_analyze_p;
  static constexpr auto copy_factor = cholmod_copy_factor;
  static constexpr auto change_factor = cholmod_change_factor;
  static constexpr auto update = cholmod_updown;
  static constexpr auto solve = cholmod_solve2;
  static constexpr auto free_factor = cholmod_free_factor;
  static constexpr auto free_dense = cholmod_free_dense;
};

template <>
struct Cholmod<SuiteSparse_long> {
  static constexpr int index_type = CHOLMOD_LONG;
  static constexpr auto version = cholmod_l_version;
  static constexpr auto start = cholmod_l_start, finish = cholmod_l_finish;
  static constexpr auto analyze = cholmod_l_analyze_p;
  static constexpr auto copy_factor = cholmod_l_copy_factor;
  static constexpr auto change_factor = cholmod_l_change_factor;
  static constexpr auto update = cholmod_l_updown;
  static constexpr auto solve = cholmod_l_solve2;
  static constexpr auto free_factor = cholmod_l_free_factor;
  static constexpr auto free_dense = cholmod_l_free_dense;
};

// Exception for a factor with more entries than indices of 32 bits can count.
struct TooLargeForIndices : std::bad_alloc {};

// Workspace and settings of CHOLMOD. Its errors become exceptions instead of messages on the host's terminal.
template <class Index>
class CholmodCommon {
 public:
  CholmodCommon() {
    int running[3] = {0, 0, 0};
    Cholmod<Index>::version(running);
    require_cholmod(running[0]);
    Cholmod<Index>::start(&common_);
    common_.print = 0;
    common_.error_handler = [](int, const char*, int, const char* message) { last_message() = message; };
  }
  ~CholmodCommon() { Cholmod<Index>::finish(&common_); }
  CholmodCommon(const CholmodCommon&) = delete;
  CholmodCommon& operator=(const CholmodCommon&) = delete;

  cholmod_common* get() { return &common_; }
  cholmod_common* operator->() { return &common_; }

  // Throws if the last CHOLMOD call has failed; must follow each call. A negative status is an error, a positive status
  // a warning.
  void check() const {
    if (common_.status == CHOLMOD_TOO_LARGE) throw TooLargeForIndices();
    if (common_.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
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
template <class Index, class T, int (*release)(T**, cholmod_common*)>
class CholmodHandle {
 public:
  explicit CholmodHandle(CholmodCommon<Index>& common) : common_(common) {}
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
  CholmodCommon<Index>& common_;
  T* value_ = nullptr;
};

template <class Index>
using CholmodFactor = CholmodHandle<Index, cholmod_factor, Cholmod<Index>::free_factor>;
template <class Index>
using CholmodDense = CholmodHandle<Index, cholmod_dense, Cholmod<Index>::free_dense>;

}  // namespace bempd::linalg
