// SPDX-License-Identifier: BSD-3-Clause
// The accessors of a glTF file.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "gltf_data.h"
#include "mesh.h"

namespace hogelscope::mesh {

namespace {

struct ComponentType {
  std::size_t bytes = 0;
  double scale = 0;  ///< of normalised values
};

ComponentType componentType(double number) {
  switch (int(number)) {
    case 5120:
      return {1, 127};
    case 5121:
      return {1, 255};
    case 5122:
      return {2, 32767};
    case 5123:
      return {2, 65535};
    case 5125:
      return {4, 4294967295.0};
    case 5126:
      return {4, 1};
    default:
      return {};
  }
}

template <class T>
double valueAs(const char* bytes) {
  T value{};
  std::memcpy(&value, bytes, sizeof value);
  return double(value);
}

double valueOf(const char* bytes, int type) {
  switch (type) {
    case 5120:
      return valueAs<std::int8_t>(bytes);
    case 5121:
      return valueAs<std::uint8_t>(bytes);
    case 5122:
      return valueAs<std::int16_t>(bytes);
    case 5123:
      return valueAs<std::uint16_t>(bytes);
    case 5125:
      return valueAs<std::uint32_t>(bytes);
    default:
      return valueAs<float>(bytes);
  }
}

std::size_t componentsOf(const std::string& type) {
  if (type == "SCALAR") return 1;
  if (type == "VEC2") return 2;
  if (type == "VEC3") return 3;
  if (type == "VEC4") return 4;
  if (type == "MAT4") return 16;
  return 0;  // nothing uses smaller matrices
}

}  // namespace

struct GltfData::Layout {
  std::string name;  ///< for messages
  int type = 0;
  std::size_t components = 0;
  std::size_t count = 0;
  std::size_t rowBytes = 0;
  double divisor = 1;
};

GltfData::Layout GltfData::layout(std::size_t accessor) const {
  const Json& object = entry("accessors", accessor);
  Layout layout;
  layout.name = named("accessors", accessor);
  const double type = number(object, "componentType", 0);
  const ComponentType component = componentType(std::clamp(type, 0.0, 1e6));
  const auto name = object.find("type");
  if (name != object.end() && name->is_string())
    layout.components = componentsOf(name->get<std::string>());
  if (component.bytes == 0 || layout.components == 0)
    fail(layout.name, "its type and componentType must be glTF's");
  layout.type = int(type);
  layout.rowBytes = component.bytes * layout.components;
  const auto normalised = object.find("normalized");
  if (normalised != object.end() && *normalised == true) layout.divisor = component.scale;
  const double count = number(object, "count", 0);
  if (!(count >= 1 && count <= 3.0 * mostTriangles))
    fail(layout.name, "its count must be 1 … " + std::to_string(3 * mostTriangles));
  layout.count = std::size_t(count);
  return layout;
}

/// Copies as many rows as fit `values`.
template <class T>
void GltfData::copyRows(std::vector<T>& values, std::string_view bytes, std::size_t stride,
                        const Layout& layout) const {
  const std::size_t rows = values.size() / layout.components;
  if (stride == 0 || stride < layout.rowBytes || bytes.size() < layout.rowBytes ||
      (bytes.size() - layout.rowBytes) / stride < rows - 1)
    fail(layout.name,
         "reaches beyond its bufferView of " + std::to_string(bytes.size()) + " bytes");
  const std::size_t width = layout.rowBytes / layout.components;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const char* at = bytes.data() + k / layout.components * stride + k % layout.components * width;
    const double value = valueOf(at, layout.type) / layout.divisor;
    if constexpr (std::is_same_v<T, float>)
      values[k] = float(layout.divisor == 1 ? value : std::max(value, -1.0));
    else
      values[k] = T(value > 0 ? std::min(value, 4294967295.0) : 0);  // NaN becomes 0
  }
}

