// SPDX-License-Identifier: BSD-3-Clause
// A part of a long run, for one of several processes: every n-th task, from the k-th on.
#pragma once

#include <cstddef>
#include <string>

namespace hogelscope {

struct Shard {
  std::size_t number = 1;  ///< k, 1 … count
  std::size_t count = 1;   ///< n

  /// Whether the task of this index, 0 …, belongs to it.
  [[nodiscard]] bool has(std::size_t task) const { return task % count == number - 1; }
  /// How many of so many tasks belong to it.
  [[nodiscard]] std::size_t share(std::size_t tasks) const {
    return tasks < number ? 0 : (tasks - number) / count + 1;
  }
  bool operator==(const Shard&) const = default;
};

/// "2/4".
inline std::string textOf(const Shard& shard) {
  return std::to_string(shard.number) + "/" + std::to_string(shard.count);
}

}  // namespace hogelscope
