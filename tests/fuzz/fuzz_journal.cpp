// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes a report's journal: what is added to one that was found is there when it is read again.
#include "runs/journal.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  constexpr std::size_t row = 3;
  (void)fileOf("report.journal", input);
  mayRefuse([&] {
    const std::size_t entries = [&] {
      Journal journal(folder(), {"key", 2, 3});
      journal.add(row, {}, "");
      return journal.entries().size() + (journal.entries().contains(row) ? 0 : 1);
    }();
    const Journal again(folder(), {"key", 2, 3});
    require(again.entries().size() == entries && again.entries().contains(row));
  });
}
