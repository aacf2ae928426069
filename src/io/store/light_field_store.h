// SPDX-License-Identifier: BSD-3-Clause
// A store (layout "pack"): a light field on disk of which only the blocks needed for a view are
// read. Its format is described in store_header.h.
#pragma once

#include <functional>
#include <mutex>

#include "core/light_field/light_field_source.h"
#include "io/images/big_tiff.h"
#include "io/layouts/light_field_file.h"
#include "io/store/store_header.h"

namespace hogelscope {

class BlockCache;

class LightFieldStore : public LightFieldFile, public LightFieldSource {
 public:
  /// Opens a store and reads the pages' directories, not their indices. `cacheBytes` is the size of
  /// the cache of decoded blocks; 0 `threads` means all. Throws InputError if it is not a store,
  /// incomplete or damaged.
  explicit LightFieldStore(const std::filesystem::path& file, bool incoming = false,
                           std::size_t cacheBytes = 0, int threads = 0);
  ~LightFieldStore() override;

  /// Whether the file is a store, complete or not, by its first page.
  static bool isStore(const std::filesystem::path& file);

  [[nodiscard]] const StoreHeader& header() const { return m_header; }
  [[nodiscard]] LightFieldSize size() const override { return m_header.size; }
  [[nodiscard]] StoredType type() const override { return m_header.type; }
  [[nodiscard]] std::vector<std::filesystem::path> files() const override {
    return {m_file.path()};
  }

  [[nodiscard]] std::string contentHash() const override { return m_contentHash; }

  /// Reads the whole light field into memory.
  [[nodiscard]] LightField read(const Progress& progress) override;
  /// Returns a store that fetches blocks if the whole exceeds `use.memory` bytes, else the whole.
  [[nodiscard]] std::shared_ptr<const LightFieldSource> source(const SourceUse& use,
                                                               const Progress& progress) override;
  /// Streams with a row of blocks of hogels in memory, or a part of it if that exceeds half of
  /// allowedMemory(). isStream() is false, because views can read the blocks that they need.
  void stream(const HogelRow& row, const Progress& progress) override;

  /// Returns a slice and keeps decoded blocks in the cache. The previous view's slice is returned
  /// again if it covers the footprint.
  [[nodiscard]] std::shared_ptr<const LightField> slice(const ViewReads& reads,
                                                        const Progress& progress) const override;

  /// Returns regularly spaced hogels and directions, read on first use. Throws InputError.
  [[nodiscard]] std::shared_ptr<const LightField> overview() const override;

  /// Receives block k of `wanted`: 64×64 texels of three values of type(), see store_header.h.
  /// Called on several threads, once for each block. Fastest if wanted blocks follow each other
  /// along u, then i, then v, then j. Reading throws InputError that names the damaged block, and
  /// Cancelled.
  using BlockUse = std::function<void(std::size_t k, std::span<const std::byte> texels)>;
  void blocks(std::span<const BlockIndex> wanted, const BlockUse& use,
              const Progress& progress) const;

 private:
  class Reader;
  [[nodiscard]] LightField readOverview() const;
  void openPages();
  void decode(Reader& reader, const BlockIndex& at, std::span<std::byte> texels) const;
  void checkPage(int number, const TiffPage& page) const;
  void copyBlock(const BlockIndex& block, std::span<const std::byte> texels,
                 LightField& target) const;
  template <class T>
  void readBand(int begin, int end, std::vector<T>& band, const Progress& progress) const;
  [[nodiscard]] std::shared_ptr<const LightField> lastSlice() const;
  [[nodiscard]] Footprint stored(const Footprint& footprint) const;
  void placeSlice(const BlockIndex& block, std::span<const std::byte> texels,
                  const Footprint& footprint, LightField& target) const;
  void placeOverview(int x0, int y0, std::span<const std::byte> texels, LightField& target) const;

  RandomAccessFile m_file;
  bool m_incoming;
  int m_threads;
  StoreHeader m_header;
  std::string m_contentHash;
  std::vector<TiffPage> m_pages;  ///< the last one is the overview
  std::unique_ptr<BlockCache> m_cache;
  mutable std::mutex m_sliceMutex;
  mutable std::shared_ptr<const LightField> m_lastSlice;
  mutable std::once_flag m_overviewIsRead;
  mutable std::shared_ptr<const LightField> m_overview;
};

}  // namespace hogelscope
