// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes raw YUV: four bytes say size and kind, the others are the file.
#include "tests/fuzz/rows.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  if (input.size() < 4) return;
  const auto byte = [&](std::size_t k) { return unsigned(static_cast<unsigned char>(input[k])); };
  YuvParams params;
  params.size = {int(byte(0)), int(byte(1))};
  params.bits = (byte(2) & 1U) != 0 ? 10 : 8;
  params.sampling = (byte(2) & 2U) != 0 ? YuvSampling::s444 : YuvSampling::s420;
  params.matrix = (byte(2) & 4U) != 0 ? YuvMatrix::bt601 : YuvMatrix::bt709;
  params.range = (byte(2) & 8U) != 0 ? YuvRange::full : YuvRange::limited;
  mayRefuse([&] { readAll(*openYuv(fileOf("p.yuv", input.substr(4)), params)); });
}
