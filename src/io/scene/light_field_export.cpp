// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/light_field_export.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/cameras/view_rig.h"
#include "io/files/atomic_file.h"
#include "io/files/files_in_use.h"
#include "io/images/image_writer.h"
#include "io/layouts/layouts.h"
#include "io/scene/twin_content.h"
#include "io/scene/view_source.h"
#include "io/store/store_writer.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// The rows of a picture in memory, rounded to 8 bits.
class RowsInMemory {
 public:
  explicit RowsInMemory(ExportedPicture& picture) : m_picture(picture) {}

  template <class T>
  void write(const T* rgb) {
    for (int k = 0; k < 3 * m_picture.width; ++k)
      m_picture.rgb.push_back(quantised(codeValue(rgb[k])));
  }

 private:
  ExportedPicture& m_picture;
};

/// Writes rows in order that arrive in any order.
template <class T, class Writer>
class RowsInOrder {
 public:
  explicit RowsInOrder(Writer& writer) : m_writer(writer) {}

  void add(std::size_t y, const T* rgb, std::size_t count) {
    if (y != m_next) {
      m_waiting.emplace(y, std::vector<T>(rgb, rgb + count));
      return;
    }
    m_writer.write(rgb);
    ++m_next;
    for (auto it = m_waiting.begin(); it != m_waiting.end() && it->first == m_next; ++m_next) {
      m_writer.write(it->second.data());
      it = m_waiting.erase(it);
    }
  }

 private:
  Writer& m_writer;
  std::size_t m_next = 0;
  std::map<std::size_t, std::vector<T>> m_waiting;
};

/// Copies texels (i, j, u, v) for all i, three values each.
template <class T>
T* copyRow(const LightField& texels, int j, int u, int v, T* rgb) {
  const auto& list = std::get<TexelArray<T>>(texels.texels());
  for (int i = 0; i < texels.size().nx; ++i) {
    const auto& [r, g, b, unused] = list[texels.layout().address({i, j, u, v})];
    *rgb++ = r;
    *rgb++ = g;
    *rgb++ = b;
  }
  return rgb;
}

fs::path viewFile(const LightFieldFile& lightField, const fs::path& folder, int u, int v) {
  const char* const ending = lightField.type() == StoredType::real ? ".exr" : ".png";
  return folder / (viewName(lightField.size(), u, v) + ending);
}

/// Throws InputError for other files: views of an earlier, larger export would be taken for views
/// of this one. Throws too if one of its own is in use.
void checkViews(const LightFieldFile& lightField, const fs::path& folder) {
  std::set<fs::path> own;
  for (int v = 0; v < lightField.size().dv; ++v)
    for (int u = 0; u < lightField.size().du; ++u) own.insert(viewFile(lightField, folder, u, v));
  checkOutputs({own.begin(), own.end()});
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (!own.contains(folder / entry.path().filename()))
      throw InputError(entry.path().string(), "is in the folder of the views",
                       "it would be taken for one: choose an empty folder");
}

template <class T>
void writeView(const LightField& texels, const fs::path& file, int u, int v) {
  const LightFieldSize size = texels.size();
  ImageRowWriter writer(file, std::size_t(size.nx), std::size_t(size.ny), texels.type());
  std::vector<T> row(3 * std::size_t(size.nx));
  for (int j = 0; j < size.ny; ++j) {
    copyRow(texels, j, u, v, row.data());
    writer.write(row.data());
  }
  writer.finish();
}

/// The first view of a row of tiles; the others follow to the right.
struct FirstView {
  int u = 0;
  int v = 0;
};

/// Tiles of views, across and down. Those of a quilt are one row of views, which begins at the
/// bottom left.
struct Tiles {
  int columns = 1;
  int rows = 1;
  bool isQuilt = false;

  /// Returns the first view of a row of tiles, counted from the top.
  [[nodiscard]] FirstView firstOf(int row) const {
    return isQuilt ? FirstView{(rows - 1 - row) * columns, 0} : FirstView{0, row};
  }
};

