// SPDX-License-Identifier: BSD-3-Clause
// --info: what a file is.
#include "cli/info.h"

#include <filesystem>
#include <sstream>

#include "core/report.h"
#include "io/folders.h"
#include "io/image_file.h"
#include "io/light_field_file.h"
#include "io/light_field_store.h"
#include "io/session_file.h"
#include "io/view_files.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

const char* typeName(StoredType type) {
  switch (type) {
    case StoredType::uint8:
      return "8 bit";
    case StoredType::uint16:
      return "16 bit";
    default:
      return "floating point";
  }
}

void printSize(std::ostream& out, const LightFieldSize& size) {
  out << "hogels      " << size.nx << "×" << size.ny << "\n"
      << "directions  " << size.du << "×" << size.dv << "\n"
      << "hogel image " << size.width() << "×" << size.height() << " px\n";
}

void printPicture(std::ostream& out, const std::string& file) {
  const ImageFile image{fs::path(file)};
  out << "picture     " << image.format() << ", " << image.width() << "×" << image.height()
      << " px, " << image.channels() << " channel(s), " << typeName(image.type()) << "\n";
  const auto [columns, rows] = quiltTilesFromName(file);
  if (columns > 0) {
    LightFieldParams params;
    params.file = file;
    params.layout = Layout::quilt;
    out << "layout      quilt of " << columns << "×" << rows << " views\n";
    printSize(out, openLightField(params, {})->size());
  } else {
    out << "layout      not said by the file; a session says it, with the hogels and directions\n";
  }
}

void printFolder(std::ostream& out, const std::string& folder) {
  LightFieldParams params;
  params.file = folder;
  params.layout = Layout::views;
  const ViewFiles views = findViews(params, {0, 0});
  out << "layout      views, " << views.rows << " rows of " << views.columns << "\n"
      << "first       " << views.files.front().filename().string() << "\n"
      << "last        " << views.files.back().filename().string() << "\n";
  printSize(out, openLightField(params, {})->size());
}

void printStore(std::ostream& out, const std::string& file) {
  const LightFieldStore store{fs::path(file)};
  const auto& [size, type, block, overview, source, display] = store.header();
  out << "layout      pack: a store, " << typeName(type) << ", blocks of " << block.i << "×"
      << block.j << " hogels × " << block.u << "×" << block.v << " directions\n"
      << "overview    " << overview.nx << "×" << overview.ny << " hogels of " << overview.du << "×"
      << overview.dv << " directions\n"
      << "made of     " << source.substr(0, source.rfind(' ')) << "\n";
  if (display)
    out << "display     " << numberText(display->size[0]) << "×" << numberText(display->size[1])
        << " m, fov " << numberText(display->fov[0]) << "×" << numberText(display->fov[1]) << "°\n";
  printSize(out, size);
}

void printSession(std::ostream& out, const std::string& file) {
  const Session session = loadSession(file);
  out << "session     " << session.cameras.size() << " camera state(s)\n"
      << "display     " << numberText(session.display.size[0]) << "×"
      << numberText(session.display.size[1]) << " m, fov " << numberText(session.display.fov[0])
      << "×" << numberText(session.display.fov[1]) << "°\n"
      << "light field " << session.lightField.file << "\n";
  printSize(out, openLightField(session.lightField, session.display)->size());
  for (const CameraState& state : session.cameras) {
    const auto& [name, eye, lookat, up, fov, res, weight] = state.camera;
    out << "state       " << name << ": eye (" << numberText(eye.x) << ", " << numberText(eye.y)
        << ", " << numberText(eye.z) << ") m, fov " << numberText(fov) << "°, " << res[0] << "×"
        << res[1] << " px, psf sigma " << numberText(state.psf.sigma) << " in "
        << state.psf.windowSize << " px" << (weight == 1 ? "" : ", weight " + numberText(weight))
        << "\n";
  }
}

}  // namespace

std::string infoText(const std::string& file) {
  std::ostringstream out;
  if (isSessionFile(file))
    printSession(out, file);
  else if (isFolder(file))
    printFolder(out, file);
  else if (LightFieldStore::isStore(file))
    printStore(out, file);
  else
    printPicture(out, file);
  return out.str();
}

}  // namespace hogelscope
