// SPDX-License-Identifier: BSD-3-Clause
// Summing the window round each sampled pixel is the same as blurring every whole hogel image first
// (OpenCV does that here) and sampling the blurred light field then.
#include <QTest>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/engine/fast_simulation.h"
#include "tests/core/random_scene.h"

using namespace hogelscope;

namespace {

/// The hogel image of hogel (i, j), in the light that is summed.
cv::Mat hogelImage(const LightFieldSource& field, int i, int j, LightModel light) {
  cv::Mat image(field.size().dv, field.size().du, CV_64FC3);
  for (int v = 0; v < image.rows; ++v)
    for (int u = 0; u < image.cols; ++u) {
      const Rgb c = decoded(light, field.texel({i, j, u, v}));
      image.at<cv::Vec3d>(v, u) = {c.r, c.g, c.b};
    }
  return image;
}

cv::Mat blurred(const cv::Mat& image, const PsfParams& psf) {
  const cv::Mat kernel = cv::getGaussianKernel(psf.windowSize, psf.sigma, CV_64F);
  const int border = psf.border == PsfBorder::clamp ? cv::BORDER_REPLICATE : cv::BORDER_CONSTANT;
  cv::Mat sum;
  cv::sepFilter2D(image, sum, -1, kernel, kernel, {-1, -1}, 0, border);
  if (psf.border != PsfBorder::renormalise) return sum;
  cv::Mat weight;
  cv::sepFilter2D(cv::Mat(image.size(), image.type(), cv::Scalar::all(1)), weight, -1, kernel,
                  kernel, {-1, -1}, 0, cv::BORDER_CONSTANT);
  return sum / weight;
}

std::shared_ptr<const LightField> blurredFirst(const RenderJob& job) {
  const LightFieldSource& field = *job.lightField;
  const PsfParams& psf = job.state.psf;
  auto result = std::make_shared<LightField>(field.size(), StoredType::real);
  for (int i = 0; i < field.size().nx; ++i)
    for (int j = 0; j < field.size().ny; ++j) {
      const cv::Mat image = blurred(hogelImage(field, i, j, psf.light), psf);
      for (int v = 0; v < image.rows; ++v)
        for (int u = 0; u < image.cols; ++u) {
          const auto& sum = image.at<cv::Vec3d>(v, u);
          const Rgb c = encoded(psf.light, {sum[0], sum[1], sum[2]});
          const std::array rgb{float(c.r / 255), float(c.g / 255), float(c.b / 255)};
          result->set({i, j, u, v}, rgb.data());
        }
    }
  return result;
}

std::vector<float> codeValues(const RenderJob& job) {
  LensTables tables;
  const FastSimulation simulation(job, tables, serialRows);
  const auto [width, height] = job.state.camera.res;
  std::vector<float> values(std::size_t(3 * width * height));
  std::vector<std::uint8_t> seen(std::size_t(width * height));
  simulation.rows(0, height, 0, width, values.data(), seen.data());
  return values;
}

}  // namespace

class TestBlurFirst : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void isTheSame_data() {
    QTest::addColumn<int>("border");
    QTest::addColumn<int>("light");
    QTest::addColumn<int>("reconstruction");
    const std::array borders{"renormalise", "clamp", "black"};
    for (int border = 0; border < 3; ++border) {
      for (int how = 0; how < 3; ++how)
        QTest::addRow("%s, reconstruction %d", borders[std::size_t(border)], how)
            << border << int(LightModel::encoded) << how;
      // Interpolation would mix encoded values of what was blurred in linear light.
      QTest::addRow("%s, linear light", borders[std::size_t(border)])
          << border << int(LightModel::linear) << int(Reconstruction::nearest);
    }
  }

  void isTheSame() {
    QFETCH(const int, border);
    QFETCH(const int, light);
    QFETCH(const int, reconstruction);
    Random random(8);
    int lit = 0;
    for (int repeat = 0; repeat < 30; ++repeat) {
      RandomScene scene = randomScene(random);
      RenderJob& job = scene.job;
      job.state.psf = {random.uniform(0.3, 2), 2 * random.integer(1, 4) + 1,
                       static_cast<PsfBorder>(border), static_cast<LightModel>(light)};
      job.sampling.reconstruction = static_cast<Reconstruction>(reconstruction);
      RenderJob first = job;
      first.lightField = blurredFirst(job);
      first.state.psf = {job.state.psf.sigma, 1};
      const std::vector<float> windows = codeValues(job);
      const std::vector<float> whole = codeValues(first);
      for (std::size_t k = 0; k < windows.size(); ++k) {
        QVERIFY(std::abs(windows[k] - whole[k]) < 2e-3F);
        lit += windows[k] > 0 ? 1 : 0;
      }
    }
    QVERIFY2(lit > 5000, qPrintable(QString::number(lit)));
  }
};

QTEST_APPLESS_MAIN(TestBlurFirst)
#include "test_blur_first.moc"
