// SPDX-License-Identifier: BSD-3-Clause
// The versions of the libraries that `io` uses.
#include "io/images/library_versions.h"

#include <OpenImageIO/imageio.h>

#include <opencv2/core/utility.hpp>

namespace hogelscope {

std::string openCvVersion() {
  return cv::getVersionString();
}

/// OpenImageIO gives it as one number: 10000 × major + 100 × minor + patch.
std::string openImageIoVersion() {
  const int version = OIIO::openimageio_version();
  return std::to_string(version / 10000) + "." + std::to_string(version / 100 % 100) + "." +
         std::to_string(version % 100);
}

}  // namespace hogelscope
