// SPDX-License-Identifier: BSD-3-Clause
#include "report/versions.h"

#include "core/base/version.h"
#include "io/images/image_file.h"

namespace hogelscope {

std::vector<Version> versions() {
  return {{"Hogelscope", programVersion()},
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
