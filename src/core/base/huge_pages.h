// SPDX-License-Identifier: BSD-3-Clause
// An allocator for large arrays that requests huge pages. Views read from all parts of a light
// field, and small pages spend most of the time on address translation.
#pragma once

#include <cstddef>
#include <new>
#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace hogelscope {

template <class T>
struct HugePageAllocator {
  using value_type = T;
  static constexpr std::size_t pageSize = std::size_t{2} << 20;

  HugePageAllocator() = default;
  template <class U>
  explicit HugePageAllocator(const HugePageAllocator<U>&) {}

  static std::align_val_t alignment(std::size_t count) {
    return std::align_val_t{count * sizeof(T) >= pageSize ? pageSize : 64};
  }

  T* allocate(std::size_t count) {
    void* memory = ::operator new(count * sizeof(T), alignment(count));
#if defined(__linux__)
    if (count * sizeof(T) >= pageSize) ::madvise(memory, count * sizeof(T), MADV_HUGEPAGE);
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) {
    ::operator delete(memory, alignment(count));
  }

  bool operator==(const HugePageAllocator&) const = default;
};

}  // namespace hogelscope
