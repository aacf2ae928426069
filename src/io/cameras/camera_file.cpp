// SPDX-License-Identifier: BSD-3-Clause
#include "io/cameras/camera_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <set>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/cameras/camera_formats.h"
#include "io/json/xml_reader.h"
#include "io/json/yaml_reader.h"

namespace hogelscope {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t mostText = std::size_t{1} << 20;   ///< of YAML and XML
constexpr std::size_t mostJson = std::size_t{16} << 20;  ///< of the many frames of a capture
constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

/// The formats; the first that recognises a document reads it.
const std::array<const CameraFormat*, 8>& cameraFormats() {
  static const std::array<const CameraFormat*, 8> formats{
      &gltfFormat, &transformsFormat, &splatsFormat, &kalibrFormat,
      &listFormat, &rosFormat,        &matrixFormat, &colmapFormat};
  return formats;
}

/// Returns at most `most` bytes of a file from `begin` on.
std::string bytesOf(const fs::path& file, std::size_t begin, std::size_t most) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError("cannot be read", std::strerror(errno));
  in.seekg(std::streamoff(begin));
  std::string bytes(most, '\0');
  in.read(bytes.data(), std::streamsize(most));
  bytes.resize(std::size_t(in.gcount()));
  return bytes;
}

/// Reads a text of at most `most` bytes, without a byte order mark.
std::string cameraText(const fs::path& file, std::size_t most) {
  std::string text = bytesOf(file, 0, most + 1);
  if (text.size() > most)
    throw InputError(
        "is larger than " + std::to_string(most >> 20U) + " MiB: not a camera's calibration", "");
  if (text.starts_with(byteOrderMark)) text.erase(0, byteOrderMark.size());
  return text;
}

/// Returns the document of JSON in a GLB file: 12 bytes of header, length and kind of the chunk.
Json glbDocument(const fs::path& file) {
  const std::string header = bytesOf(file, 0, 20);
  std::uint32_t length = 0;
  if (header.size() == 20) std::memcpy(&length, header.data() + 12, sizeof length);
  if (header.size() < 20 || header.substr(16, 4) != "JSON" || length > mostJson)
    throw InputError("is not a GLB file whose first part is JSON of at most 16 MiB", "");
  return parseJson(bytesOf(file, 20, length), JsonComments::ignored);
}

/// Parses a file by how it begins. A file that begins otherwise has no documents.
CameraDocument documentOf(const fs::path& file) {
  CameraDocument document{file};
  std::error_code none;
  if (fs::is_directory(file, none)) return document;
  constexpr std::size_t sniffed = 4096;
  std::string begin = bytesOf(file, 0, sniffed);
  if (begin.starts_with("glTF")) {
    document.documents.push_back(glbDocument(file));
    return document;
  }
  if (begin.starts_with(byteOrderMark)) begin.erase(0, byteOrderMark.size());
  begin.erase(0, std::min(begin.find_first_not_of(" \t\r\n"), begin.size()));
  if (begin.starts_with("{") || begin.starts_with("[")) {
    document.syntax = "JSON";
    document.documents.push_back(parseJson(cameraText(file, mostJson), JsonComments::ignored));
  } else if (begin.starts_with("<?xml") || begin.starts_with("<opencv_storage")) {
    document.syntax = "OpenCV XML";
    document.documents.push_back(parseOpenCvXml(cameraText(file, mostText)));
  } else if (begin.starts_with("%YAML")) {
    document.syntax = "OpenCV YAML";
    std::string text = cameraText(file, mostText);
    text.erase(0, text.find('%'));
    document.documents.push_back(parseOpenCvYaml(text));
  }
  return document;
}

/// Parses a text that may be YAML: it has names and colons, and no bytes that texts do not have.
std::vector<Json> yamlOf(const fs::path& file) {
  constexpr std::size_t sniffed = 4096;
  const std::string begin = bytesOf(file, 0, sniffed);
  const auto isForeign = [](char c) {
    return static_cast<unsigned char>(c) < 32 && c != '\n' && c != '\r' && c != '\t';
  };
  if (begin.find(':') == std::string::npos || std::ranges::any_of(begin, isForeign)) return {};
  return parseYaml(cameraText(file, mostText));
}

/// Our own documents have cameras, too, of another kind.
bool isOwn(const CameraDocument& document) {
  for (const Json& object : document.documents)
    for (const auto& [key, value] : object.items())
      if (object.is_object() && key.starts_with("hogelscope")) return true;
  return false;
}

const CameraFormat* formatOf(const CameraDocument& document) {
  if (isOwn(document)) return nullptr;
  const auto found = std::ranges::find_if(
      cameraFormats(), [&](const CameraFormat* format) { return format->recognises(document); });
  return found == cameraFormats().end() ? nullptr : *found;
}

/// Parses a file and finds its format; null if it has none that is known. COLMAP's own texts are
/// asked before YAML is tried.
std::pair<CameraDocument, const CameraFormat*> parsed(const fs::path& file) {
  CameraDocument document = documentOf(file);
  const CameraFormat* format = formatOf(document);
  std::error_code none;
  if (format != nullptr || !document.documents.empty() || fs::is_directory(file, none))
    return {document, format};
  document.syntax = "YAML";
  document.documents = yamlOf(file);
  if (!document.documents.empty()) format = formatOf(document);
  return {document, format};
}

std::string namesText(const std::vector<std::string>& names) {
  constexpr std::size_t most = 12;
  std::string text;
  for (std::size_t k = 0; k < std::min(most, names.size()); ++k)
    text += (k == 0 ? "" : ", ") + printable(names[k]);
  return text + (names.size() > most ? ", …" : "");
}

