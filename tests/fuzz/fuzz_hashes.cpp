// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes report.hashes: whatever it holds, a file that it does not know is hashed.
#include "runs/file_hashes.h"

#include "io/files/content_hash.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  const std::vector<std::filesystem::path> files{fileOf("picture.png", "pixels")};
  (void)fileOf("report.hashes", input);
  mayRefuse([&] { require(FileHashes(folder()).of(files, {}) == contentHash(files, {})); });
}
