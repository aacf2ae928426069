// SPDX-License-Identifier: BSD-3-Clause
// COLMAP's cameras and images, text and binary. A file of images needs that of cameras beside it;
// points are passed over.
#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <span>
#include <sstream>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/cameras/camera_formats.h"

namespace hogelscope {

namespace {

namespace fs = std::filesystem;

/// COLMAP's camera models, in the order of their numbers.
struct ColmapModel {
  std::string_view name;
  std::size_t parameters;
};
constexpr ColmapModel colmapModels[]{{"SIMPLE_PINHOLE", 3},
                                     {"PINHOLE", 4},
                                     {"SIMPLE_RADIAL", 4},
                                     {"RADIAL", 5},
                                     {"OPENCV", 8},
                                     {"OPENCV_FISHEYE", 8},
                                     {"FULL_OPENCV", 12},
                                     {"FOV", 5},
                                     {"SIMPLE_RADIAL_FISHEYE", 4},
                                     {"RADIAL_FISHEYE", 5},
                                     {"THIN_PRISM_FISHEYE", 12},
                                     {"RAD_TAN_THIN_PRISM_FISHEYE", 16}};

struct ColmapImage {
  std::array<double, 4> q{};  ///< w, x, y, z of cameraFromWorld
  std::array<double, 3> t{};
  std::string camera;
  std::string name;
};

struct ColmapCamera {
  std::string id;
  const ColmapModel* model = nullptr;
  double width = 0, height = 0;
  std::vector<double> parameters;
};

/// The lines of a text without comments, the first 4096 bytes of each; a file of images has lines
/// of points that are much longer, but not longer than `longest`.
class ColmapLines {
 public:
  ColmapLines(const fs::path& file, std::uint64_t longest)
      : m_in(file, std::ios::binary), m_longest(longest) {
    if (!m_in) throw InputError(file.string(), "cannot be read", std::strerror(errno));
  }

  /// Returns the next line, also an empty one; none at the end.
  std::optional<std::string> next() {
    constexpr std::size_t kept = 4096;
    for (;;) {
      std::string line;
      std::uint64_t count = 0;
      int c = m_in.get();
      if (c == std::char_traits<char>::eof()) return std::nullopt;
      for (; c != '\n' && c != std::char_traits<char>::eof(); c = m_in.get()) {
        if (line.size() < kept) line += static_cast<char>(c);
        if (++count > m_longest) throw InputError("has a line that is too long for COLMAP's", "");
      }
      if (!line.starts_with('#')) return line;
    }
  }

