#include "allocator.hpp"

#include <link.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstring>

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);
}

namespace {

// Libraries that are spared: their memory is some kilobytes a call, and they end the process where it is missing.
constexpr std::array spared_libraries = {"libgomp", "openblas", "libblas"};

struct Range {
  std::uintptr_t begin, end;
};

std::array<Range, 16> spared_ranges;
std::size_t spared_range_count = 0;

std::atomic<bool> is_counting{false};
std::atomic<std::int64_t> asked_for{0}, failed{0}, spared{0}, held{0};
std::int64_t first_failure = allocation::never;
bool goes_on = false;

int note_library(dl_phdr_info* library, std::size_t, void*) {
  for (const char* name : spared_libraries) {
    if (std::strstr(library->dlpi_name, name) == nullptr) continue;
    for (int k = 0; k < library->dlpi_phnum && spared_range_count < spared_ranges.size(); ++k) {
      const ElfW(Phdr)& part = library->dlpi_phdr[k];
      if (part.p_type != PT_LOAD || (part.p_flags & PF_X) == 0) continue;
      const std::uintptr_t begin = library->dlpi_addr + part.p_vaddr;
      spared_ranges[spared_range_count++] = {begin, begin + part.p_memsz};
    }
  }
  return 0;
}

bool is_spared(const void* caller) {
  const auto address = reinterpret_cast<std::uintptr_t>(caller);
  for (std::size_t k = 0; k < spared_range_count; ++k)
    if (address >= spared_ranges[k].begin && address < spared_ranges[k].end) return true;
  return false;
}

bool fails(const void* caller) {
  if (!is_counting.load(std::memory_order_relaxed)) return false;
  const std::int64_t number = ++asked_for;
  const bool hit = first_failure != allocation::never && (goes_on ? number >= first_failure : number == first_failure);
  if (!hit) return false;
  if (is_spared(caller)) {
    ++spared;
    return false;
  }
  ++failed;
  errno = ENOMEM;
  return true;
}

void* taken(void* block) {
  if (block != nullptr && is_counting.load(std::memory_order_relaxed)) ++held;
  return block;
}

void* align(std::size_t alignment, std::size_t size, const void* caller) {
  return fails(caller) ? nullptr : taken(__libc_memalign(alignment, size));
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) noexcept {
  return fails(__builtin_return_address(0)) ? nullptr : taken(__libc_malloc(size));
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  return fails(__builtin_return_address(0)) ? nullptr : taken(__libc_calloc(count, size));
}

void* realloc(void* block, std::size_t size) noexcept {
  if (fails(__builtin_return_address(0))) return nullptr;
  void* const moved = __libc_realloc(block, size);
  return block == nullptr ? taken(moved) : moved;
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  return align(alignment, size, __builtin_return_address(0));
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return align(alignment, size, __builtin_return_address(0));
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
  void* const found = align(alignment, size, __builtin_return_address(0));
  if (found == nullptr) return ENOMEM;
  *block = found;
  return 0;
}

void free(void* block) noexcept {
  if (block != nullptr && is_counting.load(std::memory_order_relaxed)) --held;
  __libc_free(block);
}

}  // extern "C"

namespace allocation {

void start(Mode mode, std::int64_t first) {
  if (spared_range_count == 0) dl_iterate_phdr(&note_library, nullptr);
  asked_for = failed = spared = 0;
  first_failure = first;
  goes_on = mode == Mode::from_then_on;
  is_counting = true;
}

Count stop() {
  is_counting = false;
  return {asked_for, failed, spared};
}

std::int64_t blocks_held() { return held; }

}  // namespace allocation