template <class Writer>
void writeTiles(LightFieldFile& lightField, const Tiles& tiles, Writer& writer,
                const Progress& progress) {
  const LightFieldSize size = lightField.size();
  const int columns = tiles.columns, rows = tiles.rows;
  const auto source = lightField.source({.memory = allowedMemory() / 2}, part(progress, 0, 0.2));
  for (int row = 0; row < rows; ++row) {
    const FirstView first = tiles.firstOf(row);
    const auto at = [&](int k) { return 0.2 + 0.8 * double(row + k) / rows; };
    const auto texels = source->slice(
        readsOfRows(size, {0, size.ny - 1}, {first.u, first.u + columns - 1}, {first.v, first.v}),
        part(progress, at(0), at(1)));
    withStoredType(lightField.type(), [&]<class T>(T) {
      std::vector<T> pixels(3 * std::size_t(columns) * std::size_t(size.nx));
      for (int j = 0; j < size.ny; ++j) {
        T* to = pixels.data();
        for (int k = 0; k < columns; ++k) to = copyRow(*texels, j, first.u + k, first.v, to);
        writer.write(pixels.data());
      }
    });
  }
}

template <class Writer>
void writeHogels(LightFieldFile& lightField, Writer& writer, const Progress& progress) {
  const LightFieldSize size = lightField.size();
  withStoredType(lightField.type(), [&]<class T>(T) {
    RowsInOrder<T, Writer> rows(writer);
    lightField.stream(
        [&](int j, int v, const StoredRows& rgb) {
          rows.add(std::size_t(j) * std::size_t(size.dv) + std::size_t(v), std::get<const T*>(rgb),
                   3 * size.width());
        },
        progress);
  });
}

/// Writes a file of tiles.
void exportTiles(LightFieldFile& lightField, const Tiles& tiles, const fs::path& file,
                 const Progress& progress) {
  const LightFieldSize size = lightField.size();
  ImageRowWriter writer(file, std::size_t(tiles.columns) * std::size_t(size.nx),
                        std::size_t(tiles.rows) * std::size_t(size.ny), lightField.type());
  writeTiles(lightField, tiles, writer, progress);
  writer.finish();
}

}  // namespace

void exportHogels(LightFieldFile& lightField, const fs::path& file, const Progress& progress) {
  const LightFieldSize size = lightField.size();
  ImageRowWriter writer(file, size.width(), size.height(), lightField.type());
  writeHogels(lightField, writer, progress);
  writer.finish();
}

void exportViews(LightFieldFile& lightField, const fs::path& folder, const Progress& progress) {
  makeFolder(folder);
  checkViews(lightField, folder);
  const LightFieldSize size = lightField.size();
  const auto source = lightField.source({.memory = allowedMemory() / 2}, part(progress, 0, 0.2));
  const double bytesOfRow =
      double(size.width()) * size.ny * double(memoryBytes(lightField.type()) + 1);
  const int most = int(std::clamp(double(allowedMemory()) / 2 / bytesOfRow, 1.0, double(size.dv)));
  const auto at = [&](double rows) { return 0.2 + 0.8 * rows / size.dv; };
  for (int v0 = 0; v0 < size.dv; v0 += most) {
    const int v1 = std::min(v0 + most, size.dv);
    const auto texels =
        source->slice(readsOfRows(size, {0, size.ny - 1}, {0, size.du - 1}, {v0, v1 - 1}),
                      part(progress, at(v0), at((v0 + v1) / 2.0)));
    withStoredType(lightField.type(), [&]<class T>(T) {
      for (int v = v0; v < v1; ++v)
        for (int u = 0; u < size.du; ++u) {
          reportProgress(progress, at((v0 + v1) / 2.0 + (v - v0) / 2.0));
          writeView<T>(*texels, viewFile(lightField, folder, u, v), u, v);
        }
    });
  }
}

