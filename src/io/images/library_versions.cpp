// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/library_versions.h"

#include <OpenImageIO/oiioversion.h>

#include <opencv2/core/utility.hpp>

namespace hogelscope {

std::string openCvVersion() {
  return cv::getVersionString();
}

std::string openImageIoVersion() {
  return OIIO_VERSION_STRING;
}

}  // namespace hogelscope
