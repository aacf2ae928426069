// SPDX-License-Identifier: BSD-3-Clause
#include "gltf_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>

#include "errors.h"
#include "mesh.h"
#include "mesh_reader.h"

namespace hogelscope::mesh {

namespace {

std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

std::string decodeBase64(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    static constexpr std::string_view letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::size_t value = letters.find(c);
    if (value == std::string_view::npos) break;  // '=' at the end
    bits = (bits << 6U) | std::uint32_t(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(char((bits >> unsigned(count)) & 0xFFU));
  }
  return bytes;
}

/// Decodes percent-encoded characters such as %20.
std::string decodePercents(const std::string& uri) {
  std::string text;
  for (std::size_t k = 0; k < uri.size(); ++k) {
    const std::string digits = uri.substr(k, 3);
    const bool isCode = digits.size() == 3 && digits[0] == '%' &&
                        digits.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
    text.push_back(isCode ? char(std::stoi(digits.substr(1), nullptr, 16)) : uri[k]);
    if (isCode) k += 2;
  }
  return text;
}

}  // namespace

GltfData::GltfData(Reading& reading)
    : m_reading(reading), m_bytes(reading.bytesOf(reading.file())), m_files{reading.file()} {
  const std::string_view binary = readContainer();
  if (!m_root.is_object()) fail("is not glTF", "its JSON is no object");
  checkExtensions();
  const Json& asset = part(m_root, "asset");
  if (!asset.contains("version") || asset["version"] != "2.0")
    fail("asset.version", "must be \"2.0\"");
  readBuffers(binary);
}

void GltfData::fail(const std::string& what, const std::string& why) const {
  mesh::fail(file(), what, why);
}

/// Reads the JSON and returns the binary chunk of a .glb.
std::string_view GltfData::readContainer() {
  const std::string_view bytes = m_bytes;
  std::string_view json = bytes;
  std::string_view binary;
  constexpr std::size_t chunkHeader = 8;
  if (bytes.starts_with("glTF")) {
    std::size_t at = 12;
    if (bytes.size() < at + chunkHeader || wordAt(bytes, 8) > bytes.size())
      fail("is damaged", "it ends before its last chunk");
    if (wordAt(bytes, 4) != 2) fail("is not glTF 2.0", "the container has another version");
    for (int chunk = 0; chunk < 2 && at + chunkHeader <= bytes.size(); ++chunk) {
      const std::size_t size = wordAt(bytes, at);
      if (size > bytes.size() - at - chunkHeader)
        fail("is damaged", "it ends before its last chunk");
      (chunk == 0 ? json : binary) = bytes.substr(at + chunkHeader, size);
      at += chunkHeader + size;
    }
  }
  parse(json);
  return binary;
}

/// Limits the depth, because deep values are destroyed and copied recursively.
void GltfData::parse(std::string_view json) {
  constexpr int deepest = 100;
  constexpr double bytesOfValue = 64;  // an object's member has a key in addition to its value
  m_reading.take(double(json.size()));
  std::size_t count = 0;
  const auto look = [&](int depth, Json::parse_event_t, Json&) {
    if (depth > deepest) fail("is no glTF that can be read", "its JSON is nested too deeply");
    m_reading.take(bytesOfValue);
    if (++count % 65536 == 0) m_reading.poll();
    return true;
  };
  m_root = Json::parse(json, look, false);
  if (m_root.is_discarded()) fail("is not glTF", "its JSON is damaged");
}

void GltfData::checkExtensions() const {
  for (const Json& name : listAt("extensionsRequired")) {
    if (!name.is_string()) fail("extensionsRequired", "must be a list of names");
    const auto text = name.get<std::string>();
    if (std::ranges::find(knownExtensions, text) != knownExtensions.end()) continue;
    fail("needs the extension " + shortName(text), text == "KHR_draco_mesh_compression"
                                                       ? "export it without Draco compression"
                                                       : "export it without that extension");
  }
}

void GltfData::readBuffers(std::string_view binary) {
  const Json& buffers = listAt("buffers");
  for (std::size_t k = 0; k < buffers.size(); ++k) {
    const std::string name = named("buffers", k);
    const double length = number(entry("buffers", k), "byteLength", 0);
    std::string_view bytes;
    if (const auto uri = buffers[k].find("uri"); uri != buffers[k].end()) {
      if (!uri->is_string()) fail(name + ".uri", "must be a text");
      bytes = readBuffer(uri->get_ref<const std::string&>(), name);
    } else if (k == 0) {
      bytes = binary;
    }
    if (length > double(bytes.size()))
      fail(name, "has " + std::to_string(bytes.size()) + " bytes, not the byteLength it states");
    m_buffers.push_back(bytes);
  }
}

std::string_view GltfData::readBuffer(const std::string& uri, const std::string& name) {
  if (isData(uri)) return m_data.emplace_back(dataOf(uri, name));
  const std::string path = fileOf(uri, name);
  const auto [found, isNew] = m_contents.try_emplace(sameName(path));
  if (isNew) {
    found->second = m_reading.bytesOf(path);
    m_files.push_back(path);
  }
  return found->second;
}

std::string GltfData::dataOf(const std::string& uri, const std::string& what) const {
  const std::size_t comma = uri.find(";base64,");
  if (comma == std::string::npos) fail(what, "its data URI is not in base64");
  m_reading.take(double(uri.size()));
  return decodeBase64(std::string_view(uri).substr(comma + 8));
}

std::string GltfData::fileOf(const std::string& uri, const std::string& what) const {
  std::string path = besides(file(), decodePercents(uri));
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    fail(what, "there is no file " + shortName(path));
  return path;
}

const Json& GltfData::part(const Json& object, const char* member) {
  static const Json nothing = Json::object();
  const auto found = object.find(member);
  return found != object.end() && found->is_object() ? *found : nothing;
}

const Json& GltfData::listAt(const char* member) const {
  static const Json nothing = Json::array();
  const auto found = m_root.find(member);
  if (found == m_root.end()) return nothing;
  if (!found->is_array()) fail(member, "must be a list");
  return *found;
}

const Json& GltfData::entry(const char* list, std::size_t index) const {
  const auto found = m_root.find(list);
  if (found == m_root.end() || !found->is_array() || index >= found->size())
    fail(list, "there is no entry " + std::to_string(index));
  const Json& object = (*found)[index];
  if (!object.is_object()) fail(named(list, index), "must be an object");
  return object;
}

std::size_t GltfData::index(const Json& object, const char* member) const {
  const auto found = object.find(member);
  if (found == object.end()) return none;
  if (!found->is_number_unsigned()) fail(member, "must be a whole number from 0 on");
  return found->get<std::size_t>();
}

double GltfData::number(const Json& object, const char* member, double otherwise) const {
  const auto found = object.find(member);
  if (found == object.end()) return otherwise;
  if (!found->is_number() || !std::isfinite(found->get<double>())) fail(member, "must be a number");
  return found->get<double>();
}

std::vector<double> GltfData::list(const Json& object, const char* member,
                                   std::size_t count) const {
  const auto found = object.find(member);
  if (found == object.end()) return {};
  const auto isNumber = [](const Json& x) { return x.is_number(); };
  if (!found->is_array() || found->size() != count ||
      !std::all_of(found->begin(), found->end(), isNumber))
    fail(member, "must be a list of " + std::to_string(count) + " numbers");
  return found->get<std::vector<double>>();
}

std::string_view GltfData::bufferView(std::size_t index) const {
  const Json& view = entry("bufferViews", index);
  const std::string name = named("bufferViews", index);
  const std::size_t buffer = this->index(view, "buffer");
  if (buffer >= m_buffers.size()) fail(name, "names a buffer that is not there");
  const double offset = number(view, "byteOffset", 0);
  const double length = number(view, "byteLength", 0);
  const std::string_view bytes = m_buffers[buffer];
  if (!(offset >= 0 && length >= 0 && offset + length <= double(bytes.size())))
    fail(name, "reaches beyond its buffer of " + std::to_string(bytes.size()) + " bytes");
  return bytes.substr(std::size_t(offset), std::size_t(length));
}

}  // namespace hogelscope::mesh
