// SPDX-License-Identifier: BSD-3-Clause
#include "io/store/store_header.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/error.h"
#include "io/images/big_tiff.h"
#include "io/json/json_parameters.h"
#include "io/plugins/display_json.h"

namespace hogelscope {

namespace {

constexpr const char* versionKey = "hogelscope-store";
constexpr int storeVersion = 1;
constexpr std::string_view hashName = "XXH3-128 ";
constexpr int side = int(tileSide);
constexpr std::array<const char*, 3> typeNames{"uint8", "uint16", "float"};

int blocksAlong(int cells, int block) {
  return (cells + block - 1) / block;
}

/// Returns the least power of two that is at least `cells`, limited to `most`.
int powerOfTwo(int cells, int most) {
  return std::min(most, int(std::bit_ceil(unsigned(cells))));
}

/// The most texels of an overview: 64 MB of 8-bit ones.
constexpr double mostOverviewTexels = 16e6;

std::array<int, 4> listOf(const BlockIndex& block) {
  return {block.i, block.j, block.u, block.v};
}
std::array<int, 4> listOf(const LightFieldSize& size) {
  return {size.nx, size.ny, size.du, size.dv};
}

std::array<int, 4> readList(const Json& object, const char* key) {
  const auto list = object.at(key).get<std::array<std::int64_t, 4>>();
  std::array<int, 4> result{};
  for (std::size_t k = 0; k < list.size(); ++k) {
    constexpr std::int64_t most = 1 << 24;
    if (list[k] < 1 || list[k] > most) throw InputError(key, "is out of range");
    result[k] = int(list[k]);
  }
  return result;
}

StoredType readType(const Json& object) {
  const auto name = object.at("type").get<std::string>();
  const auto found = std::find(typeNames.begin(), typeNames.end(), name);
  if (found == typeNames.end()) throw InputError("type", "\"" + name + "\" is not known");
  return StoredType(found - typeNames.begin());
}

Json documentOf(const std::string& text) {
  try {
    return parseJson(text);
  } catch (const InputError&) {
    throw InputError("", "is damaged: its description cannot be read");
  }
}

double readDistance(const Json& object) {
  if (!object.contains("viewingDistance")) return notGiven;
  const auto distance = object.at("viewingDistance").get<double>();
  if (!(distance > 0 && distance <= 1e6)) throw InputError("viewingDistance", "is out of range");
  return distance;
}

StoreHeader readHeader(const Json& object) {
  if (object.at(versionKey) != storeVersion)
    throw InputError(versionKey,
                     object.at(versionKey).dump() + " is not a version that this program reads");
  StoreHeader header;
  const auto [nx, ny, du, dv] = readList(object, "size");
  const auto [bi, bj, bu, bv] = readList(object, "block");
  const auto [ox, oy, ou, ov] = readList(object, "overview");
  header.size = {nx, ny, du, dv};
  header.block = {bi, bj, bu, bv};
  header.overview = {ox, oy, ou, ov};
  if (bi > side || bj > side || bi * bu != side || bj * bv != side)
    throw InputError("block", "is not of 64×64 pixels");
  if (ox > nx || oy > ny || ou > du || ov > dv)
    throw InputError("overview", "is larger than the light field");
  if (double(header.overview.width()) * double(header.overview.height()) > mostOverviewTexels)
    throw InputError("overview", "is too large");
  header.type = readType(object);
  header.source = object.at("source").get<std::string>();
  if (object.contains("display")) {
    header.display = PanelParams{{}, readDistance(object)};
    readParts(object.at("display"), "display", *header.display);
  }
  return header;
}

}  // namespace

BlockIndex StoreHeader::blocks() const {
  return {blocksAlong(size.nx, block.i), blocksAlong(size.ny, block.j),
          blocksAlong(size.du, block.u), blocksAlong(size.dv, block.v)};
}

BlockIndex blockFor(const LightFieldSize& size, int hogelRows) {
  constexpr int usual = 8;  // measured: see docs/measurements.md
  BlockIndex block;
  block.u = powerOfTwo(size.du, usual);
  block.i = side / block.u;
  block.v = powerOfTwo(size.dv, usual);
  block.j = std::min(side / block.v, int(std::bit_floor(unsigned(std::max(hogelRows, 1)))));
  block.v = side / block.j;
  return block;
}

LightFieldSize overviewSize(const LightFieldSize& size, StoredType type) {
  constexpr int mostDirections = 32;
  constexpr double share = 1.0 / 8;
  LightFieldSize shown = size;
  shown.du = std::min(size.du, mostDirections);
  shown.dv = std::min(size.dv, mostDirections);
  const double texels =
      std::min(mostOverviewTexels * memoryBytes(StoredType::uint8) / double(memoryBytes(type)),
               share * double(size.width()) * double(size.height()));
  const double wanted = double(shown.width()) * double(shown.height());
  const double scale = std::min(1.0, std::sqrt(texels / wanted));
  shown.nx = std::max(1, int(size.nx * scale));
  shown.ny = std::max(1, int(size.ny * scale));
  return shown;
}

std::string textOf(const StoreHeader& header) {
  Json object = Json::object();
  object[versionKey] = storeVersion;
  object["size"] = listOf(header.size);
  object["type"] = typeNames[std::size_t(header.type)];
  object["block"] = listOf(header.block);
  object["overview"] = listOf(header.overview);
  object["source"] = header.source;
  if (header.display) {
    object["display"] = writtenParts(*header.display);
    if (const double distance = header.display->viewingDistance; distance > 0)
      object["viewingDistance"] = distance;
  }
  return object.dump(-1, ' ', true, Json::error_handler_t::replace);
}

std::string pageNameOf(const ContentHash& tiles) {
  return std::string(hashName) + tiles.hex();
}

bool isPageName(const std::string& name) {
  constexpr std::size_t digits = 32;
  return name.starts_with(hashName) && name.size() == hashName.size() + digits;
}

std::optional<StoreHeader> parseStoreHeader(const std::string& text) {
  if (!text.starts_with(std::string("{\"") + versionKey + "\"")) return std::nullopt;
  const Json document = documentOf(text);
  try {
    return readHeader(document);
  } catch (const Json::exception&) {
    throw InputError("", "is damaged: its description cannot be read");
  } catch (const InputError& error) {
    throw InputError("", std::string("is damaged: its description's ") + error.what());
  }
}

}  // namespace hogelscope
