// SPDX-License-Identifier: BSD-3-Clause
// A part of a long run for one of several processes: every n-th task, starting at the k-th.
#pragma once

#include <cstddef>
#include <string>

namespace hogelscope {

struct Shard {
  std::size_t number = 1;  ///< k, 1 … count
  std::size_t count = 1;   ///< n

  /// Whether the task of this index, from 0, belongs to the shard.
  [[nodiscard]] bool has(std::size_t task) const { return task % count == number - 1; }
  /// Returns how many of `tasks` tasks belong to the shard.
  [[nodiscard]] std::size_t share(std::size_t tasks) const {
    return tasks < number ? 0 : (tasks - number) / count + 1;
  }
  bool operator==(const Shard&) const = default;
};

/// Returns a text such as "2/4".
inline std::string textOf(const Shard& shard) {
  return std::to_string(shard.number) + "/" + std::to_string(shard.count);
}

}  // namespace hogelscope
