// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes PGX: the input is the file of each of three components.
#include "io/images/pgx_rows.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  constexpr std::size_t most = 4096;  // a side; larger ones find nothing new
  for (const char* component : {"0", "1", "2"})
    std::filesystem::create_directory(folder() / component);
  (void)fileOf("1/p.pgx", input);
  (void)fileOf("2/p.pgx", input);
  mayRefuse([&] {
    PgxRows pgx(fileOf("0/p.pgx", input));
    require(pgx.channels() == 3);
    if (pgx.width() > most || pgx.height() > most) return;
    for (std::size_t y = 0; y < pgx.height(); ++y)
      require((pgx.type() == StoredType::uint8 ? pgx.next8().size() : pgx.next16().size()) ==
              3 * pgx.width());
  });
}
