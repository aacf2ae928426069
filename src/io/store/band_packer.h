// SPDX-License-Identifier: BSD-3-Clause
// Creates a store's pages from the rows of a hogel image: while one band of hogels is read, threads
// gather and compress the blocks of the previous one. Memory is a fixed number of rows.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "core/base/progress.h"
#include "io/store/tile_codec.h"

namespace hogelscope {

class BandPacker {
 public:
  /// Keeps at most `rows` rows of the hogel image, at least a band (bandRows()).
  BandPacker(const StoreHeader& header, std::size_t rows, int threads, StoreOutput& output);
  ~BandPacker();
  BandPacker(const BandPacker&) = delete;
  BandPacker& operator=(const BandPacker&) = delete;

  /// Returns the rows of the hogel image in a band.
  static std::size_t bandRows(const StoreHeader& header);

  /// Takes directions v of hogel row j; hogel rows come in order. Waits for memory. Rethrows
  /// exceptions of the threads. Skips pages that the output already has.
  void take(int j, int v, const void* rgb);
  /// Waits until all pages are written. Rethrows likewise, or throws Cancelled.
  void finish(const Progress& progress);

 private:
  struct Band {
    int page = 0;
    std::vector<std::byte*> rows;  ///< v of the first hogel row, of the second, …
    std::size_t taken = 0;
    int strips = 0;  ///< rows of tiles started by a thread
  };
  struct Strip {
    std::shared_ptr<Band> band;
    int v = 0;
  };

  void stop();
  void work();
  std::optional<Strip> nextStrip();
  TileBytes compressed(const Strip& strip, TileCompressor& compressor) const;
  [[nodiscard]] std::vector<std::byte*> rowsOf(const Strip& strip) const;
  void release(const Strip& strip);
  void write(const Strip& strip, const TileBytes& tiles);
  std::byte* freeRow();

  StoreHeader m_header;
  BlockIndex m_blocks;
  StoreOutput& m_output;
  std::size_t m_rowBytes;
  int m_firstPage;  ///< earlier ones are already written
  std::unique_ptr<std::byte[]> m_memory;
  std::vector<std::byte*> m_free;
  std::shared_ptr<Band> m_filling;  ///< used by the reading thread only
  std::deque<std::shared_ptr<Band>> m_full;
  long m_turn = 0;  ///< the row of tiles that is written next
  bool m_isAllTaken = false;
  bool m_isStopped = false;
  std::exception_ptr m_error;
  std::mutex m_mutex;
  std::condition_variable m_changed;
  std::vector<std::jthread> m_threads;
};

}  // namespace hogelscope
