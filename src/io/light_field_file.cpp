// SPDX-License-Identifier: BSD-3-Clause
// Each layout in turn: where its files have direction (u, v) of hogel (i, j).
#include "io/light_field_file.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <regex>

#include "core/error.h"
#include "io/image_file.h"
#include "io/light_field_store.h"
#include "io/view_files.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

std::string pixels(std::size_t width, std::size_t height) {
  return std::to_string(width) + "×" + std::to_string(height);
}

/// Reads a picture into the light field; `target(x, y)` says which texel pixel (x, y) is, or none.
/// `incoming` flips directions that were recorded looking into the scene.
template <class Target>
void place(ImageFile& image, StoredType type, LightField& lightField, bool incoming, Target target,
           const Progress& progress) {
  const auto [nx, ny, du, dv] = lightField.size();
  const auto putRow = [&, du = du, dv = dv](int y, const auto* rgb) {
    for (int x = 0; x < int(image.width()); ++x, rgb += 3) {
      std::optional<TexelIndex> at = target(x, y);
      if (!at) continue;
      if (incoming) at = {at->i, at->j, du - 1 - at->u, dv - 1 - at->v};
      lightField.set(*at, rgb);
    }
  };
  image.read(
      type,
      [&](std::size_t first, std::size_t rows, const StoredRows& values) {
        std::visit(
            [&](const auto* rgb) {
              for (std::size_t row = 0; row < rows; ++row)
                putRow(int(first + row), rgb + 3 * row * image.width());
            },
            values);
      },
      progress);
}

/// Directions that were recorded looking into the scene, as they leave: each hogel's row backwards.
template <class T>
void turnHogels(const LightFieldSize& size, const T* rgb, std::vector<T>& turned) {
  turned.resize(3 * size.width());
  for (int i = 0; i < size.nx; ++i)
    for (int u = 0; u < size.du; ++u)
      std::copy_n(rgb + std::ptrdiff_t(3) * (i * size.du + u), 3,
                  &turned[std::size_t(3) * std::size_t((i + 1) * size.du - 1 - u)]);
}

class HogelImage : public LightFieldFile {
 public:
  HogelImage(const LightFieldParams& params, const DisplayParams& display)
      : m_params(params),
        m_image(params.file),
        m_size{display.hogels[0], display.hogels[1], display.directions[0], display.directions[1]} {
    if (m_size.nx < 1 || m_size.ny < 1 || m_size.du < 1 || m_size.dv < 1)
      throw InputError(params.file, "size",
                       "is " + pixels(m_image.width(), m_image.height()) +
                           " px; how many of them are hogels and directions it does not say: give "
                           "display.hogels and display.directions");
    if (m_image.width() != m_size.width() || m_image.height() != m_size.height())
      throw InputError(params.file, "size",
                       "is " + pixels(m_image.width(), m_image.height()) + " px, but " +
                           pixels(std::size_t(m_size.nx), std::size_t(m_size.ny)) + " hogels of " +
                           pixels(std::size_t(m_size.du), std::size_t(m_size.dv)) +
                           " directions need " + pixels(m_size.width(), m_size.height()));
  }

  [[nodiscard]] StoredType type() const override { return m_image.type(); }
  [[nodiscard]] LightFieldSize size() const override { return m_size; }
  [[nodiscard]] std::vector<fs::path> files() const override { return {m_image.file()}; }

  [[nodiscard]] LightField read(const Progress& progress) override {
    LightField lightField =
        blankLightField(m_size, m_image.type(), m_params.file, ": --pack it, and use the store");
    const auto target = [this](int x, int y) {
      return std::optional(TexelIndex{x / m_size.du, y / m_size.dv, x % m_size.du, y % m_size.dv});
    };
    place(m_image, m_image.type(), lightField, m_params.incoming, target, progress);
    return lightField;
  }

  [[nodiscard]] bool isStream() const override { return true; }
  void stream(const HogelRow& row, const Progress& progress) override {
    m_image.read(
        m_image.type(),
        [&](std::size_t first, std::size_t rows, const StoredRows& values) {
          std::visit(
              [&](const auto* rgb) {
                for (std::size_t k = 0; k < rows; ++k)
                  hand(int(first + k), rgb + 3 * k * m_size.width(), row);
              },
              values);
        },
        progress);
  }

 private:
  template <class T>
  void hand(int y, const T* rgb, const HogelRow& row) const {
    if (!m_params.incoming) return row(y / m_size.dv, y % m_size.dv, rgb);
    std::vector<T> turned;
    turnHogels(m_size, rgb, turned);
    row(y / m_size.dv, m_size.dv - 1 - y % m_size.dv, turned.data());
  }

  LightFieldParams m_params;
  ImageFile m_image;
  LightFieldSize m_size;
};

