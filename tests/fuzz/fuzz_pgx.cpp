// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes PGX: the input is the file of each of three components.
#include "tests/fuzz/rows.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  for (const char* component : {"0", "1", "2"})
    std::filesystem::create_directory(folder() / component);
  (void)fileOf("1/p.pgx", input);
  (void)fileOf("2/p.pgx", input);
  mayRefuse([&] {
    const auto pgx = openPgx(fileOf("0/p.pgx", input));
    require(pgx->facts().channels == 3);
    readAll(*pgx);
  });
}
