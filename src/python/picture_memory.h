// SPDX-License-Identifier: BSD-3-Clause
// Memory of the pictures that Python gets. That of pictures which Python has given up is used
// again, since new pages of the system cost more than a view does.
#pragma once

#include <pybind11/numpy.h>

#include <cstddef>
#include <utility>

namespace hogelscope {

/// Memory that is not initialised, aligned for any vector unit. For any thread.
class PictureMemory {
 public:
  PictureMemory() = default;
  /// Throws std::bad_alloc.
  explicit PictureMemory(std::size_t bytes);
  ~PictureMemory();
  PictureMemory(PictureMemory&& other) noexcept
      : m_data(std::exchange(other.m_data, nullptr)), m_bytes(other.m_bytes) {}
  PictureMemory& operator=(PictureMemory&& other) noexcept {
    std::swap(m_data, other.m_data);
    std::swap(m_bytes, other.m_bytes);
    return *this;
  }
  PictureMemory(const PictureMemory&) = delete;
  PictureMemory& operator=(const PictureMemory&) = delete;

  template <class Value>
  [[nodiscard]] Value* as() const {
    return static_cast<Value*>(m_data);
  }
  [[nodiscard]] bool isEmpty() const { return m_data == nullptr; }

 private:
  void* m_data = nullptr;
  std::size_t m_bytes = 0;
};

/// Returns a numpy array of the memory, which it owns.
template <class Value>
pybind11::array_t<Value> arrayOf(PictureMemory memory, const std::vector<std::size_t>& shape) {
  auto* const held = new PictureMemory(std::move(memory));  // NOLINT: the capsule owns it
  const pybind11::capsule owner(held,
                                [](void* p) { delete static_cast<PictureMemory*>(p); });  // NOLINT
  return pybind11::array_t<Value>(shape, held->as<Value>(), owner);
}

}  // namespace hogelscope
