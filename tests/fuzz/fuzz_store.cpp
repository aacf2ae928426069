// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes stores: opened, read whole, as rows, by a view's footprint and as an overview; and an
// unfinished one that packing goes on with.
#include "io/store/light_field_store.h"
#include "io/store/store_output.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

namespace {

/// The first directions of some hogels, the last of others.
Footprint footprintOf(const LightFieldSize& size) {
  Footprint footprint;
  footprint.u.assign(std::size_t(size.nx), {0, std::min(size.du - 1, 2)});
  footprint.v.assign(std::size_t(size.ny), {std::max(0, size.dv - 2), size.dv - 1});
  return footprint;
}

void readAll(LightFieldStore& store) {
  constexpr std::size_t most = 300000;  // texels; reading more finds nothing new
  const LightFieldSize size = store.size();
  mayRefuse([&] { require(store.overview() != nullptr); });
  mayRefuse([&] {
    const Footprint footprint = footprintOf(size);
    if (footprint.texels() < most) (void)store.slice({[&] { return footprint; }, {}}, {});
  });
  if (double(size.width()) * double(size.height()) > most) return;
  mayRefuse([&] { (void)store.read({}); });
  mayRefuse([&] { store.stream([](int, int, const StoredRows&) {}, {}); });
}

}  // namespace

void fuzz(std::string_view input) {
  const std::filesystem::path file = fileOf("s.tif", input);
  (void)LightFieldStore::isStore(file);
  const bool incoming = input.size() % 2 == 1;
  const std::size_t cacheBytes = input.size() % 3 == 1 ? 1 << 20 : 0;
  mayRefuse([&] {
    LightFieldStore store(file, incoming, cacheBytes, 1);
    readAll(store);
    (void)fileOf("o.tif.part", input);
    const StoreOutput unfinished(folder() / "o.tif", store.header());
  });
}
