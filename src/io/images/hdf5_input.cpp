// SPDX-License-Identifier: BSD-3-Clause
// Reads the views of an HDF5 file through libhdf5.
#include "io/images/image_inputs.h"

#define H5_USE_110_API  // Debian 12 has this version; H5Ovisit2's callback differs in later ones
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/error.h"
#include "io/files/system_limits.h"
#include "io/images/view_axes.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Owns an identifier.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close) : m_id(id), m_close(close) {}
  Handle(Handle&& other) noexcept : m_id(std::exchange(other.m_id, -1)), m_close(other.m_close) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (m_id >= 0) m_close(m_id);
  }
  [[nodiscard]] hid_t id() const { return m_id; }
  [[nodiscard]] bool isOpen() const { return m_id >= 0; }

 private:
  hid_t m_id;
  Close m_close;
};

/// Returns the innermost message of the library's last error.
std::string lastError() {
  std::string text = "HDF5 gives no reason";
  const auto keep = [](unsigned, const H5E_error2_t* error, void* to) -> herr_t {
    if (error->desc != nullptr) *static_cast<std::string*>(to) = error->desc;
    return 1;  // the first one only
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep, &text);
  return text;
}

/// Opens a file without following links into other files, which checks of inputs and hashes do not
/// cover.
Handle openFile(const fs::path& file) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // otherwise errors are printed
  H5Lunregister(H5L_TYPE_EXTERNAL);
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_file_locking(access.id(), false, true);  // archives are often read-only
  Handle opened(H5Fopen(file.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose);
  if (!opened.isOpen()) throw InputError("cannot be read as HDF5", lastError());
  return opened;
}

std::vector<std::string> dataSetsOf(const Handle& file) {
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5O_info_t* info, void* to) -> herr_t {
    constexpr std::size_t most = 1000;
    auto& list = *static_cast<std::vector<std::string>*>(to);
    if (info->type == H5O_TYPE_DATASET) list.emplace_back(name);
    return list.size() < most ? 0 : 1;
  };
  H5Ovisit2(file.id(), H5_INDEX_NAME, H5_ITER_INC, add, &names, H5O_INFO_BASIC);
  return names;
}

struct Shape {
  std::vector<hsize_t> lengths;
  std::optional<StoredType> type;  ///< none if the values are not pixels
  bool isMatlab = false;           ///< MATLAB's axes are stored in reversed order

  /// Returns which axes are the views'; none if these are no values of views, or it is unclear.
  [[nodiscard]] std::optional<ViewAxes> axes() const {
    constexpr hsize_t longest = 1U << 20U;
    if (!type || !std::ranges::all_of(lengths, [](hsize_t n) { return n >= 1 && n <= longest; }))
      return std::nullopt;
    return viewAxesOf({lengths.begin(), lengths.end()}, isMatlab);
  }
  [[nodiscard]] std::string text() const {
    std::string all;
    for (const hsize_t length : lengths) all += (all.empty() ? "" : "×") + std::to_string(length);
    return all.empty() ? "one value" : all;
  }
};

std::optional<StoredType> typeOf(const Handle& dataSet) {
  const Handle type(H5Dget_type(dataSet.id()), H5Tclose);
  if (!type.isOpen()) return std::nullopt;
  if (H5Tget_class(type.id()) == H5T_FLOAT) return StoredType::real;
  if (H5Tget_class(type.id()) != H5T_INTEGER || H5Tget_sign(type.id()) != H5T_SGN_NONE)
    return std::nullopt;
  if (H5Tget_size(type.id()) == 1) return StoredType::uint8;
  if (H5Tget_size(type.id()) == 2) return StoredType::uint16;
  return std::nullopt;
}

Shape shapeOf(const Handle& dataSet) {
  const Handle space(H5Dget_space(dataSet.id()), H5Sclose);
  const int rank = space.isOpen() ? H5Sget_simple_extent_ndims(space.id()) : -1;
  Shape shape{std::vector<hsize_t>(std::size_t(std::max(rank, 0))), typeOf(dataSet),
              H5Aexists(dataSet.id(), "MATLAB_class") > 0};
  if (rank > 0) H5Sget_simple_extent_dims(space.id(), shape.lengths.data(), nullptr);
  return shape;
}

hid_t nativeType(StoredType type) {
  if (type == StoredType::uint8) return H5T_NATIVE_UINT8;
  return type == StoredType::uint16 ? H5T_NATIVE_UINT16 : H5T_NATIVE_FLOAT;
}

struct DataSet {
  Handle file;
  std::string name;
  Handle handle;
  Shape shape;
  ViewAxes axes;
};

template <class T>
constexpr StoredType typeFor() {
  if (std::is_same_v<T, std::uint8_t>) return StoredType::uint8;
  return std::is_same_v<T, std::uint16_t> ? StoredType::uint16 : StoredType::real;
}

/// Throws if even a single colour could not be stored in so few bytes.
void checkStored(const Handle& dataSet, const Shape& shape, const std::string& name) {
  constexpr double mostValuesPerByte = 1 << 17;
  double values = 1;
  for (const hsize_t length : shape.lengths) values *= double(length);
  if (values > mostValuesPerByte * double(H5Dget_storage_size(dataSet.id())))
    throw InputError(name, "is damaged: " + shape.text() + " values are not in the file");
}