template <class T>
std::vector<T> GltfData::elements(std::size_t accessor, const Layout& layout) const {
  const Json& object = entry("accessors", accessor);
  const std::size_t view = index(object, "bufferView");
  const auto sparse = object.find("sparse");
  if (view == none && sparse == object.end())
    fail(layout.name, "has no bufferView; Draco compression is not supported");
  std::vector<T> values(layout.count * layout.components);
  if (view != none) {
    std::string_view bytes = bufferView(view);
    const double offset = number(object, "byteOffset", 0);
    if (!(offset >= 0 && offset <= double(bytes.size())))
      fail(layout.name, "starts beyond its bufferView");
    bytes.remove_prefix(std::size_t(offset));
    const double stride = number(entry("bufferViews", view), "byteStride", double(layout.rowBytes));
    copyRows(values, bytes, stride > 0 && stride < 1e6 ? std::size_t(stride) : 0, layout);
  }
  if (sparse != object.end()) replaceSparse(values, *sparse, layout);
  return values;
}

template <class T>
void GltfData::replaceSparse(std::vector<T>& values, const Json& sparse,
                             const Layout& layout) const {
  const Json& indicesPart = sparse.is_object() ? part(sparse, "indices") : sparse;
  const Json& valuesPart = sparse.is_object() ? part(sparse, "values") : sparse;
  if (!sparse.is_object() || indicesPart.empty() || valuesPart.empty())
    fail(layout.name, "its sparse part needs indices and values");
  const double count = number(sparse, "count", 0);
  if (!(count >= 1 && count <= double(layout.count)))
    fail(layout.name, "its sparse part has more entries than it");
  const auto read = [&]<class U>(const Json& part, const Layout& rows, std::vector<U>& into) {
    std::string_view bytes = bufferView(index(part, "bufferView"));
    const double offset = number(part, "byteOffset", 0);
    if (!(offset >= 0 && offset <= double(bytes.size())))
      fail(layout.name, "its sparse part starts beyond its bufferView");
    bytes.remove_prefix(std::size_t(offset));
    copyRows(into, bytes, rows.rowBytes, rows);
  };
  Layout index = layout;
  index.components = 1;
  index.divisor = 1;
  const double type = number(indicesPart, "componentType", 0);
  index.type = int(std::clamp(type, 0.0, 1e6));
  index.rowBytes = componentType(index.type).bytes;
  if (index.rowBytes == 0) fail(layout.name, "its sparse indices have no known componentType");
  std::vector<std::uint32_t> places{};
  places.resize(std::size_t(count));
  read(indicesPart, index, places);
  std::vector<T> replaced(std::size_t(count) * layout.components);
  read(valuesPart, layout, replaced);
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (places[k] >= layout.count)
      fail(layout.name, "its sparse part names an entry beyond its end");
    for (std::size_t c = 0; c < layout.components; ++c)
      values[places[k] * layout.components + c] = replaced[k * layout.components + c];
  }
}

std::size_t GltfData::rows(std::size_t accessor) const {
  return layout(accessor).count;
}

double GltfData::bytes(std::size_t accessor) const {
  const Layout layout = this->layout(accessor);
  const Json& sparse = part(entry("accessors", accessor), "sparse");
  const double replaced = std::clamp(number(sparse, "count", 0), 0.0, double(layout.count));
  static_assert(sizeof(float) == sizeof(std::uint32_t));
  return sizeof(float) *
         (double(layout.count * layout.components) + replaced * double(layout.components + 1));
}

Numbers GltfData::numbers(std::size_t accessor) const {
  const Layout layout = this->layout(accessor);
  return {elements<float>(accessor, layout), layout.components};
}

std::vector<std::uint32_t> GltfData::indices(std::size_t accessor, std::size_t components) const {
  const Layout layout = this->layout(accessor);
  if (layout.components != components || layout.divisor != 1)
    fail(layout.name, components == 1
                          ? "must be a list of whole numbers"
                          : "must have " + std::to_string(components) + " whole numbers in a row");
  return elements<std::uint32_t>(accessor, layout);
}

}  // namespace hogelscope::mesh
