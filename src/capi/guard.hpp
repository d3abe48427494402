#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bempd.h"
#include "error.hpp"
#include "model/model.hpp"

namespace bempd::capi {

enum class Use { idle, in_a_call, to_be_freed };  // to_be_freed: when the running call returns

}  // namespace bempd::capi

// Handles of the C interface. Calls on a const model do not change its engine; error message and flags are mutable,
// because every call sets them.
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

// Message of the last failed call without a model on this thread, cut off at 2047 bytes. The text is no std::string:
// the destructor of a thread-local string has to be registered, and the C library ends the process if memory for that
// is missing.
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

// Reference to the work of a call, so that the guards are compiled once and not for every function. It consists of two
// pointers, allocates nothing, and may only be used as an argument.
template <class... Arguments>
class Work {
 public:
  template <class Body>
  Work(const Body& body)
      : body_(&body),
        call_([](const void* b, Arguments... arguments) { (*static_cast<const Body*>(b))(arguments...); }) {}

  void operator()(Arguments... arguments) const { call_(body_, arguments...); }

 private:
  const void* body_;
  void (*call_)(const void*, Arguments...);
};

// Runs a call without a model. Every exception becomes a status and a message that begins with the function's name.
bempd_status without_model(const char* function, const Work<>& body) noexcept;

// Runs a call on a model; `body` receives the model's engine. Every exception becomes a status and a message on the
// model.
bempd_status with_model(bempd_model* model, const char* function, const Work<model::Model&>& body) noexcept;
bempd_status with_model(const bempd_model* model, const char* function, const Work<const model::Model&>& body) noexcept;

template <class T>
T& out(T* pointer, const char* name) {
  require(pointer != nullptr, name, " is NULL; give a place for the result");
  return *pointer;
}

// Writes a result to a place that is null if the caller does not want it.
template <class T, class Value>
void give(T* place, const Value& value) {
  if (place) *place = value;
}

// Writes displacements and stresses at places to arrays; those that are null are left out.
template <class PointValues>
void give_values(const PointValues& values, double* displacement, double* stress) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (displacement) std::copy_n(values[i].displacement.data(), 2, displacement + 2 * i);
    if (stress) std::copy_n(values[i].stress.data(), 3, stress + 3 * i);
  }
}

inline void require_finite(double value, const char* name) {
  require(std::isfinite(value), name, " is ", value, "; it must be a finite number");
}

// Throws Error (argument) unless the length of a caller's array is 1 .. 2^31 - 1; `thing` is a word for an entry.
inline void require_count(std::int64_t count, const char* name, const char* thing) {
  require(count >= 1 && count < (std::int64_t{1} << 31), name, " is ", count, "; give at least 1 ", thing);
}

std::vector<Point> points_from(const double* values, std::int64_t count, const char* name);

// Copy of a caller's numbers; zeros if `values` is null.
inline std::vector<double> numbers_or_zeros(const double* values, std::size_t count) {
  return values ? std::vector<double>(values, values + count) : std::vector<double>(count, 0.0);
}

// Name of a file as the caller gives it; throws Error (argument) without one.
inline const char* file_name(const char* path) {
  require(path != nullptr && *path != '\0', "path is NULL or empty; give a file name");
  return path;
}

// Throws Error (argument) unless a list of `count` entries has one at `index`. The words before and after the count say
// what the list is.
template <class Before>
void require_index(std::int64_t index, std::size_t count, const Before& before, const char* after) {
  require(index >= 0 && index < static_cast<std::int64_t>(count), "index is ", index, before, count, after);
}

// Entry of a list at a caller's index, with the words of require_index().
template <class List, class Before>
const auto& entry_at(const List& list, std::int64_t index, const Before& before, const char* after) {
  require_index(index, list.size(), before, after);
  return list[static_cast<std::size_t>(index)];
}
template <class List, class Before>
void entry_at(const List&& list, std::int64_t index, const Before& before, const char* after) = delete;  // would dangle

// Ends of a crack, which are 0 and 1 inside, as the caller's bempd_crack_end; 0 for a tip of no crack.
inline std::int32_t end_of(int end) { return end == 0 ? BEMPD_CRACK_START : BEMPD_CRACK_END; }
inline std::int32_t end_of(const crack::TipId& tip) { return tip.crack == 0 ? 0 : end_of(tip.end); }
// End that the caller names; throws Error (argument) if there is no such end.
inline int end_from(std::int32_t end) {
  require(end == BEMPD_CRACK_START || end == BEMPD_CRACK_END, "end is ", end,
          "; it must be BEMPD_CRACK_START (1) or BEMPD_CRACK_END (2)");
  return end == BEMPD_CRACK_START ? 0 : 1;
}

// Size of a caller's struct as its first member says; throws Error (argument) if `given` is null or the size is below
// `least`.
template <class T>
std::size_t struct_bytes(const T* given, const char* name, std::size_t least = sizeof(std::int64_t)) {
  require(given != nullptr, name, " is NULL; give a struct filled by its _init function");
  require(given->struct_size >= static_cast<std::int64_t>(least) && given->struct_size < (1 << 20), name,
          "->struct_size is ", given->struct_size, "; give the struct's size to its _init function first");
  return static_cast<std::size_t>(given->struct_size);
}

// Copies values into a caller's struct, as many members as its size allows; the first member of the struct, its size,
// stays.
template <class T>
void write_struct(T* target, const T& values, const char* name) {
  const std::size_t size = std::min(struct_bytes(target, name), sizeof(T));
  const std::int64_t keep = target->struct_size;
  std::memcpy(target, &values, size);
  target->struct_size = keep;
}

// Copies bytes to a caller's buffer; `needed` receives their number. With `capacity` 0 the buffer may be null and only
// the number is returned; throws Error (argument) if the capacity is too small.
void write_bytes(std::span<const std::uint8_t> bytes, void* buffer, std::int64_t capacity, std::int64_t* needed);

// Copies text with its final zero to a caller's buffer, as write_bytes() does.
void write_text(const std::string& words, char* buffer, std::int64_t capacity, std::int64_t* needed);

// Fills a caller's struct with defaults. `size` is the size with which the caller was compiled.
template <class T>
bempd_status init_struct(const char* function, const char* name, T* target, std::int64_t size, const T& defaults) {
  return without_model(function, [&] {
    out(target, name).struct_size = size;
    struct_bytes(target, name);
    write_struct(target, defaults, name);
  });
}

}  // namespace bempd::capi
