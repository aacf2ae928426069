// SPDX-License-Identifier: BSD-3-Clause
#include "io/store/store_writer.h"

#include <algorithm>
#include <cstring>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/optics/session.h"
#include "io/documents/light_field_params.h"
#include "io/files/system_limits.h"
#include "io/json/json_parameters.h"
#include "io/store/band_packer.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Computes Fowler–Noll–Vo 1a, 64 bits.
std::uint64_t hashOf(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

/// Returns a key that depends on the file, its time of writing and the way it is read.
std::string sourceOf(LightFieldParams params, const LightFieldFile& file) {
  Json object = Json::object();
  JsonWriter writer(object);
  describe(writer, params);
  if (params.content.isGiven()) {
    describe(writer, params.content);
    describe(writer, params.live);
  }
  std::string text = object.dump(-1, ' ', true, Json::error_handler_t::replace);
  std::error_code none;
  for (const fs::path& path : file.files())
    text += "\n" + fs::absolute(path, none).string() + " " + fileIdentity(path);
  std::array<char, 20> hash{};
  std::snprintf(hash.data(), hash.size(), "%016llx", static_cast<unsigned long long>(hashOf(text)));
  return (params.isLive() ? params.source : fs::path(params.file).filename().string()) + " " +
         hash.data();
}

/// Estimates the store's size: that of its source, unless the source is lossy or has no pixels.
std::uint64_t expectedBytes(const StoreHeader& header, const LightFieldFile& file, bool isLive) {
  std::error_code none;
  std::uint64_t ofSource = 0;
  const std::vector<fs::path> files = file.files();
  for (const fs::path& path : files) ofSource += fs::file_size(path, none);
  constexpr double shareOfPixels = 0.8;  // of a path-traced scene's JPEGs: 0.79
  const std::string ending = files.empty() ? "" : lowerCase(files[0].extension().string());
  const bool isLossy = ending == ".jpg" || ending == ".jpeg";
  return isLossy || isLive
             ? std::uint64_t(shareOfPixels * double(header.size.width()) *
                             double(header.size.height()) * double(pixelBytes(header.type)))
             : ofSource;
}

/// Checks the space on disk; the bytes of an unfinished store count as available.
void checkRoom(const fs::path& output, std::uint64_t storeBytes) {
  fs::path part = output;
  part += ".part";
  std::error_code none;
  checkRoomOnDisk(output, storeBytes,
                  fs::is_regular_file(part, none) ? fs::file_size(part, none) : 0);
}

/// Picks the overview's texels from the streamed rows.
class OverviewTaker {
 public:
  explicit OverviewTaker(const StoreHeader& header)
      : m_header(header),
        m_texel(pixelBytes(header.type)),
        m_rowOf(placesOf(header.overview.ny, header.size.ny)),
        m_directionOf(placesOf(header.overview.dv, header.size.dv)),
        m_picture(header.overview.width() * header.overview.height() * m_texel) {}

  void take(int j, int v, const std::byte* row) {
    const LightFieldSize& shown = m_header.overview;
    const int y = m_rowOf[std::size_t(j)];
    const int q = m_directionOf[std::size_t(v)];
    if (y < 0 || q < 0) return;
    std::byte* to = &m_picture[std::size_t(y * shown.dv + q) * shown.width() * m_texel];
    for (int x = 0; x < shown.nx; ++x)
      for (int p = 0; p < shown.du; ++p, to += m_texel) {
        const int i = overviewCell(x, shown.nx, m_header.size.nx);
        const int u = overviewCell(p, shown.du, m_header.size.du);
        std::memcpy(
            to, row + (std::size_t(i) * std::size_t(m_header.size.du) + std::size_t(u)) * m_texel,
            m_texel);
      }
  }

  void write(StoreOutput& output) const {
    const TiffPage page{tilesAlong(m_header.overview.width()),
                        tilesAlong(m_header.overview.height()), m_header.type};
    TileCompressor compressor(m_header.type);
    TileBytes bytes;
    for (std::uint32_t y = 0; y < page.tilesDown; ++y)
      for (std::uint32_t x = 0; x < page.tilesAcross; ++x)
        compressor.add(tile(std::size_t(x) * tileSide, std::size_t(y) * tileSide), bytes);
    output.add(bytes);
    output.finishPage(page);
  }

 private:
  /// Returns the index in the overview of each cell; -1 if it is omitted.
  static std::vector<int> placesOf(int shown, int cells) {
    std::vector<int> places(std::size_t(cells), -1);
    for (int k = 0; k < shown; ++k) places[std::size_t(overviewCell(k, shown, cells))] = k;
    return places;
  }

  [[nodiscard]] std::vector<std::byte> tile(std::size_t x, std::size_t y) const {
    const std::size_t width = m_header.overview.width();
    const std::size_t columns = std::min<std::size_t>(tileSide, width - x);
    const std::size_t rows = std::min<std::size_t>(tileSide, m_header.overview.height() - y);
    std::vector<std::byte> result(std::size_t(tileSide) * tileSide * m_texel);
    for (std::size_t k = 0; k < rows; ++k)
      std::memcpy(&result[k * tileSide * m_texel], &m_picture[((y + k) * width + x) * m_texel],
                  columns * m_texel);
    return result;
  }

  StoreHeader m_header;
  std::size_t m_texel;
  std::vector<int> m_rowOf;
  std::vector<int> m_directionOf;
  std::vector<std::byte> m_picture;
};

}  // namespace

