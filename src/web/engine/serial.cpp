// SPDX-License-Identifier: BSD-3-Clause
// core/base/parallel.h where there are no threads.
#include "core/base/parallel.h"

namespace hogelscope {

void serialRows(int count, const std::function<void(int begin, int end)>& rows) {
  rows(0, count);
}

void parallelRows(int count, const std::function<void(int begin, int end)>& rows) {
  rows(0, count);
}

int threadCount() {
  return 1;
}

void setThreads(int /*count*/) {}

void sideBySide(std::size_t count, int /*workers*/,
                const std::function<void(std::size_t k, std::size_t worker)>& work) {
  for (std::size_t k = 0; k < count; ++k) work(k, 0);
}

}  // namespace hogelscope
