// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes session documents: what is read and written again reads the same.
#include "io/documents/session_file.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  const std::filesystem::path file = fileOf("s.json", input);
  mayRefuse([&] { (void)loadStates(file); });
  mayRefuse([&] {
    const Session session = loadSession(file);
    require(loadSession(fileOf("t.json", textOf(session))) == session);
  });
}
