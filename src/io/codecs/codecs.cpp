// SPDX-License-Identifier: BSD-3-Clause
// All codecs, for programs that link them. The program hogelscope loads them (loaded_codecs.cpp).
#include "io/images/codecs.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "io/codecs/open_image_io.h"
#include "io/codecs/video_input.h"

namespace hogelscope {

namespace {

class AllCodecs : public Codecs {
 public:
  [[nodiscard]] std::unique_ptr<ImageInput> open(const std::filesystem::path& file,
                                                 const std::string& format) const override {
    return openByOpenImageIo(file, format);
  }
  [[nodiscard]] std::unique_ptr<ImageInput> openVideo(const std::filesystem::path& file,
                                                      const std::string& format) const override {
    return hogelscope::openVideo(file, format);
  }
  [[nodiscard]] std::unique_ptr<ImageOutput> create(const std::filesystem::path& file,
                                                    const ImageSpec& spec,
                                                    ByteOutput& bytes) const override {
    return createByOpenImageIo(file, spec, bytes);
  }
  void throughJpeg(int quality, int width, int height, std::uint8_t* rgb,
                   std::size_t stride) const override {
    cv::Mat image(height, width, CV_8UC3, rgb, stride);
    cv::Mat bgr;
    cv::cvtColor(image, bgr, cv::COLOR_RGB2BGR);
    std::vector<std::uint8_t> file;
    cv::imencode(".jpg", bgr, file, {cv::IMWRITE_JPEG_QUALITY, quality});
    cv::cvtColor(cv::imdecode(file, cv::IMREAD_COLOR), image, cv::COLOR_BGR2RGB);
  }
};

}  // namespace

const Codecs& codecs() {
  static const AllCodecs all;
  return all;
}

}  // namespace hogelscope