PackPlan planPack(const LightFieldParams& params, const LightFieldFile& file,
                  const std::optional<DisplayParams>& display, std::size_t memory) {
  PackPlan plan;
  StoreHeader& header = plan.header;
  header.size = file.size();
  header.type = file.type();
  header.overview = overviewSize(header.size, header.type);
  header.source = sourceOf(params, file);
  if (display) {
    header.display = resolved({*display, params.viewingDistance}, header.size);
    header.display->lensParams.changeFiles(
        [](const std::string& lens) { return fs::absolute(lens).string(); });
  }
  const std::size_t rowBytes = header.size.width() * pixelBytes(header.type);
  const std::size_t hogelRowBytes = rowBytes * std::size_t(header.size.dv);
  const std::size_t fitting = memory / hogelRowBytes;
  if (fitting == 0)
    throw InputError(params.file, "size",
                     "one row of hogels needs " + bytesText(hogelRowBytes) + " of memory, " +
                         bytesText(memory) + " are allowed");
  // One row of hogels more than a block's, so that reading continues while the last band is packed.
  header.block = blockFor(header.size, int(std::min<std::size_t>(fitting - 1, tileSide)));
  const std::size_t band = BandPacker::bandRows(header);
  plan.rows = std::clamp(memory / rowBytes, band, band + std::size_t(header.size.dv));
  plan.memory = plan.rows * rowBytes;
  plan.storeBytes = expectedBytes(header, file, params.isLive());
  return plan;
}

void pack(LightFieldFile& file, const PackPlan& plan, const fs::path& output, int threads,
          const Progress& progress) {
  checkRoom(output, plan.storeBytes);
  StoreOutput store(output, plan.header);
  const int pages = plan.header.blocks().j;
  if (store.pages() <= pages) {
    constexpr double reading = 0.98;  // of the whole; the rest is the last band's packing
    OverviewTaker overview(plan.header);
    const int cores = std::max(1, int(std::thread::hardware_concurrency()));
    BandPacker packer(plan.header, plan.rows, threads > 0 ? std::min(threads, cores) : cores,
                      store);
    const auto take = [&](int j, int v, const auto* rgb) {
      overview.take(j, v, reinterpret_cast<const std::byte*>(rgb));
      packer.take(j, v, rgb);
    };
    file.stream(
        [&](int j, int v, const StoredRows& rgb) {
          std::visit([&](const auto* values) { take(j, v, values); }, rgb);
        },
        part(progress, 0, reading));
    packer.finish(part(progress, reading, 1));
    overview.write(store);
  }
  store.commit();
}

}  // namespace hogelscope
