// SPDX-License-Identifier: BSD-3-Clause
// Cameras as matrices under their usual names: cv::FileStorage, ROS camera_info, and what NumPy
// users write as JSON or YAML; one camera, a stereo pair, or several by name.
#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/cameras/camera_formats.h"

namespace hogelscope {

namespace {

const KeyNames matrixNames{"cameramatrix",
                           "k",
                           "m1",
                           "m",
                           "mtx",
                           "cammatrix",
                           "cameramtx",
                           "intrinsicmatrix",
                           "cameraintrinsics",
                           "intrinsics",
                           "intrinsic",
                           "kmatrix"};
const KeyNames lensNamesOfFiles{"distortioncoefficients",
                                "distcoeffs",
                                "d",
                                "d1",
                                "distcoeff",
                                "distcoefs",
                                "distcoef",
                                "dist",
                                "distortioncoeffs",
                                "distortioncoeff",
                                "distortion",
                                "distortionparameters",
                                "coeffs"};
const KeyNames modelNames{"distortionmodel", "lensmodel", "model", "cameratype"};

/// Whether a value may be a matrix; k1 = 0.1 is none, though a stereo pair's K1 is called so, too.
bool isMatrix(const Json& value) {
  return value.is_array() || (value.is_object() && value.contains("data"));
}

/// Whether a plain key is a name of matrices or lenses with the mark of one camera of several: K1,
/// D2, cameraMatrixLeft, left_dist. Returns the mark, "" if it has none.
std::string markOf(const std::string& plain, KeyNames names) {
  static const KeyNames marks{"1", "2", "3", "4", "0", "left", "right", "l", "r"};
  for (const std::string_view name : names)
    for (const std::string_view mark : marks)
      if (plain == std::string(name) + std::string(mark) ||
          (mark.size() > 1 && plain == std::string(mark) + std::string(name)))
        return std::string(mark);
  return {};
}

/// Returns fx, fy, cx, cy as members of their own: "fx", "Camera.fx", "ppx"; null without them.
Json flatIntrinsics(const Json& object) {
  Json values = Json::object();
  const auto take = [&](const char* name, KeyNames names) {
    const Json* const value = memberOf(object, names);
    if (value != nullptr && value->is_number()) values[name] = *value;
  };
  take("fx", {"fx", "camerafx", "camera1fx"});
  take("fy", {"fy", "camerafy", "camera1fy"});
  take("cx", {"cx", "ppx", "u0", "cameracx", "camera1cx"});
  take("cy", {"cy", "ppy", "v0", "cameracy", "camera1cy"});
  return values.size() == 4 ? values : Json();
}

/// Returns the coefficients that are members of their own, in the model's order.
std::vector<double> flatCoefficients(const Json& object, bool isFisheye) {
  static const std::vector<std::string> ofFisheye{"k1", "k2", "k3", "k4"};
  static const std::vector<std::string> ofOthers{"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"};
  std::vector<double> d;
  for (const std::string& name : isFisheye ? ofFisheye : ofOthers) {
    const std::string ofCamera = "camera" + name, ofFirst = "camera1" + name;
    const Json* const value = memberOf(object, {name, ofCamera, ofFirst});
    d.push_back(value != nullptr && value->is_number() ? value->get<double>() : 0.0);
  }
  constexpr std::size_t ofBrown = 5;
  while (d.size() > ofBrown && d.back() == 0) d.pop_back();
  return d;
}

bool hasMatrix(const Json& object) {
  const Json* const matrix = memberOf(object, matrixNames);
  return (matrix != nullptr && isMatrix(*matrix)) || !flatIntrinsics(object).is_null();
}

IntrinsicsParams intrinsicsOf(const std::vector<double>& k) {
  if (k.size() != 9) throw InputError("camera_matrix", "is not of 3×3 numbers");
  if (k[0] == 0 && k[4] == 0)
    throw InputError("camera_matrix", "is of zeros: the camera has not been calibrated");
  if (k[1] != 0)
    throw InputError("camera_matrix",
                     "has a skew, " + Json(k[1]).dump() + ", which is not modelled");
  if (k[3] != 0 || k[6] != 0 || k[7] != 0 || k[8] != 1)
    throw InputError("camera_matrix", "is not of the form [fx 0 cx; 0 fy cy; 0 0 1]");
  return checkedIntrinsics({{"fx", k[0]}, {"fy", k[4]}, {"cx", k[2]}, {"cy", k[5]}}, "intrinsics");
}

/// Returns a pair of numbers: [w, h], [h, w, channels] under the name of a shape, "640x480", or an
/// object of width and height; null for anything else.
Json pairOf(const Json& value) {
  if (value.is_object() && value.contains("data")) return pairOf(value["data"]);
  if (value.is_object()) {
    const Json* const width = memberOf(value, {"width", "w"});
    const Json* const height = memberOf(value, {"height", "h"});
    return width != nullptr && height != nullptr ? Json::array({*width, *height}) : Json();
  }
  if (value.is_string()) {
    const std::string text = value.get<std::string>();
    const std::size_t x = text.find_first_of("xX");
    if (x == std::string::npos) return {};
    const auto width = numberOf(text.substr(0, x)), height = numberOf(text.substr(x + 1));
    return width && height ? Json::array({*width, *height}) : Json();
  }
  if (!value.is_array() || value.size() < 2 || value.size() > 3) return {};
  if (value[0].is_array()) return value.size() == 1 ? pairOf(value[0]) : Json();
  return value;
}

/// Whether a picture of this size has the principal point farther from its middle than the other
/// way round, where it would be near.
bool isTurned(const Json& pair, const IntrinsicsParams& k) {
  if (!pair[0].is_number() || !pair[1].is_number()) return false;
  const double w = pair[0].get<double>(), h = pair[1].get<double>();
  const auto off = [&](double width, double height) {
    return std::max(std::abs(k.cx / width - 0.5), std::abs(k.cy / height - 0.5));
  };
  constexpr double near = 0.1, far = 0.15;  // of the picture's sides
  return w != h && off(h, w) < near && off(w, h) > far;
}

/// Returns the picture's size under its usual names; none if there are none.
std::optional<std::array<int, 2>> sizeOf(const Json& object, const IntrinsicsParams& k,
                                         std::vector<std::string>& notes) {
  const Json* const width =
      memberOf(object, {"imagewidth", "imgwidth", "framewidth", "width", "w", "camerawidth"});
  const Json* const height =
      memberOf(object, {"imageheight", "imgheight", "frameheight", "height", "h", "cameraheight"});
  if (width != nullptr || height != nullptr) {
    const bool areNumbers =
        width != nullptr && height != nullptr && width->is_number() && height->is_number();
    const auto isWhole = [](const Json& side) {
      return side.get<double>() == std::floor(side.get<double>());
    };
    if (!areNumbers || !isWhole(*width) || !isWhole(*height))
      throw InputError("image_width", "and image_height are not two whole numbers");
    return checkedSize({*width, *height}, "image size");
  }
  const KeyNames pairs{"imagesize",
                       "imgsize",
                       "imsize",
                       "resolution",
                       "imageresolution",
                       "res",
                       "size",
                       "framesize",
                       "dim",
                       "imagedim",
                       "dimensions",
                       "imagedimensions",
                       "imageshape",
                       "imgshape",
                       "shape",
                       "frameshape",
                       "hw"};
  std::string key;
  const Json* const value = memberOf(object, pairs, &key);
  if (value == nullptr) return std::nullopt;
  Json pair = pairOf(*value);
  if (pair.is_null()) return std::nullopt;
  const bool isShape =
      plainKey(key).ends_with("shape") || plainKey(key) == "hw" || pair.size() == 3;
  if (isShape) pair = {pair[1], pair[0]};
  if (isTurned(pair, k)) {
    pair = {pair[1], pair[0]};
    notes.push_back(printable(key) + " is taken for " +
                    (isShape ? "width and height" : "height and width") +
                    ", since the principal point is then in the middle");
  }
  return checkedSize(pair, "image size");
}

/// Sets the model's name: that of the lens, unless the camera itself is none that has lenses.
void takeModel(const Json& object, FileCamera& camera) {
  camera.model = textOf(object, modelNames, &camera.modelKey);
  FileCamera whole;
  whole.model = textOf(object, {"cameramodel"}, &whole.modelKey);
  if (camera.model.empty() || lensModelOf(whole) != "brown") {
    if (!whole.model.empty()) {
      camera.model = whole.model;
      camera.modelKey = whole.modelKey;
    }
  }
  const Json* const fisheye =
      memberOf(object, {"fisheyemodel", "fisheye", "isfisheye"}, &whole.modelKey);
  const bool isFisheye = fisheye != nullptr && (*fisheye == true || *fisheye == 1);
  if (isFisheye) {
    camera.model = "fisheye";
    camera.modelKey = whole.modelKey;
  }
  if (camera.model.empty() && memberOf(object, {"xi"}, &camera.modelKey) != nullptr)
    camera.model = "omni (xi)";
}

std::vector<double> coefficientsOf(const Json* d, const std::string& key, bool isFisheye) {
  if (d == nullptr)
    throw InputError("distortion_coefficients",
                     "is missing; it may also be called: dist_coeffs distCoeffs dist D D1");
  if (d->is_object() && !d->contains("data")) return flatCoefficients(*d, isFisheye);
  return matrixNumbers(*d, key);
}

/// Adds what a message of ROS says of its picture, but is not used.
void noteRegion(const Json& object, std::vector<std::string>& notes) {
  for (const auto& [name, key] : {std::pair("binningx", "binning_x"), {"binningy", "binning_y"}}) {
    const Json* const binning = memberOf(object, {name});
    if (binning != nullptr && binning->is_number() && *binning > 1)
      notes.push_back(std::string(key) + " is " + binning->dump() + ", which is not used");
  }
  const Json* const roi = memberOf(object, {"roi"});
  for (const char* key : {"x_offset", "y_offset"})
    if (roi != nullptr && roi->is_object() && roi->contains(key) && (*roi)[key] != 0)
      notes.push_back("roi." + std::string(key) + " is " + valueText((*roi)[key]) +
                      ", which is not used");
}

/// Reads the camera of an object; `matrix` and `lens` are its members.
FileCamera cameraIn(const Json& object, const Json* matrix, const std::string& matrixKey,
                    const Json* lens, const std::string& lensKey, CameraFile& file) {
  FileCamera camera;
  camera.lensPath = "distortion_coefficients";
  takeModel(object, camera);
  const Json flat = flatIntrinsics(object);
  const bool isFlat = matrix == nullptr && !flat.is_null();
  if (isFlat) {
    camera.calibration.intrinsics = checkedIntrinsics(flat, "intrinsics");
  } else if (matrix == nullptr) {
    throw InputError("camera_matrix", "is missing; it may also be called: cameraMatrix mtx K M1");
  } else if (matrix->is_object() && !flatIntrinsics(*matrix).is_null()) {
    camera.calibration.intrinsics = checkedIntrinsics(flatIntrinsics(*matrix), "intrinsics");
  } else {
    camera.calibration.intrinsics = intrinsicsOf(matrixNumbers(*matrix, matrixKey));
  }
  const bool isFisheye = lensModelOf(camera) == "fisheye";
  camera.coefficients = isFlat && lens == nullptr ? flatCoefficients(object, isFisheye)
                                                  : coefficientsOf(lens, lensKey, isFisheye);
  // A list without numbers stands for no lens where a model is named, as ROS has it.
  if (camera.coefficients.empty() && memberOf(object, modelNames) == nullptr)
    throw InputError(camera.lensPath, "are fewer than k1, k2, p1, p2");
  camera.calibration.res = sizeOf(object, camera.calibration.intrinsics, file.notes);
  noteRegion(object, file.notes);
  return camera;
}

/// The members of one camera of a pair in an object: K1 and D1, cameraMatrixLeft and distLeft.
struct MarkedCamera {
  std::string mark;
  std::string key;
  const Json* matrix = nullptr;
  const Json* lens = nullptr;
  std::string lensKey;
};

std::vector<MarkedCamera> markedCameras(const Json& object) {
  std::vector<MarkedCamera> cameras;
  for (const auto& [key, value] : object.items()) {
    const std::string mark = markOf(plainKey(key), matrixNames);
    if (!mark.empty() && isMatrix(value)) cameras.push_back({mark, key, &value, nullptr, {}});
  }
  for (MarkedCamera& camera : cameras)
    for (const auto& [key, value] : object.items())
      if (isMatrix(value) && markOf(plainKey(key), lensNamesOfFiles) == camera.mark) {
        camera.lens = &value;
        camera.lensKey = key;
      }
  std::erase_if(cameras, [](const MarkedCamera& camera) { return camera.lens == nullptr; });
  return cameras;
}

void readCameras(const Json& object, const std::string& name, int depth, CameraFile& file);

/// Reads the cameras of an object that is not one itself: a pair's, or those in its members.
void readSeveral(const Json& object, int depth, CameraFile& file) {
  for (const MarkedCamera& marked : markedCameras(object)) {
    FileCamera camera =
        cameraIn(object, marked.matrix, marked.key, marked.lens, marked.lensKey, file);
    camera.name = marked.key;
    file.cameras.push_back(std::move(camera));
  }
  constexpr int deepest = 3;
  if (depth == deepest) return;
  for (const auto& [key, value] : object.items()) {
    if (value.is_object()) readCameras(value, key, depth + 1, file);
    for (std::size_t k = 0; value.is_array() && k < value.size(); ++k)
      if (value[k].is_object())
        readCameras(value[k], key + "[" + std::to_string(k) + "]", depth + 1, file);
  }
}

/// Reads the camera that an object is, or those in it.
void readCameras(const Json& object, const std::string& name, int depth, CameraFile& file) {
  if (file.cameras.size() >= mostCameras) return;
  const bool isPair = markedCameras(object).size() > 1;
  if (isPair || !hasMatrix(object)) return readSeveral(object, depth, file);
  std::string matrixKey, lensKey;
  const Json* const matrix = memberOf(object, matrixNames, &matrixKey);
  const Json* const lens = memberOf(object, lensNamesOfFiles, &lensKey);
  FileCamera camera = cameraIn(object, matrix, matrixKey, lens, lensKey, file);
  const std::string own = textOf(object, {"cameraname", "name", "serial", "serialnumber"});
  const Json* const header = memberOf(object, {"header"});
  const std::string frame = header == nullptr ? "" : textOf(*header, {"frameid"});
  camera.name = !own.empty() ? own : !frame.empty() ? frame : name;
  file.cameras.push_back(std::move(camera));
}

/// Messages of one camera say the same again and again.
bool isAgain(const FileCamera& a, const FileCamera& b) {
  return a.name == b.name && a.model == b.model && a.coefficients == b.coefficients &&
         a.calibration.intrinsics == b.calibration.intrinsics &&
         a.calibration.res == b.calibration.res;
}

CameraFile readMatrices(const CameraDocument& document, CameraUse /*use*/) {
  CameraFile file;
  const std::string name = printable(document.file.stem().string());
  for (const Json& object : document.documents) {
    const std::size_t before = file.cameras.size();
    readCameras(object, name, 0, file);
    if (file.cameras.size() != before + 1) continue;
    const FileCamera& last = file.cameras.back();
    if (std::any_of(file.cameras.begin(), file.cameras.end() - 1,
                    [&](const FileCamera& one) { return isAgain(one, last); }))
      file.cameras.pop_back();
  }
  if (file.cameras.empty()) {  // says what is missing
    std::string matrixKey, lensKey;
    const Json& object = document.documents.front();
    const Json* const matrix = memberOf(object, matrixNames, &matrixKey);
    const Json* const lens = memberOf(object, lensNamesOfFiles, &lensKey);
    file.cameras.push_back(cameraIn(object, matrix, matrixKey, lens, lensKey, file));
  }
  return file;
}

/// Whether an object, or one in it, has a name of a matrix or of a lens.
bool hasNames(const Json& object, int depth) {
  if (!object.is_structured()) return false;
  if (hasMatrix(object) || !markedCameras(object).empty()) return true;
  if (memberOf(object, {"cameramatrix", "k", "m1", "mtx"}) != nullptr) return true;
  if (memberOf(object, {"distortioncoefficients", "distcoeffs", "d"}) != nullptr) return true;
  constexpr int deepest = 3;
  for (const Json& member : object) {
    if (depth == deepest) return false;
    if (hasNames(member, depth + 1)) return true;
    if (member.is_array() && std::any_of(member.begin(), member.end(), [depth](const Json& item) {
          return hasNames(item, depth + 1);
        }))
      return true;
  }
  return false;
}

bool hasMatrices(const CameraDocument& document) {
  return std::ranges::any_of(document.documents,
                             [](const Json& object) { return hasNames(object, 0); });
}

bool isRos(const CameraDocument& document) {
  if (document.documents.empty() || document.syntax == "OpenCV YAML") return false;
  const Json& object = document.documents.front();
  return object.is_object() && object.contains("distortion_model") && hasMatrix(object) &&
         !object.contains("resolution");
}

}  // namespace

const CameraFormat rosFormat{"ROS camera_info", isRos, readMatrices};
const CameraFormat matrixFormat{"camera matrix", hasMatrices, readMatrices};

}  // namespace hogelscope
