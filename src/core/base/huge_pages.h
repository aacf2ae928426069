// SPDX-License-Identifier: BSD-3-Clause
// An allocator for large arrays that requests huge pages. Views read from all parts of a light
// field, and small pages spend most of the time on address translation.
#pragma once

#include <cstddef>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>
#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace hogelscope {

/// Its memory is zero, so that a new array of trivial elements is not written before its values
/// are: the system's pages are zero.
template <class T>
struct HugePageAllocator {
  static_assert(std::is_trivially_copyable_v<T>);
  using value_type = T;
  static constexpr std::size_t pageSize = std::size_t{2} << 20;

  HugePageAllocator() = default;
  template <class U>
  explicit HugePageAllocator(const HugePageAllocator<U>&) {}

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
#if defined(__linux__)
    if (bytes >= pageSize) return static_cast<T*>(zeroPages(bytes));
#endif
    void* const memory = ::operator new(bytes, alignment);
    return static_cast<T*>(std::memset(memory, 0, bytes));
  }
  void deallocate(T* memory, std::size_t count) {
#if defined(__linux__)
    if (count * sizeof(T) >= pageSize) {
      ::munmap(memory, count * sizeof(T));
      return;
    }
#endif
    ::operator delete(memory, alignment);
  }

  /// Leaves a new element zero.
  template <class U>
  void construct(U* /*element*/) {}
  template <class U, class... Arguments>
  void construct(U* element, Arguments&&... arguments) {
    ::new (static_cast<void*>(element)) U(std::forward<Arguments>(arguments)...);
  }

  bool operator==(const HugePageAllocator&) const = default;

 private:
  static constexpr std::align_val_t alignment{64};

#if defined(__linux__)
  /// Returns pages that begin at a huge one. Throws std::bad_alloc.
  static void* zeroPages(std::size_t bytes) {
    void* const mapped = ::mmap(nullptr, bytes + pageSize, PROT_READ | PROT_WRITE,
                                MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapped == MAP_FAILED) throw std::bad_alloc();
    auto* const first = static_cast<std::byte*>(mapped);
    const std::size_t before = -reinterpret_cast<std::size_t>(first) % pageSize;  // NOLINT
    constexpr std::size_t smallPage = 4096;
    const std::size_t used = (bytes + smallPage - 1) / smallPage * smallPage;
    if (before > 0) ::munmap(first, before);
    ::munmap(first + before + used, pageSize + bytes - before - used);
    ::madvise(first + before, bytes, MADV_HUGEPAGE);  // a wish
    return first + before;
  }
#endif
};

}  // namespace hogelscope
