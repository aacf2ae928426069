// SPDX-License-Identifier: BSD-3-Clause
// The program's version and those of its libraries.
#include "report/versions.h"

#include <vtkVersion.h>

#include <QtGlobal>

#include "io/images/library_versions.h"

namespace hogelscope {

std::vector<Version> versions() {
  return {{"Hogelscope", HOGELSCOPE_VERSION},
          {"Qt", qVersion()},
          {"VTK", vtkVersion::GetVTKVersion()},
          {"OpenCV", openCvVersion()},
          {"OpenImageIO", openImageIoVersion()}};
}

std::string versionsLine() {
  std::string line;
  for (const Version& each : versions())
    line += (line.empty() ? "" : ", ") + each.name + " " + each.version;
  return line;
}

}  // namespace hogelscope