class ViewsFolder : public LightFieldFile {
 public:
  ViewsFolder(const LightFieldParams& params, const DisplayParams& display)
      : m_params(params), m_views(findViews(params, display.directions)) {
    const ImageFile first(m_views.files.front());
    m_type = first.type();
    m_size = {int(first.width()), int(first.height()), m_views.columns, m_views.rows};
  }

  [[nodiscard]] StoredType type() const override { return m_type; }
  [[nodiscard]] LightFieldSize size() const override { return m_size; }
  [[nodiscard]] std::vector<fs::path> files() const override { return m_views.files; }

  [[nodiscard]] LightField read(const Progress& progress) override {
    LightField lightField = blankLightField(m_size, m_type, m_params.file);
    const std::size_t count = m_views.files.size();
    for (std::size_t k = 0; k < count; ++k) {
      advance(progress, double(k) / double(count));
      readView(int(k) / m_views.columns, int(k) % m_views.columns, lightField);
    }
    return lightField;
  }

 private:
  void readView(int row, int column, LightField& lightField) const {
    const fs::path& file =
        m_views.files[std::size_t(row) * std::size_t(m_views.columns) + std::size_t(column)];
    ImageFile image(file);
    if (image.width() != std::size_t(m_size.nx) || image.height() != std::size_t(m_size.ny))
      throw InputError(file.string(), "size",
                       "is " + pixels(image.width(), image.height()) +
                           " px, but the first view is " +
                           pixels(std::size_t(m_size.nx), std::size_t(m_size.ny)));
    const int u = m_params.columns == ColumnOrder::leftRight ? column : m_size.du - 1 - column;
    const int v = m_params.rows == RowOrder::topDown ? row : m_size.dv - 1 - row;
    const int right = int(std::floor(m_params.shear[0] * (u - (m_size.du - 1) / 2.0) + 0.5));
    const int down = int(std::floor(m_params.shear[1] * (v - (m_size.dv - 1) / 2.0) + 0.5));
    const auto target = [&](int x, int y) -> std::optional<TexelIndex> {
      const TexelIndex at{x + right, y + down, u, v};
      if (at.i < 0 || at.i >= m_size.nx || at.j < 0 || at.j >= m_size.ny) return std::nullopt;
      return at;
    };
    place(image, m_type, lightField, m_params.incoming, target, {});
  }

  LightFieldParams m_params;
  ViewFiles m_views;
  StoredType m_type{};
  LightFieldSize m_size;
};

/// One row of views from the left; the picture has them row by row from the bottom left.
class QuiltImage : public LightFieldFile {
 public:
  explicit QuiltImage(const LightFieldParams& params) : m_params(params), m_image(params.file) {
    const auto [columns, rows] = quiltTilesFromName(params.file);
    m_columns = params.quiltColumns > 0 ? params.quiltColumns : columns;
    m_rows = params.quiltRows > 0 ? params.quiltRows : rows;
    if (m_columns < 1 || m_rows < 1)
      throw InputError(
          params.file, "lightField.columns",
          "and rows are not given, and the file's name has no _qs{columns}x{rows}a{aspect}");
    const auto tilesX = std::size_t(m_columns);
    const auto tilesY = std::size_t(m_rows);
    if (m_image.width() % tilesX != 0 || m_image.height() % tilesY != 0)
      throw InputError(params.file, "size",
                       "is " + pixels(m_image.width(), m_image.height()) +
                           " px, which does not divide into " + pixels(tilesX, tilesY) + " views");
    m_size = {int(m_image.width() / tilesX), int(m_image.height() / tilesY), m_columns * m_rows, 1};
  }

  [[nodiscard]] StoredType type() const override { return m_image.type(); }
  [[nodiscard]] LightFieldSize size() const override { return m_size; }
  [[nodiscard]] std::vector<fs::path> files() const override { return {m_image.file()}; }

  [[nodiscard]] LightField read(const Progress& progress) override {
    LightField lightField = blankLightField(m_size, m_image.type(), m_params.file);
    const auto target = [this](int x, int y) {
      const int rowFromBottom = m_rows - 1 - y / m_size.ny;
      return std::optional(
          TexelIndex{x % m_size.nx, y % m_size.ny, rowFromBottom * m_columns + x / m_size.nx, 0});
    };
    place(m_image, m_image.type(), lightField, m_params.incoming, target, progress);
    return lightField;
  }

 private:
  LightFieldParams m_params;
  ImageFile m_image;
  int m_columns = 0;
  int m_rows = 0;
  LightFieldSize m_size;
};

std::unique_ptr<LightFieldFile> openStore(const LightFieldParams& params,
                                          const DisplayParams& display) {
  auto store = std::make_unique<LightFieldStore>(params.file, params.incoming);
  (void)resolved(display, store->size());  // both say the size: they must agree
  return store;
}

}  // namespace