 private:
  std::ifstream m_in;
  std::uint64_t m_longest;
};

constexpr std::uint64_t longestLine = std::uint64_t{1} << 28;  ///< ten million points

std::vector<std::string> wordsOfLine(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

const ColmapModel* modelNamed(const std::string& name) {
  const auto* const found = std::ranges::find(colmapModels, name, &ColmapModel::name);
  return found == std::end(colmapModels) ? nullptr : found;
}

/// Returns the numbers of words from `begin` on; none if one is no number.
std::optional<std::vector<double>> numbersOfWords(const std::vector<std::string>& words,
                                                  std::size_t begin, std::size_t end) {
  std::vector<double> numbers;
  for (std::size_t k = begin; k < end; ++k) {
    const std::optional<double> number = numberOf(words[k]);
    if (!number || !std::isfinite(*number)) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

/// Returns the camera of a line such as "1 PINHOLE 640 480 500 500 320 240"; none if it is no such
/// line.
std::optional<ColmapCamera> cameraOfLine(const std::string& line) {
  const std::vector<std::string> words = wordsOfLine(line);
  if (words.size() < 5 || !numberOf(words[0])) return std::nullopt;
  const auto isCapital = [](char c) { return (c >= 'A' && c <= 'Z') || c == '_'; };
  if (!std::ranges::all_of(words[1], isCapital)) return std::nullopt;
  const auto numbers = numbersOfWords(words, 2, words.size());
  if (!numbers) return std::nullopt;
  const ColmapModel* const model = modelNamed(words[1]);
  if (model == nullptr)
    throw InputError("camera " + printable(words[0]),
                     printable(words[1]) + " is a camera model that is not known");
  if (numbers->size() != 2 + model->parameters)
    throw InputError("camera " + printable(words[0]),
                     std::string(model->name) + " has " + std::to_string(model->parameters) +
                         " parameters, not " + std::to_string(numbers->size() - 2));
  return ColmapCamera{
      words[0], model, (*numbers)[0], (*numbers)[1], {numbers->begin() + 2, numbers->end()}};
}

/// Returns the image of a line "ID QW QX QY QZ TX TY TZ CAMERA NAME"; none if it is no such line.
std::optional<ColmapImage> imageOfLine(const std::string& line) {
  const std::vector<std::string> words = wordsOfLine(line);
  if (words.size() < 10) return std::nullopt;
  const auto numbers = numbersOfWords(words, 0, 9);
  if (!numbers) return std::nullopt;
  const auto& n = *numbers;
  constexpr double tolerance = 0.01;
  const double square = n[1] * n[1] + n[2] * n[2] + n[3] * n[3] + n[4] * n[4];
  if (!(std::abs(square - 1) < tolerance)) return std::nullopt;
  std::string name = words[9];
  for (std::size_t k = 10; k < words.size(); ++k) name += " " + words[k];
  return ColmapImage{{n[1], n[2], n[3], n[4]}, {n[5], n[6], n[7]}, words[8], name};
}

/// Reads binary values from the front of a file, in the byte order of all machines that this
/// program runs on, little-endian.
class ColmapBytes {
 public:
  explicit ColmapBytes(const fs::path& file) : m_in(file, std::ios::binary) {
    std::error_code none;
    m_left = fs::file_size(file, none);
    if (!m_in || none) throw InputError(file.string(), "cannot be read", std::strerror(errno));
  }

  template <class T>
  T take() {
    T value{};
    if (m_left < sizeof(T) || !m_in.read(reinterpret_cast<char*>(&value), sizeof(T)))
      throw InputError("ends too early: not a whole file of COLMAP", "");
    m_left -= sizeof(T);
    return value;
  }

  std::string text() {
    constexpr std::size_t longest = 4096;
    std::string text;
    for (char c = take<char>(); c != '\0'; c = take<char>()) {
      if (text.size() == longest)
        throw InputError("has a name of more than 4096 bytes: not a file of COLMAP", "");
      text += c;
    }
    return text;
  }

  void skip(std::uint64_t count, std::uint64_t size) {
    if (count > m_left / size) throw InputError("ends too early: not a whole file of COLMAP", "");
    m_left -= count * size;
    m_in.seekg(std::streamoff(count * size), std::ios::cur);
  }

  [[nodiscard]] std::uint64_t left() const { return m_left; }

 private:
  std::ifstream m_in;
  std::uint64_t m_left = 0;
};

std::vector<ColmapCamera> binaryCameras(const fs::path& file, std::size_t most) {
  ColmapBytes bytes(file);
  const auto count = bytes.take<std::uint64_t>();
  std::vector<ColmapCamera> cameras;
  for (std::uint64_t k = 0; k < std::min<std::uint64_t>(count, most); ++k) {
    ColmapCamera camera;
    camera.id = std::to_string(bytes.take<std::uint32_t>());
    const auto model = bytes.take<std::int32_t>();
    if (model < 0 || model >= std::ssize(colmapModels))
      throw InputError("camera " + camera.id,
                       std::to_string(model) + " is no number of a camera model of COLMAP");
    camera.model = &colmapModels[model];
    camera.width = double(bytes.take<std::uint64_t>());
    camera.height = double(bytes.take<std::uint64_t>());
    for (std::size_t p = 0; p < camera.model->parameters; ++p)
      camera.parameters.push_back(bytes.take<double>());
    cameras.push_back(std::move(camera));
  }
  if (count <= most && bytes.left() > 0)
    throw InputError("has more than its cameras: not a file of COLMAP", "");
  return cameras;
}

std::vector<ColmapImage> binaryImages(const fs::path& file, std::size_t most) {
  ColmapBytes bytes(file);
  const auto count = bytes.take<std::uint64_t>();
  std::vector<ColmapImage> images;
  for (std::uint64_t k = 0; k < std::min<std::uint64_t>(count, most); ++k) {
    ColmapImage image;
    (void)bytes.take<std::uint32_t>();
    for (double& part : image.q) part = bytes.take<double>();
    for (double& part : image.t) part = bytes.take<double>();
    image.camera = std::to_string(bytes.take<std::uint32_t>());
    image.name = bytes.text();
    constexpr std::uint64_t pointSize = 24;
    bytes.skip(bytes.take<std::uint64_t>(), pointSize);
    images.push_back(std::move(image));
  }
  if (count <= most && bytes.left() > 0)
    throw InputError("has more than its images: not a file of COLMAP", "");
  return images;
}

bool isBinary(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::array<char, 8> begin{};
  in.read(begin.data(), begin.size());
  return std::ranges::count(begin, '\0') >= 4;  // a count of 8 bytes
}

std::vector<ColmapCamera> camerasOf(const fs::path& file) {
  return inFile(file.string(), [&] {
    if (isBinary(file)) return binaryCameras(file, mostCameras);
    std::vector<ColmapCamera> cameras;
    ColmapLines lines(file, longestLine);
    while (const auto line = lines.next()) {
      if (auto camera = cameraOfLine(*line)) cameras.push_back(std::move(*camera));
      if (cameras.size() >= mostCameras) break;
    }
    return cameras;
  });
}

std::vector<ColmapImage> imagesOf(const fs::path& file) {
  return inFile(file.string(), [&] {
    if (isBinary(file)) return binaryImages(file, mostCameras);
    std::vector<ColmapImage> images;
    ColmapLines lines(file, longestLine);
    while (const auto line = lines.next()) {
      if (wordsOfLine(*line).empty()) continue;
      auto image = imageOfLine(*line);
      if (!image) throw InputError(printable(line->substr(0, 40)), "is no line of an image");
      images.push_back(std::move(*image));
      (void)lines.next();  // its points
      if (images.size() >= mostCameras) break;
    }
    return images;
  });
}

/// COLMAP counts pixels from the picture's corner, half a pixel more than from a pixel's middle.
FileCamera fileCameraOf(const ColmapCamera& camera) {
  const std::string path = "camera " + printable(camera.id);
  const auto& p = camera.parameters;
  const std::string model(camera.model->name);
  const bool hasOneLength = model.starts_with("SIMPLE_") || model.starts_with("RADIAL");
  const std::size_t second = hasOneLength ? 0 : 1;
  FileCamera result;
  result.name = camera.id;
  result.model = model;
  result.modelKey = path;
  result.lensPath = path;
  if (model == "RADIAL" || model == "SIMPLE_RADIAL") {
    result.coefficients = {p[3], model == "RADIAL" ? p[4] : 0, 0, 0};
  } else {
    result.coefficients.assign(p.begin() + std::ptrdiff_t(second) + 3, p.end());
  }
  result.calibration.intrinsics = checkedIntrinsics(
      {{"fx", p[0]}, {"fy", p[second]}, {"cx", p[second + 1] - 0.5}, {"cy", p[second + 2] - 0.5}},
      path);
  result.calibration.res = checkedSize({camera.width, camera.height}, path);
  return result;
}

FileCamera fileCameraOf(const ColmapImage& image, const FileCamera& camera) {
  FileCamera result = camera;
  result.name = stemOf(image.name);
  result.picture = image.name;
  const std::string path = printable(image.name);
  RigidTransform cameraFromWorld = rotationOf(image.q[0], image.q[1], image.q[2], image.q[3], path);
  constexpr double farthest = 1e9;
  for (const double part : image.t)
    if (!(std::abs(part) < farthest)) throw InputError(path, "stands too far away");
  cameraFromWorld.origin = {image.t[0], image.t[1], image.t[2]};
  result.pose = cameraFromWorld.inverse();
  return result;
}

enum class ColmapKind { none, cameras, images };

/// Tells by its first lines or values what a file is.
ColmapKind kindOf(const fs::path& file) {
  std::error_code none;
  if (!fs::is_regular_file(file, none)) return ColmapKind::none;
  try {
    if (isBinary(file)) {
      constexpr std::uint64_t leastCamera = 48, leastImage = 73;  // bytes
      const std::uint64_t size = fs::file_size(file, none);
      const auto count = ColmapBytes(file).take<std::uint64_t>();
      if (count == 0 || count > size / leastCamera) return ColmapKind::none;
      try {
        if (!binaryCameras(file, mostCameras).empty()) return ColmapKind::cameras;
      } catch (const InputError&) {  // images, perhaps
      }
      if (count > size / leastImage) return ColmapKind::none;
      return binaryImages(file, mostCameras).empty() ? ColmapKind::none : ColmapKind::images;
    }
    constexpr std::uint64_t longestFirst = 1 << 16;
    ColmapLines lines(file, longestFirst);
    auto line = lines.next();
    for (int empty = 0; empty < 100 && line && wordsOfLine(*line).empty(); ++empty)
      line = lines.next();
    if (!line) return ColmapKind::none;
    if (imageOfLine(*line)) return ColmapKind::images;
    const std::vector<std::string> words = wordsOfLine(*line);
    const bool isCamera = words.size() > 1 && modelNamed(words[1]) != nullptr;
    return isCamera ? ColmapKind::cameras : ColmapKind::none;
  } catch (const InputError&) {
    return ColmapKind::none;
  }
}

/// Returns the file of cameras or images in a folder, text or binary; "" if there is none.
fs::path colmapFile(const fs::path& folder, const char* name, ColmapKind kind) {
  for (const char* ending : {".bin", ".txt"})
    if (fs::path file = folder / (std::string(name) + ending); kindOf(file) == kind) return file;
  return {};
}

bool isColmap(const CameraDocument& document) {
  if (!document.documents.empty()) return false;
  std::error_code none;
  return fs::is_directory(document.file, none)
             ? !colmapFile(document.file, "cameras", ColmapKind::cameras).empty()
             : kindOf(document.file) != ColmapKind::none;
}

CameraFile readColmap(const CameraDocument& document, CameraUse use) {
  std::error_code none;
  const bool isFolder = fs::is_directory(document.file, none);
  const fs::path folder = isFolder ? document.file : document.file.parent_path();
  const ColmapKind kind = isFolder ? ColmapKind::none : kindOf(document.file);
  const fs::path cameras = kind == ColmapKind::cameras
                               ? document.file
                               : colmapFile(folder, "cameras", ColmapKind::cameras);
  const fs::path images =
      kind == ColmapKind::images ? document.file : colmapFile(folder, "images", ColmapKind::images);
  if (cameras.empty())
    throw InputError("has COLMAP's images, but there is no cameras.txt or cameras.bin beside it",
                     "");
  CameraFile file;
  file.hasScale = false;
  std::map<std::string, FileCamera> byId;
  for (const ColmapCamera& camera : camerasOf(cameras))
    byId.insert_or_assign(camera.id,
                          inFile(cameras.string(), [&] { return fileCameraOf(camera); }));
  if (use == CameraUse::lens || images.empty()) {
    for (auto& [id, camera] : byId) file.cameras.push_back(std::move(camera));
    if (use == CameraUse::poses)
      file.notes.emplace_back("has no poses: there is no images.txt or images.bin beside it");
    return file;
  }
  for (const ColmapImage& image : imagesOf(images)) {
    const auto found = byId.find(image.camera);
    if (found == byId.end())
      throw InputError(images.string(), printable(image.name),
                       "is of camera " + printable(image.camera) + ", which is not in " +
                           cameras.filename().string());
    file.cameras.push_back(
        inFile(images.string(), [&] { return fileCameraOf(image, found->second); }));
  }
  return file;
}

}  // namespace

const CameraFormat colmapFormat{"COLMAP", isColmap, readColmap};

}  // namespace hogelscope