/// Throws for raw values in other files and for virtual data sets.
void checkLayout(const Handle& dataSet, const std::string& name) {
  const Handle created(H5Dget_create_plist(dataSet.id()), H5Pclose);
  if (H5Pget_external_count(created.id()) > 0 || H5Pget_layout(created.id()) == H5D_VIRTUAL)
    throw InputError(name, "keeps its values in other files; copy them into this one");
}

/// Returns a text such as "LF 9×9×512×512×3, depth 9×9×512×512".
std::string listed(const Handle& file, const std::vector<std::string>& names) {
  constexpr std::size_t most = 5;
  std::string text;
  for (std::size_t k = 0; k < std::min(most, names.size()); ++k) {
    const Handle one(H5Dopen2(file.id(), names[k].c_str(), H5P_DEFAULT), H5Dclose);
    text += (k == 0 ? "" : ", ") + names[k] + " " + shapeOf(one).text();
  }
  return names.size() > most ? text + ", …" : text;
}

/// Returns the only data set that can be views, else "LF", else the only one with colours. HCI's
/// depth has as many axes as grey views, but other values.
std::string chosenName(const Handle& file) {
  const std::vector<std::string> names = dataSetsOf(file);
  std::vector<std::string> views;
  std::vector<std::string> coloured;
  for (const std::string& name : names) {
    const Handle one(H5Dopen2(file.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
    const std::optional<ViewAxes> axes = one.isOpen() ? shapeOf(one).axes() : std::nullopt;
    if (!axes) continue;
    views.push_back(name);
    if (axes->colours) coloured.push_back(name);
  }
  if (views.size() == 1) return views[0];
  if (std::ranges::count(views, "LF") > 0) return "LF";
  if (coloured.size() == 1) return coloured[0];
  if (views.empty())
    throw InputError("",
                     "has no data set of views, rows × columns × height × width × 3 of 8 or 16 "
                     "bits or floats: " +
                         (names.empty() ? "it has none at all" : listed(file, names)));
  throw InputError("lightField.pattern", "must name one of the data sets: " + listed(file, views));
}

/// Opens the data set; all of this runs in the other process.
DataSet openDataSet(const fs::path& path, const std::string& name) {
  Handle file = openFile(path);
  const std::string chosen = name.empty() ? chosenName(file) : name;
  Handle handle(H5Dopen2(file.id(), chosen.c_str(), H5P_DEFAULT), H5Dclose);
  if (!handle.isOpen())
    throw InputError(
        "lightField.pattern",
        "\"" + chosen + "\" is no data set of the file: it has " + listed(file, dataSetsOf(file)));
  const Shape shape = shapeOf(handle);
  const std::optional<ViewAxes> axes = shape.axes();
  if (!axes)
    throw InputError(chosen, "has " + shape.text() +
                                 " values, not rows × columns × height × width × 3 of 8 or 16 bits "
                                 "or floats");
  checkLayout(handle, chosen);
  checkStored(handle, shape, chosen);
  return {std::move(file), chosen, std::move(handle), shape, *axes};
}

class Hdf5Input : public ImageInput {
 public:
  explicit Hdf5Input(DataSet dataSet) : m_dataSet(std::move(dataSet)) {
    const auto& [lengths, stored, isMatlab] = m_dataSet.shape;
    const ViewAxes& axes = m_dataSet.axes;
    const StoredType type = stored.value_or(StoredType::uint8);
    std::size_t frames = 1;
    for (const std::size_t axis : axes.views) frames *= lengths[axis];
    m_facts = {
        {lengths[axes.width], lengths[axes.height], axes.colours ? int(lengths[*axes.colours]) : 1,
         type, type == StoredType::uint8 ? 8 : 16, frames,
         axes.views.size() == 2 ? lengths[axes.views[1]] : 0},
        "hdf5"};
    m_facts.bandRows = bandRowsOf(m_facts.width);
    std::string note;
    if (!axes.isUsual)
      note = "keeps " + m_dataSet.name + " as " + m_dataSet.shape.text() +
             ", which are taken for " + axes.text;
    if (m_facts.channels == 4)
      note += (note.empty() ? "has four channels" : "") +
              std::string("; the fourth, a weight or alpha, is left aside");
    if (!note.empty()) m_facts.notes = {note};
  }

  void read(std::size_t frame, std::size_t first, std::size_t rows, const Rows& to) override {
    std::visit([&](auto* rgb) { readAs(frame, first, rows, rgb); }, to);
  }

 private:
  /// A box of the data set.
  struct Box {
    std::vector<hsize_t> from;
    std::vector<hsize_t> count;
  };

  /// Returns the box of a view's rows.
  [[nodiscard]] Box boxOf(std::size_t frame, std::size_t first, std::size_t rows) const {
    const ViewAxes& axes = m_dataSet.axes;
    const std::vector<hsize_t>& lengths = m_dataSet.shape.lengths;
    Box box{std::vector<hsize_t>(lengths.size(), 0), std::vector<hsize_t>(lengths.size(), 1)};
    for (auto axis = axes.views.rbegin(); axis != axes.views.rend(); ++axis) {
      box.from[*axis] = frame % lengths[*axis];
      frame /= lengths[*axis];
    }
    box.from[axes.height] = first;
    box.count[axes.height] = rows;
    box.count[axes.width] = m_facts.width;
    if (axes.colours) box.count[*axes.colours] = hsize_t(std::min(m_facts.channels, 3));
    return box;
  }

  template <class T>
  [[nodiscard]] std::vector<T> valuesOf(const Box& box) const {
    const hid_t dataSet = m_dataSet.handle.id();
    const Handle space(H5Dget_space(dataSet), H5Sclose);
    const Handle memory(H5Screate_simple(int(box.count.size()), box.count.data(), nullptr),
                        H5Sclose);
    H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, box.from.data(), nullptr, box.count.data(),
                        nullptr);
    std::vector<T> values(sizeOf(box));
    if (H5Dread(dataSet, nativeType(typeFor<T>()), memory.id(), space.id(), H5P_DEFAULT,
                values.data()) < 0)
      throw InputError(m_dataSet.name + " is damaged", lastError());
    return values;
  }

  static std::size_t sizeOf(const Box& box) {
    std::size_t size = 1;
    for (const hsize_t count : box.count) size *= count;
    return size;
  }

  /// Returns the box of all views if it fits into memory. Where neighbouring values are of
  /// different views, each view would decode nearly all of the file.
  template <class T>
  [[nodiscard]] std::optional<Box> allViews() const {
    if (!m_dataSet.axes.areViewsLast) return std::nullopt;
    Box box = boxOf(0, 0, m_facts.height);
    for (const std::size_t axis : m_dataSet.axes.views) {
      box.from[axis] = 0;
      box.count[axis] = m_dataSet.shape.lengths[axis];
    }
    const std::size_t most = std::min(std::size_t{400} << 20U, allowedMemory() / 2);
    if (sizeOf(box) > most / sizeof(T)) return std::nullopt;
    return box;
  }

  template <class T>
  void readAs(std::size_t frame, std::size_t first, std::size_t rows, T* rgb) {
    const Box wanted = boxOf(frame, first, rows);
    const std::optional<Box> all = allViews<T>();
    if (!all) return copy(valuesOf<T>(wanted), wanted, wanted, rgb);
    if (!std::holds_alternative<std::vector<T>>(m_all)) m_all = valuesOf<T>(*all);
    copy(std::get<std::vector<T>>(m_all), *all, wanted, rgb);
  }

  /// Copies the wanted rows of a view out of a box's values, grey as all three colours.
  template <class T>
  void copy(const std::vector<T>& values, const Box& box, const Box& wanted, T* rgb) const {
    const ViewAxes& axes = m_dataSet.axes;
    // Steps in `values` from one index of an axis to the next.
    std::vector<std::size_t> step(box.count.size(), 1);
    for (std::size_t axis = step.size() - 1; axis-- > 0;)
      step[axis] = step[axis + 1] * box.count[axis + 1];
    std::size_t begin = 0;
    for (std::size_t axis = 0; axis < step.size(); ++axis)
      begin += (wanted.from[axis] - box.from[axis]) * step[axis];
    const bool isGrey = !axes.colours || wanted.count[*axes.colours] < 3;
    const std::size_t colourStep = isGrey ? 0 : step[*axes.colours];
    for (std::size_t y = 0; y < wanted.count[axes.height]; ++y)
      for (std::size_t x = 0; x < m_facts.width; ++x)
        for (std::size_t c = 0; c < 3; ++c) {
          const T value =
              values[begin + y * step[axes.height] + x * step[axes.width] + c * colourStep];
          if (std::isnan(double(value))) throw InputError("", "has a value that is not a number");
          if (std::isinf(double(value))) throw InputError("", "has an infinite value");
          *rgb++ = value;
        }
  }

  DataSet m_dataSet;
  /// The values of all views, once they are read; none: by rows.
  std::variant<std::monostate, std::vector<std::uint8_t>, std::vector<std::uint16_t>,
               std::vector<float>>
      m_all;
};

}  // namespace

/// The library looks for its signature at these places; MATLAB has a text of 512 bytes before it.
bool isHdf5(const fs::path& file) {
  constexpr std::string_view signature("\x89HDF\r\n\x1a\n");
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return false;
  std::ifstream in(file, std::ios::binary);
  for (const int at : {0, 512, 1024, 2048}) {
    std::array<char, signature.size()> begin{};
    in.seekg(at);
    in.read(begin.data(), std::streamsize(begin.size()));
    if (!in) return false;
    if (std::string_view(begin.data(), begin.size()) == signature) return true;
  }
  return false;
}

/// Uses another process, because libhdf5 1.10 crashes on some damaged files.
std::unique_ptr<ImageInput> openHdf5(const fs::path& file, const std::string& name) {
  return isolatedInput(
      file, [file, name] { return std::make_unique<Hdf5Input>(openDataSet(file, name)); });
}

}  // namespace hogelscope
