// SPDX-License-Identifier: BSD-3-Clause
#include "python/array_light_field.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <mutex>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace hogelscope {

namespace {

constexpr const char* arrayName = "array";

/// One type's values of an array, which need not be aligned.
template <class T>
class Values {
 public:
  explicit Values(const ViewArray& array) : m_array(array) {}
  [[nodiscard]] std::array<T, 3> operator()(const TexelIndex& at) const {
    const auto& [v, u, y, x, c] = m_array.strides;
    const std::byte* from = m_array.data + at.v * v + at.u * u + at.j * y + at.i * x;
    std::array<T, 3> rgb;
    for (T& value : rgb) {
      std::memcpy(&value, from, sizeof(T));
      from += c;
    }
    return rgb;
  }

 private:
  const ViewArray& m_array;
};

/// Copies the part of each hogel row in the footprint, rows in parallel.
void copyRows(const ViewArray& array, const Footprint& footprint, LightField& target,
              const Progress& progress) {
  const LightFieldSize size = array.size;
  const Progress heard = forThreads(progress);
  std::atomic<int> rows = 0;
  withStoredType(array.type, [&](auto zero) {
    using T = decltype(zero);
    const Values<T> values(array);
    parallelRows(size.ny, [&](int begin, int end) {
      for (int j = begin; j < end; ++j) {
        const CellRange& ofRow = footprint.v[std::size_t(j)];
        for (int v = ofRow.first; v <= ofRow.last; ++v) {
          throwIfCancelled(heard);
          for (int i = 0; i < size.nx; ++i) {
            const CellRange& ofColumn = footprint.u[std::size_t(i)];
            for (int u = ofColumn.first; u <= ofColumn.last; ++u)
              target.set<T>({i, j, u, v}, values({i, j, u, v}).data());
          }
        }
        reportProgress(heard, double(++rows) / size.ny);
      }
    });
  });
}

/// Returns the footprint of the whole light field.
Footprint wholeOf(const LightFieldSize& size) {
  Footprint all(size.nx, size.ny);
  std::ranges::fill(all.u, CellRange{0, size.du - 1});
  std::ranges::fill(all.v, CellRange{0, size.dv - 1});
  return all;
}

/// A source of slices of an array.
class ArraySource : public LightFieldSource {
 public:
  explicit ArraySource(ViewArray array) : m_array(std::move(array)) {}

  [[nodiscard]] LightFieldSize size() const override { return m_array.size; }
  [[nodiscard]] StoredType type() const override { return m_array.type; }

  [[nodiscard]] std::shared_ptr<const LightField> slice(const ViewReads& reads,
                                                        const Progress& progress) const override {
    const Footprint footprint = reads.footprint();
    requireMemory(footprint, memoryBytes(m_array.type), allowedMemory());
    auto target = std::make_shared<LightField>(m_array.size, m_array.type, sliceLayout(footprint));
    copyRows(m_array, footprint, *target, progress);
    return target;
  }

  /// Returns at most 64 hogels and 16 directions along each axis, about as many as small views have
  /// pixels.
  [[nodiscard]] std::shared_ptr<const LightField> overview() const override {
    std::call_once(m_overviewIsMade, [this] { m_overview = makeOverview(); });
    return m_overview;
  }

 private:
  [[nodiscard]] std::shared_ptr<const LightField> makeOverview() const {
    const auto& [nx, ny, du, dv] = m_array.size;
    constexpr int mostHogels = 64;
    constexpr int mostDirections = 16;
    const LightFieldSize small{std::min(nx, mostHogels), std::min(ny, mostHogels),
                               std::min(du, mostDirections), std::min(dv, mostDirections)};
    // The middle of each of `count` equal parts.
    const auto spread = [](int k, int count, int all) {
      return int((2 * std::int64_t(k) + 1) * all / (2 * std::int64_t(count)));
    };
    auto overview = std::make_shared<LightField>(small, m_array.type);
    withStoredType(m_array.type, [&](auto zero) {
      using T = decltype(zero);
      const Values<T> values(m_array);
      for (int j = 0; j < small.ny; ++j)
        for (int v = 0; v < small.dv; ++v)
          for (int i = 0; i < small.nx; ++i)
            for (int u = 0; u < small.du; ++u)
              overview->set<T>({i, j, u, v}, values({spread(i, small.nx, m_array.size.nx),
                                                     spread(j, small.ny, m_array.size.ny),
                                                     spread(u, small.du, m_array.size.du),
                                                     spread(v, small.dv, m_array.size.dv)})
                                                 .data());
    });
    return overview;
  }

  ViewArray m_array;
  mutable std::once_flag m_overviewIsMade;
  mutable std::shared_ptr<const LightField> m_overview;
};

}  // namespace

void checkFinite(const ViewArray& array, const Progress& progress) {
  if (array.type != StoredType::real) return;
  const auto& [nx, ny, du, dv] = array.size;
  const Values<float> values(array);
  const Progress heard = forThreads(progress);
  parallelRows(dv, [&, nx = nx, ny = ny, du = du](int begin, int end) {
    for (int v = begin; v < end; ++v)
      for (int u = 0; u < du; ++u)
        for (int j = 0; j < ny; ++j) {
          throwIfCancelled(heard);
          for (int i = 0; i < nx; ++i)
            for (const float value : values({i, j, u, v}))
              if (!std::isfinite(value))
                throw InputError(arrayName,
                                 "[" + std::to_string(v) + ", " + std::to_string(u) + ", " +
                                     std::to_string(j) + ", " + std::to_string(i) + "]",
                                 "has a value that is not a number or infinite");
        }
  });
}

LightField ArrayLightField::read(const Progress& progress) {
  LightField target = blankLightField(m_array.size, m_array.type, arrayName);
  copyRows(m_array, wholeOf(m_array.size), target, progress);
  return target;
}

bool ArrayLightField::isCopied() const {
  constexpr std::size_t small = 100000000;
  return fitsInMemory(*this, small);
}

std::shared_ptr<const LightFieldSource> ArrayLightField::source(const SourceUse& use,
                                                                const Progress& progress) {
  if (isCopied() && fitsInMemory(*this, use.memory)) return LightFieldFile::source(use, progress);
  return std::make_shared<const ArraySource>(m_array);
}

void ArrayLightField::stream(const HogelRow& row, const Progress& progress) {
  const auto& [nx, ny, du, dv] = m_array.size;
  withStoredType(m_array.type, [&, nx = nx, ny = ny, du = du, dv = dv](auto zero) {
    using T = decltype(zero);
    const Values<T> values(m_array);
    std::vector<T> rgb;
    for (int j = 0; j < ny; ++j)
      for (int v = 0; v < dv; ++v) {
        reportProgress(progress, double(j) / ny);
        rgb.clear();
        for (int i = 0; i < nx; ++i)
          for (int u = 0; u < du; ++u)
            for (const T value : values({i, j, u, v})) rgb.push_back(value);
        row(j, v, rgb.data());
      }
  });
}

}  // namespace hogelscope
