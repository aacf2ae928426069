// SPDX-License-Identifier: BSD-3-Clause
// Reads the views of an HDF5 file: a data set of rows × columns × height × width × 3 values, as in
// the old HCI light field archive ("LF"), or without the last axis.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/progress.h"
#include "io/files/isolated.h"
#include "io/images/image_file.h"

namespace hogelscope {

class Hdf5Views;

/// A single view; reads like ImageFile.
class Hdf5View {
 public:
  [[nodiscard]] std::size_t width() const;
  /// Reads the pixels. `type` must be the file's. Throws InputError (damaged, NaN, infinite),
  /// Cancelled.
  void read(StoredType type, const ImageFile::Band& band, const Progress& progress);

 private:
  friend class Hdf5Views;
  Hdf5View(const Hdf5Views& views, int row, int column)
      : m_views(views), m_row(row), m_column(column) {}

  const Hdf5Views& m_views;
  int m_row;
  int m_column;
};

class Hdf5Views {
 public:
  static bool isHdf5(const std::filesystem::path& file);

  /// Opens data set `name`, or if empty the file's only one that can be views, or "LF". Throws
  /// InputError that names the file and its data sets.
  explicit Hdf5Views(const std::filesystem::path& file, const std::string& name = {});

  /// Returns the size: hogels are a view's pixels, directions the columns and rows of views.
  [[nodiscard]] const LightFieldSize& size() const { return m_size; }
  /// Returns 8 or 16 bits, or floating values with white at 1.
  [[nodiscard]] StoredType type() const { return m_type; }
  [[nodiscard]] Hdf5View view(int row, int column) const { return {*this, row, column}; }

 private:
  friend class Hdf5View;

  /// in its own process, because libhdf5 1.10 crashes on some damaged files
  mutable Isolated m_reader;
  std::filesystem::path m_file;
  LightFieldSize m_size;
  StoredType m_type = StoredType::uint8;
  int m_channels = 3;
};

}  // namespace hogelscope