LightField blankLightField(const LightFieldSize& size, StoredType type, const fs::path& file,
                           const std::string& hint) {
  try {
    checkFits(LightField::bytes(size, type), file);
    return {size, type};
  } catch (const std::length_error&) {
    throw InputError(file.string(), "size",
                     "is more than 2^32 directional pixels in memory" + hint);
  }
}

void LightFieldFile::stream(const HogelRow& row, const Progress& progress) {
  const LightField whole = read(part(progress, 0, 0.5));
  const auto [nx, ny, du, dv] = size();
  std::visit(
      [&, nx = nx, ny = ny, du = du, dv = dv](const auto& texels) {
        std::vector<std::decay_t<decltype(texels[0].r)>> rgb(3 * size().width());
        for (int j = 0; j < ny; ++j) {
          advance(progress, 0.5 + 0.5 * j / ny);
          for (int v = 0; v < dv; ++v) {
            for (int x = 0; x < nx * du; ++x) {
              const auto& [r, g, b, unused] =
                  texels[whole.layout().address({x / du, j, x % du, v})];
              const std::array values{r, g, b};
              std::copy(values.begin(), values.end(), &rgb[std::size_t(3) * std::size_t(x)]);
            }
            row(j, v, rgb.data());
          }
        }
      },
      whole.texels());
}

std::array<int, 2> quiltTilesFromName(const std::string& file) {
  static const std::regex suffix(R"(.*_qs(\d{1,4})x(\d{1,4})a[0-9.]+)");
  std::smatch groups;
  const std::string stem = fs::path(file).stem().string();
  if (!std::regex_match(stem, groups, suffix)) return {0, 0};
  return {std::stoi(groups[1]), std::stoi(groups[2])};
}

LightFieldParams lightFieldOf(const std::string& file) {
  LightFieldParams params;
  params.file = file;
  if (fs::is_directory(file))
    params.layout = Layout::views;
  else if (LightFieldStore::isStore(file))
    params.layout = Layout::pack;
  else if (quiltTilesFromName(file)[0] > 0)
    params.layout = Layout::quilt;
  return params;
}

LightFieldParams withFile(const LightFieldParams& params, const std::string& file) {
  const bool isAnotherKind = fs::is_directory(file) != (params.layout == Layout::views) ||
                             LightFieldStore::isStore(file) != (params.layout == Layout::pack);
  if (isAnotherKind) return lightFieldOf(file);
  LightFieldParams result = params;
  result.file = file;
  return result;
}

std::unique_ptr<LightFieldFile> openLightField(const LightFieldParams& params,
                                               const DisplayParams& display) {
  switch (params.layout) {
    case Layout::views:
      return std::make_unique<ViewsFolder>(params, display);
    case Layout::quilt:
      return std::make_unique<QuiltImage>(params);
    case Layout::pack:
      return openStore(params, display);
    default:
      return std::make_unique<HogelImage>(params, display);
  }
}

bool readTheSame(const Session& a, const Session& b) {
  return a.lightField == b.lightField && a.display.hogels == b.display.hogels &&
         a.display.directions == b.display.directions;
}

namespace {

std::atomic<std::size_t> theAllowedMemory = 0;

}  // namespace

std::size_t allowedMemory() noexcept {
  const std::size_t allowed = theAllowedMemory;
  return allowed > 0 ? allowed : machineMemory() / 4;
}

void allowMemory(std::size_t bytes) noexcept {
  theAllowedMemory = bytes;
}

Scene unloadedScene(const Session& session, const LightFieldFile& file) {
  return {
      std::make_shared<const LightField>(file.size(), file.type(), std::shared_ptr<TexelStore>()),
      resolved(session.display, file.size()), session.sampling};
}

bool fitsInMemory(const LightFieldFile& file, std::size_t memory) {
  try {
    return LightField::bytes(file.size(), file.type()) <= memory;
  } catch (const std::length_error&) {
    return false;
  }
}

Scene loadScene(const Session& session, const Progress& progress, std::size_t memory,
                const StoreUse& use) {
  const auto file = openLightField(session.lightField, session.display);
  Scene scene = unloadedScene(session, *file);
  if (session.lightField.layout == Layout::pack && !fitsInMemory(*file, memory))
    scene.lightField = std::make_shared<const LightField>(
        file->size(), file->type(),
        std::make_shared<LightFieldStore>(session.lightField.file, session.lightField.incoming,
                                          std::min(memory, use.cache), use.threads));
  else
    scene.lightField = std::make_shared<const LightField>(file->read(progress));
  return scene;
}

}  // namespace hogelscope