std::array<int, 2> quiltTilesFor(const LightFieldSize& size, const fs::path& file,
                                 const LightFieldParams& own) {
  if (size.dv != 1)
    throw InputError("display.directions",
                     "has " + std::to_string(size.dv) +
                         " rows: a quilt has one row of directions; export views");
  const auto [columns, rows] = quiltNameOf(file.string()).tiles;
  if (columns > 0) {
    if (columns * rows != size.du)
      throw InputError(file.string(), "the name",
                       "says " + std::to_string(columns * rows) + " views; there are " +
                           std::to_string(size.du) + " directions");
    return {columns, rows};
  }
  if (own.layout == Layout::quilt)
    if (const std::array<int, 2> tiles = quiltTilesOf(own); tiles[0] * tiles[1] == size.du)
      return tiles;
  std::array<int, 2> best{size.du, 1};
  for (int across = 1; across <= size.du; ++across) {
    const auto shape = [&](int c) {
      return std::abs(std::log(double(c) * size.nx / (double(size.du) / c * size.ny)));
    };
    if (size.du % across == 0 && shape(across) < shape(best[0])) best = {across, size.du / across};
  }
  return best;
}

void exportQuilt(LightFieldFile& lightField, const fs::path& file, const Progress& progress,
                 const LightFieldParams& own) {
  const auto [columns, rows] = quiltTilesFor(lightField.size(), file, own);
  exportTiles(lightField, {columns, rows, true}, file, progress);
}

void exportMosaic(LightFieldFile& lightField, const fs::path& file, const Progress& progress) {
  const LightFieldSize size = lightField.size();
  exportTiles(lightField, {size.du, size.dv}, file, progress);
}

ExportedPicture exportedPicture(ExportLayout layout, const Session& session,
                                LightFieldFile& content, const fs::path& output,
                                const Progress& progress) {
  const LightFieldSize size = content.size();
  ExportedPicture picture{int(size.width()), int(size.height()), {}};
  RowsInMemory rows(picture);
  if (layout == ExportLayout::hogels || layout == ExportLayout::woven) {
    writeHogels(content, rows, progress);
    return picture;
  }
  Tiles tiles{size.du, size.dv};
  if (layout == ExportLayout::quilt) {
    const auto [columns, down] = quiltTilesFor(size, output, session.lightField);
    tiles = {columns, down, true};
  }
  picture.width = tiles.columns * size.nx;
  picture.height = tiles.rows * size.ny;
  writeTiles(content, tiles, rows, progress);
  return picture;
}

std::optional<ExportLayout> exportLayoutNamed(const std::string& name) {
  const std::array names{"hogels", "views", "quilt", "mosaic", "woven", "pack"};
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return ExportLayout(found - names.begin());
}

std::vector<ExportLayout> exportLayoutsOf(const DisplayParams& display) {
  if (display.sheet) return {ExportLayout::quilt, ExportLayout::views, ExportLayout::woven};
  return {ExportLayout::hogels, ExportLayout::views, ExportLayout::quilt, ExportLayout::mosaic,
          ExportLayout::pack};
}

std::shared_ptr<LightFieldFile> contentToExport(const Session& session, ExportLayout layout,
                                                bool isForTwin, const Progress& progress) {
  if (session.display.sheet && layout != ExportLayout::woven)
    return openUnwoven(session.lightField, session.display, progress);
  std::shared_ptr<LightFieldFile> file =
      openLightField(session.lightField, session.display, progress);
  if (!isForTwin) return file;
  const PanelParams display = resolved(displayOf(session), file->size());
  auto twin = twinOf(session.twin, display);
  if (!twin) throw InputError("twin", "is missing: content is corrected for a unit");
  return std::make_shared<TwinContent>(file, display, twin);
}

void exportAs(ExportLayout layout, const Session& session, LightFieldFile& content,
              const fs::path& output, const Progress& progress) {
  switch (layout) {
    case ExportLayout::hogels:
    case ExportLayout::woven:
      return exportHogels(content, output, progress);
    case ExportLayout::views:
      return exportViews(content, output, progress);
    case ExportLayout::quilt:
      return exportQuilt(content, output, progress, session.lightField);
    case ExportLayout::mosaic:
      return exportMosaic(content, output, progress);
    case ExportLayout::pack:
      break;
  }
  const std::size_t memory = allowedMemory() / (content.isStream() ? 1 : 2);
  pack(content, planPack(session.lightField, content, session.display, memory), output, 0,
       progress);
}

}  // namespace hogelscope