std::vector<std::string> namesIn(const CameraFile& file) {
  std::vector<std::string> names;
  for (const FileCamera& camera : file.cameras) names.push_back(camera.name);
  return names;
}

bool isSameLens(const FileCamera& a, const FileCamera& b) {
  return a.model == b.model && a.coefficients == b.coefficients &&
         a.calibration.intrinsics == b.calibration.intrinsics &&
         a.calibration.res == b.calibration.res && a.calibration.fov == b.calibration.fov;
}

const FileCamera& cameraNamed(const CameraFile& file, const std::string& name) {
  const auto found = std::ranges::find(file.cameras, name, &FileCamera::name);
  if (found == file.cameras.end())
    throw InputError("has no camera \"" + printable(name) + "\": " + namesText(namesIn(file)), "");
  return *found;
}

/// Returns the picture's size for a file without one: the principal point is the middle.
std::array<int, 2> centredOn(const IntrinsicsParams& k) {
  const auto side = [](double centre) { return static_cast<int>(std::lround(2 * centre)) + 1; };
  const bool isWithin = k.cx >= 0 && k.cy >= 0 && k.cx < 8192 && k.cy < 8192;
  if (!isWithin)
    throw InputError("image_width", "is missing, and the principal point is not in a picture");
  return {side(k.cx), side(k.cy)};
}

}  // namespace

bool isCameraFile(const fs::path& file) {
  try {
    return parsed(file).second != nullptr;
  } catch (const InputError&) {
    return false;  // another reader says what is wrong
  }
}

CameraFile readCameraFile(const fs::path& file, CameraUse use) {
  return inFile(file.string(), [&] {
    const auto [document, format] = parsed(file);
    if (format == nullptr)
      throw InputError("is not a file of cameras",
                       "known are OpenCV's YAML, XML and JSON, matrices as JSON or YAML (K, D), "
                       "ROS camera_info, Kalibr, transforms.json, COLMAP and glTF");
    CameraFile cameras = format->read(document, use);
    const bool isOfOpenCv = format == &matrixFormat && document.syntax.starts_with("OpenCV");
    cameras.format = std::string(isOfOpenCv ? document.syntax : format->name);
    if (cameras.cameras.empty()) throw InputError("has no camera", "");
    if (cameras.cameras.size() >= mostCameras)
      cameras.notes.push_back("has more cameras than are read, " + std::to_string(mostCameras));
    return cameras;
  });
}

CalibratedCameras calibratedCameras(const CameraFile& file, const std::string& camera) {
  CalibratedCameras result;
  result.isRig = file.isRig;
  const auto add = [&](const FileCamera& one) {
    result.cameras.push_back({one.name, calibrationOf(one), one.pose});
  };
  if (!camera.empty())
    add(cameraNamed(file, camera));
  else
    for (const FileCamera& one : file.cameras) add(one);
  return result;
}

std::vector<std::string> differingCameras(const CameraFile& file) {
  const FileCamera& first = file.cameras.front();
  const bool areSame = std::ranges::all_of(
      file.cameras, [&](const FileCamera& one) { return isSameLens(one, first); });
  return areSame ? std::vector<std::string>() : namesIn(file);
}

Calibration loadCalibration(const fs::path& file, const std::string& camera,
                            std::vector<std::string>* notes) {
  const CameraFile cameras = readCameraFile(file, CameraUse::lens);
  return inFile(file.string(), [&] {
    if (notes != nullptr) *notes = cameras.notes;
    if (!camera.empty()) return calibrationOf(cameraNamed(cameras, camera));
    if (const auto names = differingCameras(cameras); !names.empty())
      throw InputError(
          "has the cameras " + namesText(names) + ": say by its name which of them is wanted", "");
    return calibrationOf(cameras.cameras.front());
  });
}

std::vector<NamedCalibration> loadCalibrations(const fs::path& file) {
  const CameraFile cameras = readCameraFile(file, CameraUse::lens);
  return inFile(file.string(), [&] {
    std::vector<NamedCalibration> result;
    std::set<std::string> names;
    for (const FileCamera& camera : cameras.cameras) {
      Calibration calibration = calibrationOf(camera);
      if (!calibration.res && calibration.intrinsics.isGiven())
        calibration.res = centredOn(calibration.intrinsics);
      if (!names.insert(camera.name).second)
        throw InputError("cameras[" + std::to_string(result.size()) + "].name",
                         "\"" + printable(camera.name) + "\" is another camera's name too");
      result.push_back({camera.name, completed(calibration, CameraParams().res)});
    }
    return result;
  });
}

std::string sizeWarning(const Calibration& calibration, const std::array<int, 2>& res) {
  if (!calibration.res)
    return "does not say the size of its pictures: " + pairText(res[0], res[1]) + " px are assumed";
  if (*calibration.res == res) return "";
  const auto [width, height] = *calibration.res;
  const double scale = double(res[0]) / width;
  const IntrinsicsParams k = scaled(completed(calibration, res).intrinsics, scale);
  std::string text = "is of pictures of " + pairText(width, height) + " px, but states have " +
                     pairText(res[0], res[1]) + " px: --set camera.res=[" + std::to_string(res[0]) +
                     "," + std::to_string(std::max(1L, std::lround(height * scale))) + "]";
  const auto add = [&text](const char* name, double value) {
    if (value != notGiven)
      text += std::string(" --set intrinsics.") + name + "=" + numberText(value);
  };
  add("fx", k.fx);
  add("fy", k.fy);
  add("cx", k.cx);
  add("cy", k.cy);
  return text + " scale it to that width";
}

}  // namespace hogelscope
