// SPDX-License-Identifier: BSD-3-Clause
// How a store's blocks had best be shaped and compressed: the table in docs/measurements.md.
//   hogelscope-store-benchmark BAND.png: the first hogel rows of the paper's light field (512×16
//   hogels of 600×600 directions), written by hogelscope --generate.
#include <zstd.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <numbers>
#include <set>

#include "core/base/error.h"
#include "io/scene/view_source.h"
#include "io/store/light_field_store.h"

namespace {

using namespace hogelscope;
using Bytes = std::vector<std::uint8_t>;

constexpr LightFieldSize paper{512, 512, 600, 600};
constexpr LightFieldSize band{512, 16, 600, 600};
constexpr int hogels = 64;  ///< columns of the band that are kept, from its middle
constexpr std::size_t stride = std::size_t{3} * hogels * std::size_t(band.du);

/// Of this thread: the machine has other work too.
double seconds() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

Bytes middleOf(const char* file) {
  LightFieldParams params;
  params.file = file;
  PanelParams display;
  display.hogels = {band.nx, band.ny};
  display.directions = {band.du, band.dv};
  Bytes kept(stride * band.height());
  constexpr std::size_t first = std::size_t{3} * (band.nx - hogels) / 2 * std::size_t(band.du);
  openLightField(params, display)
      ->stream(
          [&](int j, int v, const StoredRows& rgb) {
            std::memcpy(&kept[std::size_t(j * band.dv + v) * stride],
                        std::get<const std::uint8_t*>(rgb) + first, stride);
          },
          {});
  return kept;
}

void gather(const Bytes& rows, const BlockIndex& block, const BlockIndex& at, Bytes& tile) {
  std::fill(tile.begin(), tile.end(), 0);
  const int columns = std::min(block.u, band.du - at.u * block.u);
  auto* to = tile.data();
  for (int j = 0; j < block.j; ++j)
    for (int v = 0; v < block.v; ++v)
      for (int i = 0; i < block.i; ++i, to += 3 * block.u) {
        const int row = at.v * block.v + v;
        if (row >= band.dv) continue;
        const std::size_t y = std::size_t((at.j * block.j + j) * band.dv + row);
        const std::size_t x =
            std::size_t((at.i * block.i + i) * band.du) + std::size_t(at.u * block.u);
        std::memcpy(to, &rows[y * stride + 3 * x], std::size_t(3 * columns));
      }
}

/// TIFF's horizontal predictor: each row's texels as differences from the last one.
void predict(Bytes& tile, std::size_t rowBytes) {
  for (std::size_t row = 0; row < tile.size(); row += rowBytes)
    for (std::size_t k = rowBytes - 1; k >= 3; --k)
      tile[row + k] = std::uint8_t(tile[row + k] - tile[row + k - 3]);
}

struct Cost {
  double bytes = 0;      ///< of a tile
  double gathering = 0;  ///< seconds a byte
  double packing = 0;    ///< the same
  double decoding = 0;   ///< seconds a tile
};

Cost measure(const Bytes& rows, const BlockIndex& block, int level, bool isPredicted) {
  constexpr int step = 3;  // rows of tiles
  Bytes tile(std::size_t(3) * std::size_t(block.i * block.j * block.u * block.v));
  Bytes packed(ZSTD_compressBound(tile.size()));
  Bytes back(tile.size());
  ZSTD_CCtx* compressor = ZSTD_createCCtx();
  ZSTD_DCtx* decompressor = ZSTD_createDCtx();
  ZSTD_CCtx_setParameter(compressor, ZSTD_c_compressionLevel, level);
  ZSTD_CCtx_setParameter(compressor, ZSTD_c_checksumFlag, 1);
  Cost cost;
  double tiles = 0;
  for (int j = 0; j < band.ny / block.j; ++j)
    for (int v = 0; v * block.v < band.dv; v += step)
      for (int i = 0; i < hogels / block.i; ++i)
        for (int u = 0; u * block.u < band.du; ++u, ++tiles) {
          const double start = seconds();
          gather(rows, block, {i, j, u, v}, tile);
          const double gathered = seconds();
          if (isPredicted) predict(tile, std::size_t(3 * block.i * block.u));
          const std::size_t bytes =
              ZSTD_compress2(compressor, packed.data(), packed.size(), tile.data(), tile.size());
          const double compressed = seconds();
          ZSTD_decompressDCtx(decompressor, back.data(), back.size(), packed.data(), bytes);
          cost.bytes += double(bytes);
          cost.gathering += gathered - start;
          cost.packing += compressed - gathered;
          cost.decoding += seconds() - compressed;
        }
  ZSTD_freeCCtx(compressor);
  ZSTD_freeDCtx(decompressor);
  const double raw = tiles * double(tile.size());
  return {cost.bytes / tiles, cost.gathering / raw, cost.packing / raw, cost.decoding / tiles};
}

/// Blocks along one axis, for each of hogels and directions, that an eye in front of the panel's
/// middle sees, with leakage to two directions on either side.
std::size_t blocksSeen(double distance, int cells, int directions, int ofHogels, int ofDirections) {
  constexpr double panel = 0.5;  // metres, data/table1.json
  const double halfField = std::tan(30 * std::numbers::pi / 180);
  constexpr int leak = 2;
  constexpr int parts = 16;  // of a hogel's width
  std::set<std::array<int, 2>> blocks;
  for (int k = 0; k < cells * parts; ++k) {
    const double x = ((k + 0.5) / parts / cells - 0.5) * panel;
    const int u = int(std::floor(directions * (0.5 - x / distance / (2 * halfField))));
    if (u < 0 || u >= directions) continue;
    for (int tap = std::max(u - leak, 0); tap <= std::min(u + leak, directions - 1); ++tap)
      blocks.insert({k / parts / ofHogels, tap / ofDirections});
  }
  return blocks.size();
}

void printRow(const Bytes& rows, const BlockIndex& block, int level, bool isPredicted) {
  const Cost cost = measure(rows, block, level, isPredicted);
  const auto across = [](int cells, int of) { return double((cells + of - 1) / of); };
  const double tiles = across(paper.nx, block.i) * across(paper.ny, block.j) *
                       across(paper.du, block.u) * across(paper.dv, block.v);
  constexpr double indexEntry = 12;
  std::printf("| %d×%d × %d×%d | zstd %d%s | %.2f | %.2f + %.2f |", block.i, block.j, block.u,
              block.v, level, isPredicted ? ", predictor" : "",
              tiles * (cost.bytes + indexEntry) / 1e9, cost.gathering * 1e9, cost.packing * 1e9);
  for (const double distance : {0.559, 2.0}) {
    const double seen = double(blocksSeen(distance, paper.nx, paper.du, block.i, block.u)) *
                        double(blocksSeen(distance, paper.ny, paper.dv, block.j, block.v));
    std::printf(" %.0f k, %.1f MB, %.0f ms |", seen / 1e3, seen * cost.bytes / 1e6,
                seen * cost.decoding * 1e3);
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "hogelscope-store-benchmark BAND.png\n");
    return 2;
  }
  try {
    const Bytes rows = middleOf(arguments[1]);
    std::printf(
        "| hogels × directions | compression | GB | CPU s/GB: gather + compress | view at 0.559 m: "
        "blocks, read, decode | at 2 m |\n|---|---|---|---|---|---|\n");
    const std::array<BlockIndex, 8> shapes{{{4, 4, 4, 4},
                                            {4, 4, 8, 8},
                                            {8, 8, 4, 4},
                                            {8, 4, 8, 8},
                                            {8, 8, 8, 8},
                                            {8, 4, 8, 16},
                                            {16, 16, 8, 8},
                                            {8, 8, 16, 16}}};
    for (const BlockIndex& block : shapes) printRow(rows, block, 1, false);
    for (const int level : {-5, 3}) printRow(rows, {8, 8, 8, 8}, level, false);
    printRow(rows, {8, 8, 8, 8}, 1, true);
  } catch (const InputError& error) {
    std::fprintf(stderr, "hogelscope-store-benchmark: %s\n", error.what());
    return 2;
  }
  return 0;
}
